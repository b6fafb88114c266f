using System.Numerics;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace Surefoot.Tool.Conformance;

/// <summary>One case recorded from a peer as it is: a sweep, a placement or a walk.</summary>
internal sealed record OracleCase
{
    /// <summary>Name of the case.</summary>
    public required string Id { get; init; }

    /// <summary>Which of the three.</summary>
    public required string Family { get; init; }

    /// <summary>What its place was chosen for.</summary>
    public required string Tag { get; init; }

    /// <summary>The body.</summary>
    public required OracleBody Mover { get; init; }

    /// <summary>Bodies placed first; they stay still.</summary>
    public OracleBody[]? Others { get; init; }

    /// <summary>Sweep: where it begins.</summary>
    public OracleState? Begin { get; init; }

    /// <summary>Sweep: the position asked for.</summary>
    public OraclePlace? End { get; init; }

    /// <summary>Placement: the position asked for.</summary>
    public OraclePlace? Request { get; init; }

    /// <summary>Placement: may it slide.</summary>
    public bool Slide { get; init; }

    /// <summary>Sweep and placement: what came of it.</summary>
    public OracleOutcome? Out { get; init; }

    /// <summary>Walk: how long each quantum is, seconds.</summary>
    public float Q { get; init; }

    /// <summary>Walk: the state before the first quantum.</summary>
    public OracleState? Start { get; init; }

    /// <summary>Walk: what each quantum came to; the recording calls it a step.</summary>
    [JsonPropertyName("steps")]
    public OracleQuantum[]? Quanta { get; init; }

    /// <summary>Reads a line.</summary>
    /// <exception cref="InvalidDataException">It is not a case.</exception>
    internal static OracleCase Parse(string line)
    {
        try
        {
            OracleCase one = JsonSerializer.Deserialize(line, OracleJson.Default.OracleCase) ?? throw new JsonException("null");
            bool isWhole = one.Family switch
            {
                "transition" => one is { Begin: not null, End: not null, Out: not null },
                "placement" => one is { Request: not null, Out: not null },
                "walk" => one is { Start: not null, Quanta: not null } && !one.Quanta.Contains(null!),
                _ => throw new JsonException($"the family {one.Family} is another."),
            };
            if (!isWhole || one.Others?.Any(other => other?.Request is null) == true) throw new JsonException("a part of it is missing.");
            return one;
        }
        catch (JsonException e)
        {
            throw new InvalidDataException($"not a recorded result of a peer: {e.Message}", e);
        }
    }
}

/// <summary>A body, and where it was put.</summary>
internal sealed record OracleBody
{
    public required Hex Id { get; init; }

    public required Hex Setup { get; init; }

    public required Hex State { get; init; }

    public float? Scale { get; init; }

    public bool Player { get; init; }

    public bool Creature { get; init; }

    public OraclePlace? Request { get; init; }
}

/// <summary>A position; its rotation is the last one told when there is none.</summary>
internal sealed record OraclePlace(Hex Cell, Vector3 Pos, Quaternion? Quat = null);

/// <summary>State of a body.</summary>
internal record OracleState
{
    public required Hex Cell { get; init; }

    public required Vector3 Pos { get; init; }

    public required Vector3 Vel { get; init; }

    public required Hex Ts { get; init; }

    public Quaternion? Quat { get; init; }

    public Plane Plane { get; init; }

    public Hex PlaneCell { get; init; }

    public Vector3? Sliding { get; init; }

    public bool CollidingEnv { get; init; }

    internal OraclePlace Place => new(Cell, Pos, Quat);
}

/// <summary>State after one quantum, and what was done before it.</summary>
internal sealed record OracleQuantum : OracleState
{
    public Vector3? Root { get; init; }

    public bool Leave { get; init; }

    public Vector3? SetVelocity { get; init; }

    public Hex? State { get; init; }
}

/// <summary>What came of a sweep or a placement.</summary>
internal sealed record OracleOutcome
{
    public string? Result { get; init; }

    public bool Found { get; init; }

    public Hex? PosCell { get; init; }

    public Hex? Cell { get; init; }

    public Vector3? Pos { get; init; }

    public Hex Ts { get; init; }

    public bool Contact { get; init; }

    public Vector3? Sliding { get; init; }
}

/// <summary>A result that known departures of the peer change.</summary>
/// <param name="Id">The case.</param>
/// <param name="Quantum">Which quantum of a walk, from 0; the list calls it a step.</param>
internal sealed record OracleDeparture(string Id, [property: JsonPropertyName("step")] int? Quantum = null)
{
    /// <summary>Reads a line.</summary>
    internal static OracleDeparture Parse(string line) =>
        JsonSerializer.Deserialize(line, OracleJson.Default.OracleDeparture) ?? throw new JsonException("null");

    internal string Key => OracleReplay.KeyOf(Id, Quantum);
}

/// <summary>Reading without reflection.</summary>
[JsonSourceGenerationOptions(
    PropertyNamingPolicy = JsonKnownNamingPolicy.SnakeCaseLower, RespectNullableAnnotations = true,
    RespectRequiredConstructorParameters = true, Converters = [typeof(VectorReader), typeof(RotationReader), typeof(PlaneReader)])]
[JsonSerializable(typeof(OracleCase))]
[JsonSerializable(typeof(OracleDeparture))]
internal sealed partial class OracleJson : JsonSerializerContext;
