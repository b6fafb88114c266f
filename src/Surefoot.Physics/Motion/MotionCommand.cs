namespace Surefoot.Physics.Motion;

/// <summary>
/// A motion as the wire and the motion tables name it. Those that locomotion looks at have names here, and an emote and a stance to try
/// tables with; every other 32-bit id is as valid. The high bits say what kind it is (<see cref="MotionCommands"/>).
/// </summary>
/// <remarks>Specification 01, 2.1.</remarks>
public enum MotionCommand : uint
{
    /// <summary>No command.</summary>
    None = 0,

    /// <summary>Standing.</summary>
    Ready = 0x41000003,

    /// <summary>Walking ahead; with the run key held it becomes <see cref="RunForward"/>.</summary>
    WalkForward = 0x45000005,

    /// <summary>Walking backwards; normalised to <see cref="WalkForward"/> with a negative speed.</summary>
    WalkBackwards = 0x45000006,

    /// <summary>Running.</summary>
    RunForward = 0x44000007,

    /// <summary>Lying after a fall.</summary>
    Fallen = 0x40000008,

    /// <summary>Turning right (clockwise seen from above).</summary>
    TurnRight = 0x6500000D,

    /// <summary>Turning left; normalised to <see cref="TurnRight"/> with a negative speed.</summary>
    TurnLeft = 0x6500000E,

    /// <summary>Stepping to the right.</summary>
    SideStepRight = 0x6500000F,

    /// <summary>Stepping to the left; normalised to <see cref="SideStepRight"/> with a negative speed.</summary>
    SideStepLeft = 0x65000010,

    /// <summary>Dead.</summary>
    Dead = 0x40000011,

    /// <summary>Crouching.</summary>
    Crouch = 0x41000012,

    /// <summary>Sitting.</summary>
    Sitting = 0x41000013,

    /// <summary>Sleeping.</summary>
    Sleeping = 0x41000014,

    /// <summary>Falling.</summary>
    Falling = 0x40000015,

    /// <summary>An emote: waving, once.</summary>
    Wave = 0x13000087,

    /// <summary>The style of bare fists.</summary>
    HandCombat = 0x8000003C,

    /// <summary>The peaceful style.</summary>
    NonCombat = 0x8000003D,

    /// <summary>The style of two weapons.</summary>
    DualWieldCombat = 0x80000046,
}

/// <summary>Kinds of motion commands.</summary>
public static class MotionCommands
{
    /// <summary>Bit of a style.</summary>
    internal const uint StyleBit = 0x80000000;

    /// <summary>Bit of a substate: what a body does until told otherwise.</summary>
    internal const uint SubstateBit = 0x40000000;

    /// <summary>Bit of a modifier: done on top of a substate.</summary>
    internal const uint ModifierBit = 0x20000000;

    /// <summary>Bit of an action: done once.</summary>
    internal const uint ActionBit = 0x10000000;

    /// <summary>Bit of emotes of the kind that a style other than <see cref="MotionCommand.NonCombat"/> refuses.</summary>
    internal const uint ChatEmoteBit = 0x02000000;

    /// <summary>The low part that keys of a motion table keep.</summary>
    internal const uint KeyMask = 0x00FFFFFF;

    /// <summary>Is a style.</summary>
    public static bool IsStyle(this MotionCommand motion) => ((uint)motion & StyleBit) != 0;

    /// <summary>Is a substate; turns and sidesteps are modifiers as well.</summary>
    public static bool IsSubstate(this MotionCommand motion) => ((uint)motion & SubstateBit) != 0;

    /// <summary>Is a modifier.</summary>
    public static bool IsModifier(this MotionCommand motion) => ((uint)motion & ModifierBit) != 0;

    /// <summary>Is an action.</summary>
    public static bool IsAction(this MotionCommand motion) => ((uint)motion & ActionBit) != 0;

    /// <summary>Is an emote that a combat style refuses.</summary>
    public static bool IsChatEmote(this MotionCommand motion) => ((uint)motion & ChatEmoteBit) != 0;
}

/// <summary>The key that says whether forward means walking or running.</summary>
public enum HoldKey : uint
{
    /// <summary>Use the current one.</summary>
    Invalid = 0,

    /// <summary>Walk.</summary>
    None = 1,

    /// <summary>Run.</summary>
    Run = 2,
}

/// <summary>Why a motion was refused; the numbers are retail's.</summary>
/// <remarks>Specification 01, section 3.</remarks>
public enum MotionError : uint
{
    /// <summary>Accepted.</summary>
    None = 0,

    /// <summary>There is no animation table.</summary>
    NoAnimationTable = 0x07,

    /// <summary>There is no body.</summary>
    NoBody = 0x08,

    /// <summary>There is no motion interpreter.</summary>
    NoInterpreter = 0x0B,

    /// <summary>The body does not stand on the ground.</summary>
    NotOnGround = 0x24,

    /// <summary>A move-to was ended by something else.</summary>
    Cancelled = 0x36,

    /// <summary>The object that was moved to is gone.</summary>
    TargetGone = 0x37,

    /// <summary>Nothing was heard of the object to move to.</summary>
    NoTarget = 0x38,

    /// <summary>A move-to led farther than it may.</summary>
    ChargedTooFar = 0x3D,

    /// <summary>No crouching in combat.</summary>
    NoCrouchInCombat = 0x3F,

    /// <summary>No sitting in combat.</summary>
    NoSitInCombat = 0x40,

    /// <summary>No lying down in combat.</summary>
    NoSleepInCombat = 0x41,

    /// <summary>No emotes in combat.</summary>
    NoEmoteInCombat = 0x42,

    /// <summary>The motion table has no such motion from here.</summary>
    NoMotionData = 0x43,

    /// <summary>Too many actions wait.</summary>
    TooManyActions = 0x45,

    /// <summary>Refused for another reason.</summary>
    GeneralFailure = 0x47,

    /// <summary>One cannot jump from this position.</summary>
    CannotJumpFromThisPosition = 0x48,

    /// <summary>Too loaded to jump.</summary>
    TooLoadedToJump = 0x49,
}
