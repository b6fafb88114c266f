using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using WireAction = Surefoot.Protocol.Messages.MotionAction;

namespace Surefoot.Client;

/// <summary>States and places of the physics in the form in which they travel, and back.</summary>
internal static class WireForms
{
    /// <summary>
    /// The greatest factor on a speed that is believed; servers send single digits. A sweep goes in sub-steps of a body's radius, so that a
    /// quantum at a millionfold speed would take seconds.
    /// </summary>
    private const float MaxSpeed = 1000;

    /// <summary>A factor on a speed that can be meant.</summary>
    public static bool IsSpeed(float speed) => Math.Abs(speed) <= MaxSpeed;

    /// <summary>
    /// The factor on a body's size that is believed: a sweep goes in sub-steps of its radius, and a body is listed where it reaches.
    /// </summary>
    private const float MinScale = 0.01f, MaxScale = 100;

    /// <summary>A factor on a body's size that can be meant.</summary>
    public static bool IsScale(float scale) => scale is >= MinScale and <= MaxScale;

    /// <summary>A vector that can be meant: its length is a number.</summary>
    public static bool IsVector(Vector3 vector) => float.IsFinite(vector.LengthSquared());

    /// <summary>Reads a place.</summary>
    /// <returns>False when a number is not finite, the rotation is none, or the cell is on no map.</returns>
    public static bool TryRead(in WirePosition wire, out Position position)
    {
        position = new Position(wire.Cell, new Frame(wire.Origin, wire.Orientation));
        return position.IsValid && IsVector(wire.Origin);
    }

    /// <summary>A place.</summary>
    public static WirePosition Of(in Position position) => new(position.CellId, position.Frame.Origin, position.Frame.Rotation);

    /// <summary>The stamps of an object.</summary>
    public static MessageStamps Of(in ObjectStamps stamps) => new(
    [
        stamps.Position, stamps.Movement, stamps.State, stamps.Vector, stamps.Teleport, stamps.ServerControlledMove, stamps.ForcePosition,
        stamps.ObjDesc, stamps.Instance,
    ]);

    /// <summary>What is asked of a body, with the actions that wait, of which the wire takes 31.</summary>
    public static WireRawMotion Of(RawMotionState state)
    {
        Span<WireAction> actions = stackalloc WireAction[Math.Min(state.ActionCount, MotionActions.Most)];
        for (int i = 0; i < actions.Length; i++)
        {
            Physics.Motion.MotionAction action = state.GetAction(i);
            actions[i] = new WireAction((ushort)action.Command, (ushort)(action.Stamp & 0x7FFF), action.Autonomous, action.Speed);
        }

        return new WireRawMotion(
            (uint)state.CurrentHoldKey, (uint)state.CurrentStyle,
            (uint)state.ForwardCommand, (uint)state.ForwardHoldKey, state.ForwardSpeed,
            (uint)state.SidestepCommand, (uint)state.SidestepHoldKey, state.SidestepSpeed,
            (uint)state.TurnCommand, (uint)state.TurnHoldKey, state.TurnSpeed, new MotionActions(actions));
    }

    /// <summary>Reads what a body does.</summary>
    /// <param name="motion">What came.</param>
    /// <param name="commands">The numbering of the server's commands.</param>
    /// <param name="state">Becomes that state; whatever it was before.</param>
    /// <returns>False when a command has no name, or a speed is not finite or out of all bounds.</returns>
    public static bool TryRead(in WireInterpretedMotion motion, CommandTable commands, InterpretedMotionState state)
    {
        state.Reset();
        if (!TryName(motion.Style, out MotionCommand style) || !TryName(motion.ForwardCommand, out MotionCommand forward) ||
            !TryNameOrNone(motion.SidestepCommand, out MotionCommand sidestep) ||
            !TryNameOrNone(motion.TurnCommand, out MotionCommand turn) ||
            !IsSpeed(motion.ForwardSpeed) || !IsSpeed(motion.SidestepSpeed) || !IsSpeed(motion.TurnSpeed))
            return false;

        state.CurrentStyle = style;
        (state.ForwardCommand, state.ForwardSpeed) = (forward, motion.ForwardSpeed);
        (state.SidestepCommand, state.SidestepSpeed) = (sidestep, motion.SidestepSpeed);
        (state.TurnCommand, state.TurnSpeed) = (turn, motion.TurnSpeed);
        foreach (WireAction action in motion.Actions.Span)
        {
            if (!TryName(action.Command, out MotionCommand command) || !IsSpeed(action.Speed)) return false;
            state.AddAction(new Physics.Motion.MotionAction(command, action.Speed, action.Stamp, action.Autonomous));
        }

        return true;

        // A style of 0 was left out and counts as none; any other must have a name.
        bool TryNameOrNone(ushort lowWord, out MotionCommand command)
        {
            command = MotionCommand.None;
            return lowWord == 0 || TryName(lowWord, out command);
        }

        bool TryName(ushort lowWord, out MotionCommand command)
        {
            bool found = commands.TryGetCommand(lowWord, out uint id);
            command = (MotionCommand)id;
            return found;
        }
    }

    /// <summary>Reads how to go somewhere.</summary>
    /// <returns>False when a number is not finite, or the speed is out of all bounds.</returns>
    public static bool TryRead(in MoveToParams way, out MovementParameters parameters)
    {
        parameters = new MovementParameters
        {
            Flags = (MovementFlags)way.Bits,
            DistanceToObject = way.DistanceToObject,
            MinDistance = way.MinDistance,
            FailDistance = way.FailDistance,
            Speed = way.Speed,
            WalkRunThreshold = way.WalkRunThreshold,
            DesiredHeading = way.DesiredHeading,
        };
        return float.IsFinite(way.DistanceToObject) && float.IsFinite(way.MinDistance) && float.IsFinite(way.FailDistance) &&
            float.IsFinite(way.WalkRunThreshold) && IsSpeed(way.Speed) && float.IsFinite(way.DesiredHeading);
    }

    /// <summary>Reads how to turn: of the distances nothing is told.</summary>
    /// <returns>False when a number is not finite, or the speed is out of all bounds.</returns>
    public static bool TryReadTurn(in MoveToParams turn, out MovementParameters parameters)
    {
        parameters = new MovementParameters
        {
            Flags = (MovementFlags)turn.Bits,
            Speed = turn.Speed,
            DesiredHeading = turn.DesiredHeading,
        };
        return IsSpeed(turn.Speed) && float.IsFinite(turn.DesiredHeading);
    }
}
