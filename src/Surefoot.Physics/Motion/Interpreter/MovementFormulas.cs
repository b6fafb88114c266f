namespace Surefoot.Physics.Motion;

/// <summary>From which run skill on a runner has the top speed.</summary>
public enum TopSpeedRule
{
    /// <summary>800 and above: what today's servers compute.</summary>
    EightHundredAndAbove,

    /// <summary>Exactly 800: what the 2013 client computes.</summary>
    ExactlyEightHundred,
}

/// <summary>How skills, load and charge become speed, height and stamina. Loads are burden divided by capacity.</summary>
/// <remarks>Specification 01, 4.1.</remarks>
public static class MovementFormulas
{
    /// <summary>Walking speed, m/s.</summary>
    public const float WalkSpeed = 3.12f;

    /// <summary>Running speed at run rate 1, m/s.</summary>
    public const float RunSpeed = 4f;

    /// <summary>Sidestep speed at factor 1, m/s.</summary>
    public const float SidestepSpeed = 1.25f;

    /// <summary>Seconds from pressing the jump key to the full charge.</summary>
    public const double JumpChargeTime = 1.0;

    /// <summary>The same with two weapons.</summary>
    public const double DualWieldJumpChargeTime = 0.8;

    /// <summary>Smallest extent a jump key sends.</summary>
    public const float MinJumpExtent = 0.001f;

    /// <summary>Lowest jump, metres.</summary>
    public const float MinJumpHeight = 0.35f;

    /// <summary>Load from which one cannot jump.</summary>
    public const float OverloadedLoad = 2f;

    private const int TopSpeedSkill = 800;
    private const float TopRunRate = 18f / 4f;

    /// <summary>What one can carry, in burden units.</summary>
    /// <param name="strength">Strength.</param>
    /// <param name="augmentations">Number of carrying augmentations.</param>
    /// <remarks>Retail: EncumbranceSystem::EncumbranceCapacity @0x004FCC00.</remarks>
    public static int Capacity(int strength, int augmentations)
    {
        if (strength <= 0) return 0;
        long bonus = Math.Clamp(30L * augmentations, 0, 150);
        return (int)Math.Min(int.MaxValue, (150L * strength) + (strength * bonus));
    }

    /// <summary>Burden divided by capacity; 3 without capacity.</summary>
    /// <remarks>Retail: EncumbranceSystem::Load @0x004FCC40.</remarks>
    public static float Load(int capacity, int burden)
    {
        if (capacity <= 0) return 3f;
        return burden < 0 ? 0f : (float)((double)burden / capacity);
    }

    /// <summary>1 below a load of 1, falling to 0 at 2.</summary>
    /// <remarks>Retail: EncumbranceSystem::LoadMod @0x004FCC70.</remarks>
    public static float LoadMod(float load) => load < 1f ? 1f : load < OverloadedLoad ? (float)(2.0 - load) : 0f;

    /// <summary>Factor on the running speed of 4 m/s.</summary>
    /// <param name="load">Burden divided by capacity.</param>
    /// <param name="skill">Run skill.</param>
    /// <param name="rule">From which skill on the top speed holds.</param>
    /// <param name="scaling">Divides the result; 1 in play.</param>
    /// <remarks>Retail: MovementSystem::GetRunRate @0x006B0950.</remarks>
    public static float RunRate(float load, int skill, TopSpeedRule rule = TopSpeedRule.EightHundredAndAbove, float scaling = 1f)
    {
        bool top = rule == TopSpeedRule.ExactlyEightHundred ? skill == TopSpeedSkill : skill >= TopSpeedSkill;
        if (top) return TopRunRate;
        double s = Math.Max(skill, 0);
        return (float)(((LoadMod(load) * (s / (s + 200.0) * 11.0)) + 4.0) / scaling / 4.0);
    }

    /// <summary>Nominal height of a jump, metres, unrounded; at least <see cref="MinJumpHeight"/>.</summary>
    /// <param name="load">Burden divided by capacity.</param>
    /// <param name="skill">Jump skill.</param>
    /// <param name="power">Charge, clamped to 0..1.</param>
    /// <param name="scaling">Divides the result; 1 in play.</param>
    /// <remarks>Retail: MovementSystem::GetJumpHeight @0x006B09B0.</remarks>
    public static double JumpHeight(float load, int skill, float power, float scaling = 1f)
    {
        double s = Math.Max(skill, 0);
        double height = LoadMod(load) * ((s / (s + 1300.0) * 22.2f) + 0.05f) * Math.Clamp(power, 0f, 1f) / scaling;
        return Math.Max(MinJumpHeight, height);
    }

    /// <summary>Upward speed that reaches a height, m/s.</summary>
    /// <param name="height">Metres, as <see cref="JumpHeight"/> gives it: only the speed is rounded.</param>
    /// <remarks>Retail: the last part of CACQualities::InqJumpVelocity @0x00592980.</remarks>
    public static float JumpVelocity(double height) => (float)Math.Sqrt(height * 19.6);

    /// <summary>Stamina a jump costs.</summary>
    /// <param name="power">Charge, 0 to 1.</param>
    /// <param name="load">Burden divided by capacity.</param>
    /// <param name="pk">The jumper fights players: status PK or PK-lite and an attack on a player in the last 20 s.</param>
    /// <remarks>Retail: MovementSystem::JumpStaminaCost @0x006B0A40.</remarks>
    public static int JumpStaminaCost(float power, float load, bool pk) =>
        pk ? (int)((power + 1.0) * 100.0) : (int)Math.Ceiling(((load + 0.5) * power * 8.0) + 2.0);
}
