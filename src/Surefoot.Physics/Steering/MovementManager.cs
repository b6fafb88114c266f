using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Steering;

/// <summary>
/// The movement side of a body: its interpreter, its animations, and its move-to manager, which is made with the first order that needs it.
/// What the body tells and what a server says have files of their own, <c>Body</c> and <c>Orders</c>.
/// </summary>
/// <remarks>Retail: MovementManager together with the motion side of CPartArray; specification 09b, 3.</remarks>
public sealed partial class MovementManager
{
    private readonly IMotionBody body;
    private readonly PhysicsBody? steered;
    private readonly IWeenieObj? weenie;
    private MotionInterpreter? interpreter;

    /// <summary>The movement side of a body; with a motion table it stands ready. The caller attaches it to the body.</summary>
    /// <param name="body">The body. One that is no <see cref="PhysicsBody"/> has motions but cannot be ordered anywhere.</param>
    /// <param name="table">Its motions; null for a body that has none: it then has no interpreter until somebody asks for one.</param>
    /// <param name="weenie">What the game knows of it; null counts as a creature with run rate 1.</param>
    /// <remarks>
    /// Retail: CPhysicsObj::SetMotionTableID @0x00512780. What makes the interpreter puts it into its default state, and
    /// MovementManager::EnterDefaultState @0x005241C0 does so again: what is pending at first is so twice.
    /// </remarks>
    internal MovementManager(IMotionBody body, MotionTableAsset? table, IWeenieObj? weenie)
    {
        ArgumentNullException.ThrowIfNull(body);
        this.body = body;
        this.weenie = weenie;
        steered = body as PhysicsBody;
        if (table is null) return;
        Animation = new MotionTableManager(table);
        EnterDefaultState();
    }

    /// <summary>The animations, or null.</summary>
    public MotionTableManager? Animation { get; }

    /// <summary>There is an interpreter; without one the body ignores what servers say of its motions.</summary>
    internal bool HasInterpreter => interpreter is not null;

    /// <summary>The interpreter. A body without one gets it by being asked, in its default state.</summary>
    /// <remarks>Retail: MovementManager::get_minterp @0x005242A0.</remarks>
    internal MotionInterpreter Interpreter => interpreter ?? MakeInterpreter();

    /// <summary>What the body is asked to do now; standing still as long as it has no interpreter.</summary>
    public MotionSummary Motions => interpreter is null ? MotionSummary.Standing : MotionSummary.Of(interpreter.Interpreted);

    /// <summary>How much faster than 4 m/s it runs, as the game says now; 1 as long as it has no interpreter.</summary>
    public float RunRate => interpreter?.RunRate ?? 1f;

    /// <summary>It crouches to jump as far as it can: no other motion is done until it has.</summary>
    public bool StandingLongJump => interpreter is { StandingLongJump: true };

    /// <summary>Motions wait to be done.</summary>
    /// <remarks>Retail: MovementManager::motions_pending @0x00524280.</remarks>
    public bool MotionsPending => interpreter is { MotionsPending: true };

    /// <inheritdoc/>
    /// <remarks>Retail: MovementManager::IsMovingTo @0x00524260.</remarks>
    public bool IsMovingTo => MoveTo is { IsMovingTo: true };

    /// <summary>Why the last move-to or turn-to ended; none when it arrived, and before the first.</summary>
    public MotionError LastMoveToError { get; private set; }

    /// <summary>The move-to manager, or null before the first order.</summary>
    internal MoveToManager? MoveTo { get; private set; }

    /// <summary>One of the five kinds of single motions; the body wakes first.</summary>
    /// <exception cref="ArgumentException">The speed is NaN or infinite; nothing has changed.</exception>
    /// <remarks>
    /// Retail: MovementManager::PerformMovement @0x005240D0; its other four kinds are <see cref="MoveToObject"/> and its neighbours.
    /// </remarks>
    internal MotionError PerformMovement(MovementKind kind, MotionCommand motion, in MovementParameters parameters)
    {
        MotionInterpreter.ThrowIfNotFinite(parameters.Speed, nameof(parameters));
        steered?.SetActive(true);
        return Interpreter.PerformMovement(kind, motion, parameters);
    }

    /// <summary>A motion that the local player asks for: from now on the keys count.</summary>
    /// <remarks>Retail: CPhysicsObj::DoMotion @0x00510020.</remarks>
    public MotionError DoMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return PerformMovement(MovementKind.RawCommand, motion, parameters);
    }

    /// <summary>The end of a motion that the local player asked for.</summary>
    /// <remarks>Retail: CPhysicsObj::StopMotion @0x005100D0.</remarks>
    public MotionError StopMotion(MotionCommand motion, in MovementParameters parameters)
    {
        body.LastMoveWasAutonomous = true;
        return PerformMovement(MovementKind.StopRawCommand, motion, parameters);
    }

    /// <summary>The end of everything, a move-to included. Whose motion was the last does not change.</summary>
    /// <remarks>Retail: CPhysicsObj::StopCompletely @0x00510180.</remarks>
    public MotionError StopCompletely() => PerformMovement(MovementKind.StopCompletely, MotionCommand.None, new MovementParameters());

    /// <summary>Both states to their defaults, the animations to the beginning.</summary>
    /// <remarks>Retail: MovementManager::EnterDefaultState @0x005241C0.</remarks>
    public void EnterDefaultState() => Interpreter.EnterDefaultState();

    /// <inheritdoc/>
    /// <remarks>Retail: MovementManager::CancelMoveTo @0x005241B0.</remarks>
    public void CancelMoveTo() => MoveTo?.Cancel(MotionError.Cancelled);

    /// <summary>Does exactly what another one does, whose body has the same motion table. A move-to is not taken over.</summary>
    internal void CopyMotionsFrom(MovementManager other)
    {
        Interpreter.CopyFrom(other.Interpreter);
        if (other.Animation is { } animation) Animation?.CopyFrom(animation);
    }

    internal void OnMoveToEnded(MotionError error) => LastMoveToError = error;

    private MotionInterpreter MakeInterpreter()
    {
        interpreter = new MotionInterpreter(Animation, body, weenie);
        interpreter.EnterDefaultState();
        return interpreter;
    }
}
