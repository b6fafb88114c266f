using System.Globalization;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace Surefoot.Tool.Conformance;

/// <summary>An id or a word of flags, recorded as a string of hexadecimal digits.</summary>
/// <param name="Value">Its value.</param>
[JsonConverter(typeof(HexReader))]
internal readonly record struct Hex(uint Value)
{
    public static implicit operator uint(Hex hex) => hex.Value;
}

/// <summary>Reads <see cref="Hex"/>.</summary>
internal sealed class HexReader : JsonConverter<Hex>
{
    public override Hex Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
        reader.TokenType == JsonTokenType.String &&
        uint.TryParse(reader.GetString(), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint value)
            ? new Hex(value)
            : throw new JsonException("a hexadecimal number of at most eight digits is needed here.");

    public override void Write(Utf8JsonWriter writer, Hex value, JsonSerializerOptions options) => throw new NotSupportedException();
}

/// <summary>Reads lists of a fixed number of floats.</summary>
internal abstract class FloatsReader<T>(int count) : JsonConverter<T>
{
    public override T Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options)
    {
        Span<float> numbers = stackalloc float[4];
        if (reader.TokenType != JsonTokenType.StartArray) throw Refusal();
        for (int i = 0; i < count; i++)
        {
            bool isNumber = reader.Read() && reader.TokenType == JsonTokenType.Number && reader.TryGetSingle(out numbers[i]);
            if (!isNumber || !float.IsFinite(numbers[i])) throw Refusal();
        }

        return reader.Read() && reader.TokenType == JsonTokenType.EndArray ? Make(numbers) : throw Refusal();
    }

    public override void Write(Utf8JsonWriter writer, T value, JsonSerializerOptions options) => throw new NotSupportedException();

    /// <summary>The value that the numbers stand for.</summary>
    protected abstract T Make(ReadOnlySpan<float> numbers);

    private JsonException Refusal() => new($"a list of {count} numbers is needed here.");
}

/// <summary>Reads x, y, z.</summary>
internal sealed class VectorReader() : FloatsReader<Vector3>(3)
{
    protected override Vector3 Make(ReadOnlySpan<float> numbers) => new(numbers);
}

/// <summary>Reads a quaternion w, x, y, z.</summary>
internal sealed class RotationReader() : FloatsReader<Quaternion>(4)
{
    protected override Quaternion Make(ReadOnlySpan<float> numbers) => new(numbers[1], numbers[2], numbers[3], numbers[0]);
}

/// <summary>Reads a plane: its normal and d.</summary>
internal sealed class PlaneReader() : FloatsReader<Plane>(4)
{
    protected override Plane Make(ReadOnlySpan<float> numbers) => new(numbers[0], numbers[1], numbers[2], numbers[3]);
}
