using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>Has a body do what the movement in a server's message orders: a motion state, going or turning somewhere.</summary>
/// <remarks>Specification 08, 6.4 and 09, 5.4.</remarks>
internal sealed class ServerOrders(CommandTable commands)
{
    private readonly InterpretedMotionState state = new();

    /// <summary>Has a body obey.</summary>
    /// <param name="movement">The body's movement.</param>
    /// <param name="order">What it is to do.</param>
    /// <param name="autonomous">The body's own player asked for it.</param>
    /// <returns>
    /// False when a command has no name, a number is out of all bounds or the place has no cell; nothing has changed then.
    /// </returns>
    public bool TryObey(MovementManager movement, in MovementData order, bool autonomous)
    {
        if (!TryReadStyle(order.Style, out MotionCommand style)) return false;
        switch (order.Type)
        {
            case MovementType.InterpretedMotion:
                if (!WireForms.TryRead(order.State, commands, state)) return false;
                movement.ApplyUpdate(state, autonomous, order.StandingLongJump, order.Target, style);
                return true;
            case MovementType.MoveToObject:
            case MovementType.MoveToPosition:
                if (!WireForms.TryRead(order.Parameters, out MovementParameters way) || !WireForms.IsSpeed(order.RunRate)) return false;
                Position place = new(order.Cell, order.Origin);
                if (!place.IsValid || !float.IsFinite(order.Origin.LengthSquared())) return false;
                if (order.Type == MovementType.MoveToPosition) movement.ApplyMoveToPosition(style, place, way, order.RunRate, autonomous);
                else movement.ApplyMoveToObject(style, order.Target, place, way, order.RunRate, autonomous);
                return true;
            case MovementType.TurnToObject:
            case MovementType.TurnToHeading:
                if (!WireForms.TryReadTurn(order.Parameters, out MovementParameters turn) || !float.IsFinite(order.DesiredHeading))
                    return false;
                if (order.Type == MovementType.TurnToHeading) movement.ApplyTurnToHeading(style, turn, autonomous);
                else movement.ApplyTurnToObject(style, order.Target, order.DesiredHeading, turn, autonomous);
                return true;
            default:
                movement.ApplyStyle(style, autonomous);
                return true;
        }
    }

    /// <summary>Word 0 names none.</summary>
    private bool TryReadStyle(ushort word, out MotionCommand style)
    {
        style = MotionCommand.None;
        if (word == 0) return true;
        bool found = commands.TryGetCommand(word, out uint id);
        style = (MotionCommand)id;
        return found;
    }
}
