namespace Surefoot.Physics.Motion;

/// <summary>The numbers of a character that movement looks at. Skills are final: enchantments and augmentations are in them.</summary>
/// <param name="RunSkill">Run skill, 0 or more.</param>
/// <param name="JumpSkill">Jump skill, 0 or more.</param>
/// <param name="Stamina">Stamina; at 0 every skill counts as 0.</param>
/// <param name="Strength">Strength; 0 or less carries nothing, and counts as a load of 3.</param>
/// <param name="Augmentations">Carrying augmentations; fewer than 0 count as 0, more than 5 as 5.</param>
/// <param name="Burden">What is carried, in burden units; less than 0 counts as 0.</param>
public readonly record struct CharacterStats(
    int RunSkill, int JumpSkill, int Stamina = 100, int Strength = 100, int Augmentations = 0, int Burden = 0)
{
    /// <summary>Burden divided by capacity.</summary>
    public float Load => MovementFormulas.Load(MovementFormulas.Capacity(Strength, Augmentations), Burden);

    /// <summary>Factor on the running speed of 4 m/s.</summary>
    public float RunRate(TopSpeedRule rule = TopSpeedRule.EightHundredAndAbove) =>
        MovementFormulas.RunRate(Load, Stamina > 0 ? RunSkill : 0, rule);
}

/// <summary>The local player's weenie: answers from the character's numbers.</summary>
/// <remarks>Retail: CACQualities behind ACCWeenieObject; specification 01, 4.1.</remarks>
public sealed class PlayerWeenie : IWeenieObj
{
    /// <summary>A player with these numbers.</summary>
    public PlayerWeenie(CharacterStats stats, TopSpeedRule topSpeedRule = TopSpeedRule.EightHundredAndAbove)
    {
        TopSpeedRule = topSpeedRule;
        SetStats(stats);
    }

    /// <summary>The character's numbers.</summary>
    public CharacterStats Stats { get; private set; }

    /// <summary>From which run skill on the top speed holds.</summary>
    public TopSpeedRule TopSpeedRule { get; }

    /// <summary>The player fights players: jumps cost more stamina.</summary>
    public bool IsPlayerKillerInCombat { get; set; }

    /// <inheritdoc/>
    public bool IsThePlayer => true;

    /// <inheritdoc/>
    public bool IsCreature => true;

    /// <summary>Takes over new numbers; they act at the next question.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A skill or the stamina is negative.</exception>
    public void SetStats(CharacterStats stats)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(stats.RunSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.JumpSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.Stamina, nameof(stats));
        Stats = stats;
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CACQualities::InqRunRate @0x00592800.</remarks>
    public bool InqRunRate(out float rate)
    {
        rate = Stats.RunRate(TopSpeedRule);
        return true;
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CACQualities::InqJumpVelocity @0x00592980.</remarks>
    public bool InqJumpVelocity(float extent, out float velocity)
    {
        velocity = MovementFormulas.JumpVelocity(MovementFormulas.JumpHeight(Stats.Load, Stats.Stamina > 0 ? Stats.JumpSkill : 0, extent));
        return true;
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CACQualities::CanJump @0x00591B50.</remarks>
    public bool CanJump(float extent) => Stats.Load < MovementFormulas.OverloadedLoad;

    /// <inheritdoc/>
    /// <remarks>Retail: CACQualities::JumpStaminaCost @0x00591B90. Too little stamina does not refuse the jump.</remarks>
    public bool JumpStaminaCost(float extent, out int cost)
    {
        cost = MovementFormulas.JumpStaminaCost(extent, Stats.Load, IsPlayerKillerInCombat);
        return true;
    }
}
