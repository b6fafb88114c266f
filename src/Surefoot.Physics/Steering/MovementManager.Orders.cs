using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <content>Orders to go somewhere, and what the movement messages of a server do.</content>
public sealed partial class MovementManager
{
    private const float FullCircle = 360f;

    /// <summary>Goes to an object, or away from it, and follows it on the way; ends a move-to under way and sticking.</summary>
    /// <param name="id">The object. What a creature holds is sought at the creature.</param>
    /// <param name="parameters">How.</param>
    /// <returns>False when there is no such object; nothing has changed then.</returns>
    /// <exception cref="ArgumentException">A parameter is not finite; nothing has changed.</exception>
    /// <remarks>Retail: CPhysicsObj::MoveToObject @0x00512860.</remarks>
    public bool MoveToObject(uint id, in MovementParameters parameters)
    {
        MovementParameters p = Checked(parameters);
        if (!TryFind(id, out PhysicsBody? target, out uint topLevel)) return false;
        BeginOrder().MoveToObject(topLevel, target.Radius, target.Height, p);
        return true;
    }

    /// <summary>Goes to a place, or away from it.</summary>
    /// <param name="place">The place.</param>
    /// <param name="parameters">How.</param>
    /// <exception cref="ArgumentException">
    /// The place or a parameter is not finite, or the cell id names no cell; nothing has changed.
    /// </exception>
    /// <exception cref="InvalidOperationException">The body is not one of an engine.</exception>
    /// <remarks>Retail: MovementManager::PerformMovement @0x005240D0 with kind 7.</remarks>
    public void MoveToPosition(in Position place, in MovementParameters parameters)
    {
        PhysicsBody.ThrowIfBad(place);
        MovementParameters p = Checked(parameters);
        BeginOrder().MoveToPosition(place, p);
    }

    /// <summary>Turns to face an object. The heading of the parameters has no effect.</summary>
    /// <param name="id">The object.</param>
    /// <param name="parameters">How.</param>
    /// <returns>False when there is no such object; nothing has changed then.</returns>
    /// <exception cref="ArgumentException">A parameter is not finite; nothing has changed.</exception>
    /// <remarks>Retail: CPhysicsObj::TurnToObject @0x00512940.</remarks>
    public bool TurnToObject(uint id, in MovementParameters parameters)
    {
        MovementParameters p = Checked(parameters);
        if (!TryFind(id, out _, out uint topLevel)) return false;
        BeginOrder().TurnToObject(topLevel, p);
        return true;
    }

    /// <summary>Turns to the heading of the parameters.</summary>
    /// <param name="parameters">How, and where to.</param>
    /// <exception cref="ArgumentException">A parameter is not finite; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The body is not one of an engine.</exception>
    /// <remarks>Retail: CPhysicsObj::TurnToHeading @0x00512980.</remarks>
    public void TurnToHeading(in MovementParameters parameters)
    {
        MovementParameters p = Checked(parameters);
        BeginOrder().TurnToHeading(p);
    }

    /// <summary>Does what an UpdateMotion of the interpreted kind says; nothing without an interpreter.</summary>
    /// <param name="state">The state in the message.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <param name="standingLongJump">The body charges a standing long jump.</param>
    /// <param name="stickTo">Id of the object to stick to, 0 for none.</param>
    /// <param name="style">The style that the message has beside the state; null for that of the state.</param>
    /// <exception cref="ArgumentException">A speed is NaN or infinite; nothing has changed.</exception>
    /// <remarks>Retail: MovementManager::unpack_movement @0x00524440, type 0.</remarks>
    public void ApplyUpdate(
        InterpretedMotionState state, bool autonomous, bool standingLongJump = false, uint stickTo = 0, MotionCommand? style = null)
    {
        ArgumentNullException.ThrowIfNull(state);
        MotionInterpreter.ThrowIfNotFinite(state);
        if (!TryBeginUpdate(style ?? state.CurrentStyle, autonomous)) return;
        Interpreter.MoveToInterpretedState(state);
        if (stickTo != 0) steered?.StickToObject(stickTo);
        Interpreter.StandingLongJump = standingLongJump;
    }

    /// <summary>
    /// Does what an UpdateMotion of type 6 says: goes to an object, or to the place in the message when the object is not known.
    /// </summary>
    /// <param name="style">The style in the message.</param>
    /// <param name="id">The object.</param>
    /// <param name="place">Where it was.</param>
    /// <param name="parameters">How.</param>
    /// <param name="runRate">Factor on the running speed.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <exception cref="ArgumentException">A number is not finite, or the cell id names no cell; nothing has changed.</exception>
    public void ApplyMoveToObject(
        MotionCommand style, uint id, in Position place, in MovementParameters parameters, float runRate, bool autonomous)
    {
        PhysicsBody.ThrowIfBad(place);
        MovementParameters p = Checked(parameters);
        MotionInterpreter.ThrowIfNotFinite(runRate, nameof(runRate));
        if (!TryBeginUpdate(style, autonomous)) return;
        MoveToManager manager = MakeMoveToManager();
        Interpreter.MyRunRate = runRate;
        if (!MoveToObject(id, p)) manager.MoveToPosition(place, p);
    }

    /// <summary>Does what an UpdateMotion of type 7 says: goes to a place.</summary>
    /// <param name="style">The style in the message.</param>
    /// <param name="place">The place.</param>
    /// <param name="parameters">How.</param>
    /// <param name="runRate">Factor on the running speed.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <exception cref="ArgumentException">A number is not finite, or the cell id names no cell; nothing has changed.</exception>
    public void ApplyMoveToPosition(
        MotionCommand style, in Position place, in MovementParameters parameters, float runRate, bool autonomous)
    {
        PhysicsBody.ThrowIfBad(place);
        MovementParameters p = Checked(parameters);
        MotionInterpreter.ThrowIfNotFinite(runRate, nameof(runRate));
        if (!TryBeginUpdate(style, autonomous)) return;
        Interpreter.MyRunRate = runRate;
        MakeMoveToManager().MoveToPosition(place, p);
    }

    /// <summary>
    /// Does what an UpdateMotion of type 8 says: turns to an object, or to the heading in the message when the object is not known.
    /// </summary>
    /// <param name="style">The style in the message.</param>
    /// <param name="id">The object.</param>
    /// <param name="heading">Degrees.</param>
    /// <param name="parameters">How.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <exception cref="ArgumentException">A number is not finite; nothing has changed.</exception>
    public void ApplyTurnToObject(MotionCommand style, uint id, float heading, in MovementParameters parameters, bool autonomous)
    {
        MovementParameters p = parameters;
        p.DesiredHeading = heading;
        MovementParameters fallback = Checked(p), known = Checked(parameters);
        if (!TryBeginUpdate(style, autonomous)) return;
        MoveToManager manager = MakeMoveToManager();
        if (!TurnToObject(id, known)) manager.TurnToHeading(fallback);
    }

    /// <summary>Does what an UpdateMotion of type 9 says: turns to the heading of the parameters.</summary>
    /// <param name="style">The style in the message.</param>
    /// <param name="parameters">How, and where to.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <exception cref="ArgumentException">A number is not finite; nothing has changed.</exception>
    public void ApplyTurnToHeading(MotionCommand style, in MovementParameters parameters, bool autonomous)
    {
        MovementParameters p = Checked(parameters);
        if (!TryBeginUpdate(style, autonomous)) return;
        MakeMoveToManager().TurnToHeading(p);
    }

    /// <summary>Does what an UpdateMotion of a kind that there is not says: of all of it only the style acts.</summary>
    /// <param name="style">The style in the message.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    public void ApplyStyle(MotionCommand style, bool autonomous) => TryBeginUpdate(style, autonomous);

    /// <summary>What every movement message begins with: a move-to and sticking end, and the style is taken. The style that a message
    /// leaves out is <see cref="MotionCommand.None"/>; it stays as it is then (08, section 12, 1).</summary>
    /// <returns>False without an interpreter: such a body ignores the message.</returns>
    private bool TryBeginUpdate(MotionCommand style, bool autonomous)
    {
        body.LastMoveWasAutonomous = autonomous;
        if (interpreter is null) return false;
        body.CancelMoveTo();
        body.Unstick();
        if (style != MotionCommand.None && style != interpreter.Interpreted.CurrentStyle)
            interpreter.PerformMovement(MovementKind.RawCommand, style, new MovementParameters());
        return true;
    }

    private MoveToManager BeginOrder()
    {
        steered?.SetActive(true);
        MoveToManager manager = MakeMoveToManager();
        manager.Interrupt();
        return manager;
    }

    /// <remarks>Retail: MovementManager::MakeMoveToManager @0x00524000.</remarks>
    private MoveToManager MakeMoveToManager()
    {
        if (steered is null) throw new InvalidOperationException("Only a body of an engine can be ordered somewhere.");
        return MoveTo ??= new MoveToManager(SteeredPhysicsBody.Of(steered));
    }

    private bool TryFind(uint id, [System.Diagnostics.CodeAnalysis.NotNullWhen(true)] out PhysicsBody? target, out uint topLevel)
    {
        target = steered?.Population.Find(id);
        topLevel = target?.Parent?.Id ?? target?.Id ?? 0;
        return target is not null;
    }

    /// <summary>Finite parameters with a heading below a full circle: one of exactly 360 degrees would never be reached.</summary>
    private static MovementParameters Checked(in MovementParameters parameters)
    {
        MovementParameters p = parameters;
        ThrowIfNotFinite(p.DistanceToObject);
        ThrowIfNotFinite(p.MinDistance);
        ThrowIfNotFinite(p.DesiredHeading);
        ThrowIfNotFinite(p.FailDistance);
        ThrowIfNotFinite(p.WalkRunThreshold);
        MotionInterpreter.ThrowIfNotFinite(p.Speed, nameof(parameters));
        p.DesiredHeading %= FullCircle;
        if (p.DesiredHeading < 0) p.DesiredHeading += FullCircle;
        return p;
    }

    private static void ThrowIfNotFinite(float value)
    {
        if (!float.IsFinite(value)) throw new ArgumentException($"The movement parameter {value} is not finite.", nameof(value));
    }
}
