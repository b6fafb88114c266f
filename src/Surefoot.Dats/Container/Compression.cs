using System.Buffers;
using System.Buffers.Binary;
using System.IO.Compression;

namespace Surefoot.Dats;

/// <summary>Compressed records: u32 unpacked size and a zlib stream (spec 07, 4.4).</summary>
internal static class Compression
{
    private const int SizeBytes = 4;
    private const int LeastStored = 16;
    private const long GreatestUnpacked = 256L << 20;

    // Deflate reaches about 1032 : 1 at most, so no honest size exceeds this.
    private const long GreatestRatio = 1040;

    public static ReadOnlySequence<byte> Unpack(ReadOnlySequence<byte> stored, uint recordId, string file)
    {
        if (stored.Length < LeastStored)
            throw new DatFormatException(file, recordId, 0, $"a compressed record of {stored.Length} bytes; {LeastStored} are the least");
        Span<byte> head = stackalloc byte[SizeBytes];
        stored.Slice(0, SizeBytes).CopyTo(head);
        uint size = BinaryPrimitives.ReadUInt32LittleEndian(head);
        if (size > GreatestUnpacked || size > stored.Length * GreatestRatio)
            throw new DatFormatException(file, recordId, 0, $"{stored.Length} stored bytes cannot unpack to {size} bytes");
        try
        {
            using var zlib = new ZLibStream(new MemoryStream(stored.Slice(SizeBytes).ToArray()), CompressionMode.Decompress);
            var unpacked = new byte[size];
            int length = zlib.ReadAtLeast(unpacked, unpacked.Length, throwOnEndOfStream: false);
            if (length < size || zlib.ReadByte() >= 0)
                throw new DatFormatException(file, recordId, 0, $"the compressed record does not unpack to {size} bytes");
            return new ReadOnlySequence<byte>(unpacked);
        }
        catch (InvalidDataException e)
        {
            throw new DatFormatException(file, recordId, SizeBytes, "the compressed record is damaged", e);
        }
    }

    /// <summary>The stored form; null when it is no smaller, or when the record is too short for retail to try.</summary>
    public static byte[]? Pack(ReadOnlySpan<byte> record)
    {
        if (record.Length <= LeastStored)
            return null;
        using var packed = new MemoryStream();
        Span<byte> head = stackalloc byte[SizeBytes];
        BinaryPrimitives.WriteUInt32LittleEndian(head, (uint)record.Length);
        packed.Write(head);
        using (var zlib = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
            zlib.Write(record);
        return packed.Length < record.Length && packed.Length >= LeastStored ? packed.ToArray() : null;
    }
}
