using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

public class JumpKeyTests
{
    /// <summary>A player who has control and stands.</summary>
    private static KeyFixture InControl()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.None, 30);
        f.Sent.Moves.Clear();
        return f;
    }

    [Theory]
    [Behaviour("controller.jump.charges-in-one-second", "spec/01, 4.12; spec/09b, 14.8; ClientCombatSystem::GetPowerBarLevel @0x0056ADE0")]
    [InlineData(false, 0.0, 0f)]
    [InlineData(false, 0.25, 0.25f)]
    [InlineData(false, 0.999, 0.999000013f)]
    [InlineData(false, 1.0, 1f)]
    [InlineData(false, 3.0, 1f)]
    [InlineData(false, -1.0, 0f)]
    [InlineData(true, 0.4, 0.5f)]
    [InlineData(true, 0.8, 1f)]
    public void A_jump_charges_in_a_second_and_stays_full(bool twoWeapons, double time, float level)
    {
        KeyFixture f = new() { Now = 0 };
        f.Controller.Update(MovementKeys.Jump, 0);
        Assert.True(f.Controller.IsChargingJump);
        if (twoWeapons) f.Interpreter.Interpreted.CurrentStyle = MotionCommand.DualWieldCombat;
        Assert.Equal(level, f.Controller.JumpLevel(time));
    }

    [Theory]
    [Behaviour("controller.jump.tap-is-the-least", "spec/01, 4.12; spec/09b, 14.8")]
    [InlineData(0.0)]
    [InlineData(0.0005)]
    public void A_tap_jumps_the_least(double time)
    {
        KeyFixture f = new();
        f.Controller.Update(MovementKeys.Jump, 10);
        f.Controller.Update(MovementKeys.None, 10 + time);
        SentJump e = Assert.Single(f.Sent.Jumps);
        Assert.Equal((0.001f, new Vector3(0, 0, 2.61916018f)), (e.Extent, e.Velocity));
    }

    [Fact]
    [Behaviour("controller.jump.charge-is-told", "spec/01, 4.12; spec/09b, 14.8 K7 and K8")]
    public void The_accepted_charge_is_told_with_the_long_jump_bit_and_keys_meanwhile_as_well()
    {
        KeyFixture f = InControl();
        f.Press(MovementKeys.Jump);
        SentMove charge = Assert.Single(f.Sent.Moves);
        Assert.Equal((HoldKey.Run, MotionCommand.Ready, true, true),
            (charge.State.CurrentHoldKey, charge.State.ForwardCommand, charge.Contact, charge.StandingLongJump));

        f.Press(MovementKeys.Jump | MovementKeys.Forward, 5);
        Assert.Equal(2, f.Sent.Moves.Count);
        Assert.Equal((MotionCommand.WalkForward, true, true),
            (f.LastSent.State.ForwardCommand, f.LastSent.Contact, f.LastSent.StandingLongJump));
        Assert.Equal((MotionCommand.WalkForward, MotionCommand.Ready), (f.Raw.ForwardCommand, f.Movement.Animation!.Substate));
    }

    [Fact]
    [Behaviour("controller.jump.charge-while-moving-is-no-long-jump", "spec/01, 4.12")]
    public void A_charge_in_the_run_is_told_without_the_long_jump_bit()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Jump);
        Assert.Equal(2, f.Sent.Moves.Count);
        Assert.Equal((MotionCommand.WalkForward, false), (f.LastSent.State.ForwardCommand, f.LastSent.StandingLongJump));
    }

    [Fact]
    [Behaviour("controller.jump.standing-long-jump", "spec/01, 4.12 and 6; spec/09b, 14.8 K9")]
    public void A_standing_long_jump_stands_until_it_goes_where_the_keys_point()
    {
        KeyFixture f = InControl();
        f.Controller.Update(MovementKeys.Jump, 10);
        f.Controller.Update(MovementKeys.Jump | MovementKeys.Forward, 10.1);
        int sent = f.Sent.Moves.Count;
        f.Controller.Update(MovementKeys.Forward, 10.25);
        SentJump e = Assert.Single(f.Sent.Jumps);
        Assert.Equal((0.25f, new Vector3(0, 10.6000004f, 4.54326439f)), (e.Extent, e.Velocity));
        Assert.Equal(sent, f.Sent.Moves.Count);
        Assert.False(f.Interpreter.StandingLongJump);
    }

    [Fact]
    [Behaviour("controller.jump.release-jumps", "spec/01, 4.12 and 6; ClientCombatSystem::DoJump @0x0056B110")]
    public void Letting_go_jumps_and_tells_extent_and_velocity()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Press(MovementKeys.Forward | MovementKeys.Jump, 40);
        f.Press(MovementKeys.Forward);
        SentJump e = Assert.Single(f.Sent.Jumps);
        Assert.Equal(1f, e.Extent);
        Assert.Equal(new Vector3(0, 10.6000004f, 9.08652878f), e.Velocity);
        Assert.False(f.OnWalkable);
        Assert.False(f.Controller.IsChargingJump);
        Assert.Equal(0f, f.Controller.JumpLevel(f.Now));
    }

    [Fact]
    [Behaviour("controller.jump.refused-in-the-air-but-charged", "spec/01, 4.12; spec/09b, 14.8 K10")]
    public void In_the_air_a_jump_is_charged_and_refused_only_when_it_comes()
    {
        KeyFixture f = InControl();
        (f.HasContact, f.OnWalkable) = (false, false);
        f.Press(MovementKeys.Jump);
        Assert.True(f.Controller.IsChargingJump);
        SentMove charge = Assert.Single(f.Sent.Moves);
        Assert.Equal((false, false), (charge.Contact, charge.StandingLongJump));
        f.Press(MovementKeys.None);
        Assert.Empty(f.Sent.Jumps);
        Assert.Equal(MotionError.NotOnGround, f.Controller.LastRefusal);
        Assert.Single(f.Sent.Moves);

        f.Press(MovementKeys.Jump, 10);
        (f.HasContact, f.OnWalkable) = (true, true);
        f.Press(MovementKeys.None);
        Assert.Single(f.Sent.Jumps);
    }

    [Fact]
    [Behaviour("controller.jump.edge-keeps-the-charge", "spec/01, 4.12; spec/09b, 10")]
    public void Walking_off_an_edge_ends_the_long_jump_but_not_the_charge()
    {
        KeyFixture f = InControl();
        f.Press(MovementKeys.Jump);
        f.SetOnWalkable(false);
        Assert.Equal((false, true), (f.Interpreter.StandingLongJump, f.Controller.IsChargingJump));
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
        Assert.Empty(f.Sent.Moves);
    }

    [Fact]
    [Behaviour("controller.jump.abort-applies-and-sends-nothing", "spec/01, 4.12; ClientCombatSystem::FinishJump @0x0056A9B0")]
    public void An_aborted_charge_applies_no_motion_sends_nothing_and_does_not_jump()
    {
        KeyFixture f = InControl();
        f.Press(MovementKeys.Jump);
        f.Press(MovementKeys.Jump | MovementKeys.Forward);
        int sent = f.Sent.Moves.Count;
        f.Controller.AbortJump();
        f.Press(MovementKeys.Jump | MovementKeys.Forward, 5);
        Assert.Equal((false, false), (f.Controller.IsChargingJump, f.Interpreter.StandingLongJump));
        Assert.Equal((MotionCommand.WalkForward, MotionCommand.Ready), (f.Raw.ForwardCommand, f.Movement.Animation!.Substate));
        f.Press(MovementKeys.Forward);
        Assert.Empty(f.Sent.Jumps);
        Assert.Equal(sent, f.Sent.Moves.Count);

        f.Press(MovementKeys.Forward | MovementKeys.Walk);
        Assert.Equal(MotionCommand.WalkForward, f.Movement.Animation.Substate);
    }

    [Fact]
    [Behaviour("controller.jump.lost-with-control", "spec/01, 4.12; spec/09b, 9.6; CommandInterpreter::LoseControlToServer @0x006B3170")]
    public void When_a_server_takes_control_the_charge_ends_and_releasing_sends_no_jump()
    {
        KeyFixture f = InControl();
        f.Press(MovementKeys.Jump, 10);
        f.Order(MotionCommand.WalkForward, 0.5f);
        Assert.Equal((false, 0f), (f.Controller.IsChargingJump, f.Controller.JumpLevel(f.Now)));
        f.Press(MovementKeys.None, 5);
        Assert.Empty(f.Sent.Jumps);
        Assert.True(f.OnWalkable);
        Assert.True(f.Controller.IsControlledByServer);
    }

    [Fact]
    [Behaviour("controller.jump.takes-no-control", "spec/09b, 9.3")]
    public void The_jump_key_does_not_take_control_from_a_server()
    {
        KeyFixture f = InControl();
        f.Order(MotionCommand.WalkForward, 0.5f);
        f.Press(MovementKeys.Jump);
        Assert.Single(f.Sent.Moves);
        Assert.True(f.Controller.IsControlledByServer);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), f.Forward);
    }
}
