using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;

namespace Surefoot.Physics.Tests.Steering;

public class MovementManagerTests
{
    private static readonly InterpretedMotionState Walk = new() { ForwardCommand = MotionCommand.WalkForward, ForwardSpeed = 0.5f };

    [Fact]
    [Behaviour("motion.manager.no-table-no-interpreter", "spec/09, 5.4; spec/09b, 3; MovementManager::unpack_movement @0x00524440")]
    public void A_body_without_a_motion_table_ignores_a_servers_motions_until_somebody_asks_for_its_interpreter()
    {
        bool cancelled = false;
        FakeBody body = new() { OnCancelMoveTo = () => cancelled = true };
        MovementManager movement = new(body, table: null, new OtherWeenie());
        Assert.False(movement.HasInterpreter);
        movement.ApplyUpdate(Walk, autonomous: false, standingLongJump: true);
        ((IBodyMovement)movement).LeaveGround();
        ((IBodyMovement)movement).HitGround();
        ((IBodyMovement)movement).HandleExitWorld();
        Assert.Equal((false, false, false), (movement.HasInterpreter, movement.MotionsPending, body.LastMoveWasAutonomous));

        MotionInterpreter interpreter = movement.Interpreter;
        Assert.True(movement.HasInterpreter);
        Assert.Same(interpreter, movement.Interpreter);
        Assert.Equal((true, MotionCommand.Ready, false),
            (interpreter.IsInitialised, interpreter.Interpreted.ForwardCommand, interpreter.StandingLongJump));
        Assert.Equal((false, false), (cancelled, body.Unstuck));
        movement.ApplyUpdate(Walk, autonomous: false, standingLongJump: true);
        Assert.Equal((MotionCommand.WalkForward, 0.5f), (interpreter.Interpreted.ForwardCommand, interpreter.Interpreted.ForwardSpeed));
        Assert.True(interpreter.StandingLongJump);
        Assert.Equal((true, true), (cancelled, body.Unstuck));
    }

    [Fact]
    [Behaviour("motion.manager.motion-makes-the-interpreter", "spec/09b, 3; MovementManager::PerformMovement @0x005240D0")]
    public void A_motion_asked_of_a_body_without_a_motion_table_makes_its_interpreter_and_fails()
    {
        MovementManager movement = new(new FakeBody(), table: null, new OtherWeenie());
        Assert.Equal(MotionError.NoAnimationTable, movement.DoMotion(MotionCommand.WalkForward, new MovementParameters()));
        Assert.True(movement.HasInterpreter);
    }

    [Fact]
    [Behaviour("motion.manager.table-readies-twice", "spec/09b, 3; MovementManager::EnterDefaultState @0x005241C0")]
    public void With_a_motion_table_there_is_an_interpreter_at_once_made_ready_twice()
    {
        MovementManager movement = new(new FakeBody(), HumanoidTable.Create(), new OtherWeenie());
        Assert.True(movement.HasInterpreter);

        // Each time the default state, then the style and the forward command of its LeaveGround.
        Assert.Equal(
            [
                MotionCommand.Ready, MotionCommand.NonCombat, MotionCommand.Ready, MotionCommand.Ready, MotionCommand.NonCombat,
                MotionCommand.Ready],
            Enumerable.Range(0, movement.Interpreter.PendingCount).Select(i => movement.Interpreter.GetPending(i).Motion));
        ((IBodyMovement)movement).UseTime();
        Assert.False(movement.MotionsPending);
    }

    [Theory]
    [Behaviour("motion.manager.own-motions-set-autonomous-first", "spec/01, 4.8; spec/09b, 3; CPhysicsObj::DoMotion @0x00510020")]
    [InlineData(MovementKind.RawCommand, true)]
    [InlineData(MovementKind.StopRawCommand, true)]
    [InlineData(MovementKind.StopCompletely, false)]
    public void Doing_and_stopping_a_motion_sets_the_autonomous_flag_before_anything_else_and_stopping_completely_leaves_it(
        object kind, bool autonomous)
    {
        FakeBody body = new() { LastMoveWasAutonomous = false };
        MovementManager movement = new(body, HumanoidTable.Create(), FakeBody.Player());
        bool flag = false;
        body.OnCancelMoveTo = () => flag = body.LastMoveWasAutonomous;
        switch (kind)
        {
            case MovementKind.RawCommand: movement.DoMotion(MotionCommand.WalkForward, new MovementParameters()); break;
            case MovementKind.StopRawCommand: movement.StopMotion(MotionCommand.WalkForward, new MovementParameters()); break;
            default: movement.StopCompletely(); break;
        }

        Assert.Equal((autonomous, autonomous), (flag, body.LastMoveWasAutonomous));
    }
}
