using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>The motion side of a body: its interpreter and its animations, driven by the body once per quantum.</summary>
/// <remarks>Retail: MovementManager together with the motion side of CPartArray.</remarks>
public sealed class MovementManager : IBodyMovement
{
    private readonly IMotionBody body;

    /// <summary>The motion side of a body, standing ready. The caller attaches it to the body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="table">Its motions; null for a body that has none.</param>
    /// <param name="weenie">What the game knows of it; null counts as a creature with run rate 1.</param>
    public MovementManager(IMotionBody body, MotionTableAsset? table, IWeenieObj? weenie)
    {
        ArgumentNullException.ThrowIfNull(body);
        this.body = body;
        Animation = table is null ? null : new MotionTableManager(table);
        Interpreter = new MotionInterpreter(Animation, body, weenie);
        Interpreter.EnterDefaultState();
    }

    /// <summary>The animations, or null.</summary>
    public MotionTableManager? Animation { get; }

    /// <summary>The interpreter.</summary>
    public MotionInterpreter Interpreter { get; }

    /// <summary>A motion that the local player asks for: from now on the keys count.</summary>
    /// <remarks>Retail: CPhysicsObj::DoMotion.</remarks>
    public MotionError DoMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return Interpreter.PerformMovement(MovementKind.RawCommand, motion, parameters);
    }

    /// <summary>The end of a motion that the local player asked for.</summary>
    /// <remarks>Retail: CPhysicsObj::StopMotion.</remarks>
    public MotionError StopMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return Interpreter.PerformMovement(MovementKind.StopRawCommand, motion, parameters);
    }

    /// <summary>Does what an UpdateMotion of the interpreted kind says.</summary>
    /// <param name="state">The state in the message.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <param name="standingLongJump">The body charges a standing long jump.</param>
    /// <exception cref="ArgumentException">A speed is NaN or infinite; nothing has changed.</exception>
    /// <remarks>Retail: MovementManager::unpack_movement @0x00524440, type 0.</remarks>
    public void ApplyUpdate(InterpretedMotionState state, bool autonomous, bool standingLongJump = false)
    {
        ArgumentNullException.ThrowIfNull(state);
        MotionInterpreter.ThrowIfNotFinite(state);
        body.LastMoveWasAutonomous = autonomous;
        Interpreter.Interruption?.CancelMoveTo();
        Interpreter.Interruption?.Unstick();
        if (state.CurrentStyle != Interpreter.Interpreted.CurrentStyle)
            Interpreter.PerformMovement(MovementKind.RawCommand, state.CurrentStyle, new MovementParameters());
        Interpreter.MoveToInterpretedState(state);
        Interpreter.StandingLongJump = standingLongJump;
    }

    /// <inheritdoc/>
    public void HitGround() => Interpreter.HitGround();

    /// <inheritdoc/>
    public void LeaveGround() => Interpreter.LeaveGround();

    /// <inheritdoc/>
    public void AccumulateRootMotion(float quantum, ref Frame offset) => Animation?.Update(quantum, ref offset);

    /// <inheritdoc/>
    public void ProcessHooks(PhysicsBody owner) => Animation?.ProcessHooks(owner);

    /// <inheritdoc/>
    public ReadOnlySpan<Frame> PartFrames => Animation is null ? [] : Animation.Sequence.PartFrames;

    /// <inheritdoc/>
    public void UseTime() => Animation?.CheckForCompletedMotions();

    /// <inheritdoc/>
    public void HandleEnterWorld() => Animation?.HandleEnterWorld();

    /// <inheritdoc/>
    public void HandleExitWorld()
    {
        Animation?.HandleExitWorld();
        Interpreter.HandleExitWorld();
    }
}
