using System.Numerics;
using System.Text.Json;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Replays recorded runs of the managers that move other bodies: each case from its start, until something differs.</summary>
internal static class SteeringReplay
{
    private static readonly HashSet<string> Motions = ["do", "stop", "halt", "cancel", "place"];
    private static readonly HashSet<string> MotionsAndReports = [.. Motions, "told"];

    /// <summary>What it replays.</summary>
    internal static readonly string[] Families = ["interpolation", "sticky", "constraint", "move-to", "target"];

    /// <summary>Replays a case.</summary>
    internal static ManagerResult Run(JsonElement recorded)
    {
        StubWorld world = new()
        {
            Clock = recorded.GetProperty("clock").GetDouble(),
            Noteworthy = recorded.GetProperty("family").GetString() == "target" ? MotionsAndReports : Motions,
        };
        foreach (JsonElement body in recorded.GetProperty("bodies").EnumerateArray())
            world.Add(new StubBody(world, new StubSettings(body)));
        List<WatchedBody> watched =
            [.. recorded.GetProperty("watch").EnumerateArray().Select(static id => new WatchedBody(id.GetString()!))];
        int done = 0;
        string? difference = null;
        JsonElement entries = recorded.GetProperty("steps");
        foreach (JsonElement entry in entries.EnumerateArray())
        {
            Advance(world, entry);
            difference = Compare(world, watched, entry.GetProperty("out"));
            if (difference is not null) break;
            done++;
        }

        return ManagerResult.Of(recorded, entries.GetArrayLength(), done, difference);
    }

    private static void Advance(StubWorld world, JsonElement entry)
    {
        world.Calls.Clear();
        if (entry.TryGetProperty("ev", out JsonElement events))
            foreach (JsonElement e in events.EnumerateArray()) Happen(world, e);
        float quantum = entry.GetProperty("q").GetSingle();
        world.Clock += quantum;
        foreach (StubBody body in world.Bodies.ToArray()) body.Advance(quantum);
    }

    private static string? Compare(StubWorld world, List<WatchedBody> watched, JsonElement recorded)
    {
        if (world.CompareCalls(recorded) is { } call) return call;
        bool anyState = recorded.TryGetProperty("s", out JsonElement states);
        foreach (WatchedBody body in watched)
        {
            if (anyState && states.TryGetProperty(body.Name, out JsonElement changes)) body.Take(changes);
            if (body.Compare(world[body.Id]) is { } difference) return difference;
        }

        return null;
    }

    private static void Happen(StubWorld world, JsonElement e)
    {
        StubBody body = world[e[1].Id()];
        StubSettings settings = body.Settings;
        switch (e[0].GetString())
        {
            case "contact": settings.Contact = e[2].Flag(); break;
            case "walkable": settings.Walkable = e[2].Flag(); break;
            case "free": settings.Free = e[2].GetSingle(); break;
            case "placing": settings.Placing = e[2].Flag(); break;
            case "speeds": settings.Speeds = (e[2].GetSingle(), e[3].GetSingle()); break;
            case "run-rate": settings.RunRate = e[2].GetSingle(); break;
            case "hold-key": settings.HoldKey = (HoldKey)e[2].GetInt32(); break;
            case "refuse": settings.Refusal = (MotionError)e[2].GetInt32(); break;
            case "root": settings.Root = new Vector4(e[2].GetSingle(), e[3].GetSingle(), e[4].GetSingle(), e[5].GetSingle()); break;
            case "pending": settings.SetPending(e[2].GetInt32(), e[3].GetInt32(), e[4].GetInt32()); break;
            case "face": body.SetHeading(e[2].GetSingle()); break;
            case "warp": settings.Position = PositionAt(e, 2); break;
            case "gone": world.Forget(body.Id); break;
            case "back": world.BringBack(body.Id); break;
            case "exit":
                body.HandleExitWorld();
                world.Forget(body.Id);
                break;
            case "teleport":
                body.HandleTeleport();
                body.Place(PositionAt(e, 2));
                break;
            default: Steer(body, e); break;
        }
    }

    private static void Steer(StubBody body, JsonElement e)
    {
        switch (e[0].GetString())
        {
            case "to": body.InterpolateTo(PositionAt(e, 2), e[5].Flag()); break;
            case "stop-interpolating": body.StopInterpolating(); break;
            case "stick": body.MakePositionManager().StickTo(e[2].Id(), e[3].GetSingle()); break;
            case "stick-to-object": body.StickToObject(e[2].Id()); break;
            case "unstick": body.Unstick(); break;
            case "constrain": body.ConstrainTo(PositionAt(e, 2), e[5].GetSingle(), e[6].GetSingle()); break;
            case "unconstrain": body.Unconstrain(); break;
            case "set-target": body.SetTarget(e[2].GetUInt32(), e[3].Id(), e[4].GetSingle(), e[5].GetDouble()); break;
            case "clear-target": body.ClearTarget(); break;
            case "target-quantum": body.TargetManager?.SetQuantum(e[2].GetDouble()); break;
            case "cancel": body.CancelMoveTo(); break;
            case "hit-ground": body.MoveTo?.HitGround(); break;
            default: StubOrders.Give(body, e); break;
        }
    }

    private static Position PositionAt(JsonElement e, int index) => StubSettings.PositionIn(e[index], e[index + 1], e[index + 2]);
}
