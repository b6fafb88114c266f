using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>Single motions by their kind, and what a creature's weenie knows.</summary>
public class SingleMotionTests
{
    [Fact, Behaviour("motion.perform.interpreted-kinds", "spec/01, 4; CMotionInterp::PerformMovement @0x00528E80")]
    public void An_interpreted_command_acts_without_a_key_and_its_stop_ends_it()
    {
        (_, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        MovementParameters p = new() { Speed = 1.5f };
        p.Flags &= ~MovementFlags.ModifyRawState;
        Assert.Equal(MotionError.None, interpreter.PerformMovement(MovementKind.InterpretedCommand, MotionCommand.TurnRight, p));
        Assert.Equal((MotionCommand.TurnRight, 1.5f), (interpreter.Interpreted.TurnCommand, interpreter.Interpreted.TurnSpeed));
        Assert.Equal(MotionCommand.None, interpreter.Raw.TurnCommand);
        Assert.Equal(MotionError.None, interpreter.PerformMovement(MovementKind.StopInterpretedCommand, MotionCommand.TurnRight, p));
        Assert.Equal(MotionCommand.None, interpreter.Interpreted.TurnCommand);
    }

    [Fact, Behaviour("motion.interpreted.remove-style", "spec/01, 2.3; InterpretedMotionState::RemoveMotion @0x0051E790")]
    public void The_style_that_is_taken_out_of_the_state_leaves_the_one_of_peace()
    {
        InterpretedMotionState state = new();
        state.ApplyMotion(MotionCommand.DualWieldCombat, new MovementParameters());
        state.RemoveMotion(MotionCommand.NonCombat);
        Assert.Equal(MotionCommand.DualWieldCombat, state.CurrentStyle);
        state.RemoveMotion(MotionCommand.DualWieldCombat);
        Assert.Equal(MotionCommand.NonCombat, state.CurrentStyle);
    }

    [Fact, Behaviour("motion.weenie.others-know-nothing", "spec/01, 2.5: only the local player's own weenie answers")]
    public void The_weenie_of_another_knows_no_speed_no_jump_and_no_cost()
    {
        OtherWeenie other = new();
        Assert.True(other.IsCreature);
        Assert.False(other.IsThePlayer || other.CanJump(1));
        Assert.False(other.InqRunRate(out _) || other.InqJumpVelocity(1, out _) || other.JumpStaminaCost(1, out _));
        Assert.False(new OtherWeenie(isCreature: false).IsCreature);
    }
}
