using System.Text.Json;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Recorded runs of the managers that move other bodies. They need no world.</summary>
internal static class ManagerVectors
{
    /// <summary>What they drive.</summary>
    internal static readonly string[] Families = [.. SteeringReplay.Families, TimestampReplay.Family];

    /// <summary>What a case aims at.</summary>
    internal static string TagOf(JsonElement recorded) => recorded.TryGetProperty("tag", out JsonElement tag) ? $"{tag}" : "";

    /// <summary>Replays a case.</summary>
    /// <exception cref="InvalidDataException">It is not one.</exception>
    internal static ManagerResult Run(JsonElement recorded)
    {
        try
        {
            string? family = recorded.GetProperty("family").GetString();
            if (!Families.Contains(family)) throw new InvalidDataException($"not a recorded run: the family {family} is another.");
            return family == TimestampReplay.Family ? TimestampReplay.Run(recorded) : SteeringReplay.Run(recorded);
        }
        catch (Exception e) when (
            e is KeyNotFoundException or InvalidOperationException or FormatException or ArgumentException or IndexOutOfRangeException
                or OverflowException)
        {
            throw new InvalidDataException($"not a recorded run: {e.Message}", e);
        }
    }
}
