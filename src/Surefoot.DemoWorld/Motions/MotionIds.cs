namespace Surefoot.DemoWorld.Motions;

/// <summary>Numbers of the motions that the demo world's tables know (specification 01, 2.1, and the list of 08, 12).</summary>
internal static class MotionIds
{
    /// <summary>Styles.</summary>
    public const uint HandCombat = 0x8000003C, NonCombat = 0x8000003D;

    /// <summary>Substates. Turning and sidestepping are modifiers as well.</summary>
    public const uint Ready = 0x41000003, Walk = 0x45000005, Run = 0x44000007, Fallen = 0x40000008, Turn = 0x6500000D,
        SideStep = 0x6500000F, Dead = 0x40000011, Crouch = 0x41000012, Sitting = 0x41000013, Sleeping = 0x41000014, Falling = 0x40000015;

    /// <summary>Actions: a blow straight ahead, and an emote.</summary>
    public const uint Attack = 0x10000063, Wave = 0x13000087;
}
