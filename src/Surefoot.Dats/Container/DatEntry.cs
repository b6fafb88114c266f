using System.Buffers.Binary;

namespace Surefoot.Dats;

/// <summary>One line of a file's directory (spec 07, 4.4).</summary>
/// <param name="Flags">Bit 0: compressed; the others are reserved.</param>
/// <param name="Version">Version of the record's packing.</param>
/// <param name="Id">The record.</param>
/// <param name="Offset">Byte offset of its first block in the file.</param>
/// <param name="Size">Stored size in bytes.</param>
/// <param name="Date">Unix seconds.</param>
/// <param name="Iteration">Update in which it was last changed.</param>
public readonly record struct DatEntry(ushort Flags, ushort Version, uint Id, uint Offset, uint Size, uint Date, uint Iteration)
{
    /// <summary>The bit of <see cref="Flags"/> that says a zlib stream is stored.</summary>
    public const ushort CompressedFlag = 1;

    internal const int ByteSize = 24;

    /// <summary>Whether the stored bytes are u32 unpacked size and a zlib stream.</summary>
    public bool IsCompressed => (Flags & CompressedFlag) != 0;

    internal static DatEntry Read(ReadOnlySpan<byte> bytes) => new(
        BinaryPrimitives.ReadUInt16LittleEndian(bytes),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[2..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[4..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[8..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[12..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[16..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[20..]));

    internal void Write(Span<byte> bytes)
    {
        BinaryPrimitives.WriteUInt16LittleEndian(bytes, Flags);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[2..], Version);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[4..], Id);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[8..], Offset);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[12..], Size);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[16..], Date);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[20..], Iteration);
    }
}
