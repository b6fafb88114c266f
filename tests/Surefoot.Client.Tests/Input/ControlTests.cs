using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>Who is in control: the player, a server, or nobody because the keyboard is elsewhere.</summary>
public class ControlTests
{
    [Fact]
    [Behaviour("controller.server.takes-over-until-its-motion-is-done", "spec/08, 4.3 and 5.6; spec/01, 4.14; spec/09b, 9.6")]
    public void A_servers_order_takes_over_and_held_keys_come_back_untold()
    {
        KeyFixture f = new(table: HumanoidTable.Create(links: true));
        f.Controller.SetAutoRun(true, f.Now);
        f.Press(MovementKeys.TurnLeft, 30);
        int sent = f.Sent.Moves.Count;
        f.Order(MotionCommand.WalkForward, 0.5f);
        Assert.True(f.Controller.IsControlledByServer);
        Assert.False(f.Controller.AutoRun);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        Assert.Equal(MotionCommand.None, f.Turn.Command);

        int frames = 0;
        while (f.Interpreter.MotionsPending && frames < 60)
        {
            f.Press(MovementKeys.TurnLeft);
            frames++;
        }

        Assert.InRange(frames, 1, 59);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        f.Press(MovementKeys.TurnLeft, 3);
        Assert.False(f.Controller.IsControlledByServer);
        Assert.Equal((MotionCommand.Ready, MotionCommand.TurnRight), (f.Forward.Command, f.Turn.Command));
        Assert.False(f.Controller.AutoRun);
        Assert.Equal(sent, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.server.taking-control-ends-its-corrections",
        "spec/09b, 9.6; CommandInterpreter::TakeControlFromServer @0x006B32D0")]
    public void Taking_control_stops_everything_and_ends_following_the_servers_places()
    {
        KeyFixture f = new();
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal((1, MotionCommand.Ready, MotionCommand.TurnRight), (f.InterpolationStops, f.Forward.Command, f.Turn.Command));
        f.Press(MovementKeys.None);
        f.Press(MovementKeys.Forward);
        Assert.Equal(1, f.InterpolationStops);
    }

    [Fact]
    [Behaviour("controller.server.no-key-no-return", "spec/09b, 9.6; CommandInterpreter::UseTime @0x006B3BF0")]
    public void Without_a_key_held_control_stays_with_the_server()
    {
        KeyFixture f = new();
        f.Controller.SetAutoRun(true, f.Now);
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Press(MovementKeys.None, 30);
        Assert.True(f.Controller.IsControlledByServer);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
    }

    [Fact]
    [Behaviour("controller.server.autorun-since-then-runs", "spec/09b, 9.6; CommandInterpreter::SetAutoRun @0x006B4850")]
    public void Autorun_switched_on_since_takes_control_and_runs()
    {
        KeyFixture f = new();
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.False(f.Controller.IsControlledByServer);
        f.Press(MovementKeys.None, 3);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        Assert.Single(f.Sent.Moves);
    }

    [Fact]
    [Behaviour("controller.server.key-up-only-updates-the-lists", "spec/08, 5.6; spec/09b, 9.3")]
    public void Letting_a_key_go_while_the_server_moves_changes_nothing()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 5);
        f.Order(MotionCommand.WalkForward, 0.5f);
        int sent = f.Sent.Moves.Count;
        f.Press(MovementKeys.None, 10);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        Assert.Equal(sent, f.Sent.Moves.Count);
        f.Press(MovementKeys.Back);
        Assert.Equal((MotionCommand.WalkForward, -1.72249997f), f.Forward);
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.server.walk-key-counts-meanwhile", "spec/09b, 9.6; CommandInterpreter::SetHoldRun @0x006B3370")]
    public void The_walk_key_changes_the_hold_key_also_while_the_server_moves()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 5);
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Press(MovementKeys.Walk);
        Assert.Equal(HoldKey.None, f.Raw.CurrentHoldKey);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
        f.Press(MovementKeys.Walk | MovementKeys.Forward);
        Assert.Equal((HoldKey.None, MotionCommand.WalkForward, 1f), (f.LastSent.State.CurrentHoldKey, f.Forward.Command, f.Forward.Speed));
    }

    [Fact]
    [Behaviour("controller.server.echo-is-ignored", "spec/08, 4.3 and 11.12; spec/09, 5.4")]
    public void An_echo_of_what_the_player_does_changes_nothing()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Echo(new WireInterpretedMotion(forwardCommand: 0x0007, forwardSpeed: 1.5f));
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        f.Echo(new WireInterpretedMotion());
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        Assert.False(f.Controller.IsControlledByServer);
    }

    [Fact]
    [Behaviour("controller.dead.keys-do-not-move", "spec/09b, 9.5; CommandInterpreter::MovePlayer @0x006B3F40")]
    public void Keys_do_not_move_the_dead()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward, 5);
        f.Order(MotionCommand.Dead);
        int sent = f.Sent.Moves.Count;
        f.Press(MovementKeys.Forward, 30);
        Assert.Equal((MotionCommand.Dead, true), (f.Forward.Command, f.Controller.IsControlledByServer));

        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft | MovementKeys.SidestepLeft, 5);
        Assert.Equal((MotionCommand.Dead, MotionCommand.None, MotionCommand.None), (f.Forward.Command, f.Turn.Command, f.Sidestep.Command));
        Assert.Equal(MotionCommand.Dead, f.Movement.Animation!.Substate);
        Assert.Equal(sent + 2, f.Sent.Moves.Count);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.False(f.Controller.AutoRun);
        f.Press(MovementKeys.None, 5);
        Assert.Equal(MotionCommand.Dead, f.Movement.Animation.Substate);

        f.Order(MotionCommand.Ready);
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
    }

    [Fact]
    [Behaviour("controller.dead.lets-everything-go", "spec/09b, 9.5")]
    public void A_death_that_no_server_ordered_lets_every_key_go()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.Walk, 5);
        f.Movement.DoMotion(MotionCommand.Dead, new MovementParameters());
        f.Press(MovementKeys.Forward | MovementKeys.Walk | MovementKeys.TurnLeft, 5);
        Assert.Equal((MotionCommand.Dead, MotionCommand.None), (f.Forward.Command, f.Turn.Command));
        Assert.Equal(HoldKey.Run, f.Raw.CurrentHoldKey);
        f.Controller.LoseKeyboardFocus(f.Now);
        Assert.Equal(MotionCommand.Dead, f.Forward.Command);
    }

    [Fact]
    [Behaviour("controller.focus-lost.stops", "spec/09b, 9.6; CommandInterpreter::LoseKeyboardFocus @0x006B31F0")]
    public void Losing_the_focus_lets_keys_and_charge_go_and_tells_it()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft | MovementKeys.Walk | MovementKeys.Jump, 5);
        int sent = f.Sent.Moves.Count;
        f.Controller.LoseKeyboardFocus(f.Now);
        Assert.Equal((MotionCommand.Ready, MotionCommand.None), (f.Forward.Command, f.Turn.Command));
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
        Assert.Equal((HoldKey.Run, MotionCommand.Ready), (f.LastSent.State.CurrentHoldKey, f.LastSent.State.ForwardCommand));
        f.Press(MovementKeys.None, 5);
        Assert.Empty(f.Sent.Jumps);
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.focus-lost.keeps-autorun", "spec/09b, 9.6")]
    public void Losing_the_focus_keeps_autorun()
    {
        KeyFixture f = new();
        f.Controller.SetAutoRun(true, f.Now);
        f.Press(MovementKeys.TurnLeft);
        f.Controller.LoseKeyboardFocus(f.Now);
        Assert.True(f.Controller.AutoRun);
        Assert.Equal((MotionCommand.RunForward, MotionCommand.None), (f.Forward.Command, f.Turn.Command));
        Assert.Equal((MotionCommand.WalkForward, HoldKey.Run), (f.LastSent.State.ForwardCommand, f.LastSent.State.ForwardHoldKey));
    }

    [Fact]
    [Behaviour("controller.focus-lost.untold-while-a-server-moves", "spec/09b, 9.8")]
    public void Losing_the_focus_while_a_server_moves_is_not_told()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Controller.LoseKeyboardFocus(f.Now);
        f.Press(MovementKeys.None, 30);
        Assert.Single(f.Sent.Moves);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
    }

    [Fact]
    [Behaviour("controller.disabled.is-deaf-and-silent", "spec/09b, 9.6; CommandInterpreter::Disable @0x006B3250")]
    public void A_disabled_controller_hears_no_keys_and_tells_no_positions()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Controller.Disable(f.Now);
        Assert.Equal(MotionCommand.Ready, f.LastSent.State.ForwardCommand);
        int sent = f.Sent.Moves.Count, told = f.Sent.Positions.Count;
        f.Position = f.Position with { CellId = 0xA9B40002 };
        f.Press(MovementKeys.Back | MovementKeys.Jump, 40);
        f.Controller.SetAutoRun(true, f.Now);
        f.Controller.Disable(f.Now);
        Assert.Equal((MotionCommand.Ready, false, false), (f.Forward.Command, f.Controller.IsChargingJump, f.Controller.AutoRun));
        Assert.Equal((sent, told), (f.Sent.Moves.Count, f.Sent.Positions.Count));

        f.Controller.Enable();
        f.Press(MovementKeys.Forward);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
        Assert.Equal(told + 1, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.disabled.pointer-is-silent", "spec/09b, 9.6 and 9.7; CommandInterpreter::Disable @0x006B3250")]
    public void A_controller_disabled_while_the_pointer_turns_sends_nothing_also_when_the_button_comes_up()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Controller.UseMouseTurning(true, f.Now);
        f.Controller.SetMouseButtons(left: false, right: true, f.Now);
        for (int i = 0; i < 10; i++) f.Controller.MoveMouse(100, f.Now);
        f.Controller.Disable(f.Now);
        int sent = f.Sent.Moves.Count;
        f.Press(MovementKeys.None, 90);
        f.Controller.MoveMouse(100, f.Now);
        f.Controller.SetMouseButtons(left: true, right: false, f.Now);
        f.Press(MovementKeys.None, 30);
        Assert.Equal(sent, f.Sent.Moves.Count);
        Assert.Equal(MotionCommand.None, f.Turn.Command);

        f.Controller.Enable();
        f.Controller.SetMouseButtons(left: false, right: true, f.Now);
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("controller.teleport.ends-autorun-and-is-told", "spec/09b, 9.6; CommandInterpreter::PlayerTeleported @0x006B32B0")]
    public void A_teleport_ends_autorun_and_is_told_once()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.TurnLeft);
        f.Controller.SetAutoRun(true, f.Now);
        int sent = f.Sent.Moves.Count;
        f.Controller.OnTeleported(f.Now);
        Assert.Equal((false, MotionCommand.Ready, MotionCommand.TurnRight), (f.Controller.AutoRun, f.Forward.Command, f.Turn.Command));
        f.Controller.OnTeleported(f.Now);
        Assert.Equal(sent + 2, f.Sent.Moves.Count);
    }
}
