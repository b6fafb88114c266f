namespace Surefoot.Physics.Decisions;

/// <summary>Answer of a collision test to the position that was tried.</summary>
public enum TransitionState
{
    /// <summary>Nothing was tried.</summary>
    Invalid = 0,

    /// <summary>The position is free; nothing was moved by the test.</summary>
    OK = 1,

    /// <summary>Refused outright; do not try again.</summary>
    Collided = 2,

    /// <summary>The check position was moved out of trouble; test again.</summary>
    Adjusted = 3,

    /// <summary>The check position was moved along an obstacle and the contact plane is void; test again.</summary>
    Slid = 4,
}
