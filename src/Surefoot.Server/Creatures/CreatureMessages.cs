using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>Makes the messages about a creature, each with the next stamp.</summary>
/// <remarks>Specification 08, 4.3 and 8.7.</remarks>
internal sealed class CreatureMessages(PhysicsBody body, in ObjectStamps stamps)
{
    /// <summary>A body that moved less since its place was told last has not moved, metres.</summary>
    private const double Unmoved = 0.01;

    private readonly ushort instance = stamps.Instance, teleport = stamps.Teleport, force = stamps.ForcePosition;
    private ushort position = stamps.Position, movement = stamps.Movement, control = stamps.ServerControlledMove;
    private Position told = Position.Nowhere;

    /// <summary>What it does from now on, as the server ordered it.</summary>
    public UpdateMotion Motion(in MovementData order) => new(body.Id, instance, ++movement, ++control, Autonomous: false, order);

    /// <summary>Where it is; false when that has been told.</summary>
    public bool TryTellPosition(out UpdatePosition message)
    {
        message = default;
        Position here = body.Position;
        if (!body.HasCell) return false;
        if (told.CellId == here.CellId && told.Frame.Rotation == here.Frame.Rotation && told.DistanceTo(here) < Unmoved) return false;
        told = here;
        WirePosition place = new(here.CellId, here.Frame.Origin, here.Frame.Rotation);
        message = new UpdatePosition(body.Id, new PositionPack(place, body.OnWalkable, instance, ++position, teleport, force));
        return true;
    }
}
