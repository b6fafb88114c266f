using CsCheck;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class FormulaTests
{
    [Theory]
    [Behaviour("motion.run-rate.follows-skill-and-load", "spec/01, 4.1 and 6; MovementSystem::GetRunRate @0x006B0950")]
    [InlineData(0f, 0, 1f)]
    [InlineData(0f, 10, 1.13095236f)]
    [InlineData(0f, 100, 1.91666663f)]
    [InlineData(0f, 200, 2.375f)]
    [InlineData(0f, 300, 2.6500001f)]
    [InlineData(0f, 400, 2.83333325f)]
    [InlineData(0f, 799, 3.19944954f)]
    [InlineData(0f, 800, 4.5f)]
    [InlineData(0f, 1200, 4.5f)]
    [InlineData(1.0f, 300, 2.6500001f)]
    [InlineData(1.5f, 300, 1.82500005f)]
    [InlineData(1.99f, 300, 1.0165f)]
    [InlineData(2.5f, 300, 1f)]
    public void The_run_rate_follows_skill_and_load(float load, int skill, float expected) =>
        Assert.Equal(expected, MovementFormulas.RunRate(load, skill));

    [Theory]
    [Behaviour("motion.run-rate.equality-rule-is-an-option", "spec/01, 4.1 and 6")]
    [InlineData(799, 3.19944954f)]
    [InlineData(800, 4.5f)]
    [InlineData(1200, 3.35714293f)]
    public void The_clients_own_rule_knows_only_exactly_800(int skill, float expected) =>
        Assert.Equal(expected, MovementFormulas.RunRate(0, skill, TopSpeedRule.ExactlyEightHundred));

    [Theory]
    [Behaviour("motion.jump.height-and-speed-follow-skill-load-and-charge",
        "spec/01, 4.1 and 6; MovementSystem::GetJumpHeight @0x006B09B0")]
    [InlineData(0f, 0, 1f, 0.349999994f, 2.61916018f)]
    [InlineData(0f, 100, 1f, 1.63571434f, 5.66215515f)]
    [InlineData(0f, 200, 0.5f, 1.50500005f, 5.43120623f)]
    [InlineData(0f, 200, 1f, 3.0100001f, 7.68088531f)]
    [InlineData(0f, 300, 0.001f, 0.349999994f, 2.61916018f)]
    [InlineData(0f, 300, 0.25f, 1.05312504f, 4.54326439f)]
    [InlineData(0f, 300, 1f, 4.21250014f, 9.08652878f)]
    [InlineData(0f, 400, 1f, 5.27352959f, 10.1666698f)]
    [InlineData(0f, 1000, 1f, 9.70217425f, 13.7899466f)]
    [InlineData(1.5f, 300, 1f, 2.10625007f, 6.4251461f)]
    [InlineData(2f, 300, 1f, 0.349999994f, 2.61916018f)]
    public void Jump_height_and_speed_follow_skill_load_and_charge(float load, int skill, float power, float height, float velocity)
    {
        Assert.Equal(height, (float)MovementFormulas.JumpHeight(load, skill, power));
        Assert.Equal(velocity, MovementFormulas.JumpVelocity(MovementFormulas.JumpHeight(load, skill, power)));
    }

    [Theory]
    [Behaviour("motion.jump.speed-from-the-unrounded-height",
        "spec/01, 4.1: only the speed is stored; from the stored height it would be one bit off")]
    [InlineData(29, 0.534424424f, 3.23646688f)]
    [InlineData(73, 1.23033512f, 4.91065836f)]
    [InlineData(77, 1.29139435f, 5.03103685f)]
    public void The_speed_of_a_jump_comes_from_the_unrounded_height(int skill, float height, float velocity)
    {
        double exact = MovementFormulas.JumpHeight(0, skill, 1);
        Assert.Equal((height, velocity), ((float)exact, MovementFormulas.JumpVelocity(exact)));
        Assert.NotEqual(velocity, MovementFormulas.JumpVelocity(height));
        Assert.True(new PlayerWeenie(new CharacterStats(0, skill)).InqJumpVelocity(1, out float answered));
        Assert.Equal(velocity, answered);
    }

    [Theory]
    [Behaviour("motion.jump.stamina-cost", "spec/01, 4.1 and 6; MovementSystem::JumpStaminaCost @0x006B0A40")]
    [InlineData(1f, 0f, false, 6)]
    [InlineData(1f, 0.5f, false, 10)]
    [InlineData(0.5f, 1f, false, 8)]
    [InlineData(0.001f, 0f, false, 3)]
    [InlineData(1f, 1.99f, false, 22)]
    [InlineData(0.5f, 0f, true, 150)]
    [InlineData(1f, 0f, true, 200)]
    public void A_jump_costs_stamina_by_charge_and_load(float power, float load, bool pk, int expected) =>
        Assert.Equal(expected, MovementFormulas.JumpStaminaCost(power, load, pk));

    [Theory]
    [Behaviour("motion.load.capacity-from-strength-and-augmentations",
        "spec/01, 4.1 and 6; EncumbranceSystem::EncumbranceCapacity @0x004FCC00")]
    [InlineData(100, 0, 15000)]
    [InlineData(100, 2, 21000)]
    [InlineData(100, 9, 30000)]
    [InlineData(100, -3, 15000)]
    [InlineData(0, 5, 0)]
    [InlineData(-5, 5, 0)]
    public void Capacity_follows_strength_and_augmentations(int strength, int augmentations, int expected) =>
        Assert.Equal(expected, MovementFormulas.Capacity(strength, augmentations));

    [Fact]
    [Behaviour("motion.load.three-without-capacity", "spec/01, 4.1; EncumbranceSystem::Load @0x004FCC40")]
    public void Load_is_burden_by_capacity_and_three_without_one()
    {
        Assert.Equal(3f, MovementFormulas.Load(0, 10));
        Assert.Equal(0f, MovementFormulas.Load(15000, -1));
        Assert.Equal(1.5f, MovementFormulas.Load(15000, 22500));
    }

    [Fact]
    [Behaviour("motion.run-rate.skill-counts-as-zero-without-stamina", "spec/01, 4.1; CACQualities::InqRunRate @0x00592800")]
    public void Exhausted_players_run_and_jump_as_the_unskilled()
    {
        PlayerWeenie weenie = new(new CharacterStats(300, 300, Stamina: 0));
        Assert.True(weenie.InqRunRate(out float rate));
        Assert.Equal(1f, rate);
        Assert.True(weenie.InqJumpVelocity(1f, out float velocity));
        Assert.Equal(2.61916018f, velocity);
    }

    [Fact]
    [Behaviour("motion.run-rate.grows-with-skill-and-falls-with-load", "spec/01, 4.1")]
    public void More_skill_is_never_slower_and_more_load_never_faster() =>
        Gen.Select(Gen.Int[0, 1000], Gen.Int[0, 1000], Gen.Float[0, 3], Gen.Float[0, 3]).Sample((a, b, l, m) =>
        {
            float low = MovementFormulas.RunRate(l, Math.Min(a, b)), high = MovementFormulas.RunRate(l, Math.Max(a, b));
            float light = MovementFormulas.RunRate(Math.Min(l, m), a), heavy = MovementFormulas.RunRate(Math.Max(l, m), a);
            return low <= high && heavy <= light && low is >= 1f and <= 4.5f;
        });

    [Fact]
    [Behaviour("motion.jump.longer-charge-never-lower", "spec/01, 4.1")]
    public void A_longer_charge_is_never_lower_and_never_below_the_minimum() =>
        Gen.Select(Gen.Int[0, 2000], Gen.Float[0, 3], Gen.Float[0, 1], Gen.Float[0, 1]).Sample((skill, load, p, q) =>
        {
            double low = MovementFormulas.JumpHeight(load, skill, Math.Min(p, q)),
                high = MovementFormulas.JumpHeight(load, skill, Math.Max(p, q));
            return low >= 0.35f && low <= high;
        });
}
