using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class InterpreterTests
{
    private const MotionCommand Bow = HumanoidTable.Bow;
    private static readonly MovementParameters Defaults = new();

    [Theory]
    [Behaviour("motion.adjust.normalises-with-run", "spec/01, 4.2, 4.3 and 6; CMotionInterp::adjust_motion @0x00528010")]
    [InlineData(MotionCommand.WalkForward, MotionCommand.RunForward, 2.6500001f)]
    [InlineData(MotionCommand.WalkBackwards, MotionCommand.WalkForward, -1.72249997f)]
    [InlineData(MotionCommand.TurnLeft, MotionCommand.TurnRight, -1.5f)]
    [InlineData(MotionCommand.TurnRight, MotionCommand.TurnRight, 1.5f)]
    [InlineData(MotionCommand.SideStepLeft, MotionCommand.SideStepRight, -3f)]
    [InlineData(MotionCommand.RunForward, MotionCommand.RunForward, 1f)]
    public void Commands_are_normalised_with_the_run_key(MotionCommand motion, MotionCommand expected, float expectedSpeed) =>
        AssertAdjusted(motion, HoldKey.Run, expected, expectedSpeed);

    [Theory]
    [Behaviour("motion.adjust.normalises-without-run", "spec/01, 4.2 and 6")]
    [InlineData(MotionCommand.WalkForward, MotionCommand.WalkForward, 1f)]
    [InlineData(MotionCommand.WalkBackwards, MotionCommand.WalkForward, -0.649999976f)]
    [InlineData(MotionCommand.TurnLeft, MotionCommand.TurnRight, -1f)]
    [InlineData(MotionCommand.SideStepLeft, MotionCommand.SideStepRight, -1.24799991f)]
    [InlineData(MotionCommand.Crouch, MotionCommand.Crouch, 1f)]
    public void Commands_are_normalised_without_the_run_key(MotionCommand motion, MotionCommand expected, float expectedSpeed) =>
        AssertAdjusted(motion, HoldKey.None, expected, expectedSpeed);

    private static void AssertAdjusted(MotionCommand motion, HoldKey key, MotionCommand expected, float expectedSpeed)
    {
        MotionInterpreter interpreter = new(null, new FakeBody(), FakeBody.Player());
        float speed = 1f;
        interpreter.AdjustMotion(ref motion, ref speed, key);
        Assert.Equal((expected, expectedSpeed), (motion, speed));
        Assert.Equal(HoldKey.None, interpreter.Raw.CurrentHoldKey);
    }

    [Fact]
    [Behaviour("motion.adjust.leaves-what-is-no-creature", "spec/01, 4.2")]
    public void What_is_no_creature_is_left_alone()
    {
        MotionInterpreter interpreter = new(null, new FakeBody(), new OtherWeenie(isCreature: false));
        (MotionCommand motion, float speed) = (MotionCommand.TurnLeft, 1f);
        interpreter.AdjustMotion(ref motion, ref speed, HoldKey.Run);
        Assert.Equal((MotionCommand.TurnLeft, 1f), (motion, speed));
    }

    [Fact]
    [Behaviour("motion.run-rate.own-then-told-then-one", "spec/01, 4.3; CMotionInterp::apply_run_to_command @0x00527BE0")]
    public void The_run_rate_comes_from_the_weenie_else_from_the_server_else_is_one()
    {
        (_, MotionInterpreter other) = FakeBody.Standing(new OtherWeenie());
        InterpretedMotionState state = new() { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = 2.5f };
        Assert.Equal(1f, other.RunRate);
        other.MoveToInterpretedState(state);
        Assert.Equal(2.5f, other.RunRate);
        Assert.Equal(10f, other.MaxSpeed);

        (FakeBody body, MotionInterpreter player) = FakeBody.Standing(FakeBody.Player(run: 200));
        body.LastMoveWasAutonomous = false;
        player.MoveToInterpretedState(state);
        Assert.Equal((2.375f, 2.5f), (player.RunRate, player.MyRunRate));
        Assert.Equal(10f, player.AdjustedMaxSpeed);
        Assert.Equal(9.5f, player.MaxSpeed);

        (_, MotionInterpreter nobody) = FakeBody.Standing(null);
        Assert.Equal(1f, nobody.RunRate);
    }

    [Fact]
    [Behaviour("motion.state-velocity.limited-to-running-speed", "spec/01, 4.11 and 6; CMotionInterp::get_state_velocity @0x00527D50")]
    public void The_velocity_of_a_state_is_limited_to_the_running_speed()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.SetHoldRun(true, false);
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        Assert.Equal(new Vector3(0, 10.6000004f, 0), interpreter.GetStateVelocity());
        interpreter.DoMotion(MotionCommand.SideStepRight, Defaults);
        Vector3 v = interpreter.GetStateVelocity();
        Assert.Equal(3.53529f, v.X, 1e-5f);
        Assert.Equal(9.99308f, v.Y, 1e-5f);
        Assert.Equal(0f, v.Z);
    }

    [Fact]
    [Behaviour("motion.state-velocity.walking", "spec/01, 4.11")]
    public void Walking_is_three_point_one_two()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        Assert.Equal(new Vector3(0, 3.12f, 0), interpreter.GetStateVelocity());
        interpreter.DoMotion(MotionCommand.WalkBackwards, Defaults);
        Assert.Equal(new Vector3(0, (float)(3.12f * (double)-0.65f), 0), interpreter.GetStateVelocity());
    }

    [Fact]
    [Behaviour("motion.hold-key.switches-between-walking-and-running", "spec/01, 4.9; CMotionInterp::set_hold_run @0x00528B70")]
    public void The_hold_key_turns_walking_into_running_at_once()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        Assert.Equal((MotionCommand.WalkForward, 1f), (interpreter.Interpreted.ForwardCommand, interpreter.Interpreted.ForwardSpeed));
        Assert.Equal(MotionCommand.WalkForward, interpreter.Animation!.Substate);

        interpreter.SetHoldRun(true, false);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f),
            (interpreter.Interpreted.ForwardCommand, interpreter.Interpreted.ForwardSpeed));
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), (interpreter.Animation.Substate, interpreter.Animation.SubstateSpeed));
        Assert.Equal((MotionCommand.WalkForward, 1f), (interpreter.Raw.ForwardCommand, interpreter.Raw.ForwardSpeed));

        interpreter.SetHoldKey(HoldKey.Invalid, false);
        Assert.Equal(HoldKey.Run, interpreter.Raw.CurrentHoldKey);
        interpreter.SetHoldKey(HoldKey.None, false);
        Assert.Equal(MotionCommand.WalkForward, interpreter.Interpreted.ForwardCommand);
    }

    [Fact]
    [Behaviour("motion.permission.ground-needed", "spec/01, 4.6; CMotionInterp::contact_allows_move @0x00528240")]
    public void Without_ground_only_turning_falling_and_dying_are_allowed()
    {
        FakeBody body = new() { OnWalkable = false };
        MotionInterpreter interpreter = new(null, body, FakeBody.Player());
        MotionCommand[] free = [MotionCommand.Falling, MotionCommand.Dead, MotionCommand.TurnRight, MotionCommand.TurnLeft];
        foreach (MotionCommand motion in free)
            Assert.True(interpreter.ContactAllowsMove(motion));
        MotionCommand[] bound =
            [MotionCommand.Ready, MotionCommand.WalkForward, MotionCommand.SideStepRight, Bow, MotionCommand.NonCombat];
        foreach (MotionCommand motion in bound)
            Assert.False(interpreter.ContactAllowsMove(motion));

        (body.HasContact, body.OnWalkable) = (false, true);
        Assert.False(interpreter.ContactAllowsMove(MotionCommand.WalkForward));
        body.HasContact = true;
        Assert.True(interpreter.ContactAllowsMove(MotionCommand.WalkForward));
        (body.HasContact, body.HasGravity) = (false, false);
        Assert.True(interpreter.ContactAllowsMove(MotionCommand.WalkForward));

        body.HasGravity = true;
        Assert.True(new MotionInterpreter(null, body, new OtherWeenie(isCreature: false)).ContactAllowsMove(MotionCommand.WalkForward));
        Assert.False(new MotionInterpreter(null).ContactAllowsMove(MotionCommand.Dead));
    }

    [Fact]
    [Behaviour("motion.do.in-the-air-is-remembered", "spec/01, 4.7; CMotionInterp::DoInterpretedMotion @0x00528360")]
    public void In_the_air_a_motion_is_remembered_and_an_action_refused()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        body.SetOnWalkable(false);
        Assert.Equal(MotionCommand.Falling, interpreter.Animation!.Substate);
        Assert.Equal(MotionError.None, interpreter.DoMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionCommand.WalkForward, interpreter.Interpreted.ForwardCommand);
        Assert.Equal(MotionCommand.Falling, interpreter.Animation.Substate);
        Assert.Equal(MotionError.NotOnGround, interpreter.DoMotion(Bow, Defaults));

        body.SetOnWalkable(true);
        Assert.Equal(MotionCommand.WalkForward, interpreter.Animation.Substate);
        body.SetOnWalkable(false);
        Assert.Equal(MotionError.None, interpreter.StopMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionCommand.Ready, interpreter.Interpreted.ForwardCommand);
    }

    [Fact]
    [Behaviour("motion.do.refusals", "spec/01, 4.8; CMotionInterp::DoMotion @0x00528D20")]
    public void Motions_are_refused_with_their_reason()
    {
        Assert.Equal(MotionError.NoBody, new MotionInterpreter(null).DoMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionError.NoBody, new MotionInterpreter(null).StopMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionError.NoBody, new MotionInterpreter(null).DoInterpretedMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionError.NoBody, new MotionInterpreter(null).StopInterpretedMotion(MotionCommand.WalkForward, Defaults));
        Assert.Equal(MotionError.NoBody, new MotionInterpreter(null).Jump(1f));
        Assert.Equal(MotionError.NoAnimationTable,
            new MotionInterpreter(null, new FakeBody()).DoMotion(MotionCommand.WalkForward, Defaults));

        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(), HumanoidTable.Create(links: true));
        Assert.Equal(MotionError.NoMotionData, interpreter.DoMotion((MotionCommand)0x400000EE, Defaults));
        Assert.Equal(MotionCommand.Ready, interpreter.Raw.ForwardCommand);
        Assert.Equal(MotionError.GeneralFailure, interpreter.PerformMovement((MovementKind)6, MotionCommand.Ready, Defaults));

        for (int i = 0; i < 6; i++) Assert.Equal(MotionError.None, interpreter.DoMotion(Bow, Defaults));
        Assert.Equal(6, interpreter.Raw.ActionCount);
        Assert.Equal(MotionError.TooManyActions, interpreter.DoMotion(Bow, Defaults));
    }

    [Theory]
    [Behaviour("motion.do.combat-refuses-poses-and-emotes", "spec/01, 4.8")]
    [InlineData(0x41000012u, 0x3Fu)]
    [InlineData(0x41000013u, 0x40u)]
    [InlineData(0x41000014u, 0x41u)]
    [InlineData(0x1200007Du, 0x42u)]
    public void In_combat_poses_and_emotes_are_refused(uint motion, uint error)
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.Interpreted.CurrentStyle = MotionCommand.DualWieldCombat;
        Assert.Equal((MotionError)error, interpreter.DoMotion((MotionCommand)motion, Defaults));
    }

    [Fact]
    [Behaviour("motion.stop.knows-no-refusal", "spec/01, 4.8; CMotionInterp::StopMotion @0x00528530")]
    public void Stopping_knows_no_hold_key_no_posture_and_no_number_of_actions()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(), HumanoidTable.Create(links: true));
        interpreter.DoMotion(MotionCommand.Crouch, Defaults);
        for (int i = 0; i < 6; i++) interpreter.Interpreted.AddAction(new MotionAction(Bow, 1f, 1, Autonomous: true));
        interpreter.Interpreted.CurrentStyle = MotionCommand.DualWieldCombat;
        MovementParameters p = new() { HoldKey = HoldKey.Run };
        Assert.Equal(MotionError.NoCrouchInCombat, interpreter.DoMotion(MotionCommand.Crouch, Defaults));
        Assert.Equal(MotionError.None, interpreter.StopMotion(MotionCommand.Crouch, p));
        Assert.Equal((MotionCommand.Ready, MotionCommand.Ready), (interpreter.Raw.ForwardCommand, interpreter.Interpreted.ForwardCommand));
        Assert.Equal(HoldKey.None, interpreter.Raw.CurrentHoldKey);

        // The table does not have these; it is what says so, and no rule of postures, emotes or actions.
        Assert.Equal(MotionError.NoMotionData, interpreter.StopMotion(MotionCommand.Sleeping, p));
        Assert.Equal(MotionError.NoMotionData, interpreter.StopMotion((MotionCommand)0x1200007D, p));
        Assert.Equal(MotionError.NoMotionData, interpreter.StopMotion(Bow, p));
    }

    [Fact]
    [Behaviour("motion.do.bad-speed-changes-nothing", "design, decision 7")]
    public void A_speed_that_is_not_finite_is_refused_and_changes_nothing()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        MovementParameters p = new() { Speed = float.NaN };
        Assert.Throws<ArgumentException>(() => interpreter.DoMotion(MotionCommand.WalkForward, p));
        Assert.Throws<ArgumentException>(() => interpreter.MoveToInterpretedState(
            new InterpretedMotionState { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = float.PositiveInfinity }));
        Assert.Throws<ArgumentException>(() => interpreter.Jump(float.NaN));
        Assert.Equal((MotionCommand.Ready, MotionCommand.Ready), (interpreter.Raw.ForwardCommand, interpreter.Interpreted.ForwardCommand));
        Assert.False(interpreter.MotionsPending);
    }

    [Fact]
    [Behaviour("motion.queue.head-is-done-first", "spec/01, 4.10; CMotionInterp::MotionDone @0x00527EC0")]
    public void Motions_are_done_in_order_and_an_action_leaves_both_states()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(), HumanoidTable.Create(links: true));
        interpreter.DoMotion(MotionCommand.TurnRight, Defaults);
        interpreter.StopMotion(MotionCommand.TurnRight, Defaults);
        interpreter.DoMotion(Bow, Defaults);
        Assert.Equal(
            [MotionCommand.TurnRight, MotionCommand.Ready, Bow],
            Enumerable.Range(0, interpreter.PendingCount).Select(i => interpreter.GetPending(i).Motion));
        interpreter.MotionDone(true);
        Assert.Equal((1, 1), (interpreter.Raw.ActionCount, interpreter.Interpreted.ActionCount));
        interpreter.HandleExitWorld();
        Assert.False(interpreter.MotionsPending);
        Assert.Equal((0, 0), (interpreter.Raw.ActionCount, interpreter.Interpreted.ActionCount));
    }

    [Fact]
    [Behaviour("motion.stop-completely", "spec/01, 4.8; CMotionInterp::StopCompletely @0x00527E40")]
    public void Stopping_completely_clears_both_states()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        interpreter.SetHoldRun(true, false);
        interpreter.DoMotion(MotionCommand.WalkForward, Defaults);
        interpreter.DoMotion(MotionCommand.TurnRight, Defaults);
        interpreter.DoMotion(MotionCommand.SideStepRight, Defaults);
        interpreter.StopCompletely();
        Assert.Equal(
            (MotionCommand.Ready, MotionCommand.None, MotionCommand.None),
            (interpreter.Raw.ForwardCommand, interpreter.Raw.SidestepCommand, interpreter.Raw.TurnCommand));
        Assert.Equal(
            (MotionCommand.Ready, MotionCommand.None, MotionCommand.None),
            (interpreter.Interpreted.ForwardCommand, interpreter.Interpreted.SidestepCommand, interpreter.Interpreted.TurnCommand));
        Assert.Equal((MotionCommand.Ready, 0), (interpreter.Animation!.Substate, interpreter.Animation.State.ModifierCount));
        Assert.Equal((0f, 0f), (interpreter.Animation.Sequence.Velocity.Length(), interpreter.Animation.Sequence.Omega.Length()));
    }

    [Theory]
    [Behaviour("motion.server.action-stamps-wrap", "spec/01, 4.14")]
    [InlineData(5, 6, true)]
    [InlineData(5, 5, false)]
    [InlineData(6, 5, false)]
    [InlineData(0x7FFF, 0, true)]
    [InlineData(0, 0x7FFF, false)]
    [InlineData(0, 0x3FFF, true)]
    [InlineData(0, 0x4000, false)]
    public void Action_stamps_wrap_around(int own, int other, bool newer) =>
        Assert.Equal(newer, MotionInterpreter.IsNewerStamp(own, other));

    [Fact]
    [Behaviour("motion.server.state-is-done", "spec/01, 4.14; CMotionInterp::move_to_interpreted_state @0x005289C0")]
    public void A_servers_state_is_done_with_its_new_actions()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(), HumanoidTable.Create(links: true));
        body.LastMoveWasAutonomous = false;
        InterpretedMotionState state = new();
        state.AddAction(new MotionAction(Bow, 1f, 1, Autonomous: false));
        state.AddAction(new MotionAction(Bow, 1f, 1, Autonomous: false));
        state.AddAction(new MotionAction(Bow, 1f, 2, Autonomous: true));
        interpreter.MoveToInterpretedState(state);
        Assert.Equal(1u, interpreter.ServerActionStamp);
        Assert.Equal(1, interpreter.Interpreted.ActionCount);
    }

    [Theory]
    [Behaviour("motion.server.autonomous-actions-are-for-others", "spec/01, 4.14")]
    [InlineData(Who.Nobody, false)]
    [InlineData(Who.Player, false)]
    [InlineData(Who.Other, true)]
    public void An_autonomous_action_of_a_state_is_done_by_others_only_and_a_body_without_a_weenie_counts_as_the_player(Who who, bool done)
    {
        IWeenieObj? weenie = who switch { Who.Nobody => null, Who.Player => FakeBody.Player(), _ => new OtherWeenie() };
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(weenie, HumanoidTable.Create(links: true));
        body.LastMoveWasAutonomous = false;
        InterpretedMotionState state = new();
        state.AddAction(new MotionAction(Bow, 1f, 3, Autonomous: true));
        interpreter.MoveToInterpretedState(state);
        Assert.Equal((done ? 3u : 0u, done ? 1 : 0), (interpreter.ServerActionStamp, interpreter.Interpreted.ActionCount));
    }

    /// <summary>Whose body it is.</summary>
    public enum Who
    {
        /// <summary>It has no weenie.</summary>
        Nobody,

        /// <summary>The local player's.</summary>
        Player,

        /// <summary>Somebody else's.</summary>
        Other,
    }
}
