using System.Buffers.Binary;
using Microsoft.Win32.SafeHandles;

namespace Surefoot.Dats;

/// <summary>Blocks of a file that changes: the free list, storing and freeing chains, growing (spec 07, 5.2).</summary>
internal sealed class BlockStore : IDisposable
{
    private const int LinkSize = 4;
    private const int Growth = 0x100000;
    private const int SpareBlocks = 51;

    private readonly SafeFileHandle file;
    private readonly string name;
    private readonly int blockSize;
    private readonly int payload;
    private DatHeader header;
    private long length;

    public BlockStore(string path, DatHeader header, string name)
    {
        file = File.OpenHandle(path, FileMode.Open, FileAccess.ReadWrite, FileShare.None);
        this.header = header;
        this.name = name;
        blockSize = (int)header.BlockSize;
        payload = blockSize - LinkSize;
        length = RandomAccess.GetLength(file);
        if (!FreeListIsSound())
            StartFreeList();
    }

    public uint RootNode
    {
        get => header.RootNode;
        set => header = header with { RootNode = value };
    }

    /// <summary>Bytes of the chain from a block on, cut at a size.</summary>
    public byte[] Load(uint first, int size)
    {
        var bytes = new byte[size];
        int done = 0;
        for (uint offset = first; done < size; offset = LinkOf(offset))
        {
            RequireBlock(offset);
            int count = Math.Min(payload, size - done);
            ReadAt(offset + LinkSize, bytes.AsSpan(done, count));
            done += count;
        }

        return bytes;
    }

    /// <summary>Writes bytes to blocks from the head of the free list.</summary>
    /// <returns>Offset of the first block.</returns>
    public uint Store(ReadOnlySpan<byte> bytes)
    {
        while ((bytes.Length / payload) + SpareBlocks >= header.FreeBlockCount)
            Expand();
        uint first = header.FirstFreeBlock, offset = first;
        for (bool last = false; !last;)
        {
            last = bytes.Length <= payload;
            uint next = LinkOf(offset) & ~BlockReader.FreeBit;
            WriteLink(offset, last ? 0 : next);
            WriteAt(offset + LinkSize, last ? bytes : bytes[..payload]);
            bytes = last ? default : bytes[payload..];
            header = header with { FirstFreeBlock = next, FreeBlockCount = header.FreeBlockCount - 1 };
            offset = next;
        }

        return first;
    }

    /// <summary>Overwrites a chain along its blocks; the size is the one it was stored with.</summary>
    public void Overwrite(uint first, ReadOnlySpan<byte> bytes)
    {
        for (uint offset = first; !bytes.IsEmpty; offset = LinkOf(offset))
        {
            RequireBlock(offset);
            int count = Math.Min(payload, bytes.Length);
            WriteAt(offset + LinkSize, bytes[..count]);
            bytes = bytes[count..];
        }
    }

    /// <summary>Appends a chain to the free list. The first free block does not change.</summary>
    public void Free(uint first)
    {
        uint count = 0, last = first;
        for (uint offset = first; offset != 0; count++)
        {
            RequireBlock(offset);
            uint next = LinkOf(offset);

            // A block that is free already: the chain loops or is freed twice.
            if ((next & BlockReader.FreeBit) != 0)
                throw new DatFormatException(name, null, offset, "a chain of blocks runs into a free block");
            WriteLink(offset, BlockReader.FreeBit | next);
            last = offset;
            offset = next;
        }

        WriteLink(header.LastFreeBlock, BlockReader.FreeBit | first);
        header = header with { LastFreeBlock = last, FreeBlockCount = header.FreeBlockCount + count };
    }

    /// <summary>Writes the header and closes the file.</summary>
    public void Close()
    {
        var head = new byte[DatHeader.ByteSize];
        ReadAt(0, head);
        var text = head.AsSpan(0, 0x100).ToArray();
        (header with { FileSize = (uint)length }).Write(head);
        text.CopyTo(head, 0);
        WriteAt(0, head);
        RandomAccess.FlushToDisk(file);
        Dispose();
    }

    public void Dispose() => file.Dispose();

    private bool FreeListIsSound()
    {
        if (header.FreeBlockCount == 0 || header.FreeBlockCount > length / blockSize)
            return false;
        uint offset = header.FirstFreeBlock;
        for (uint i = 1; ; i++)
        {
            if (!IsBlock(offset))
                return false;
            uint link = LinkOf(offset);
            if ((link & BlockReader.FreeBit) == 0)
                return false;
            if (i == header.FreeBlockCount)
                return link == BlockReader.FreeBit && offset == header.LastFreeBlock;
            offset = link & ~BlockReader.FreeBit;
        }
    }

    // Other writers do not link their free blocks. Theirs are left alone and a list of our own begins at the end of the file.
    private void StartFreeList()
    {
        header = header with { FirstFreeBlock = 0, LastFreeBlock = 0, FreeBlockCount = 0 };
        Expand();
    }

    private void Expand()
    {
        int blocks = Math.Max(1, Growth / blockSize);
        long start = length;
        if (start + ((long)blocks * blockSize) >= BlockReader.FreeBit)
            throw new IOException($"'{name}' would be larger than 2 GB, which links between blocks cannot express.");
        var grown = new byte[blocks * blockSize];
        for (int i = 0; i < blocks; i++)
        {
            uint next = i == blocks - 1 ? 0 : (uint)(start + ((i + 1L) * blockSize));
            BinaryPrimitives.WriteUInt32LittleEndian(grown.AsSpan(i * blockSize), BlockReader.FreeBit | next);
        }

        WriteAt(start, grown);
        length += grown.Length;
        if (header.LastFreeBlock != 0)
            WriteLink(header.LastFreeBlock, BlockReader.FreeBit | (uint)start);
        header = header with
        {
            FirstFreeBlock = header.FirstFreeBlock == 0 ? (uint)start : header.FirstFreeBlock,
            LastFreeBlock = (uint)(length - blockSize),
            FreeBlockCount = header.FreeBlockCount + (uint)blocks,
        };
    }

    private bool IsBlock(uint offset) => offset >= DatHeader.ByteSize && (long)offset + LinkSize <= length;

    private void RequireBlock(uint offset)
    {
        if (!IsBlock(offset))
            throw new DatFormatException(name, null, offset, "a block lies outside the file");
    }

    private uint LinkOf(uint offset)
    {
        Span<byte> link = stackalloc byte[LinkSize];
        ReadAt(offset, link);
        return BinaryPrimitives.ReadUInt32LittleEndian(link);
    }

    private void WriteLink(uint offset, uint link)
    {
        Span<byte> bytes = stackalloc byte[LinkSize];
        BinaryPrimitives.WriteUInt32LittleEndian(bytes, link);
        WriteAt(offset, bytes);
    }

    private void ReadAt(long offset, Span<byte> bytes)
    {
        while (!bytes.IsEmpty)
        {
            int count = RandomAccess.Read(file, bytes, offset);
            if (count == 0)
                throw new DatFormatException(name, null, offset, "the file ends within a block");
            bytes = bytes[count..];
            offset += count;
        }
    }

    private void WriteAt(long offset, ReadOnlySpan<byte> bytes) => RandomAccess.Write(file, bytes, offset);
}
