namespace Surefoot.Physics.Motion;

/// <summary>What a body is asked to do at a moment.</summary>
/// <param name="Style">Style.</param>
/// <param name="Forward">Forward command or another substate.</param>
/// <param name="ForwardSpeed">Speed factor of the forward command; the run rate when running, negative backwards.</param>
/// <param name="Sidestep"><see cref="MotionCommand.SideStepRight"/> or none.</param>
/// <param name="SidestepSpeed">Speed factor of the sidestep, negative to the left.</param>
/// <param name="Turn"><see cref="MotionCommand.TurnRight"/> or none.</param>
/// <param name="TurnSpeed">Speed factor of the turn, negative to the left.</param>
public readonly record struct MotionSummary(
    MotionCommand Style, MotionCommand Forward, float ForwardSpeed, MotionCommand Sidestep, float SidestepSpeed, MotionCommand Turn,
    float TurnSpeed)
{
    /// <summary>Stands still.</summary>
    public static MotionSummary Standing { get; } =
        new(MotionCommand.NonCombat, MotionCommand.Ready, 1f, MotionCommand.None, 1f, MotionCommand.None, 1f);

    internal static MotionSummary Of(InterpretedMotionState state) => new(
        state.CurrentStyle, state.ForwardCommand, state.ForwardSpeed, state.SidestepCommand, state.SidestepSpeed, state.TurnCommand,
        state.TurnSpeed);
}
