namespace Surefoot.Physics.Decisions;

/// <summary>Why a decision was made.</summary>
public enum TraceReason : byte
{
    /// <summary>As usual.</summary>
    None,

    /// <summary>An object: the mover itself.</summary>
    IsTheMover,

    /// <summary>An object: it is attached to another one.</summary>
    IsAttached,

    /// <summary>An object: ethereal and out of all collisions.</summary>
    IgnoresCollisions,

    /// <summary>An object or the mover is ethereal: it is asked for room only and passed through.</summary>
    Ethereal,

    /// <summary>An object: a creature, which the camera and those who ignore creatures pass.</summary>
    IgnoredCreature,

    /// <summary>An object: a player whom this player passes.</summary>
    PassedPlayer,

    /// <summary>An object: missiles pass it.</summary>
    PassedByMissile,

    /// <summary>An object or a part of it is too far away to be met.</summary>
    TooFar,

    /// <summary>An object has no shape.</summary>
    NoShape,

    /// <summary>A hit: the movement runs into it.</summary>
    RunInto,

    /// <summary>A hit: overlapped, but not run into; answered when nothing else is in the way.</summary>
    Deferred,

    /// <summary>A hit in the air: a landing is asked for.</summary>
    LandingAsked,

    /// <summary>A hit: it is in the way of what is put there.</summary>
    Overlaps,

    /// <summary>A hit: it supports the foot.</summary>
    Supports,

    /// <summary>Ground or a surface that is too steep to stand on.</summary>
    TooSteep,

    /// <summary>An obstacle that is higher than the step height.</summary>
    TooHigh,

    /// <summary>Footing that is out of the reach of the step.</summary>
    OutOfReach,

    /// <summary>Something blocks the probe.</summary>
    Blocked,

    /// <summary>No footing was found.</summary>
    NoFooting,

    /// <summary>Too little of the footing is under the foot.</summary>
    BarelySupported,

    /// <summary>There is footing, and no room for the body on it.</summary>
    NoRoom,

    /// <summary>What is left of the movement is too short.</summary>
    TooShort,

    /// <summary>The obstacle leads into the floor, with no crease to slide along.</summary>
    AgainstTheFloor,

    /// <summary>A normal without a direction.</summary>
    NoDirection,

    /// <summary>The body does not stand, or does not mind edges.</summary>
    Careless,

    /// <summary>The movement crosses no edge of the footing.</summary>
    NoEdgeCrossed,

    /// <summary>The floor that the body came from is not found again.</summary>
    NothingBehind,

    /// <summary>Bent along the floor.</summary>
    AlongFloor,

    /// <summary>Put down onto the floor that leads away.</summary>
    DownTheFloor,

    /// <summary>Bent along the wall that was slid along before.</summary>
    AlongWall,

    /// <summary>Bent along the crease between the wall that was slid along before and the floor.</summary>
    AlongCrease,

    /// <summary>A contact plane: the one of the sub-step before holds again.</summary>
    Regained,

    /// <summary>A contact plane made up, because the body failed to move three times.</summary>
    MadeUp,

    /// <summary>The position is in no loaded cell.</summary>
    NotLoaded,

    /// <summary>The cell is guarded and lets this player not in.</summary>
    Guarded,

    /// <summary>A block that is water all over.</summary>
    OpenWater,
}
