using System.Globalization;
using System.Text.Json;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>What was recorded of a body so far, and the same fields of the replay.</summary>
internal sealed class WatchedBody(string name)
{
    /// <summary>Fields of a manager that was not made yet have these values.</summary>
    private static readonly Dictionary<string, JsonElement> Initial = JsonElement.Parse(
        """
        {"queue":0,"frames":0,"time":0,"from":999999,"fails":0,"keep":0,"stuck":0,"known":0,"bound":0,"type":0,"nodes":[],
        "cmd":"0","aux":"0"}
        """)
        .EnumerateObject().ToDictionary(p => p.Name, p => p.Value);

    private readonly Dictionary<string, JsonElement> recorded = [];

    internal string Name => name;

    internal uint Id { get; } = uint.Parse(name, NumberStyles.HexNumber, CultureInfo.InvariantCulture);

    /// <summary>Takes the fields that changed; null ones are no longer there.</summary>
    internal void Take(JsonElement changes)
    {
        foreach (JsonProperty change in changes.EnumerateObject())
        {
            if (change.Value.ValueKind == JsonValueKind.Null) recorded.Remove(change.Name);
            else recorded[change.Name] = change.Value;
        }
    }

    /// <summary>The first field that differs, or null.</summary>
    internal string? Compare(StubBody body)
    {
        foreach ((string field, JsonElement value) in recorded)
        {
            if (Difference(body, field, value) is { } difference) return difference;
        }

        foreach ((string field, JsonElement value) in Initial)
        {
            if (!recorded.ContainsKey(field) && Difference(body, field, value) is { } difference) return difference;
        }

        return null;
    }

    private static string? Difference(StubBody body, string field, JsonElement recorded)
    {
        object? value = ValueOf(body, field);
        return value is null || Tolerance.Same(value, recorded) ? null : $"{field} is {Text(value)}, recorded {recorded}";
    }

    /// <summary>Null where the value has no meaning.</summary>
    private static object? ValueOf(StubBody body, string field)
    {
        MoveToManager? moveTo = body.MoveTo;
        InterpolationManager? interpolation = body.PositionManager?.Interpolation;
        StickyManager? sticky = body.PositionManager?.Sticky;
        ConstraintManager? leash = body.PositionManager?.Constraint;
        return field switch
        {
            "cell" => body.Position.CellId,
            "pos" => body.Position.Frame.Origin,
            "rot" => body.Position.Frame.Rotation,
            "off" => body.Offset.Origin,
            "turn" => body.Offset.Rotation,
            "vel" => body.AchievedVelocity,
            "queue" => interpolation?.QueueLength ?? 0,
            "frames" => interpolation?.FrameCounter ?? 0,
            "time" => interpolation?.ProgressTime ?? 0f,
            "from" => interpolation?.OriginalDistance ?? 999999f,
            "fails" => interpolation?.FailCount ?? 0,
            "keep" => interpolation is { KeepsHeading: true },
            "stuck" => sticky?.TargetId ?? 0,
            "known" => sticky is { IsInitialised: true },
            "until" => sticky is null ? null : new Moment(sticky.Until),
            "bound" => leash is { IsConstrained: true },
            "spent" => leash?.PathLength ?? 0f,
            "full" => leash is { IsFullyConstrained: true },
            "target" => TargetOf(body),
            "voyeurs" => VoyeursOf(body),
            "type" => (int)(moveTo?.Kind ?? 0),
            "nodes" => NodesOf(moveTo),
            "cmd" => moveTo?.CurrentCommand ?? MotionCommand.None,
            "aux" => moveTo?.AuxCommand ?? MotionCommand.None,
            "away" => moveTo is { IsMovingAway: true },
            "ready" => moveTo is { IsInitialised: true },
            "stalls" => moveTo?.StallCount ?? 0,
            "key" => (int)(moveTo?.HoldKey ?? HoldKey.Invalid),
            "pd" => IsWalking(moveTo) ? moveTo!.Previous.Distance : null,
            "pt" => IsWalking(moveTo) ? new Moment(moveTo!.Previous.Time) : null,
            "od" => IsWalking(moveTo) ? moveTo!.Original.Distance : null,
            "ot" => IsWalking(moveTo) ? new Moment(moveTo!.Original.Time) : null,
            "ph" => IsTurning(moveTo) ? new Degrees(moveTo!.PreviousHeading) : null,
            _ => throw new InvalidDataException($"the field {field} is not known."),
        };
    }

    private static bool IsWalking(MoveToManager? moveTo) =>
        moveTo is { CurrentCommand: MotionCommand.WalkForward or MotionCommand.WalkBackwards or MotionCommand.RunForward };

    private static bool IsTurning(MoveToManager? moveTo) => moveTo is { CurrentCommand: MotionCommand.TurnRight or MotionCommand.TurnLeft };

    private static object TargetOf(StubBody body)
    {
        if (body.TargetManager is not { HasTarget: true } tracker) return 0;
        object[] target = [tracker.Target.ObjectId, (int)tracker.Target.Status, tracker.Target.Quantum];
        return target;
    }

    private static object[] VoyeursOf(StubBody body)
    {
        List<object> ids = [];
        for (int i = 0; i < (body.TargetManager?.Voyeurs.Count ?? 0); i++) ids.Add(body.TargetManager!.Voyeurs[i].Id);
        return [.. ids];
    }

    private static object[] NodesOf(MoveToManager? moveTo)
    {
        List<object> nodes = [];
        for (int i = 0; i < (moveTo?.NodeCount ?? 0); i++)
        {
            MoveToNode node = moveTo!.NodeAt(i);
            nodes.Add((object[])[node.IsMove ? 7 : 9, new Degrees(node.Heading)]);
        }

        return [.. nodes];
    }

    private static string Text(object value) => value switch
    {
        object[] items => $"[{string.Join(", ", items.Select(Text))}]",
        uint id => $"{id:X}",
        _ => $"{value}",
    };
}
