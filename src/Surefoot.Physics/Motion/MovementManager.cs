using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>The motion side of a body: its interpreter and its animations, driven by the body once per quantum.</summary>
/// <remarks>Retail: MovementManager together with the motion side of CPartArray.</remarks>
public sealed class MovementManager : IBodyMovement
{
    private readonly IMotionBody body;
    private readonly IWeenieObj? weenie;
    private MotionInterpreter? interpreter;

    /// <summary>The motion side of a body; with a motion table it stands ready. The caller attaches it to the body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="table">Its motions; null for a body that has none: it then has no interpreter until somebody asks for one.</param>
    /// <param name="weenie">What the game knows of it; null counts as a creature with run rate 1.</param>
    /// <remarks>
    /// Retail: CPhysicsObj::SetMotionTableID @0x00512780. What makes the interpreter puts it into its default state, and MovementManager::EnterDefaultState
    /// @0x005241C0 does so again: what is pending at first is so twice.
    /// </remarks>
    public MovementManager(IMotionBody body, MotionTableAsset? table, IWeenieObj? weenie)
    {
        ArgumentNullException.ThrowIfNull(body);
        this.body = body;
        this.weenie = weenie;
        if (table is null) return;
        Animation = new MotionTableManager(table);
        Interpreter.EnterDefaultState();
    }

    /// <summary>The animations, or null.</summary>
    public MotionTableManager? Animation { get; }

    /// <summary>There is an interpreter; without one the body ignores what servers say of its motions.</summary>
    public bool HasInterpreter => interpreter is not null;

    /// <summary>The interpreter. A body without one gets it by being asked, in its default state.</summary>
    /// <remarks>Retail: MovementManager::get_minterp @0x005242A0.</remarks>
    public MotionInterpreter Interpreter => interpreter ?? MakeInterpreter();

    /// <summary>Motions wait to be done.</summary>
    /// <remarks>Retail: MovementManager::motions_pending @0x00524280.</remarks>
    public bool MotionsPending => interpreter is { MotionsPending: true };

    /// <summary>A motion that the local player asks for: from now on the keys count.</summary>
    /// <remarks>Retail: CPhysicsObj::DoMotion @0x00510020.</remarks>
    public MotionError DoMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return Interpreter.PerformMovement(MovementKind.RawCommand, motion, parameters);
    }

    /// <summary>The end of a motion that the local player asked for.</summary>
    /// <remarks>Retail: CPhysicsObj::StopMotion @0x005100D0.</remarks>
    public MotionError StopMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return Interpreter.PerformMovement(MovementKind.StopRawCommand, motion, parameters);
    }

    /// <summary>The end of everything, whoever asks for it.</summary>
    /// <remarks>Retail: CPhysicsObj::StopCompletely @0x00510180.</remarks>
    public MotionError StopCompletely() => Interpreter.PerformMovement(MovementKind.StopCompletely, MotionCommand.None, new MovementParameters());

    /// <summary>Does what an UpdateMotion of the interpreted kind says; nothing without an interpreter.</summary>
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
        if (interpreter is null) return;
        interpreter.Interruption?.CancelMoveTo();
        interpreter.Interruption?.Unstick();
        if (state.CurrentStyle != interpreter.Interpreted.CurrentStyle)
            interpreter.PerformMovement(MovementKind.RawCommand, state.CurrentStyle, new MovementParameters());
        interpreter.MoveToInterpretedState(state);
        interpreter.StandingLongJump = standingLongJump;
    }

    /// <inheritdoc/>
    public void HitGround() => interpreter?.HitGround();

    /// <inheritdoc/>
    public void LeaveGround() => interpreter?.LeaveGround();

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
        interpreter?.HandleExitWorld();
    }

    private MotionInterpreter MakeInterpreter()
    {
        interpreter = new MotionInterpreter(Animation, body, weenie);
        interpreter.EnterDefaultState();
        return interpreter;
    }
}
