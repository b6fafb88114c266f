using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

public class MouseTurningTests
{
    private const double EventTime = 1.0 / 60;

    /// <summary>The option is on at sensitivity 1, and the player, who has control, holds the right button.</summary>
    private static KeyFixture Looking(MovementKeys keys = MovementKeys.None)
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Back);
        f.Press(keys, 3);
        f.Controller.UseMouseTurning(true, f.Now);
        f.Controller.MouseTurning.Sensitivity = 1;
        f.Sent.Moves.Clear();
        f.Controller.SetMouseButtons(left: false, right: true, f.Now);
        return f;
    }

    private static void Move(KeyFixture f, float counts, int events)
    {
        for (int i = 0; i < events; i++) f.Controller.MoveMouse(counts, f.Now += EventTime);
    }

    [Fact]
    [Behaviour("mouse.turns-from-the-sixth-event", "spec/09b, 9.7 and 14.8 K11; CameraSet::MouseLookHandler @0x00458D80")]
    public void The_sixth_movement_in_a_row_turns_the_player_and_is_told()
    {
        KeyFixture f = Looking();
        Assert.Single(f.Sent.Moves);
        Move(f, -3, 5);
        Assert.Equal((MotionCommand.None, 1), (f.Raw.TurnCommand, f.Sent.Moves.Count));
        Move(f, -3, 1);
        Assert.Equal((MotionCommand.TurnRight, 0.400000036f, HoldKey.Run), (f.Raw.TurnCommand, f.Raw.TurnSpeed, f.Raw.TurnHoldKey));
        Assert.Equal((MotionCommand.TurnRight, (float)(1.5 * 0.400000036f)), f.Turn);
        Assert.Equal(2, f.Sent.Moves.Count);
        Assert.Equal(
            (HoldKey.Run, MotionCommand.Ready, MotionCommand.TurnRight, 0.400000036f, HoldKey.Run),
            (f.LastSent.State.CurrentHoldKey, f.LastSent.State.ForwardCommand, f.LastSent.State.TurnCommand, f.LastSent.State.TurnSpeed,
                f.LastSent.State.TurnHoldKey));
    }

    [Fact]
    [Behaviour("mouse.wire-words", "spec/09b, 14.8 K11; spec/08, 5.3")]
    public void The_pointers_turn_is_told_with_its_own_speed_and_hold_key()
    {
        KeyFixture f = Looking();
        Move(f, -3, 6);
        Assert.Equal("01070000020000000D00006502000000CECCCC3E", f.SentWords(20));
    }

    [Fact]
    [Behaviour("mouse.row-is-broken-by-no-movement", "spec/09b, 9.7")]
    public void A_movement_of_nothing_begins_the_count_anew()
    {
        KeyFixture f = Looking();
        Move(f, 3, 5);
        Move(f, 0, 1);
        Move(f, 3, 5);
        Assert.Equal(MotionCommand.None, f.Raw.TurnCommand);
        Move(f, 3, 1);
        Assert.Equal(MotionCommand.TurnLeft, f.Raw.TurnCommand);
    }

    [Theory]
    [Behaviour("mouse.speed", "spec/09b, 9.7 and 14.8; CameraSet::Rotate @0x00458310")]
    [InlineData(1f, 0.13333334f, 0.20000001f)]
    [InlineData(10f, 1.33333337f, 2f)]
    [InlineData(12f, 1.5f, 2.25f)]
    [InlineData(200f, 1.5f, 2.25f)]
    public void The_player_turns_as_fast_as_the_pointer_moves_up_to_a_limit(float counts, float speed, float turning)
    {
        KeyFixture f = Looking();
        Move(f, -counts, 6);
        Assert.Equal((MotionCommand.TurnRight, speed), (f.Raw.TurnCommand, f.Raw.TurnSpeed));
        Assert.Equal(turning, f.Turn.Speed, 1e-6f);
    }

    [Fact]
    [Behaviour("mouse.dead-zone-stops", "spec/09b, 9.7 and 14.8; CommandInterpreter::StopDrift @0x006B4510")]
    public void A_movement_too_small_stops_the_turn()
    {
        KeyFixture f = Looking();
        Move(f, -3, 6);
        Move(f, -0.2f, 1);
        Assert.Equal((MotionCommand.None, MotionCommand.None), (f.Raw.TurnCommand, f.Turn.Command));
    }

    [Theory]
    [Behaviour("mouse.direction", "spec/09b, 9.7 and 15.6")]
    [InlineData(false, MotionCommand.TurnLeft, -2.25f)]
    [InlineData(true, MotionCommand.TurnRight, 2.25f)]
    public void The_pointer_to_the_right_turns_left_as_a_camera_would_or_right_when_inverted(bool inverted, MotionCommand turn, float speed)
    {
        KeyFixture f = Looking();
        f.Controller.MouseTurning.Inverted = inverted;
        Move(f, 20, 6);
        Assert.Equal((turn, speed), (f.Raw.TurnCommand, f.Turn.Speed));
    }

    [Fact]
    [Behaviour("mouse.tells-at-most-twice-a-second", "spec/09b, 9.7 and 9.8")]
    public void While_turning_at_most_two_move_to_states_a_second_are_sent()
    {
        KeyFixture f = Looking();
        f.Sent.Moves.Clear();
        Move(f, 3, 300);
        Assert.InRange(f.Sent.Moves.Count, 9, 10);
        for (int i = 1; i < f.Sent.Moves.Count; i++) Assert.True(f.Sent.Moves[i].Time - f.Sent.Moves[i - 1].Time > 0.5);
    }

    [Fact]
    [Behaviour("mouse.rest-stops-after-a-fifth-of-a-second", "spec/09b, 9.7")]
    public void A_pointer_that_rests_stops_the_turn_after_a_fifth_of_a_second()
    {
        KeyFixture f = Looking();
        Move(f, 3, 6);
        double last = f.Now;
        f.Controller.Update(MovementKeys.None, last + 0.2);
        Assert.Equal(MotionCommand.TurnLeft, f.Raw.TurnCommand);
        f.Controller.Update(MovementKeys.None, last + 0.201);
        Assert.Equal(MotionCommand.None, f.Raw.TurnCommand);
        f.Sent.Moves.Clear();
        f.Controller.Update(MovementKeys.None, last + 0.501);
        Assert.Equal(MotionCommand.None, Assert.Single(f.Sent.Moves).State.TurnCommand);
    }

    [Fact]
    [Behaviour("mouse.smoothing", "spec/09b, 9.7; CameraSet::FilterMouseInput @0x00457530")]
    public void Smoothing_averages_with_the_movement_before_for_a_quarter_of_a_second()
    {
        MouseTurning mouse = new() { Sensitivity = 1, Smoothing = 0.5f };
        Assert.False(mouse.Filter(10, 1.0, out float turn));
        Assert.Equal(10f / 15, turn, 1e-6f);
        mouse.Filter(0, 1.1, out turn);
        Assert.Equal(2.5f / 15, turn, 1e-6f);
        mouse.Filter(8, 1.35, out turn);
        Assert.Equal(((8 * 0.5f) + ((2.5f + 8) / 2 * 0.5f)) / 15, turn, 1e-6f);
        mouse.Filter(8, 1.61, out turn);
        Assert.Equal(8f / 15, turn, 1e-6f);
    }

    [Fact]
    [Behaviour("mouse.smoothing-turns-on-after-the-rest", "spec/09b, 9.7")]
    public void With_smoothing_a_resting_pointer_turns_on_until_it_has_died_away()
    {
        KeyFixture f = Looking();
        f.Controller.MouseTurning.Smoothing = 1;
        Move(f, 3, 6);
        double rest = f.Now + 0.201;
        f.Controller.Update(MovementKeys.None, rest);
        Assert.Equal((MotionCommand.TurnLeft, 0.2f), (f.Raw.TurnCommand, MathF.Round(f.Raw.TurnSpeed, 4)));
        f.Controller.Update(MovementKeys.None, rest + 0.03);
        f.Controller.Update(MovementKeys.None, rest + 0.06);
        Assert.Equal((MotionCommand.TurnLeft, 0.05f), (f.Raw.TurnCommand, MathF.Round(f.Raw.TurnSpeed, 4)));
        f.Controller.Update(MovementKeys.None, rest + 0.09);
        Assert.Equal(MotionCommand.None, f.Raw.TurnCommand);
    }

    [Fact]
    [Behaviour("mouse.off-does-nothing", "spec/09b, 9.7")]
    public void With_the_option_off_buttons_and_pointer_do_nothing()
    {
        KeyFixture f = new();
        Assert.False(f.Controller.UsesMouseTurning);
        f.Controller.SetMouseButtons(left: false, right: true, f.Now);
        f.Controller.SetMouseButtons(left: true, right: true, f.Now);
        Move(f, 20, 20);
        f.Controller.SetMouseButtons(left: false, right: false, f.Now);
        Assert.Empty(f.Sent.Moves);
        Assert.Equal((MotionCommand.Ready, MotionCommand.None), (f.Raw.ForwardCommand, f.Raw.TurnCommand));
    }

    [Fact]
    [Behaviour("mouse.option-off-ends-the-look", "spec/09b, 9.7")]
    public void Switching_the_option_off_ends_the_turn()
    {
        KeyFixture f = Looking();
        Move(f, 3, 6);
        f.Controller.UseMouseTurning(false, f.Now);
        Assert.Equal(MotionCommand.None, f.Turn.Command);
        Move(f, 3, 20);
        f.Controller.SetMouseButtons(left: false, right: false, f.Now);
        Assert.Equal(MotionCommand.None, f.Turn.Command);
    }

    [Fact]
    [Behaviour("mouse.release-ends-the-turn-and-is-told", "spec/09b, 9.7 and 9.8; CameraSet::ToggleMouseLook @0x00457490")]
    public void Letting_the_button_go_ends_the_turn_and_is_told()
    {
        KeyFixture f = Looking();
        Move(f, 3, 6);
        int sent = f.Sent.Moves.Count;
        f.Controller.SetMouseButtons(left: false, right: false, f.Now);
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
        Assert.Equal((MotionCommand.None, MotionCommand.None), (f.LastSent.State.TurnCommand, f.Turn.Command));
        Move(f, 3, 20);
        Assert.Equal(MotionCommand.None, f.Turn.Command);
    }

    [Fact]
    [Behaviour("mouse.both-buttons-run", "spec/09b, 9.7; CommandInterpreter::HandleSelectLeft @0x006B3630")]
    public void Both_buttons_run_ahead_whatever_the_walk_key_says()
    {
        KeyFixture f = Looking(MovementKeys.Walk);
        f.Controller.SetMouseButtons(left: true, right: true, f.Now);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        Assert.Equal((HoldKey.None, MotionCommand.WalkForward, HoldKey.Run),
            (f.LastSent.State.CurrentHoldKey, f.LastSent.State.ForwardCommand, f.LastSent.State.ForwardHoldKey));
        f.Controller.SetMouseButtons(left: false, right: true, f.Now);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
        Assert.Equal(3, f.Sent.Moves.Count);

        f.Controller.SetMouseButtons(left: false, right: false, f.Now);
        f.Controller.SetMouseButtons(left: true, right: false, f.Now);
        Assert.Equal(MotionCommand.Ready, f.Forward.Command);
        f.Controller.SetMouseButtons(left: true, right: true, f.Now);
        Assert.Equal(MotionCommand.RunForward, f.Forward.Command);
    }

    [Theory]
    [Behaviour("mouse.look-makes-sidesteps-of-turns", "spec/09b, 9.7")]
    [InlineData(MovementKeys.TurnRight, MotionCommand.SideStepRight)]
    [InlineData(MovementKeys.TurnLeft, MotionCommand.SideStepLeft)]
    [InlineData(MovementKeys.TurnRight | MovementKeys.SidestepLeft, MotionCommand.SideStepLeft)]
    [InlineData(MovementKeys.TurnRight | MovementKeys.SidestepRight, MotionCommand.SideStepRight)]
    [InlineData(MovementKeys.TurnLeft | MovementKeys.SidestepLeft, MotionCommand.SideStepLeft)]
    public void A_turn_held_when_the_look_begins_becomes_a_sidestep_and_a_turn_again_after_it(MovementKeys keys, MotionCommand sidestep)
    {
        KeyFixture f = Looking(keys);
        Assert.Equal((sidestep, MotionCommand.None), (f.Raw.SidestepCommand, f.Raw.TurnCommand));
        Assert.Single(f.Sent.Moves);
        f.Controller.SetMouseButtons(left: false, right: false, f.Now);
        MotionCommand turn = (keys & MovementKeys.TurnRight) != 0 ? MotionCommand.TurnRight : MotionCommand.TurnLeft;
        bool stepping = (keys & (MovementKeys.SidestepLeft | MovementKeys.SidestepRight)) != 0;
        Assert.Equal((turn, HoldKey.Invalid), (f.Raw.TurnCommand, f.Raw.TurnHoldKey));
        Assert.Equal(stepping ? sidestep : MotionCommand.None, f.Raw.SidestepCommand);
    }

    [Fact]
    [Behaviour("mouse.look-stops-the-right-turn-for-a-left-one", "spec/09b, 9.7")]
    public void With_left_turn_and_right_sidestep_held_the_look_steps_right()
    {
        KeyFixture f = Looking(MovementKeys.TurnLeft | MovementKeys.SidestepRight);
        Assert.Equal(MotionCommand.SideStepRight, f.Raw.SidestepCommand);
        Assert.Equal(MotionCommand.None, f.Raw.TurnCommand);
    }

    [Fact]
    [Behaviour("mouse.turn-keys-step-sideways-during-a-look", "spec/09b, 9.7")]
    public void During_a_look_the_turn_keys_step_sideways()
    {
        KeyFixture f = Looking();
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal((MotionCommand.SideStepLeft, HoldKey.Invalid, MotionCommand.None),
            (f.Raw.SidestepCommand, f.Raw.SidestepHoldKey, f.Raw.TurnCommand));
        f.Press(MovementKeys.TurnLeft | MovementKeys.TurnRight);
        Assert.Equal(MotionCommand.SideStepRight, f.Raw.SidestepCommand);
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(MotionCommand.SideStepLeft, f.Raw.SidestepCommand);
        f.Press(MovementKeys.None);
        Assert.Equal((MotionCommand.None, MotionCommand.None), (f.Raw.SidestepCommand, f.Raw.TurnCommand));
    }

    [Fact]
    [Behaviour("mouse.other-keys-stop-the-turn-of-the-pointer", "spec/09b, 9.7")]
    public void Another_key_during_a_look_stops_the_pointers_turn_until_it_moves_again()
    {
        KeyFixture f = Looking();
        Move(f, 3, 6);
        f.Controller.Update(MovementKeys.Forward, f.Now);
        Assert.Equal((MotionCommand.WalkForward, MotionCommand.None), (f.Raw.ForwardCommand, f.Raw.TurnCommand));
        Move(f, 3, 1);
        Assert.Equal((MotionCommand.WalkForward, MotionCommand.TurnLeft), (f.Raw.ForwardCommand, f.Raw.TurnCommand));
    }

    [Fact]
    [Behaviour("mouse.autorun-turns-while-a-turn-key-is-held", "spec/09b, 9.7")]
    public void With_the_option_on_autorun_switched_on_while_turning_turns_on()
    {
        KeyFixture f = new();
        f.Controller.UseMouseTurning(true, f.Now);
        f.Press(MovementKeys.TurnLeft);
        f.Controller.SetAutoRun(true, f.Now);
        Assert.Equal((true, MotionCommand.Ready, MotionCommand.TurnLeft), (f.Controller.AutoRun, f.Raw.ForwardCommand, f.Raw.TurnCommand));
    }
}
