using System.Buffers.Binary;
using System.Numerics;

namespace Surefoot.Protocol;

/// <summary>Writes one element of a list.</summary>
public delegate void WriteElement<in T>(ref WireWriter writer, T element);

/// <summary>Writes the bytes of a message, from its opcode on (specification 08, conventions), into memory of the caller. It never throws:
/// what does not fit, or has no form on the wire, sets <see cref="Failed"/>, and nothing more is written.</summary>
public ref struct WireWriter
{
    private readonly Span<byte> bytes;

    /// <summary>Starts at the first byte.</summary>
    /// <param name="bytes">Where to write; alignment is measured from its start.</param>
    public WireWriter(Span<byte> bytes) => this.bytes = bytes;

    /// <summary>Something could not be written: what stands there is no message.</summary>
    public bool Failed { get; private set; }

    /// <summary>Bytes written so far.</summary>
    public int Position { get; private set; }

    /// <summary>The bytes written so far.</summary>
    public readonly ReadOnlySpan<byte> Written => bytes[..Position];

    /// <summary>Refuses what was to be written.</summary>
    public void Fail() => Failed = true;

    /// <summary>Writes a byte.</summary>
    public void WriteByte(byte value)
    {
        if (Take(1) is { IsEmpty: false } target)
            target[0] = value;
    }

    /// <summary>Writes a 16-bit number.</summary>
    public void WriteUInt16(ushort value)
    {
        if (Take(2) is { IsEmpty: false } target)
            BinaryPrimitives.WriteUInt16LittleEndian(target, value);
    }

    /// <summary>Writes a 32-bit number.</summary>
    public void WriteUInt32(uint value)
    {
        if (Take(4) is { IsEmpty: false } target)
            BinaryPrimitives.WriteUInt32LittleEndian(target, value);
    }

    /// <summary>Writes a 32-bit number.</summary>
    public void WriteInt32(int value) => WriteUInt32((uint)value);

    /// <summary>Writes a 64-bit number.</summary>
    public void WriteUInt64(ulong value)
    {
        if (Take(8) is { IsEmpty: false } target)
            BinaryPrimitives.WriteUInt64LittleEndian(target, value);
    }

    /// <summary>Writes a 64-bit number.</summary>
    public void WriteInt64(long value) => WriteUInt64((ulong)value);

    /// <summary>Writes a float, bit for bit.</summary>
    public void WriteSingle(float value) => WriteUInt32(BitConverter.SingleToUInt32Bits(value));

    /// <summary>Writes a double, bit for bit.</summary>
    public void WriteDouble(double value) => WriteUInt64(BitConverter.DoubleToUInt64Bits(value));

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

    /// <summary>Writes a text of at most 65,534 characters and the zeros behind it (specification 08, 3, string16).</summary>
    public void WriteString16(string text)
    {
        if (text.Length >= 0xFFFF)
            Fail();
        WriteUInt16((ushort)text.Length);
        if (Take(text.Length) is { IsEmpty: false } target)
            WireText.CodePage.GetBytes(text, target);
        WriteZeros(-(2 + text.Length) & 3);
    }

    /// <summary>Writes an unsigned number below 0x80000000 in two or four bytes (specification 08, 3, packedDword).</summary>
    public void WritePackedUInt32(uint value)
    {
        if (value <= 0x7FFF)
        {
            WriteUInt16((ushort)value);
            return;
        }

        if (value > 0x7FFFFFFF)
            Fail();
        WriteUInt16((ushort)(0x8000 | (value >> 16)));
        WriteUInt16((ushort)value);
    }

    /// <summary>Writes an id whose kind the context knows; id 0 becomes <paramref name="baseId"/> (specification 08, 3,
    /// packedDid).</summary>
    /// <param name="id">In baseId … baseId + 0x3FFFFFFF.</param>
    /// <param name="baseId">Lowest id of the kind.</param>
    public void WritePackedId(uint id, uint baseId)
    {
        uint offset = id == 0 ? 0 : id - baseId;
        if (offset > 0x3FFFFFFF)
            Fail();
        WritePackedUInt32(offset);
    }

    /// <summary>Writes zeros up to the next multiple of 4.</summary>
    public void Align4() => WriteZeros(-Position & 3);

    /// <summary>Writes bytes as they are.</summary>
    public void WriteBytes(scoped ReadOnlySpan<byte> source)
    {
        if (Take(source.Length) is { IsEmpty: false } target)
            source.CopyTo(target);
    }

    /// <summary>Writes elements one after the other, without a count.</summary>
    public void WriteElements<T>(ValueList<T> values, WriteElement<T> write)
    {
        foreach (T value in values)
            write(ref this, value);
    }

    /// <summary>Writes a u32 count and the elements.</summary>
    public void WriteList<T>(ValueList<T> values, WriteElement<T> write)
    {
        WriteUInt32((uint)values.Count);
        WriteElements(values, write);
    }

    /// <summary>Writes a u16 count, a u16 bucket count and the elements (specification 08, 7.3, table).</summary>
    public void WriteTable<T>(ValueList<T> values, ushort buckets, WriteElement<T> write)
    {
        WriteUInt16(CountOf(values.Count, ushort.MaxValue));
        WriteUInt16(buckets);
        WriteElements(values, write);
    }

    /// <summary>A count in the form that the wire has for it; fails when it is above <paramref name="most"/>.</summary>
    internal ushort CountOf(int count, int most)
    {
        if (count > most)
            Fail();
        return (ushort)count;
    }

    /// <summary>Puts a number where zeros were written before.</summary>
    internal readonly void PatchUInt32(int position, uint value)
    {
        if (!Failed)
            BinaryPrimitives.WriteUInt32LittleEndian(bytes[position..], value);
    }

    private void WriteZeros(int count)
    {
        if (Take(count) is { IsEmpty: false } target)
            target.Clear();
    }

    private Span<byte> Take(int count)
    {
        if (Failed || bytes.Length - Position < count)
        {
            Failed = true;
            return default;
        }

        Position += count;
        return bytes.Slice(Position - count, count);
    }
}
