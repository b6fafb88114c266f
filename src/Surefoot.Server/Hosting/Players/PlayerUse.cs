using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>A player uses an object: one in reach at once, one out of reach when the server has moved the player there.</summary>
/// <remarks>Specification 08, 5.7.</remarks>
internal sealed class PlayerUse(WorldStage stage, PlayerItem player)
{
    private const double LongestWay = 30;
    private const float WalkWithin = 15;
    private const uint CannotReach = 0x0039;

    private WorldItem? target;
    private double givenUpAt;

    /// <summary>The server moves the player to something.</summary>
    public bool IsUnderWay => target is not null;

    /// <summary>The player wants to use something.</summary>
    public void Begin(uint id)
    {
        End();
        if (stage.Find(id) is not { IsThere: true } item || item == player || !player.Awareness.Knows(item))
        {
            player.Client.Send(new UseDone(CannotReach));
            return;
        }

        player.Claims.BeginOrder();
        Position there = item.Place;
        MovementFlags way = MovementFlags.Default;
        if (IsInReach(item))
        {
            player.Broadcast.Order(MovementData.TurnToObject(0, id, player.Place.HeadingTo(there), (uint)way, 1, 0));
            Act(item);
            return;
        }

        target = item;
        givenUpAt = stage.Server.Now + LongestWay;
        player.Broadcast.Order(MovementData.MoveToObject(
            0, id, there.CellId, there.Frame.Origin,
            new MoveToParams((uint)way, ReachOf(item), 0, float.MaxValue, 1, WalkWithin, 0), player.RunRate));
    }

    /// <summary>Looks how the way there goes.</summary>
    public void Update(double now)
    {
        if (target is not { } item) return;
        if (!item.IsThere || now >= givenUpAt) End();
        else if (IsInReach(item))
        {
            target = null;
            Act(item);
        }
    }

    /// <summary>The player goes elsewhere: nothing comes of it.</summary>
    public void End()
    {
        if (target is null) return;
        target = null;
        player.Client.Send(new UseDone(CannotReach));
    }

    private static float ReachOf(WorldItem item) => item is DoorItem ? DoorItem.UseRadius : 0.6f;

    /// <summary>From surface to surface, and a little more than a body comes near by itself.</summary>
    private bool IsInReach(WorldItem item) =>
        player.Place.HorizontalDistanceTo(item.Place) - player.Body.Radius - item.Body.Radius <= ReachOf(item) + 0.25;

    private void Act(WorldItem item)
    {
        if (item is DoorItem door) door.Use(stage.Server.Now);
        player.Client.Send(new UseDone(0));
    }
}
