using System.Buffers.Binary;
using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Collects the bytes of one record (spec 07, section 2).</summary>
public sealed class DatWriter
{
    private byte[] buffer = new byte[256];

    /// <summary>Bytes written so far.</summary>
    public int Position { get; private set; }

    /// <summary>The bytes written so far; valid until the next write.</summary>
    public ReadOnlySpan<byte> WrittenSpan => buffer.AsSpan(0, Position);

    /// <summary>A copy of the bytes written so far.</summary>
    public byte[] ToArray() => WrittenSpan.ToArray();

    /// <summary>Writes a byte.</summary>
    public void WriteByte(byte value) => Take(1)[0] = value;

    /// <summary>Writes a 16-bit number.</summary>
    public void WriteInt16(short value) => BinaryPrimitives.WriteInt16LittleEndian(Take(2), value);

    /// <summary>Writes a 16-bit number.</summary>
    public void WriteUInt16(ushort value) => BinaryPrimitives.WriteUInt16LittleEndian(Take(2), value);

    /// <summary>Writes a 32-bit number.</summary>
    public void WriteInt32(int value) => BinaryPrimitives.WriteInt32LittleEndian(Take(4), value);

    /// <summary>Writes a 32-bit number.</summary>
    public void WriteUInt32(uint value) => BinaryPrimitives.WriteUInt32LittleEndian(Take(4), value);

    /// <summary>Writes a float, bit for bit.</summary>
    public void WriteSingle(float value) => WriteInt32(BitConverter.SingleToInt32Bits(value));

    /// <summary>Writes a double, bit for bit.</summary>
    public void WriteDouble(double value)
        => BinaryPrimitives.WriteInt64LittleEndian(Take(8), BitConverter.DoubleToInt64Bits(value));

    /// <summary>Writes x, y, z.</summary>
    public void WriteVector3(Vector3 value)
    {
        WriteSingle(value.X);
        WriteSingle(value.Y);
        WriteSingle(value.Z);
    }

    /// <summary>Writes a rotation in the order w, x, y, z, as it is.</summary>
    public void WriteQuaternion(Quaternion value)
    {
        WriteSingle(value.W);
        WriteSingle(value.X);
        WriteSingle(value.Y);
        WriteSingle(value.Z);
    }

    /// <summary>Writes origin and rotation.</summary>
    public void WriteFrame(DatFrame value)
    {
        WriteVector3(value.Origin);
        WriteQuaternion(value.Rotation);
    }

    /// <summary>Writes normal and d.</summary>
    public void WritePlane(Plane value)
    {
        WriteVector3(value.Normal);
        WriteSingle(value.D);
    }

    /// <summary>Writes centre and radius.</summary>
    public void WriteSphere(DatSphere value)
    {
        WriteVector3(value.Centre);
        WriteSingle(value.Radius);
    }

    /// <summary>Writes blue, green, red, alpha.</summary>
    public void WriteColor(DatColor value)
    {
        WriteByte(value.Blue);
        WriteByte(value.Green);
        WriteByte(value.Red);
        WriteByte(value.Alpha);
    }

    /// <summary>Writes an unsigned number in its shortest form of 1, 2 or 4 bytes.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Above 0x3FFFFFFF.</exception>
    public void WriteCompressedUInt32(uint value)
    {
        ArgumentOutOfRangeException.ThrowIfGreaterThan(value, 0x3FFFFFFFu);
        if (value <= 0x7F)
        {
            WriteByte((byte)value);
        }
        else if (value <= 0x3FFF)
        {
            WriteByte((byte)(0x80 + (value >> 8)));
            WriteByte((byte)value);
        }
        else
        {
            WriteByte((byte)(0xC0 + (value >> 24)));
            WriteByte((byte)(value >> 16));
            WriteUInt16((ushort)value);
        }
    }

    /// <summary>Writes an id whose kind the context knows; id 0 becomes <paramref name="baseId"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not in baseId … baseId + 0x3FFFFFFF.</exception>
    public void WriteKnownTypeId(uint id, uint baseId)
    {
        uint offset = id == 0 ? 0 : id - baseId;
        ArgumentOutOfRangeException.ThrowIfGreaterThan(offset, 0x3FFFFFFFu, nameof(id));
        if (offset <= 0x3FFF)
        {
            WriteUInt16((ushort)offset);
        }
        else
        {
            WriteUInt16((ushort)(0x8000 + (offset >> 16)));
            WriteUInt16((ushort)offset);
        }
    }

    /// <summary>Writes a text in Windows-1252 and aligns.</summary>
    /// <exception cref="ArgumentException">A character that Windows-1252 lacks.</exception>
    public void WritePString(string text)
    {
        if (text.Length < 0xFFFF)
        {
            WriteUInt16((ushort)text.Length);
        }
        else
        {
            WriteUInt16(0xFFFF);
            WriteUInt32((uint)text.Length);
        }

        foreach (char character in text)
        {
            if (!Windows1252.TryEncode(character, out byte value))
                throw new ArgumentException($"The character U+{(int)character:X4} of \"{text}\" is not in Windows-1252.", nameof(text));
            WriteByte(value);
        }

        Align4();
    }

    /// <summary>Writes zeros up to the next multiple of 4.</summary>
    public void Align4() => WriteZeros(-Position & 3);

    /// <summary>Writes zeros.</summary>
    public void WriteZeros(int count) => Take(count).Clear();

    /// <summary>Writes bytes.</summary>
    public void WriteBytes(ReadOnlySpan<byte> bytes) => bytes.CopyTo(Take(bytes.Length));

    /// <summary>Writes 16-bit numbers.</summary>
    public void WriteUInt16Array(ImmutableArray<ushort> values)
    {
        foreach (ushort value in values)
            WriteUInt16(value);
    }

    /// <summary>Writes signed 16-bit numbers.</summary>
    public void WriteInt16Array(ImmutableArray<short> values)
    {
        foreach (short value in values)
            WriteInt16(value);
    }

    /// <summary>Writes 32-bit numbers.</summary>
    public void WriteUInt32Array(ImmutableArray<uint> values)
    {
        foreach (uint value in values)
            WriteUInt32(value);
    }

    /// <summary>Writes elements one after the other, without a count.</summary>
    public void WriteArray<T>(ImmutableArray<T> values, Action<DatWriter, T> write)
    {
        foreach (T value in values)
            write(this, value);
    }

    /// <summary>Writes a u32 count and the elements.</summary>
    public void WriteList<T>(ImmutableArray<T> values, Action<DatWriter, T> write)
    {
        WriteUInt32((uint)values.Length);
        WriteArray(values, write);
    }

    /// <summary>Refuses to write a record that contradicts itself.</summary>
    /// <exception cref="InvalidOperationException">When <paramref name="holds"/> is false.</exception>
    internal static void Require(bool holds, string message)
    {
        if (!holds)
            throw new InvalidOperationException(message);
    }

    /// <summary>Refuses a list that its 8-bit or 16-bit count cannot hold.</summary>
    internal static int RequireCount(int count, int limit, string what)
    {
        Require(count <= limit, $"At most {limit} {what} can be written, not {count}.");
        return count;
    }

    private Span<byte> Take(int count)
    {
        if (buffer.Length - Position < count)
            Array.Resize(ref buffer, checked(Math.Max(buffer.Length * 2, Position + count)));
        Position += count;
        return buffer.AsSpan(Position - count, count);
    }
}
