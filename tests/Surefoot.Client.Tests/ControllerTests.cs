using System.Numerics;
using CsCheck;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

public class ControllerTests
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
    [Behaviour("controller.sends.move-to-state", "spec/08, 5.3 and 5.6")]
    public void A_move_to_state_has_the_hold_key_and_forward_speed_one()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 30);
        MoveToStateEvent e = Assert.Single(f.Sent.Moves);
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
    [Behaviour("controller.sends.hold-key-only-while-moving", "spec/08, 5.6")]
    public void The_walk_key_is_told_only_while_moving()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        Assert.Equal(2, f.Sent.Moves.Count);
        Assert.Equal(HoldKey.None, f.Sent.Moves[1].State.CurrentHoldKey);
        f.Press(MovementKeys.Walk);
        Assert.Equal(3, f.Sent.Moves.Count);
        f.Press(MovementKeys.None);
        f.Press(MovementKeys.Walk);
        Assert.Equal(3, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.keys.newest-acts-and-falls-back", "spec/01, 4.15")]
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

        // The older one is let go: the newer one goes on and nothing is sent.
        int sent = f.Sent.Moves.Count;
        f.Press(MovementKeys.Forward | MovementKeys.TurnRight);
        Assert.Equal((MotionCommand.TurnRight, 1.5f), f.Turn);
        Assert.Equal(sent, f.Sent.Moves.Count);
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.None, f.Turn.Command);
        Assert.Equal(MotionCommand.None, f.Interpreter.Raw.TurnCommand);
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
    [Behaviour("controller.autorun", "spec/01, 4.15")]
    public void Autorun_runs_until_a_key_for_ahead_or_back()
    {
        KeyFixture f = new();
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        Assert.Single(f.Sent.Moves);
        f.Press(MovementKeys.Walk);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        f.Press(MovementKeys.Back);
        Assert.False(f.Controller.AutoRun);
        Assert.Equal((MotionCommand.WalkForward, -1.72249997f), f.Forward);
        f.Press(MovementKeys.None);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
    }

    [Fact]
    [Behaviour("controller.jump.charges-in-one-second", "spec/01, 4.12; ClientCombatSystem::GetPowerBarLevel @0x0056ADE0")]
    public void A_jump_charges_in_a_second_and_stays_full()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Jump);
        double start = f.Now;
        Assert.True(f.Controller.IsChargingJump);
        Assert.Equal(0f, f.Controller.JumpLevel(start));
        Assert.Equal(0.25f, f.Controller.JumpLevel(start + 0.25));
        Assert.Equal(1f, f.Controller.JumpLevel(start + 7));
        Assert.Equal(0f, f.Controller.JumpLevel(start - 1));
        Assert.Empty(f.Sent.Moves);
        f.Interpreter.Interpreted.CurrentStyle = MotionCommand.DualWieldCombat;
        Assert.Equal(0.5f, f.Controller.JumpLevel(start + 0.4));
    }

    [Fact]
    [Behaviour("controller.jump.release-jumps", "spec/01, 4.12 and 6; ClientCombatSystem::DoJump @0x0056B110")]
    public void Letting_go_jumps_and_tells_extent_and_velocity()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Jump, 40);
        f.Press(MovementKeys.Forward);
        JumpEvent e = Assert.Single(f.Sent.Jumps);
        Assert.Equal(1f, e.Extent);
        Assert.Equal(new Vector3(0, 10.6000004f, 9.08652878f), e.Velocity);
        Assert.False(f.OnWalkable);
        Assert.False(f.Controller.IsChargingJump);
        Assert.Equal(0f, f.Controller.JumpLevel(f.Now));
    }

    [Fact]
    [Behaviour("controller.jump.tap-is-the-least", "spec/01, 4.12")]
    public void A_tap_jumps_the_least()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Jump);
        f.Controller.Update(MovementKeys.None, f.Now);
        JumpEvent e = Assert.Single(f.Sent.Jumps);
        Assert.Equal((0.001f, new Vector3(0, 0, 2.61916018f)), (e.Extent, e.Velocity));
    }

    [Fact]
    [Behaviour("controller.jump.standing-long-jump", "spec/01, 4.12")]
    public void A_standing_long_jump_stands_until_it_goes_where_the_keys_point()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Jump);
        f.Press(MovementKeys.Jump | MovementKeys.Forward, 29);
        Assert.Equal(MotionCommand.Ready, f.Movement.Animation!.Substate);
        Assert.True(Assert.Single(f.Sent.Moves).StandingLongJump);
        f.Press(MovementKeys.Forward);
        JumpEvent e = Assert.Single(f.Sent.Jumps);
        Assert.Equal(10.6000004f, e.Velocity.Y);
        Assert.Equal(1f, e.Extent, 1e-6f);
    }

    [Fact]
    [Behaviour("controller.jump.refused-in-the-air-but-charged", "spec/01, 4.12")]
    public void In_the_air_a_jump_is_charged_and_refused_only_when_it_comes()
    {
        KeyFixture f = new();
        f.SetOnWalkable(false);
        f.Press(MovementKeys.Jump, 10);
        Assert.True(f.Controller.IsChargingJump);
        f.Press(MovementKeys.None);
        Assert.Empty(f.Sent.Jumps);
        Assert.Equal(MotionError.NotOnGround, f.Controller.LastRefusal);

        f.Press(MovementKeys.Jump, 10);
        f.SetOnWalkable(true);
        f.Press(MovementKeys.None);
        Assert.Single(f.Sent.Jumps);
    }

    [Fact]
    [Behaviour("controller.jump.refused-when-overloaded", "spec/01, 4.12")]
    public void The_overloaded_do_not_even_charge()
    {
        KeyFixture f = new(new PlayerWeenie(new CharacterStats(300, 300, Burden: 30000)));
        f.Press(MovementKeys.Jump, 10);
        Assert.False(f.Controller.IsChargingJump);
        Assert.Equal(MotionError.TooLoadedToJump, f.Controller.LastRefusal);
        f.Press(MovementKeys.None);
        Assert.Empty(f.Sent.Jumps);
    }

    [Fact]
    [Behaviour("controller.sends.position-each-second-of-movement", "spec/08, 5.6")]
    public void A_position_is_told_after_a_second_and_only_when_it_changed()
    {
        KeyFixture f = new();
        Assert.Single(f.Sent.Positions);
        f.Press(MovementKeys.None, 90);
        Assert.Single(f.Sent.Positions);
        f.Position = new Position(0xA9B40001, new Vector3(13, 12, 0));
        f.Press(MovementKeys.None);
        Assert.Equal(2, f.Sent.Positions.Count);
        Assert.True(f.Sent.Positions[1].Contact);
        f.Position = new Position(0xA9B40001, new Vector3(14, 12, 0));
        f.Press(MovementKeys.None, 29);
        Assert.Equal(2, f.Sent.Positions.Count);
        f.Press(MovementKeys.None, 3);
        Assert.Equal(3, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.sends.position-at-once-on-a-new-cell-or-plane", "spec/08, 5.6")]
    public void A_new_cell_or_plane_is_told_at_once_and_nothing_from_the_air()
    {
        KeyFixture f = new();
        f.Position = new Position(0xA9B40002, new Vector3(12, 25, 0));
        f.Press(MovementKeys.None);
        Assert.Equal(2, f.Sent.Positions.Count);
        f.ContactPlane = new Plane(0, 0, 1, -0.5f);
        f.Press(MovementKeys.None);
        Assert.Equal(3, f.Sent.Positions.Count);

        f.SetOnWalkable(false);
        f.Position = new Position(0xA9B40003, new Vector3(12, 49, 5));
        f.Press(MovementKeys.None, 60);
        Assert.Equal(3, f.Sent.Positions.Count);
        f.SetOnWalkable(true);
        f.Press(MovementKeys.None);
        Assert.Equal(4, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.sends.move-to-state-delays-the-position", "spec/08, 5.6")]
    public void A_move_to_state_counts_as_a_position_in_time()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.None, 20);
        f.Position = new Position(0xA9B40001, new Vector3(13, 12, 0));
        f.Press(MovementKeys.Forward, 29);
        Assert.Single(f.Sent.Positions);
        f.Press(MovementKeys.Forward, 4);
        Assert.Equal(2, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.server.takes-over-until-its-motion-is-done", "spec/08, 4.3 and 5.6; spec/01, 4.14")]
    public void A_servers_order_takes_over_and_held_keys_come_back()
    {
        KeyFixture f = new();
        f.Controller.SetAutoRun(true, f.Now);
        f.Press(MovementKeys.TurnLeft);
        InterpretedMotionState walk = new() { ForwardCommand = MotionCommand.WalkForward, ForwardSpeed = 0.5f };
        f.Controller.HandleUpdateMotion(new UpdateMotionEvent(walk, Autonomous: false));
        Assert.True(f.Controller.IsControlledByServer);
        Assert.False(f.Controller.AutoRun);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        Assert.Equal(MotionCommand.None, f.Turn.Command);

        f.Press(MovementKeys.TurnLeft, 3);
        Assert.False(f.Controller.IsControlledByServer);
        Assert.Equal((MotionCommand.Ready, MotionCommand.TurnRight), (f.Forward.Command, f.Turn.Command));
    }

    [Fact]
    [Behaviour("controller.server.key-up-only-updates-the-lists", "spec/08, 5.6")]
    public void Letting_a_key_go_while_the_server_moves_changes_nothing()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 5);
        InterpretedMotionState walk = new() { ForwardCommand = MotionCommand.WalkForward, ForwardSpeed = 0.5f };
        f.Controller.HandleUpdateMotion(new UpdateMotionEvent(walk, Autonomous: false));
        int sent = f.Sent.Moves.Count;
        f.Press(MovementKeys.None, 10);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        Assert.Equal(sent, f.Sent.Moves.Count);
        f.Press(MovementKeys.Back);
        Assert.Equal((MotionCommand.WalkForward, -1.72249997f), f.Forward);
    }

    [Fact]
    [Behaviour("controller.server.echo-is-ignored-but-its-run-rate", "spec/08, 4.3; spec/01, 4.5")]
    public void An_echo_changes_nothing_but_the_run_rate()
    {
        KeyFixture f = new(new PlayerWeenie(new CharacterStats(300, 300), RunRateSource.Server));
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 1f), f.Forward);
        f.Controller.HandleUpdateMotion(new UpdateMotionEvent(new InterpretedMotionState(), Autonomous: true));
        Assert.Equal((MotionCommand.RunForward, 1f), f.Forward);
        InterpretedMotionState run = new() { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = 2.5f };
        f.Controller.HandleUpdateMotion(new UpdateMotionEvent(run, Autonomous: true));
        Assert.Equal((MotionCommand.RunForward, 2.5f), f.Forward);
        Assert.False(f.Controller.IsControlledByServer);
        Assert.Equal(new Vector3(0, 10, 0), f.Interpreter.GetStateVelocity());
    }

    [Fact]
    [Behaviour("controller.focus-lost-stops", "spec/08, 5.6")]
    public void Losing_the_focus_stops_and_tells_it()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft | MovementKeys.Jump, 5);
        f.Controller.ReleaseAll(f.Now);
        Assert.Equal((MotionCommand.Ready, MotionCommand.None), (f.Forward.Command, f.Turn.Command));
        Assert.Equal(MotionCommand.Ready, f.Sent.Moves[^1].State.ForwardCommand);
        f.Press(MovementKeys.None, 5);
        Assert.Empty(f.Sent.Jumps);
    }

    [Fact]
    [Behaviour("controller.bad-input-changes-nothing", "design, decision 7")]
    public void A_time_that_is_no_number_is_refused_and_changes_nothing()
    {
        KeyFixture f = new();
        Assert.Throws<ArgumentException>(() => f.Controller.Update(MovementKeys.Forward, double.NaN));
        Assert.Throws<ArgumentException>(() => f.Controller.SetAutoRun(true, double.PositiveInfinity));
        InterpretedMotionState bad = new() { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = float.NaN };
        Assert.Throws<ArgumentException>(() => f.Controller.HandleUpdateMotion(new UpdateMotionEvent(bad, true)));
        Assert.Throws<ArgumentException>(() => f.Controller.HandleUpdateMotion(new UpdateMotionEvent(bad, false)));
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
            return f.Forward.Command == MotionCommand.Ready && f.Turn.Command == MotionCommand.None && f.Sidestep.Command == MotionCommand.None &&
                   f.Interpreter.Raw is { ForwardCommand: MotionCommand.Ready, SidestepCommand: MotionCommand.None, TurnCommand: MotionCommand.None };
        });
    }
}
