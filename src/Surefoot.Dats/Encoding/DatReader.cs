using System.Buffers;
using System.Collections.Immutable;
using System.Numerics;
using System.Runtime.InteropServices;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Reads one element of a list.</summary>
/// <param name="reader">Stands at the element, and behind it afterwards.</param>
public delegate T ReadElement<out T>(ref DatReader reader);

/// <summary>A cursor over the bytes of a record (spec 07, section 2). A read past the end is a <see cref="DatFormatException"/>.</summary>
public ref struct DatReader
{
    private readonly ICollection<DatRemark>? remarks;
    private SequenceReader<byte> bytes;

    /// <summary>Starts at the first byte of a record.</summary>
    /// <param name="bytes">The whole record.</param>
    /// <param name="recordId">Its id in the directory.</param>
    /// <param name="file">Name of its file, for errors.</param>
    /// <param name="remarks">Receives what is odd but readable; null to drop it.</param>
    public DatReader(ReadOnlySequence<byte> bytes, uint recordId, string file = "", ICollection<DatRemark>? remarks = null)
    {
        this.bytes = new SequenceReader<byte>(bytes);
        this.remarks = remarks;
        RecordId = recordId;
        File = file;
    }

    private DatReader(DatReader from)
    {
        bytes = from.bytes;
        RecordId = from.RecordId;
        File = from.File;
    }

    /// <summary>Name of the file, for errors.</summary>
    public string File { get; }

    /// <summary>Id of the record in the directory.</summary>
    public uint RecordId { get; }

    /// <summary>Bytes read so far.</summary>
    public readonly long Position => bytes.Consumed;

    /// <summary>Bytes left.</summary>
    public readonly long Remaining => bytes.Remaining;

    /// <summary>A second cursor at the same place, for a reading that is only tried: it notes nothing odd.</summary>
    internal readonly DatReader Fork() => new(this);

    /// <summary>An error at the current position.</summary>
    public readonly DatFormatException Error(string message) => Error(message, Position);

    /// <summary>An error at an offset from the start of the record.</summary>
    public readonly DatFormatException Error(string message, long offset) => new(File, RecordId, offset, message);

    /// <summary>Notes something odd at an offset from the start of the record.</summary>
    public readonly void Remark(string message, long offset) => remarks?.Add(new DatRemark(RecordId, offset, message));

    /// <summary>Reads a byte.</summary>
    public byte ReadByte() => bytes.TryRead(out byte value) ? value : throw Truncated(1);

    /// <summary>Reads a 16-bit number.</summary>
    public short ReadInt16() => bytes.TryReadLittleEndian(out short value) ? value : throw Truncated(2);

    /// <summary>Reads a 16-bit number.</summary>
    public ushort ReadUInt16() => (ushort)ReadInt16();

    /// <summary>Reads a 32-bit number.</summary>
    public int ReadInt32() => bytes.TryReadLittleEndian(out int value) ? value : throw Truncated(4);

    /// <summary>Reads a 32-bit number.</summary>
    public uint ReadUInt32() => (uint)ReadInt32();

    /// <summary>Reads a float; its bits are kept, NaN included.</summary>
    public float ReadSingle() => BitConverter.Int32BitsToSingle(ReadInt32());

    /// <summary>Reads a double; its bits are kept, NaN included.</summary>
    public double ReadDouble()
        => bytes.TryReadLittleEndian(out long value) ? BitConverter.Int64BitsToDouble(value) : throw Truncated(8);

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

    /// <summary>Reads a frame. NaN in it is an error, a rotation that is not of length 1 a remark (spec 07, section 2).</summary>
    public DatFrame ReadFrame()
    {
        long start = Position;
        var frame = new DatFrame(ReadVector3(), ReadQuaternion());
        if (frame.HasNaN)
            throw Error("a frame has a number that is NaN", start);
        if (!frame.IsValid)
            Remark("the rotation of a frame is not of length 1", start);
        return frame;
    }

    /// <summary>Reads a plane: normal, then d; a point p is in front when n·p + d > 0.</summary>
    public Plane ReadPlane()
    {
        Vector3 normal = ReadVector3();
        return new Plane(normal, ReadSingle());
    }

    /// <summary>Reads a sphere: centre, radius.</summary>
    public DatSphere ReadSphere()
    {
        Vector3 centre = ReadVector3();
        return new DatSphere(centre, ReadSingle());
    }

    /// <summary>Reads a colour, stored as blue, green, red, alpha.</summary>
    public DatColor ReadColor()
    {
        byte blue = ReadByte(), green = ReadByte(), red = ReadByte(), alpha = ReadByte();
        return new DatColor(red, green, blue, alpha);
    }

    /// <summary>Reads an unsigned number of 1, 2 or 4 bytes (spec 07, section 2, cuint).</summary>
    public uint ReadCompressedUInt32()
    {
        byte first = ReadByte();
        if ((first & 0x80) == 0)
            return first;
        byte second = ReadByte();
        if ((first & 0x40) == 0)
            return ((first & 0x7Fu) << 8) | second;
        return ((((first & 0x3Fu) << 8) | second) << 16) | ReadUInt16();
    }

    /// <summary>Reads an id whose kind the context knows (spec 07, section 2, known-type id).</summary>
    /// <param name="baseId">Lowest id of the kind.</param>
    public uint ReadKnownTypeId(uint baseId)
    {
        ushort word = ReadUInt16();
        uint offset = (word & 0x3FFFu);
        return baseId + ((word & 0x8000) == 0 ? offset : (offset << 16) | ReadUInt16());
    }

    /// <summary>Reads a pstring with the alignment behind it. A trailing NUL among the counted bytes stays, so that the record
    /// re-encodes to the same bytes; retail drops it.</summary>
    public string ReadPString()
    {
        long length = ReadUInt16();
        if (length == 0xFFFF)
            length = ReadUInt32();
        if (length > Remaining)
            throw Error($"a text of {length} bytes, but {Remaining} are left");
        string text = string.Create((int)length, bytes.UnreadSequence.Slice(0, length), static (characters, source) =>
        {
            int i = 0;
            foreach (ReadOnlyMemory<byte> segment in source)
            {
                foreach (byte value in segment.Span)
                    characters[i++] = Windows1252.Decode(value);
            }
        });
        bytes.Advance(length);
        Align4();
        return text;
    }

    /// <summary>Skips to the next multiple of 4, counted from the start of the record.</summary>
    public void Align4() => SkipPadding((int)(-Position & 3));

    /// <summary>Skips bytes that carry nothing; notes them when they are not zero.</summary>
    public void SkipPadding(int count)
    {
        for (; count > 0; count--)
        {
            long offset = Position;
            if (ReadByte() != 0)
                Remark(PaddingRemark, offset);
        }
    }

    /// <summary>Reads a u32 count and checks it against the bytes left.</summary>
    /// <param name="elementSize">Least bytes of one element, at least 1.</param>
    public int ReadCount(int elementSize) => CheckCount(ReadUInt32(), elementSize);

    /// <summary>Refuses a count whose elements cannot fit into the bytes left, before anything is allocated for them.</summary>
    public readonly int CheckCount(long count, int elementSize)
        => count * elementSize <= Remaining
            ? (int)count
            : throw Error($"a list of {count} elements of {elementSize} bytes or more, but {Remaining} bytes are left");

    /// <summary>Reads a list without its count.</summary>
    /// <param name="count">Number of elements, checked here against the bytes left.</param>
    /// <param name="elementSize">Least bytes of one element, at least 1.</param>
    /// <param name="read">Reads one element.</param>
    public ImmutableArray<T> ReadArray<T>(long count, int elementSize, ReadElement<T> read)
    {
        var elements = new T[CheckCount(count, elementSize)];
        for (int i = 0; i < elements.Length; i++)
            elements[i] = read(ref this);
        return ImmutableCollectionsMarshal.AsImmutableArray(elements);
    }

    /// <summary>Reads a u32 count and that many elements.</summary>
    public ImmutableArray<T> ReadList<T>(int elementSize, ReadElement<T> read) => ReadArray(ReadUInt32(), elementSize, read);

    /// <summary>Reads a list of ids or other 32-bit numbers without its count.</summary>
    public ImmutableArray<uint> ReadUInt32Array(long count) => ReadArray(count, 4, static (ref r) => r.ReadUInt32());

    /// <summary>Reads a list of 16-bit numbers without its count.</summary>
    public ImmutableArray<ushort> ReadUInt16Array(long count) => ReadArray(count, 2, static (ref r) => r.ReadUInt16());

    /// <summary>Reads a list of signed 16-bit numbers without its count.</summary>
    public ImmutableArray<short> ReadInt16Array(long count) => ReadArray(count, 2, static (ref r) => r.ReadInt16());

    /// <summary>Reads a list of bytes without its count.</summary>
    public ImmutableArray<byte> ReadByteArray(long count)
    {
        var copy = new byte[CheckCount(count, 1)];
        bytes.UnreadSequence.Slice(0, copy.Length).CopyTo(copy);
        bytes.Advance(copy.Length);
        return ImmutableCollectionsMarshal.AsImmutableArray(copy);
    }

    /// <summary>Reads the leading id and checks that it is the directory's.</summary>
    public uint ReadId()
    {
        uint id = ReadUInt32();
        return id == RecordId ? id : throw Error($"the record begins with id 0x{id:X8}", 0);
    }

    internal const string PaddingRemark = "a byte of alignment is not zero";

    /// <summary>Up to three zeros that align the end are fine; anything else left over is an error.</summary>
    internal int ReadEnd()
    {
        long start = Position;
        int zeros = 0;
        while (Remaining > 0 && zeros < 3 && bytes.TryPeek(out byte value) && value == 0)
        {
            bytes.Advance(1);
            zeros++;
        }

        return Remaining == 0 ? zeros : throw Error($"{Remaining + zeros} bytes are left over", start);
    }

    private readonly DatFormatException Truncated(int wanted)
        => Error($"the record ends here: {wanted} bytes wanted, {Remaining} left");
}
