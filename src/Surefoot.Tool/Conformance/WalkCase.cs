using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace Surefoot.Tool.Conformance;

/// <summary>One recorded walk.</summary>
/// <param name="Id">Name of the case.</param>
/// <param name="Scene">What the case was aimed at.</param>
/// <param name="Setup">Setup of the mover, hexadecimal.</param>
/// <param name="Others">Creatures placed first; they stay still.</param>
/// <param name="Place">Where the mover was asked to be.</param>
/// <param name="Placed">Outcome of the placement.</param>
/// <param name="Start">State after placement; null when there was no room.</param>
/// <param name="Steps">One entry a quantum; null when there was no room.</param>
internal sealed record WalkCase(
    string Id, string Scene, string Setup, WalkOther[]? Others, WalkPlace Place, string Placed, WalkStep? Start, WalkStep[]? Steps)
{
    /// <summary>Reads the cases of a file, one JSON object a line, gzipped or not.</summary>
    /// <exception cref="InvalidDataException">A line is not a case; the message names file and line.</exception>
    internal static IEnumerable<WalkCase> ReadAll(string path) => VectorFile.Read(path, Parse);

    private static WalkCase Parse(string line)
    {
        WalkCase? walk = JsonSerializer.Deserialize(line, WalkJson.Default.WalkCase);
        return walk is { Place: not null, Setup: not null, Placed: not null } ? walk : throw new InvalidDataException("not a recorded walk.");
    }

    internal static uint ParseId(string hex) => uint.Parse(hex, NumberStyles.HexNumber, CultureInfo.InvariantCulture);
}

/// <summary>A creature that stands in the way.</summary>
internal sealed record WalkOther(string Setup, string Cell, float[] Pos);

/// <summary>A placement asked for; yaw in radians about +z.</summary>
internal sealed record WalkPlace(string Cell, float[] Pos, float Yaw);

/// <summary>The state after one quantum, and what was put into it.</summary>
internal sealed record WalkStep(
    string Cell, float[] Pos, float[] Vel, bool Ok, uint Ts, string? Pcell, float[]? Plane, float[]? Slide, float Q, float[]? Off, float[]? Jump, bool Env);

/// <summary>Reading without reflection.</summary>
[JsonSourceGenerationOptions(PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase)]
[JsonSerializable(typeof(WalkCase))]
internal sealed partial class WalkJson : JsonSerializerContext;
