using System.Runtime.InteropServices;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>What a player knows: objects of its landblock and of the eight around it, from the moment on when they are near; in a closed
/// room those of the rooms that are seen from there.</summary>
/// <remarks>Specification 08, 8.7.</remarks>
internal sealed class Awareness(WorldStage stage, PlayerItem player)
{
    private const double FirstSight = 112.5, ForgottenAfter = 25, LookEvery = 5;

    private readonly Dictionary<WorldItem, double> lostAt = [];
    private readonly List<WorldItem> lost = [];
    private double nextLook, nextLoss = double.PositiveInfinity;

    /// <summary>Objects known.</summary>
    public int Count => lostAt.Count;

    /// <summary>It knows an object.</summary>
    public bool Knows(WorldItem item) => lostAt.ContainsKey(item);

    /// <summary>The player has come into another cell, or the time has come: looks at everything.</summary>
    public void LookAround(double now)
    {
        nextLook = now + LookEvery;
        foreach (WorldItem item in stage.Items) Look(item, now);
    }

    /// <summary>Looks at everything now and then.</summary>
    public void Update(double now)
    {
        if (now >= nextLook) LookAround(now);
        if (now < nextLoss) return;
        nextLoss = double.PositiveInfinity;
        foreach ((WorldItem item, double at) in lostAt)
        {
            if (now >= at) lost.Add(item);
            else nextLoss = Math.Min(nextLoss, at);
        }

        foreach (WorldItem item in lost) Forget(item);
        lost.Clear();
    }

    /// <summary>An object has come into another cell, or is gone from where it was.</summary>
    public void Look(WorldItem item, double now)
    {
        if (item == player) return;
        bool isSeen = item.IsThere && IsAround(item.Place.CellId);
        ref double at = ref CollectionsMarshal.GetValueRefOrNullRef(lostAt, item);
        if (!System.Runtime.CompilerServices.Unsafe.IsNullRef(ref at))
        {
            at = isSeen ? double.PositiveInfinity : Math.Min(at, now + ForgottenAfter);
            nextLoss = Math.Min(nextLoss, at);
            return;
        }

        if (!isSeen || item.Place.HorizontalDistanceTo(player.Place) > FirstSight) return;
        lostAt.Add(item, double.PositiveInfinity);
        item.Audience.Add(player);
        player.Client.Send(item.Describe());
    }

    /// <summary>An object is not known any more.</summary>
    public void Forget(WorldItem item)
    {
        if (!lostAt.Remove(item)) return;
        item.Audience.Remove(player);
        player.Client.Send(new DeleteObject(item.Id, item.Instance));
    }

    /// <summary>Nobody tells this player anything any more.</summary>
    public void Clear()
    {
        foreach (WorldItem item in lostAt.Keys) item.Audience.Remove(player);
        lostAt.Clear();
    }

    private bool IsAround(uint cell)
    {
        uint own = player.Place.CellId;
        if (stage.Engine.World.GetVisible(own) is EnvCell { SeenOutside: false } room) return cell == own || room.StabList.Contains(cell);
        return Math.Abs((int)(own >> 24) - (int)(cell >> 24)) <= 1 &&
            Math.Abs((int)((own >> 16) & 0xFF) - (int)((cell >> 16) & 0xFF)) <= 1;
    }
}
