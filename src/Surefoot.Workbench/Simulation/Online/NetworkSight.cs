using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>Reads off a client's world what its page is to draw.</summary>
internal static class NetworkSight
{
    /// <summary>How far a player reaches for a door: a server has it walk there, metres.</summary>
    private const double Reach = 15;

    /// <summary>Flag of doors in what a server says of an object (specification 08, 6.7).</summary>
    private const uint DoorFlag = 0x1000;

    /// <summary>Lists the bodies that are no players.</summary>
    public static void Bodies(GameClient? game, List<BodyPose> near)
    {
        near.Clear();
        if (game?.Player is not { } player) return;
        Position from = player.Body.Position;
        foreach (RemoteBody one in game.Others.Objects)
        {
            PhysicsBody body = one.Body;
            if (!IsShown(body) || (body.Weenie & WeenieTraits.Player) != 0 || body.Position.DistanceTo(from) > Sight.ShownWithin) continue;
            Position place = body.Position;
            bool isDoor = IsDoor(one);
            Vector3 size = body.Setup is { } shape ? ShapeSize.Of(shape, body.Scale) : Vector3.Zero;
            BodyFlags flags = BodyFlags.None;
            if (isDoor && (body.State & PhysicsState.Ethereal) != 0) flags |= BodyFlags.Open;
            if (!isDoor && !body.HasContact) flags |= BodyFlags.Airborne;
            near.Add(new BodyPose(
                body.Id, isDoor ? BodyKind.Door : BodyKind.Wanderer, flags, one.Weenie.Name, place.CellId, place.Frame.Origin,
                PlayerPose.YawOf(place), Sight.VelocityOf(body), body.Scale, size));
        }

        near.Sort((a, b) => a.Id.CompareTo(b.Id));
    }

    /// <summary>Lists the other players.</summary>
    public static void Players(GameClient? game, List<(uint Id, PlayerPose Pose)> near)
    {
        near.Clear();
        if (game is null) return;
        foreach (RemoteBody one in game.Others.Objects)
        {
            if (IsShown(one.Body) && (one.Body.Weenie & WeenieTraits.Player) != 0)
                near.Add((one.Id, Sight.PoseOf(one.Body, one.Movement?.Motions ?? default, leaps: 0)));
        }
    }

    /// <summary>The nearest door within reach; null when there is none.</summary>
    public static RemoteBody? NearestDoor(GameClient game, LocalPlayer player) => game.Others.Objects
        .Where(one => IsShown(one.Body) && IsDoor(one) && one.Body.Position.DistanceTo(player.Body.Position) <= Reach)
        .MinBy(one => one.Body.Position.DistanceTo(player.Body.Position));

    private static bool IsDoor(RemoteBody one) => (one.Weenie.Description & DoorFlag) != 0;

    private static bool IsShown(PhysicsBody body) =>
        body is { HasCell: true, Parent: null } && (body.State & (PhysicsState.Hidden | PhysicsState.NoDraw)) == 0;
}
