using System.Buffers.Binary;
using System.Numerics;

namespace Surefoot.Protocol;

/// <summary>Reads one element of a list.</summary>
/// <param name="reader">Stands at the element, and behind it afterwards.</param>
public delegate T ReadElement<out T>(ref WireReader reader);

/// <summary>A cursor over the bytes of a message, from its opcode on (specification 08, conventions). It never throws: the first thing that
/// cannot be read sets <see cref="Fault"/>, and everything after it reads as zero.</summary>
public ref struct WireReader
{
    private readonly ReadOnlySpan<byte> bytes;

    /// <summary>Starts at the first byte.</summary>
    /// <param name="bytes">A whole message; alignment is measured from its start.</param>
    public WireReader(ReadOnlySpan<byte> bytes) => this.bytes = bytes;

    /// <summary>What was wrong first; <see cref="WireFault.None"/> so far.</summary>
    public WireFault Fault { get; private set; }

    /// <summary>Bytes read so far.</summary>
    public int Position { get; private set; }

    /// <summary>Bytes left; none after a fault.</summary>
    public readonly int Remaining => bytes.Length - Position;

    /// <summary>Refuses what was read: sets <see cref="Fault"/>, unless something was wrong before.</summary>
    public void Fail(WireFault fault)
    {
        if (Fault == WireFault.None)
            Fault = fault;
        Position = bytes.Length;
    }

    /// <summary>Takes bytes as they are; empty when there are fewer.</summary>
    /// <param name="count">How many, not negative.</param>
    public ReadOnlySpan<byte> ReadBytes(int count)
    {
        if (Remaining < count)
        {
            Fail(WireFault.Truncated);
            return [];
        }

        Position += count;
        return bytes.Slice(Position - count, count);
    }

    /// <summary>Reads a byte.</summary>
    public byte ReadByte() => ReadBytes(1) is [var value] ? value : default;

    /// <summary>Reads a 16-bit number.</summary>
    public ushort ReadUInt16() => ReadBytes(2) is { IsEmpty: false } source ? BinaryPrimitives.ReadUInt16LittleEndian(source) : default;

    /// <summary>Reads a 32-bit number.</summary>
    public uint ReadUInt32() => ReadBytes(4) is { IsEmpty: false } source ? BinaryPrimitives.ReadUInt32LittleEndian(source) : default;

    /// <summary>Reads a 32-bit number.</summary>
    public int ReadInt32() => (int)ReadUInt32();

    /// <summary>Reads a 64-bit number.</summary>
    public ulong ReadUInt64() => ReadBytes(8) is { IsEmpty: false } source ? BinaryPrimitives.ReadUInt64LittleEndian(source) : default;

    /// <summary>Reads a 64-bit number.</summary>
    public long ReadInt64() => (long)ReadUInt64();

    /// <summary>Reads a float; its bits are kept, NaN included.</summary>
    public float ReadSingle() => BitConverter.UInt32BitsToSingle(ReadUInt32());

    /// <summary>Reads a double; its bits are kept, NaN included.</summary>
    public double ReadDouble() => BitConverter.UInt64BitsToDouble(ReadUInt64());

    /// <summary>Reads x, y, z.</summary>
    public Vector3 ReadVector3()
    {
        float x = ReadSingle(), y = ReadSingle(), z = ReadSingle();
        return new Vector3(x, y, z);
    }

    /// <summary>Reads a rotation, stored as w, x, y, z.</summary>
    public Quaternion ReadQuaternion()
    {
        float w = ReadSingle(), x = ReadSingle(), y = ReadSingle(), z = ReadSingle();
        return new Quaternion(x, y, z, w);
    }

    /// <summary>Reads a counted text and the zeros behind it (specification 08, 3, string16).</summary>
    public string ReadString16()
    {
        int length = ReadUInt16();
        string text = WireText.CodePage.GetString(ReadBytes(length));
        ReadBytes(-(2 + length) & 3);
        return text;
    }

    /// <summary>Reads an unsigned number of two or four bytes (specification 08, 3, packedDword).</summary>
    public uint ReadPackedUInt32()
    {
        uint first = ReadUInt16();
        return (first & 0x8000) == 0 ? first : ((first & 0x7FFF) << 16) | ReadUInt16();
    }

    /// <summary>Reads an id whose kind the context knows (specification 08, 3, packedDid).</summary>
    /// <param name="baseId">Lowest id of the kind.</param>
    public uint ReadPackedId(uint baseId) => baseId + (ReadPackedUInt32() & 0x3FFFFFFF);

    /// <summary>Skips to the next multiple of 4.</summary>
    public void Align4() => ReadBytes(-Position & 3);

    /// <summary>Reads a list without its count. A count that the bytes left cannot hold is refused before anything is allocated.</summary>
    /// <param name="count">Number of elements.</param>
    /// <param name="elementSize">Least bytes of one element, at least 1.</param>
    /// <param name="read">Reads one element.</param>
    public ValueList<T> ReadList<T>(uint count, int elementSize, ReadElement<T> read)
    {
        if (count > Remaining / elementSize)
            Fail(WireFault.CountTooLarge);
        if (count == 0 || Fault != WireFault.None)
            return default;

        var elements = new T[count];
        for (int i = 0; i < elements.Length; i++)
            elements[i] = read(ref this);
        return new ValueList<T>(elements);
    }

    /// <summary>Reads a u32 count and that many elements.</summary>
    /// <param name="elementSize">Least bytes of one element, at least 1.</param>
    /// <param name="read">Reads one element.</param>
    public ValueList<T> ReadList<T>(int elementSize, ReadElement<T> read) => ReadList(ReadUInt32(), elementSize, read);

    /// <summary>Reads a u16 count, a u16 bucket count that says nothing, and the elements (specification 08, 7.3, table).</summary>
    /// <param name="elementSize">Least bytes of one element, at least 1.</param>
    /// <param name="read">Reads one element.</param>
    public ValueList<T> ReadTable<T>(int elementSize, ReadElement<T> read)
    {
        uint count = ReadUInt16();
        ReadUInt16();
        return ReadList(count, elementSize, read);
    }
}
