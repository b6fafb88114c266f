using System.Collections.Immutable;
using System.Numerics;
using System.Text.Json;
using System.Text.Json.Serialization;

namespace Surefoot.Dats;

/// <summary>Base of converters that only write.</summary>
internal abstract class WriteOnlyConverter<T> : JsonConverter<T>
{
    public override T Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options)
        => throw new NotSupportedException("Records are read from dat files, not from JSON.");

    protected static void WriteNumber(Utf8JsonWriter writer, float value)
    {
        if (float.IsFinite(value))
            writer.WriteNumberValue(value);
        else
            writer.WriteStringValue(float.IsNaN(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity");
    }
}

/// <summary>[x, y, z].</summary>
internal sealed class Vector3Converter : WriteOnlyConverter<Vector3>
{
    public override void Write(Utf8JsonWriter writer, Vector3 value, JsonSerializerOptions options)
    {
        writer.WriteStartArray();
        WriteNumber(writer, value.X);
        WriteNumber(writer, value.Y);
        WriteNumber(writer, value.Z);
        writer.WriteEndArray();
    }
}

/// <summary>[w, x, y, z], as in the files.</summary>
internal sealed class QuaternionConverter : WriteOnlyConverter<Quaternion>
{
    public override void Write(Utf8JsonWriter writer, Quaternion value, JsonSerializerOptions options)
    {
        writer.WriteStartArray();
        WriteNumber(writer, value.W);
        WriteNumber(writer, value.X);
        WriteNumber(writer, value.Y);
        WriteNumber(writer, value.Z);
        writer.WriteEndArray();
    }
}

/// <summary>[normal x, y, z, d].</summary>
internal sealed class PlaneConverter : WriteOnlyConverter<Plane>
{
    public override void Write(Utf8JsonWriter writer, Plane value, JsonSerializerOptions options)
    {
        writer.WriteStartArray();
        WriteNumber(writer, value.Normal.X);
        WriteNumber(writer, value.Normal.Y);
        WriteNumber(writer, value.Normal.Z);
        WriteNumber(writer, value.D);
        writer.WriteEndArray();
    }
}

/// <summary>"0x01000001" for u32, "0x0100" for u16, and lists of them.</summary>
internal sealed class HexadecimalConverter : WriteOnlyConverter<object>
{
    public static bool Handles(Type type)
        => type == typeof(uint) || type == typeof(ushort) || type == typeof(ImmutableArray<uint>) || type == typeof(ImmutableArray<ushort>);

    public override void Write(Utf8JsonWriter writer, object value, JsonSerializerOptions options)
    {
        switch (value)
        {
            case uint number:
                writer.WriteStringValue($"0x{number:X8}");
                break;
            case ushort number:
                writer.WriteStringValue($"0x{number:X4}");
                break;
            case ImmutableArray<uint> numbers:
                WriteAll(writer, numbers.Select(static number => $"0x{number:X8}"));
                break;
            case ImmutableArray<ushort> numbers:
                WriteAll(writer, numbers.Select(static number => $"0x{number:X4}"));
                break;
        }
    }

    private static void WriteAll(Utf8JsonWriter writer, IEnumerable<string> texts)
    {
        writer.WriteStartArray();
        foreach (string text in texts)
            writer.WriteStringValue(text);
        writer.WriteEndArray();
    }
}

/// <summary>Bytes as one text of hexadecimal digits.</summary>
internal sealed class HexBytesConverter : WriteOnlyConverter<ImmutableArray<byte>>
{
    public override void Write(Utf8JsonWriter writer, ImmutableArray<byte> value, JsonSerializerOptions options)
        => writer.WriteStringValue(Convert.ToHexString(value.AsSpan()));
}
