using System.Text.Json;
using Surefoot.Tool.Conformance.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>What a file records.</summary>
internal enum VectorKind
{
    /// <summary>Walks corrected to the retail rules.</summary>
    Walks,

    /// <summary>Sweeps, placements and walks of a peer as it is.</summary>
    Oracle,

    /// <summary>Results that known departures of that peer change; read beside the cases they belong to.</summary>
    Departures,

    /// <summary>Runs of the managers that move other bodies.</summary>
    Managers,

    /// <summary>Datagrams of a session between a client and a server.</summary>
    Captures,
}

/// <summary>Tells kinds of files apart.</summary>
internal static class VectorKinds
{
    /// <summary>What a file records, by its first line.</summary>
    /// <exception cref="InvalidDataException">It is none of the kinds.</exception>
    internal static VectorKind Of(VectorFile file)
    {
        if (file.FirstLine is not { } first) throw new InvalidDataException($"{file.Path} is empty.");
        try
        {
            return Of(JsonElement.Parse(first));
        }
        catch (Exception e) when (e is JsonException or InvalidDataException)
        {
            throw new InvalidDataException($"{file.Path}, line 1: {e.Message}", e);
        }
    }

    private static VectorKind Of(JsonElement first)
    {
        if (first.ValueKind != JsonValueKind.Object) throw new InvalidDataException("a recording has one JSON object a line.");
        if (first.TryGetProperty("differs", out _)) return VectorKind.Departures;
        if (first.TryGetProperty("hex", out _)) return VectorKind.Captures;
        if (!first.TryGetProperty("family", out JsonElement family)) return VectorKind.Walks;
        string? name = family.ValueKind == JsonValueKind.String ? family.GetString() : null;
        if (ManagerVectors.Families.Contains(name)) return VectorKind.Managers;
        if (OracleReplay.Families.Contains(name)) return VectorKind.Oracle;
        string known = string.Join(", ", OracleReplay.Families.Concat(ManagerVectors.Families));
        throw new InvalidDataException($"the family {family} is not known; known are {known}, and walks, which name none.");
    }
}
