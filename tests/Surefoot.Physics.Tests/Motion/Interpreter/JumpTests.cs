using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class JumpTests
{
    private static readonly MovementParameters Defaults = new();

    [Fact]
    [Behaviour("motion.jump.standing-velocity", "spec/01, 4.12 and 6; CMotionInterp::get_leave_ground_velocity @0x005280C0")]
    public void A_standing_jump_goes_straight_up()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        Assert.Equal(MotionError.None, interpreter.Jump(1f));
        Assert.False(body.OnWalkable);
        Assert.Equal(new Vector3(0, 0, 9.08652878f), body.LocalVelocity);
        Assert.Equal(0f, interpreter.JumpExtent);
        Assert.Equal(MotionCommand.Falling, interpreter.Animation!.Substate);
    }

    [Fact]
    [Behaviour("motion.jump.running-velocity", "spec/01, 4.12 and 6")]
    public void A_running_jump_keeps_the_running_speed()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.SetHoldRun(true, false);
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        Assert.Equal(MotionError.None, interpreter.Jump(1f));
        Assert.Equal(new Vector3(0, 10.6000004f, 9.08652878f), body.LocalVelocity);
    }

    [Fact]
    [Behaviour("motion.leave-ground.keeps-what-the-body-has", "spec/01, 4.12; CMotionInterp::LeaveGround @0x00528B00")]
    public void Standing_off_an_edge_keeps_the_velocity_of_the_body()
    {
        (FakeBody body, _) = FakeBody.Standing(FakeBody.Player());
        body.LocalVelocity = new Vector3(1, 2, 3);
        body.SetOnWalkable(false);
        Assert.Equal(new Vector3(1, 2, 3), body.LocalVelocity);
    }

    [Fact]
    [Behaviour("motion.leave-ground.walker-takes-its-speed-along", "spec/01, 4.12")]
    public void Walking_off_an_edge_takes_the_walking_speed_along()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        body.SetOnWalkable(false);
        Assert.Equal(new Vector3(0, 3.12f, 0), body.LocalVelocity);
    }

    [Fact]
    [Behaviour("motion.jump.without-weenie", "spec/01, 4.12; CMotionInterp::get_jump_v_z @0x00527AA0")]
    public void Without_a_weenie_a_jump_starts_at_ten()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(null);
        Assert.Equal(MotionError.None, interpreter.Jump(0.5f));
        Assert.Equal(new Vector3(0, 0, 10), body.LocalVelocity);
    }

    [Fact]
    [Behaviour("motion.jump.refusal-order", "spec/01, 4.12; CMotionInterp::jump_is_allowed @0x005282B0")]
    public void The_reasons_come_in_their_order()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(load: 2.5));
        interpreter.Interpreted.ForwardCommand = MotionCommand.Crouch;
        MovementParameters held = new();
        held.Flags |= MovementFlags.DisableJumpDuringLink;
        interpreter.DoInterpretedMotion(MotionCommand.TurnRight, held);
        (body.OnWalkable, body.IsFullyConstrained) = (false, true);

        Assert.Equal(MotionError.NotOnGround, interpreter.JumpIsAllowed(1f));
        body.OnWalkable = true;
        Assert.Equal(MotionError.GeneralFailure, interpreter.JumpIsAllowed(1f));
        body.IsFullyConstrained = false;
        Assert.Equal(MotionError.CannotJumpFromThisPosition, interpreter.JumpIsAllowed(1f));
        interpreter.MotionDone(true);
        Assert.Equal(MotionError.TooLoadedToJump, interpreter.JumpIsAllowed(1f));
        ((PlayerWeenie)interpreter.Weenie!).SetStats(new CharacterStats(300, 300));
        Assert.Equal(MotionError.CannotJumpFromThisPosition, interpreter.JumpIsAllowed(1f));
        interpreter.Interpreted.ForwardCommand = (MotionCommand)0x40000016;
        Assert.Equal(MotionError.CannotJumpFromThisPosition, interpreter.JumpIsAllowed(1f));
        interpreter.Interpreted.ForwardCommand = MotionCommand.Ready;
        Assert.Equal(MotionError.None, interpreter.JumpIsAllowed(1f));
    }

    [Fact]
    [Behaviour("motion.jump.others-cannot", "spec/01, 2.5")]
    public void Only_the_local_players_weenie_may_jump()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(new OtherWeenie());
        Assert.Equal(MotionError.TooLoadedToJump, interpreter.Jump(1f));
    }

    [Theory]
    [Behaviour("motion.jump.poses-that-forbid-it", "spec/01, 4.12; CMotionInterp::motion_allows_jump @0x005279E0")]
    [InlineData(0x1000006Eu, true)]
    [InlineData(0x1000006Fu, false)]
    [InlineData(0x10000078u, false)]
    [InlineData(0x10000079u, true)]
    [InlineData(0x10000127u, true)]
    [InlineData(0x10000128u, false)]
    [InlineData(0x10000131u, false)]
    [InlineData(0x10000132u, true)]
    [InlineData(0x40000007u, true)]
    [InlineData(0x40000008u, false)]
    [InlineData(0x40000015u, true)]
    [InlineData(0x40000016u, false)]
    [InlineData(0x40000018u, false)]
    [InlineData(0x40000019u, true)]
    [InlineData(0x4000001Du, true)]
    [InlineData(0x4000001Eu, false)]
    [InlineData(0x40000039u, false)]
    [InlineData(0x4000003Au, true)]
    [InlineData(0x41000011u, true)]
    [InlineData(0x41000012u, false)]
    [InlineData(0x41000014u, false)]
    [InlineData(0x41000015u, true)]
    public void Poses_from_which_one_cannot_jump(uint motion, bool allowed) => Assert.Equal(
        allowed ? MotionError.None : MotionError.CannotJumpFromThisPosition, MotionInterpreter.MotionAllowsJump((MotionCommand)motion));

    [Fact]
    [Behaviour("motion.jump.blocked-until-the-head-is-done", "spec/01, 4.7 and 4.10")]
    public void A_pose_forbids_the_jump_until_it_is_done()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.DoMotion(MotionCommand.Crouch, Defaults);
        interpreter.DoMotion(MotionCommand.Ready, Defaults);
        Assert.Equal(MotionError.CannotJumpFromThisPosition, interpreter.Jump(1f));
        interpreter.MotionDone(true);
        interpreter.MotionDone(true);
        Assert.Equal(MotionError.None, interpreter.Jump(1f));
    }

    [Fact]
    [Behaviour("motion.jump.standing-long-jump", "spec/01, 4.12; CMotionInterp::charge_jump @0x005281C0")]
    public void A_standing_long_jump_holds_the_body_and_goes_where_the_keys_point()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        Assert.Equal(MotionError.None, interpreter.ChargeJump());
        Assert.True(interpreter.StandingLongJump);
        interpreter.SetHoldRun(true, false);
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        Assert.Equal(MotionCommand.RunForward, interpreter.Interpreted.ForwardCommand);
        Assert.Equal(MotionCommand.Ready, interpreter.Animation!.Substate);

        interpreter.EndJumpCharge();
        Assert.Equal(MotionError.None, interpreter.Jump(0.25f));
        Assert.Equal(new Vector3(0, 10.6000004f, 4.54326439f), body.LocalVelocity);
        Assert.False(interpreter.StandingLongJump);
    }

    [Fact]
    [Behaviour("motion.jump.moving-charge-is-no-long-jump", "spec/01, 4.12")]
    public void Charging_while_moving_or_in_the_air_holds_nothing()
    {
        (_, MotionInterpreter moving) = FakeBody.Standing(FakeBody.Player());
        moving.DoMotion(MotionCommand.TurnRight, Defaults);
        Assert.Equal(MotionError.None, moving.ChargeJump());
        Assert.False(moving.StandingLongJump);

        (FakeBody body, MotionInterpreter flying) = FakeBody.Standing(FakeBody.Player());
        body.SetOnWalkable(false);
        Assert.Equal(MotionError.None, flying.ChargeJump());
        Assert.False(flying.StandingLongJump);
        Assert.Equal(MotionError.NotOnGround, flying.Jump(1f));
    }

    [Fact]
    [Behaviour("motion.jump.charge-refused", "spec/01, 4.12")]
    public void The_loaded_and_the_sitting_do_not_charge()
    {
        (_, MotionInterpreter loaded) = FakeBody.Standing(FakeBody.Player(load: 2));
        Assert.Equal(MotionError.TooLoadedToJump, loaded.ChargeJump());
        (_, MotionInterpreter crouching) = FakeBody.Standing(FakeBody.Player());
        crouching.DoMotion(MotionCommand.Crouch, Defaults);
        Assert.Equal(MotionError.CannotJumpFromThisPosition, crouching.ChargeJump());
    }

    [Theory]
    [Behaviour("motion.jump.charge-refused-by-pose", "spec/01, 4.12; CMotionInterp::charge_jump @0x005281C0")]
    [InlineData(0x41000011, true)]
    [InlineData(0x41000012, false)]
    [InlineData(0x41000013, false)]
    [InlineData(0x41000014, false)]
    [InlineData(0x40000008, false)]
    [InlineData(0x41000003, true)]
    public void Who_crouches_sits_sleeps_or_has_fallen_does_not_charge(uint forward, bool charges)
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.Interpreted.ForwardCommand = (MotionCommand)forward;
        Assert.Equal(charges ? MotionError.None : MotionError.CannotJumpFromThisPosition, interpreter.ChargeJump());
        Assert.Equal(forward == (uint)MotionCommand.Ready, interpreter.StandingLongJump);
    }
}
