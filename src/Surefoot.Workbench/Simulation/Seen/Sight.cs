using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>Reads off a page's view what it is to draw.</summary>
internal static class Sight
{
    /// <summary>How far from a player bodies are shown to it, metres.</summary>
    internal const double ShownWithin = 160;

    /// <summary>Lists the bodies that are no players: creatures as the page sees them, doors as they are.</summary>
    public static void Bodies(SimulatedPlayer player, IReadOnlyList<Inhabitant> inhabitants, List<BodyPose> near)
    {
        near.Clear();
        Position from = player.Player.Body.Position;
        foreach (Inhabitant one in inhabitants)
        {
            PhysicsBody? body = one.Kind == BodyKind.Door ? one.Body : player.Viewer.Find(one.Body.Id);
            if (body is not { HasCell: true } || body.Position.DistanceTo(from) > ShownWithin) continue;
            Position place = body.Position;
            BodyFlags flags = BodyFlags.None;
            if (one.IsOpen) flags |= BodyFlags.Open;
            if ((one.Body.Transient & TransientState.CheckEthereal) != 0) flags |= BodyFlags.WaitsToClose;
            if (one.Kind != BodyKind.Door && !body.HasContact) flags |= BodyFlags.Airborne;
            near.Add(new BodyPose(
                body.Id, one.Kind, flags, one.Name, place.CellId, place.Frame.Origin, PlayerPose.YawOf(place), VelocityOf(body), body.Scale,
                one.Size));
        }
    }

    /// <summary>Lists the other players.</summary>
    public static void Players(SimulatedPlayer player, IReadOnlyList<SimulatedPlayer> players, List<(uint Id, PlayerPose Pose)> near)
    {
        near.Clear();
        foreach (SimulatedPlayer other in players)
        {
            if (other == player || player.Viewer.Find(other.Seen.Id) is not { } body) continue;
            near.Add((body.Id, PoseOf(body, player.Viewer.MotionsOf(body), player.Viewer.LeapsOf(body))));
        }
    }

    /// <summary>Another player as a page draws it.</summary>
    /// <param name="body">Its body in the page's own view.</param>
    /// <param name="motions">What it does there.</param>
    /// <param name="leaps">How often it was not moved but put somewhere else, modulo 256.</param>
    public static PlayerPose PoseOf(PhysicsBody body, in MotionSummary motions, byte leaps)
    {
        Position place = body.Position;
        Vector3 velocity = VelocityOf(body);
        return new PlayerPose(
            body.SimulatedTime,
            place.CellId,
            place.Frame.Origin,
            PlayerPose.YawOf(place),
            velocity,
            new Vector2(velocity.X, velocity.Y).Length(),
            FlagsOf(body),
            body.HasContact ? body.ContactPlane : default,
            0,
            body.LastQuantum,
            1,
            (uint)motions.Forward,
            motions.ForwardSpeed,
            motions.Sidestep == MotionCommand.None ? 0 : motions.SidestepSpeed,
            motions.Turn == MotionCommand.None ? 0 : motions.TurnSpeed,
            leaps);
    }

    /// <summary>Lists where those are in truth that the page sees.</summary>
    public static void Truth(SimulatedPlayer player, IReadOnlyList<ISeenObject> seen, List<TruePlace> near)
    {
        near.Clear();
        if (!player.WantsTruth) return;
        Position from = player.Player.Body.Position;
        foreach (ISeenObject one in seen)
        {
            if (one.Id == player.Seen.Id || !one.IsThere) continue;
            Position place = one.Place;
            if (place.DistanceTo(from) <= ShownWithin)
                near.Add(new TruePlace(one.Id, place.CellId, place.Frame.Origin, PlayerPose.YawOf(place)));
        }
    }

    /// <summary>What it stands on, or touches.</summary>
    internal static PoseFlags FlagsOf(PhysicsBody body)
    {
        PoseFlags flags = PoseFlags.None;
        if (body.HasContact) flags |= PoseFlags.Contact;
        if (body.OnWalkable) flags |= PoseFlags.OnWalkable;
        if (body.HasContact && body.Transient.HasFlag(TransientState.WaterContact)) flags |= PoseFlags.InWater;
        return flags;
    }

    /// <summary>How fast it went in the last tick, metres a second.</summary>
    internal static Vector3 VelocityOf(PhysicsBody body) => body.IsActive ? body.AchievedVelocity : Vector3.Zero;
}
