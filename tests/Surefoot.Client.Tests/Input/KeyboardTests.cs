using CsCheck;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using WireAction = Surefoot.Protocol.Messages.MotionAction;

namespace Surefoot.Client.Tests;

public class KeyboardTests
{
    [Fact]
    [Behaviour("controller.forward.runs-by-default", "spec/01, 4.15")]
    public void Forward_runs_and_walk_walks()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        Assert.Equal((MotionCommand.WalkForward, 1f), f.Forward);
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.Ready, 1f), f.Forward);
    }

    [Fact]
    [Behaviour("controller.forward.walk-as-default", "spec/01, 4.15")]
    public void With_walking_as_the_default_the_walk_key_runs()
    {
        KeyFixture f = new() { Controller = { RunAsDefault = false } };
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.WalkForward, f.Forward.Command);
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
    }

    [Fact]
    [Behaviour("controller.forward.changed-default-acts-at-once-untold", "spec/09b, 9.6; PlayerModule @0x0058B2D0")]
    public void A_changed_default_acts_at_once_whatever_the_walk_key_does()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        int sent = f.Sent.Moves.Count;
        f.Controller.RunAsDefault = false;
        Assert.Equal(MotionCommand.WalkForward, f.Forward.Command);
        f.Controller.RunAsDefault = true;
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        f.Press(MovementKeys.Forward | MovementKeys.Walk, 5);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        Assert.Equal(sent, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.sends.move-to-state", "spec/08, 5.3 and 5.6; spec/09b, 14.8 K1")]
    public void A_move_to_state_has_the_hold_key_and_forward_speed_one()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 30);
        SentMove e = Assert.Single(f.Sent.Moves);
        Assert.Equal(
            (HoldKey.Run, MotionCommand.WalkForward, HoldKey.Invalid, 1f),
            (e.State.CurrentHoldKey, e.State.ForwardCommand, e.State.ForwardHoldKey, e.State.ForwardSpeed));
        Assert.True(e.Contact);
        Assert.False(e.StandingLongJump);

        f.Press(MovementKeys.None);
        Assert.Equal(MotionCommand.Ready, f.Sent.Moves[1].State.ForwardCommand);
        Assert.Equal(MotionCommand.WalkForward, e.State.ForwardCommand);
    }

    [Fact]
    [Behaviour("controller.sends.nothing-for-the-walk-key", "spec/01, 4.15; spec/09b, 14.8 K2 and K3")]
    public void The_walk_key_alone_sends_nothing_and_what_is_sent_next_carries_it()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Walk, 5);
        Assert.Single(f.Sent.Moves);
        Assert.Equal((HoldKey.None, MotionCommand.WalkForward, 1f), (f.Raw.CurrentHoldKey, f.Forward.Command, f.Forward.Speed));

        f.Press(MovementKeys.Forward | MovementKeys.Walk | MovementKeys.TurnRight);
        Assert.Equal(2, f.Sent.Moves.Count);
        Assert.Equal(
            (HoldKey.None, MotionCommand.WalkForward, MotionCommand.TurnRight),
            (f.LastSent.State.CurrentHoldKey, f.LastSent.State.ForwardCommand, f.LastSent.State.TurnCommand));

        f.Press(MovementKeys.Walk, 5);
        int standing = f.Sent.Moves.Count;
        f.Press(MovementKeys.None, 5);
        f.Press(MovementKeys.Walk, 5);
        Assert.Equal(standing, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.sends.wire-words", "spec/09b, 14.8 K1, K3, K4 and K7; spec/08, 5.3")]
    public void The_wire_tells_the_forward_key_from_autorun_by_its_words()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        Assert.Equal("050000000200000005000045", f.SentWords(12));
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        f.Press(MovementKeys.Forward | MovementKeys.Walk | MovementKeys.TurnRight);
        Assert.Equal("04010000050000450D000065", f.SentWords(12));
        f.Press(MovementKeys.Walk);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal("0C0000000500004502000000", f.SentWords(12));
        f.Controller.SetAutoRun(false, f.Now);
        f.Press(MovementKeys.Walk | MovementKeys.Forward);
        Assert.Equal("0400000005000045", f.SentWords(8));
        f.Press(MovementKeys.None);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal("0D000000020000000500004502000000", f.SentWords(16));
        f.Controller.SetAutoRun(false, f.Now);
        f.Press(MovementKeys.Jump);
        Assert.Equal("0100000002000000", f.SentWords(8));
    }

    [Fact]
    [Behaviour("controller.keys.newest-acts-and-falls-back", "spec/01, 4.15; spec/09b, 9.4")]
    public void The_newest_key_acts_and_letting_it_go_falls_back()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Back);
        Assert.Equal((MotionCommand.WalkForward, -1.72249997f), f.Forward);
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);

        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft);
        Assert.Equal((MotionCommand.TurnRight, -1.5f), f.Turn);
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft | MovementKeys.TurnRight);
        Assert.Equal((MotionCommand.TurnRight, 1.5f), f.Turn);

        // The older one is let go: the newer one goes on.
        f.Press(MovementKeys.Forward | MovementKeys.TurnRight);
        Assert.Equal((MotionCommand.TurnRight, 1.5f), f.Turn);
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.None, f.Turn.Command);
        Assert.Equal(MotionCommand.None, f.Raw.TurnCommand);
    }

    [Theory]
    [Behaviour("controller.sends.every-key-up", "spec/09b, 9.4 and 14.8 K5 and K6")]
    [InlineData(MovementKeys.Back, MotionCommand.WalkBackwards, 1)]
    [InlineData(MovementKeys.Forward, MotionCommand.WalkForward, 0)]
    public void Each_key_up_is_told_also_that_of_a_key_that_did_not_act(MovementKeys kept, MotionCommand acting, int sameAs)
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Back);
        f.Press(kept);
        Assert.Equal(3, f.Sent.Moves.Count);
        Assert.Equal(acting, f.Raw.ForwardCommand);
        SentState third = f.Sent.Moves[2].State, same = f.Sent.Moves[sameAs].State;
        Assert.Equal(
            (same.CurrentHoldKey, same.ForwardCommand, same.ForwardHoldKey, same.ForwardSpeed),
            (third.CurrentHoldKey, third.ForwardCommand, third.ForwardHoldKey, third.ForwardSpeed));
    }

    [Fact]
    [Behaviour("controller.keys.last-up-stops-its-own-command", "spec/01, 4.15; spec/09b, 9.4")]
    public void Releasing_the_last_key_stops_its_command_and_orders_nothing_else()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Movement.DoMotion(MotionCommand.Crouch, new MovementParameters());
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.Crouch, MotionCommand.Crouch), (f.Forward.Command, f.Raw.ForwardCommand));
        Assert.Equal(2, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.keys.sidestep", "spec/01, 4.2 and 4.15")]
    public void Sidesteps_are_capped_and_signed()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.SidestepLeft);
        Assert.Equal((MotionCommand.SideStepRight, -3f), f.Sidestep);
        f.Press(MovementKeys.SidestepLeft | MovementKeys.Walk);
        Assert.Equal((MotionCommand.SideStepRight, -1.24799991f), f.Sidestep);
        f.Press(MovementKeys.None);
        Assert.Equal(MotionCommand.None, f.Sidestep.Command);
        Assert.Equal(MotionCommand.Ready, f.Movement.Animation!.Substate);
    }

    [Fact]
    [Behaviour("controller.keys.hold-sidestep", "spec/01, 4.15")]
    public void Holding_sidestep_makes_sidesteps_of_turns()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(MotionCommand.TurnRight, f.Turn.Command);
        f.Press(MovementKeys.TurnLeft | MovementKeys.HoldSidestep);
        Assert.Equal((MotionCommand.None, -3f), (f.Turn.Command, f.Sidestep.Speed));
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal((MotionCommand.TurnRight, MotionCommand.None), (f.Turn.Command, f.Sidestep.Command));
        f.Press(MovementKeys.TurnRight | MovementKeys.HoldSidestep);
        Assert.Equal((MotionCommand.None, 3f), (f.Turn.Command, f.Sidestep.Speed));
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.None, MotionCommand.None), (f.Turn.Command, f.Sidestep.Command));
    }

    [Fact]
    [Behaviour("controller.autorun", "spec/01, 4.15; spec/09b, 9.6")]
    public void Autorun_runs_until_a_key_for_ahead_or_back()
    {
        KeyFixture f = new();
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        Assert.Single(f.Sent.Moves);
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        f.Press(MovementKeys.Back);
        Assert.False(f.Controller.AutoRun);
        Assert.Equal((MotionCommand.WalkForward, -1.72249997f), f.Forward);
        f.Press(MovementKeys.None);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);

        f.Controller.SetAutoRun(true, f.Now);
        f.Controller.SetAutoRun(false, f.Now);
        Assert.Equal((MotionCommand.Ready, HoldKey.Invalid), (f.LastSent.State.ForwardCommand, f.LastSent.State.ForwardHoldKey));
    }

    [Fact]
    [Behaviour("controller.autorun.has-its-own-hold-key", "spec/09b, 9.5 and 14.8 K4")]
    public void Autorun_runs_by_its_own_hold_key_and_turning_follows_the_current_one()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        f.Press(MovementKeys.Walk);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal(
            (HoldKey.None, MotionCommand.WalkForward, HoldKey.Run, 1f),
            (f.LastSent.State.CurrentHoldKey, f.LastSent.State.ForwardCommand, f.LastSent.State.ForwardHoldKey,
                f.LastSent.State.ForwardSpeed));
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);

        f.Press(MovementKeys.Walk | MovementKeys.TurnRight);
        Assert.Equal((MotionCommand.TurnRight, 1f), f.Turn);
        f.Press(MovementKeys.TurnRight);
        Assert.Equal((MotionCommand.TurnRight, 1.5f), f.Turn);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
    }

    [Fact]
    [Behaviour("controller.autorun.keeps-released-keys-from-acting", "spec/09b, 9.4")]
    public void While_autorunning_releasing_a_key_held_before_changes_nothing_but_is_told()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Controller.SetAutoRun(true, f.Now);
        f.Press(MovementKeys.None);
        Assert.True(f.Controller.AutoRun);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        Assert.Equal(3, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.keys.postures-hold", "spec/09b, 9.4")]
    public void In_a_posture_keys_that_come_up_do_not_act_and_a_key_that_goes_down_ends_it()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(MotionError.None, f.Controller.Perform(MotionCommand.Crouch, f.Now));
        Assert.Equal(MotionCommand.Crouch, f.Forward.Command);
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.Crouch, MotionCommand.TurnRight), (f.Forward.Command, f.Turn.Command));
        Assert.Equal(3, f.Sent.Moves.Count);
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.None);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
    }

    [Fact]
    [Behaviour("controller.actions.stop-first-and-send-twice", "spec/09b, 9.5 and 9.8")]
    public void An_action_stops_everything_and_is_told_twice_with_the_next_stamp()
    {
        KeyFixture f = new(table: HumanoidTable.Create(links: true));
        f.Press(MovementKeys.Forward, 30);
        Assert.Equal(MotionError.None, f.Controller.Perform(HumanoidTable.Bow, f.Now));
        Assert.Equal(3, f.Sent.Moves.Count);
        Assert.Equal((MotionCommand.Ready, 0), (f.Sent.Moves[1].State.ForwardCommand, f.Sent.Moves[1].Message.Motion.Actions.Count));
        Assert.Equal(new WireAction(0x007D, 1, Autonomous: true, 1f), f.Sent.Moves[2].Message.Motion.Actions[0]);
        Assert.Equal(MotionError.None, f.Controller.Perform(HumanoidTable.Bow, f.Now));
        Assert.Equal(2, f.LastSent.Message.Motion.Actions[1].Stamp);

        f.SetOnWalkable(false);
        Assert.Equal(MotionError.NotOnGround, f.Controller.Perform(HumanoidTable.Bow, f.Now));
        Assert.Throws<ArgumentException>(() => f.Controller.Perform(MotionCommand.WalkForward, f.Now));
    }

    [Fact]
    [Behaviour("controller.stop-completely-clears-the-keys", "spec/01, 4.15; spec/09b, 9.6")]
    public void Stopping_completely_ends_keys_and_autorun_and_is_told_once()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft);
        f.Controller.SetAutoRun(true, f.Now);
        int sent = f.Sent.Moves.Count;
        f.Controller.StopCompletely(f.Now);
        Assert.Equal((MotionCommand.Ready, MotionCommand.None, false), (f.Forward.Command, f.Turn.Command, f.Controller.AutoRun));
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft, 3);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.Ready, sent + 3), (f.Forward.Command, f.Sent.Moves.Count));
    }

    [Fact]
    [Behaviour("controller.keys.state-follows-held-keys", "spec/01, 4.15")]
    public void Whatever_was_pressed_before_letting_everything_go_stands()
    {
        Gen.Int[0, 0x1FF].Select(k => (MovementKeys)k & ~MovementKeys.Jump).List[1, 40].Sample(presses =>
        {
            KeyFixture f = new();
            foreach (MovementKeys keys in presses) f.Press(keys, 2);
            MovementKeys last = presses[^1];
            bool forward = (last & (MovementKeys.Forward | MovementKeys.Back)) != 0;
            if (forward != (f.Forward.Command != MotionCommand.Ready)) return false;
            f.Press(MovementKeys.None, 2);
            return f.Forward.Command == MotionCommand.Ready && f.Turn.Command == MotionCommand.None &&
                f.Sidestep.Command == MotionCommand.None &&
                   f.Raw is { ForwardCommand: MotionCommand.Ready, SidestepCommand: MotionCommand.None, TurnCommand: MotionCommand.None };
        });
    }

    [Fact]
    [Behaviour("controller.bad-input-changes-nothing", "design, decision 7")]
    public void A_time_that_is_not_finite_is_refused_and_changes_nothing()
    {
        KeyFixture f = new();
        Assert.Throws<ArgumentException>(() => f.Controller.Update(MovementKeys.Forward, double.NaN));
        Assert.Throws<ArgumentException>(() => f.Controller.SetAutoRun(true, double.PositiveInfinity));
        Assert.Throws<ArgumentException>(() => f.Controller.Perform(MotionCommand.Crouch, double.NaN));
        Assert.Throws<ArgumentException>(() => f.Controller.MoveMouse(float.NaN, f.Now));
        Assert.Throws<ArgumentOutOfRangeException>(() => f.Controller.MouseTurning.Sensitivity = float.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => f.Controller.MouseTurning.Smoothing = 1.5f);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
        Assert.Empty(f.Sent.Moves);
    }

    [Fact]
    [Behaviour("controller.allocates-nothing-while-keys-are-held", "design, decision 4")]
    public void Holding_keys_allocates_nothing()
    {
        KeyFixture f = new();
        const MovementKeys keys = MovementKeys.Forward | MovementKeys.TurnRight | MovementKeys.SidestepLeft | MovementKeys.Jump;
        f.Press(keys, 200);
        long before = GC.GetAllocatedBytesForCurrentThread();
        f.Press(keys, 300);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }
}
