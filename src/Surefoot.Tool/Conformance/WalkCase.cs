using System.Numerics;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace Surefoot.Tool.Conformance;

/// <summary>One recorded walk. What the recording calls a step is a quantum here.</summary>
/// <param name="Id">Name of the case.</param>
/// <param name="Scene">What the case was aimed at.</param>
/// <param name="Setup">Setup of the mover.</param>
/// <param name="Place">Where the mover was asked to be.</param>
/// <param name="Placed">Outcome of the placement.</param>
/// <param name="Others">Creatures placed first; they stay still.</param>
/// <param name="Start">State after placement; null when there was no room.</param>
/// <param name="Quanta">What each quantum came to; null when there was no room.</param>
internal sealed record WalkCase(
    string Id, string Scene, Hex Setup, WalkPlace Place, string Placed, WalkOther[]? Others = null, WalkQuantum? Start = null,
    [property: JsonPropertyName("steps")] WalkQuantum[]? Quanta = null)
{
    /// <summary>Reads a line.</summary>
    /// <exception cref="InvalidDataException">It is not a case.</exception>
    internal static WalkCase Parse(string line)
    {
        try
        {
            WalkCase walk = JsonSerializer.Deserialize(line, WalkJson.Default.WalkCase) ?? throw new JsonException("null");
            bool isWhole = walk.Quanta?.Contains(null!) != true && walk.Others?.Contains(null!) != true;
            return isWhole ? walk : throw new JsonException("a step or a creature is null.");
        }
        catch (JsonException e)
        {
            throw new InvalidDataException($"not a recorded walk: {e.Message}", e);
        }
    }
}

/// <summary>A creature that stands in the way.</summary>
internal sealed record WalkOther(Hex Setup, Hex Cell, Vector3 Pos);

/// <summary>A placement asked for; yaw in radians about +z.</summary>
internal sealed record WalkPlace(Hex Cell, Vector3 Pos, float Yaw);

/// <summary>The state after one quantum, and what was put into it.</summary>
internal sealed record WalkQuantum(
    Hex Cell, Vector3 Pos, Vector3 Vel, uint Ts, Hex Pcell = default, Plane Plane = default, Vector3 Slide = default, float Q = 0,
    Vector3 Off = default, Vector3? Jump = null);

/// <summary>Reading without reflection.</summary>
[JsonSourceGenerationOptions(
    PropertyNamingPolicy = JsonKnownNamingPolicy.CamelCase, RespectNullableAnnotations = true, RespectRequiredConstructorParameters = true,
    Converters = [typeof(VectorReader), typeof(PlaneReader)])]
[JsonSerializable(typeof(WalkCase))]
internal sealed partial class WalkJson : JsonSerializerContext;
