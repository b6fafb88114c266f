using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests;

/// <summary>Run rate 2.65 is that of skill 300. The low words are 05 walk, 07 run, 0D turn right, 0F step right.</summary>
public class MotionTranslationTests
{
    private const uint RunKey = 2, WalkForward = 0x45000005, WalkBackwards = 0x45000006, TurnRight = 0x6500000D, TurnLeft = 0x6500000E;
    private const uint SideStepRight = 0x6500000F, SideStepLeft = 0x65000010, Sitting = 0x41000013, SwordCombat = 0x8000003E;
    private const float RunRate = 2.6500001f;

    private static WireInterpretedMotion Interpret(in WireRawMotion raw, float rate = RunRate) =>
        MotionTranslation.Interpret(raw, rate, false).State;

    [Fact]
    [Behaviour("server.translation.run-by-the-current-hold-key", "spec/08, 8.8")]
    public void Running_is_decided_by_the_current_hold_key_alone()
    {
        Assert.Equal(
            new WireInterpretedMotion(forwardCommand: 0x07, forwardSpeed: RunRate),
            Interpret(new WireRawMotion(RunKey, forwardCommand: WalkForward)));
        Assert.Equal(new WireInterpretedMotion(forwardCommand: 0x05),
            Interpret(new WireRawMotion(forwardCommand: WalkForward, forwardHoldKey: RunKey)));
        Assert.Equal(
            new WireInterpretedMotion(forwardCommand: 0x07, forwardSpeed: RunRate),
            Interpret(new WireRawMotion(RunKey, forwardCommand: WalkForward, forwardHoldKey: 1)));
    }

    [Fact]
    [Behaviour("server.translation.backwards", "spec/08, 8.8; spec/01, 6")]
    public void Backwards_is_a_walk_at_minus_sixty_five_hundredths_of_the_rate()
    {
        Assert.Equal(
            new WireInterpretedMotion(forwardCommand: 0x05, forwardSpeed: -1.72249997f),
            Interpret(new WireRawMotion(RunKey, forwardCommand: WalkBackwards)));
        Assert.Equal(
            new WireInterpretedMotion(forwardCommand: 0x05, forwardSpeed: -0.649999976f),
            Interpret(new WireRawMotion(forwardCommand: WalkBackwards)));
    }

    [Theory]
    [Behaviour("server.translation.sidestep", "spec/08, 8.8; spec/01, 6")]
    [InlineData(1u, SideStepRight, RunRate, 1.24799991f)]
    [InlineData(1u, SideStepLeft, RunRate, -1.24799991f)]
    [InlineData(RunKey, SideStepRight, 2f, 2.49599981f)]
    [InlineData(RunKey, SideStepRight, RunRate, 3f)]
    [InlineData(RunKey, SideStepLeft, RunRate, -3f)]
    public void A_sidestep_goes_at_the_rate_times_1248_thousandths_and_at_most_at_three(uint holdKey, uint command, float rate,
        float speed) =>
        Assert.Equal(
            new WireInterpretedMotion(sidestepCommand: 0x0F, sidestepSpeed: speed),
            Interpret(new WireRawMotion(holdKey, sidestepCommand: command), rate));

    [Theory]
    [Behaviour("server.translation.turn", "spec/08, 8.8")]
    [InlineData(RunKey, TurnRight, 1f, 1.5f)]
    [InlineData(RunKey, TurnLeft, 1f, -1.5f)]
    [InlineData(1u, TurnLeft, 1f, -1f)]
    [InlineData(RunKey, TurnRight, 0.25f, 0.25f)]
    [InlineData(RunKey, TurnLeft, 1.5f, -1.5f)]
    [InlineData(RunKey, TurnRight, 1.50000012f, 1.5f)]
    [InlineData(RunKey, TurnRight, 0f, 1.5f)]
    [InlineData(1u, TurnRight, float.NaN, 1f)]
    [InlineData(1u, TurnRight, float.NegativeInfinity, 1f)]
    public void A_turn_goes_at_its_own_speed_or_at_one_and_a_half_in_the_run(uint holdKey, uint command, float asked, float speed)
    {
        WireInterpretedMotion state = Interpret(new WireRawMotion(holdKey, turnCommand: command, turnSpeed: asked));
        Assert.Equal(new WireInterpretedMotion(turnCommand: 0x0D, turnSpeed: speed == 1f ? null : speed), state);
    }

    [Fact]
    [Behaviour("server.translation.long-jump-stands", "spec/08, 8.8")]
    public void Who_charges_a_long_jump_stands_and_turns()
    {
        WireRawMotion raw = new(RunKey, forwardCommand: WalkForward, sidestepCommand: SideStepLeft, turnCommand: TurnLeft);
        MovementData movement = MotionTranslation.Interpret(raw, RunRate, standingLongJump: true);
        Assert.True(movement.StandingLongJump);
        Assert.Equal(new WireInterpretedMotion(turnCommand: 0x0D, turnSpeed: -1.5f), movement.State);
    }

    [Fact]
    [Behaviour("server.translation.absent-stays-absent", "spec/08, 8.8 and 10")]
    public void What_was_not_asked_is_left_out_and_a_style_only_sent_when_there_is_one()
    {
        Assert.Equal(MovementData.Motion(0, new WireInterpretedMotion()),
            MotionTranslation.Interpret(new WireRawMotion(RunKey), RunRate, false));
        Assert.Equal(
            MovementData.Motion(0x3E, new WireInterpretedMotion(style: 0x3E, forwardCommand: 0x13)),
            MotionTranslation.Interpret(new WireRawMotion(RunKey, SwordCombat, Sitting), RunRate, false));
    }
}
