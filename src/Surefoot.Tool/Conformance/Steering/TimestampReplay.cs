using System.Text.Json;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Replays recorded messages against the nine stamps of one body: which are accepted, and what they do.</summary>
internal sealed class TimestampReplay
{
    /// <summary>What it replays.</summary>
    internal const string Family = "timestamps";

    private const int Dispatched = 1, Stale = 2, Kept = 4;

    private static readonly HashSet<string> Effects =
    [
        "teleport-hook", "cancel", "place", "interpolate", "constrain", "velocity", "omega", "state", "motion", "lose-control", "blip",
        "send-position", "teleport-player", "player-teleported", "leave-world",
    ];

    private readonly StubWorld world;
    private readonly StubBody body;
    private readonly Dictionary<string, JsonElement> recorded = [];
    private MessageStamps stamps;
    private bool lastMoveWasAutonomous;

    private TimestampReplay(JsonElement run)
    {
        world = new StubWorld { Clock = run.GetProperty("clock").GetDouble(), Noteworthy = Effects };
        JsonElement only = run.GetProperty("bodies")[0];
        body = new StubBody(world, new StubSettings(only));
        world.Add(body);
        if (only.TryGetProperty("stamps", out JsonElement list))
            stamps = new MessageStamps([.. list.EnumerateArray().Select(s => s.GetUInt16())]);
    }

    /// <summary>Replays a case.</summary>
    internal static ManagerResult Run(JsonElement run)
    {
        TimestampReplay replay = new(run);
        int done = 0;
        string? difference = null;
        JsonElement entries = run.GetProperty("steps");
        foreach (JsonElement entry in entries.EnumerateArray())
        {
            difference = replay.Replay(entry);
            if (difference is not null) break;
            done++;
        }

        return ManagerResult.Of(run, entries.GetArrayLength(), done, difference);
    }

    private string? Replay(JsonElement entry)
    {
        if (entry.TryGetProperty("move", out JsonElement move)) StubOrders.TurnToHeading(body, move);
        if (entry.TryGetProperty("distance", out JsonElement distance)) body.Settings.PlayerDistance = distance.GetSingle();
        world.Calls.Clear();
        int code = Dispatch(entry);
        JsonElement expected = entry.GetProperty("out");
        if (code != expected.GetProperty("code").GetInt32()) return $"code is {code}, recorded {expected.GetProperty("code")}";
        if (world.CompareCalls(expected) is { } call) return call;
        if (expected.TryGetProperty("s", out JsonElement changes))
            foreach (JsonProperty change in changes.EnumerateObject()) recorded[change.Name] = change.Value;
        foreach ((string field, JsonElement value) in recorded)
        {
            if (!Tolerance.Same(ValueOf(field), value)) return $"{field} is {ValueOf(field)}, recorded {value}";
        }

        return null;
    }

    private int Dispatch(JsonElement entry)
    {
        JsonElement message = entry.GetProperty("msg");
        if (entry.TryGetProperty("unknown", out JsonElement unknown) && unknown.Flag()) return Kept;
        if (message.TryGetProperty("unknown", out unknown) && unknown.Flag()) return Kept;
        InstanceAge age = stamps.AgeOf(message.GetProperty("i").GetUInt16());
        if (age != InstanceAge.Current) return age == InstanceAge.Stale ? Stale : Kept;
        switch (message.GetProperty("kind").GetString())
        {
            case "position":
                TakePosition(message);
                break;
            case "motion":
                TakeMotion(message, "ss");
                break;
            case "position-and-motion":
                TakePosition(message);
                TakeMotion(message, "mss");
                break;
            case "vector":
                TakeVector(message);
                break;
            case "state":
                if (stamps.TryAdvance(ObjectStamp.State, message.GetProperty("ss").GetUInt16()))
                    world.Log("state", body.Id, message.GetProperty("state").Id());
                break;
            case "pickup":
                if (stamps.TryAdvance(ObjectStamp.Position, message.GetProperty("ps").GetUInt16())) LeaveWorld();
                break;
            default:
                throw new InvalidDataException($"the message {message} is not known.");
        }

        return Dispatched;
    }

    private void TakePosition(JsonElement message)
    {
        (ushort position, ushort teleport) = (message.GetProperty("ps").GetUInt16(), message.GetProperty("ts").GetUInt16());
        Position place = StubSettings.PositionIn(message.GetProperty("cell"), message.GetProperty("pos"), message.GetProperty("rot"));
        if (body.IsLocalPlayer && stamps.TryAcceptForcedPosition(position, teleport, message.GetProperty("fs").GetUInt16()))
        {
            world.Log("blip", body.Id);
            place.Frame.SetHeading((float)body.Position.Frame.Heading);
            body.Place(place);
            world.Log("send-position", body.Id);
            return;
        }

        if (!stamps.TryAcceptPosition(position, teleport, out bool teleported)) return;
        bool contact = message.GetProperty("contact").Flag();
        if (body.IsLocalPlayer) TakePlayerPosition(message, place, teleported, contact);
        else TakeOtherPosition(place, teleported, contact);
    }

    private void TakeOtherPosition(in Position place, bool teleported, bool contact)
    {
        bool keepHeading = body.MoveTo is { IsMovingTo: true };
        PositionUpdate update = body.MoveOrTeleport(place, teleported, contact);
        if (update == PositionUpdate.Interpolated) world.Log("interpolate", body.Id, keepHeading);
        if (update != PositionUpdate.Ignored) LogLeash();
    }

    /// <remarks>Specification 08, 4.4, step 5.</remarks>
    private void TakePlayerPosition(JsonElement message, in Position place, bool teleported, bool contact)
    {
        if (teleported)
        {
            world.Log("teleport-player", body.Id);
            body.Place(place);
            body.HandleTeleport();
            world.Log("player-teleported", body.Id);
            TieLeash(place);
            world.Log("velocity", body.Id, System.Numerics.Vector3.Zero);
            return;
        }

        TieLeash(place);
        if (!message.GetProperty("server").Flag() || !contact) return;
        bool keepHeading = message.GetProperty("keep").Flag();
        body.InterpolateTo(place, keepHeading);
        world.Log("interpolate", body.Id, keepHeading);
    }

    private void TakeMotion(JsonElement message, string serverControl)
    {
        if (!stamps.TryAcceptMotion(message.GetProperty("ms").GetUInt16(), message.GetProperty(serverControl).GetUInt16())) return;
        bool autonomous = message.GetProperty("auto").Flag();
        if (autonomous && body.IsLocalPlayer) return;
        lastMoveWasAutonomous = autonomous;
        world.Log("motion", body.Id, autonomous);
        body.CancelMoveTo();
        body.Unstick();
        if (body.IsLocalPlayer) world.Log("lose-control", body.Id);
    }

    private void TakeVector(JsonElement message)
    {
        if (!stamps.TryAdvance(ObjectStamp.Vector, message.GetProperty("vs").GetUInt16())) return;
        if (body.IsLocalPlayer && !message.GetProperty("server").Flag()) return;
        world.Log("velocity", body.Id, message.GetProperty("v").Vector());
        world.Log("omega", body.Id, message.GetProperty("w").Vector());
    }

    private void TieLeash(in Position place)
    {
        uint cell = body.Position.CellId;
        body.ConstrainTo(place, CorrectionDistances.LeashStart(cell), CorrectionDistances.LeashMax(cell));
        LogLeash();
    }

    private void LogLeash()
    {
        uint cell = body.Position.CellId;
        world.Log("constrain", body.Id, CorrectionDistances.LeashStart(cell), CorrectionDistances.LeashMax(cell));
    }

    private void LeaveWorld()
    {
        world.Log("leave-world", body.Id);
        body.Settings.HasCell = false;
        body.Settings.Position.CellId = 0;
    }

    private object ValueOf(string field) => field switch
    {
        "stamps" => Enumerable.Range(0, MessageStamps.Count).Select(i => (object)(int)stamps[(ObjectStamp)i]).ToArray(),
        "cell" => body.Position.CellId,
        "pos" => body.Position.Frame.Origin,
        "rot" => body.Position.Frame.Rotation,
        "moving" => body.MoveTo is { IsMovingTo: true },
        "world" => body.HasCell,
        "queue" => body.PositionManager?.Interpolation?.QueueLength ?? 0,
        "fails" => body.PositionManager?.Interpolation?.FailCount ?? 0,
        "bound" => body.PositionManager?.Constraint is { IsConstrained: true },
        "spent" => body.PositionManager?.Constraint?.PathLength ?? 0f,
        "autonomous" => lastMoveWasAutonomous,
        _ => throw new InvalidDataException($"the field {field} is not known."),
    };
}
