using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class MotionStateTests
{
    private const MotionCommand Bow = HumanoidTable.Bow;

    [Fact]
    [Behaviour("motion.parameters.defaults", "spec/01, 2.4; MovementParameters @0x00524380")]
    public void Parameters_begin_with_the_defaults_of_retail()
    {
        MovementParameters p = new();
        Assert.Equal(0x1EE0Fu, (uint)p.Flags);
        Assert.Equal(0x3F19999Au, BitConverter.SingleToUInt32Bits(p.DistanceToObject));
        Assert.Equal(0x7F7FFFFFu, BitConverter.SingleToUInt32Bits(p.FailDistance));
        Assert.Equal(15f, p.WalkRunThreshold);
        Assert.Equal(1f, p.Speed);
        Assert.Equal(HoldKey.Invalid, p.HoldKey);
    }

    [Fact]
    [Behaviour("motion.raw.run-is-a-hold-key", "spec/01, 2.2; RawMotionState::ApplyMotion @0x0051EB60")]
    public void Run_forward_does_not_enter_the_raw_state()
    {
        RawMotionState raw = new();
        raw.ApplyMotion(MotionCommand.RunForward, new MovementParameters());
        Assert.Equal(MotionCommand.Ready, raw.ForwardCommand);
    }

    [Fact]
    [Behaviour("motion.raw.set-hold-key-leaves-no-key-of-its-own", "spec/01, 2.2")]
    public void The_hold_key_of_a_command_is_kept_only_without_the_flag()
    {
        RawMotionState raw = new();
        MovementParameters p = new() { HoldKey = HoldKey.Run, Speed = 0.5f };
        raw.ApplyMotion(MotionCommand.WalkForward, p);
        Assert.Equal((MotionCommand.WalkForward, HoldKey.Invalid, 0.5f), (raw.ForwardCommand, raw.ForwardHoldKey, raw.ForwardSpeed));
        p.Flags &= ~MovementFlags.SetHoldKey;
        raw.ApplyMotion(MotionCommand.SideStepLeft, p);
        raw.ApplyMotion(MotionCommand.TurnLeft, p);
        Assert.Equal((MotionCommand.SideStepLeft, HoldKey.Run), (raw.SidestepCommand, raw.SidestepHoldKey));
        Assert.Equal((MotionCommand.TurnLeft, HoldKey.Run), (raw.TurnCommand, raw.TurnHoldKey));
    }

    [Fact]
    [Behaviour("motion.raw.apply-and-remove", "spec/01, 2.2; RawMotionState::RemoveMotion @0x0051E6E0")]
    public void Removing_takes_out_what_was_applied()
    {
        RawMotionState raw = new();
        MovementParameters p = new() { Speed = 2f, ActionStamp = 7 };
        raw.ApplyMotion(MotionCommand.WalkForward, p);
        raw.ApplyMotion(MotionCommand.SideStepRight, p);
        raw.ApplyMotion(MotionCommand.TurnRight, p);
        raw.ApplyMotion(Bow, p);
        Assert.Equal(new MotionAction(Bow, 2f, 7, false), raw.GetAction(0));

        raw.RemoveMotion(MotionCommand.WalkBackwards);
        Assert.Equal(MotionCommand.WalkForward, raw.ForwardCommand);
        raw.RemoveMotion(MotionCommand.WalkForward);
        raw.RemoveMotion(MotionCommand.SideStepLeft);
        raw.RemoveMotion(MotionCommand.TurnLeft);
        Assert.Equal((MotionCommand.Ready, 1f), (raw.ForwardCommand, raw.ForwardSpeed));
        Assert.Equal((MotionCommand.None, MotionCommand.None), (raw.SidestepCommand, raw.TurnCommand));
        raw.RemoveAction();
        raw.RemoveAction();
        Assert.Equal(0, raw.ActionCount);
    }

    [Fact]
    [Behaviour("motion.raw.new-style-ends-forward", "spec/01, 2.2")]
    public void A_new_style_ends_the_forward_command_and_the_same_one_does_not()
    {
        RawMotionState raw = new();
        raw.ApplyMotion(MotionCommand.WalkForward, new MovementParameters());
        raw.ApplyMotion(MotionCommand.NonCombat, new MovementParameters());
        Assert.Equal(MotionCommand.WalkForward, raw.ForwardCommand);
        raw.ApplyMotion(MotionCommand.DualWieldCombat, new MovementParameters());
        Assert.Equal((MotionCommand.Ready, MotionCommand.DualWieldCombat), (raw.ForwardCommand, raw.CurrentStyle));
        raw.RemoveMotion(MotionCommand.DualWieldCombat);
        Assert.Equal(MotionCommand.NonCombat, raw.CurrentStyle);
    }

    [Fact]
    [Behaviour("motion.interpreted.apply-and-remove", "spec/01, 2.3; InterpretedMotionState::ApplyMotion @0x0051EA40")]
    public void The_interpreted_state_knows_only_the_right_hand_commands()
    {
        InterpretedMotionState state = new();
        MovementParameters p = new() { Speed = -0.5f };
        state.ApplyMotion(MotionCommand.RunForward, p);
        state.ApplyMotion(MotionCommand.SideStepRight, p);
        state.ApplyMotion(MotionCommand.TurnRight, p);
        Assert.Equal((MotionCommand.RunForward, -0.5f), (state.ForwardCommand, state.ForwardSpeed));
        Assert.Equal((-0.5f, -0.5f), (state.SidestepSpeed, state.TurnSpeed));
        InterpretedMotionState copy = new();
        copy.CopyMovementFrom(state);
        state.RemoveMotion(MotionCommand.RunForward);
        state.RemoveMotion(MotionCommand.SideStepRight);
        state.RemoveMotion(MotionCommand.TurnRight);
        Assert.Equal((MotionCommand.Ready, MotionCommand.None, MotionCommand.None),
            (state.ForwardCommand, state.SidestepCommand, state.TurnCommand));
        state.CopyMovementFrom(copy);
        Assert.Equal(MotionCommand.RunForward, state.ForwardCommand);
    }

    [Fact]
    [Behaviour("motion.raw.copy-is-independent", "spec/01, 2.2")]
    public void A_copy_lives_its_own_life()
    {
        RawMotionState raw = new() { CurrentHoldKey = HoldKey.Run };
        for (uint i = 0; i < 20; i++) raw.AddAction(new MotionAction(Bow, 1f, i, true));
        RawMotionState copy = new();
        copy.CopyFrom(raw);
        raw.RemoveAction();
        Assert.Equal((19, 20), (raw.ActionCount, copy.ActionCount));
        Assert.Equal((1u, 0u), (raw.GetAction(0).Stamp, copy.GetAction(0).Stamp));
        Assert.Equal(HoldKey.Run, copy.CurrentHoldKey);
    }
}
