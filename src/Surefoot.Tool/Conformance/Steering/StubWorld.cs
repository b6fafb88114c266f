using System.Text.Json;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>The bodies of a case, their object table and clock, and what was noteworthy since the last entry.</summary>
internal sealed class StubWorld
{
    private readonly Dictionary<uint, StubBody> known = [];

    /// <summary>Seconds; the clock of the frame and that of the physics.</summary>
    internal double Clock { get; set; }

    /// <summary>Names of what the recording lists.</summary>
    internal required IReadOnlySet<string> Noteworthy { get; init; }

    /// <summary>Every body, in the order in which they do their quanta.</summary>
    internal List<StubBody> Bodies { get; } = [];

    /// <summary>What happened: a name, the body's id, and what belongs to it.</summary>
    internal List<object[]> Calls { get; } = [];

    /// <summary>How the calls differ from the recorded ones; null when they do not.</summary>
    internal string? CompareCalls(JsonElement recorded)
    {
        int calls = recorded.TryGetProperty("calls", out JsonElement list) ? list.GetArrayLength() : 0;
        for (int i = 0; i < Math.Min(calls, Calls.Count); i++)
        {
            if (!Tolerance.SameCall(Calls[i], list[i])) return $"call {i} is {Text(Calls[i])}, recorded {list[i]}";
        }

        if (calls < Calls.Count) return $"call {calls} is {Text(Calls[calls])}, recorded none";
        return calls > Calls.Count ? $"call {Calls.Count} is missing, recorded {list[Calls.Count]}" : null;
    }

    private static string Text(object[] call) => string.Join(' ', call.Select(item => item is uint id ? $"{id:X}" : item.ToString()));

    internal StubBody? Find(uint id) => known.GetValueOrDefault(id);

    internal StubBody this[uint id] => Bodies.Find(b => b.Id == id) ?? throw new InvalidDataException($"there is no body {id:X8}.");

    internal void Add(StubBody body)
    {
        Bodies.Add(body);
        known.Add(body.Id, body);
    }

    internal void Forget(uint id) => known.Remove(id);

    /// <summary>Puts a body into the table again as a new object: without managers and at rest.</summary>
    internal void BringBack(uint id)
    {
        int index = Bodies.FindIndex(b => b.Id == id);
        StubSettings settings = Bodies[index].Settings;
        settings.Velocity = default;
        known[id] = Bodies[index] = new StubBody(this, settings);
    }

    internal void Log(string name, uint id, params object[] rest)
    {
        if (Noteworthy.Contains(name)) Calls.Add([name, id, .. rest]);
    }
}
