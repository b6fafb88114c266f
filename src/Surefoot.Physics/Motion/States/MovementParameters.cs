namespace Surefoot.Physics.Motion;

/// <summary>Flags of a motion request, as on the wire (specification 01, 2.4).</summary>
[Flags]
public enum MovementFlags : uint
{
    /// <summary>No flag.</summary>
    None = 0,

    /// <summary>May walk.</summary>
    CanWalk = 0x1,

    /// <summary>May run.</summary>
    CanRun = 0x2,

    /// <summary>May sidestep.</summary>
    CanSidestep = 0x4,

    /// <summary>May walk backwards.</summary>
    CanWalkBackwards = 0x8,

    /// <summary>May charge.</summary>
    CanCharge = 0x10,

    /// <summary>Fails instead of walking.</summary>
    FailWalk = 0x20,

    /// <summary>Turns to the desired heading at the end.</summary>
    UseFinalHeading = 0x40,

    /// <summary>Sticks to the target at the end.</summary>
    Sticky = 0x80,

    /// <summary>Moves away.</summary>
    MoveAway = 0x100,

    /// <summary>Moves towards.</summary>
    MoveTowards = 0x200,

    /// <summary>Distances are between surfaces.</summary>
    UseSpheres = 0x400,

    /// <summary>Takes the hold key of the request; in a raw state the motion then has no key of its own.</summary>
    SetHoldKey = 0x800,

    /// <summary>Asked for by the player and not by the server.</summary>
    Autonomous = 0x1000,

    /// <summary>The request enters the raw state.</summary>
    ModifyRawState = 0x2000,

    /// <summary>The request enters the interpreted state.</summary>
    ModifyInterpretedState = 0x4000,

    /// <summary>Ends a move-to under way.</summary>
    CancelMoveTo = 0x8000,

    /// <summary>Stops everything first.</summary>
    StopCompletely = 0x10000,

    /// <summary>No jump until the motion's links have played.</summary>
    DisableJumpDuringLink = 0x20000,

    /// <summary>What retail starts from: 0x1EE0F.</summary>
    Default = CanWalk | CanRun | CanSidestep | CanWalkBackwards | MoveTowards | UseSpheres | SetHoldKey | ModifyRawState |
              ModifyInterpretedState | CancelMoveTo | StopCompletely,
}

/// <summary>Parameters of a motion.</summary>
/// <remarks>Retail: MovementParameters @0x00524380.</remarks>
public struct MovementParameters
{
    /// <summary>Retail's defaults: <see cref="MovementFlags.Default"/>, speed 1.</summary>
    public MovementParameters()
    {
    }

    /// <summary>Flags.</summary>
    public MovementFlags Flags = MovementFlags.Default;

    /// <summary>Distance to keep from the target, metres.</summary>
    public float DistanceToObject = 0.6f;

    /// <summary>Smallest distance, metres.</summary>
    public float MinDistance;

    /// <summary>Heading at the end, degrees.</summary>
    public float DesiredHeading;

    /// <summary>Speed factor; negative plays a cycle backwards.</summary>
    public float Speed = 1f;

    /// <summary>Distance at which a move-to gives up, metres.</summary>
    public float FailDistance = float.MaxValue;

    /// <summary>Distance below which a move-to walks, metres.</summary>
    public float WalkRunThreshold = 15f;

    /// <summary>Identifies the request in the queue.</summary>
    public uint ContextId;

    /// <summary>Hold key of the request.</summary>
    public HoldKey HoldKey;

    /// <summary>15-bit stamp of an action.</summary>
    public uint ActionStamp;

    /// <summary>True when all the bits of <paramref name="flags"/> are set.</summary>
    public readonly bool Has(MovementFlags flags) => (Flags & flags) == flags;
}
