namespace Surefoot.Client;

/// <summary>The movement keys held down.</summary>
[Flags]
public enum MovementKeys
{
    /// <summary>No key.</summary>
    None = 0,

    /// <summary>Ahead.</summary>
    Forward = 0x1,

    /// <summary>Backwards.</summary>
    Back = 0x2,

    /// <summary>Turn to the left.</summary>
    TurnLeft = 0x4,

    /// <summary>Turn to the right.</summary>
    TurnRight = 0x8,

    /// <summary>Step to the left.</summary>
    SidestepLeft = 0x10,

    /// <summary>Step to the right.</summary>
    SidestepRight = 0x20,

    /// <summary>Walks where one would run, or runs where one would walk (<see cref="PlayerMovementController.RunAsDefault"/>).</summary>
    Walk = 0x40,

    /// <summary>Charges a jump while it is held and jumps when it is let go.</summary>
    Jump = 0x80,

    /// <summary>Makes sidesteps of the turn keys.</summary>
    HoldSidestep = 0x100,
}
