using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>Claims of a player in the form in which the physics takes them.</summary>
internal static class ClaimReader
{
    /// <summary>A turn by the pointer; keys ask for 1.</summary>
    private const float FastestTurn = 1.5f;

    /// <summary>Reads a place.</summary>
    /// <returns>False when a number is not finite, the rotation is none, or the cell is on no map.</returns>
    internal static bool TryRead(in WirePosition wire, out Position position)
    {
        position = new Position(wire.Cell, new Frame(wire.Origin, wire.Orientation));
        return position.IsValid && float.IsFinite(wire.Origin.LengthSquared());
    }

    /// <summary>Reads which keys are held.</summary>
    /// <returns>False when a speed is one that no key and no pointer asks for; <paramref name="keys"/> is as it was then.</returns>
    internal static bool TryRead(in WireRawMotion wire, RawMotionState keys)
    {
        if (!(wire.ForwardSpeed is >= 0 and <= 1 && wire.SidestepSpeed is >= 0 and <= 1 && wire.TurnSpeed is >= 0 and <= FastestTurn))
            return false;
        keys.CurrentHoldKey = (HoldKey)wire.CurrentHoldKey;
        keys.CurrentStyle = (MotionCommand)wire.CurrentStyle;
        (keys.ForwardCommand, keys.ForwardHoldKey, keys.ForwardSpeed) =
            ((MotionCommand)wire.ForwardCommand, (HoldKey)wire.ForwardHoldKey, wire.ForwardSpeed);
        (keys.SidestepCommand, keys.SidestepHoldKey, keys.SidestepSpeed) =
            ((MotionCommand)wire.SidestepCommand, (HoldKey)wire.SidestepHoldKey, wire.SidestepSpeed);
        (keys.TurnCommand, keys.TurnHoldKey, keys.TurnSpeed) =
            ((MotionCommand)wire.TurnCommand, (HoldKey)wire.TurnHoldKey, wire.TurnSpeed);
        return true;
    }
}
