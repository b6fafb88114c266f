using System.Buffers;
using System.Buffers.Binary;

namespace Surefoot.Dats;

/// <summary>Follows chains of blocks (spec 07, 4.2). Refuses chains that end early, leave the file, meet a free block or loop.</summary>
internal sealed class BlockReader(MappedFile file, int blockSize, string name)
{
    public const int LeastBlockSize = 64;
    public const int GreatestBlockSize = 1 << 24;
    public const uint FreeBit = 0x80000000;
    private const int LinkSize = 4;

    private readonly int payload = blockSize - LinkSize;
    private long blocksRead;

    /// <summary>How many blocks have been looked at so far, for the proof that opening reads the directory only.</summary>
    public long BlocksRead => Interlocked.Read(ref blocksRead);

    /// <summary>The chain from a first block on, cut at its known size. No byte is copied.</summary>
    /// <param name="first">Offset of the first block.</param>
    /// <param name="size">Bytes wanted.</param>
    /// <param name="recordId">For errors; null for a directory node.</param>
    public ReadOnlySequence<byte> Read(uint first, uint size, uint? recordId)
    {
        if (size == 0)
            return ReadOnlySequence<byte>.Empty;
        long blocks = ((long)size + payload - 1) / payload;
        if (size + (blocks * LinkSize) > file.Length - DatHeader.ByteSize)
            throw Error(recordId, first, $"{size} bytes do not fit into the file");
        if (blocks == 1)
            return new ReadOnlySequence<byte>(ReadBlock(first, (int)size, recordId, out _));

        Segment? head = null, tail = null;
        uint offset = first;
        HashSet<uint>? seen = null;
        for (long left = size; left > 0;)
        {
            int length = (int)Math.Min(left, payload);
            var memory = ReadBlock(offset, length, recordId, out uint link);
            tail = new Segment(memory, offset, tail);
            head ??= tail;
            left -= length;
            if (left == 0)
                break;
            if (link == 0)
                throw Error(recordId, offset, $"the chain of blocks ends {left} bytes early");
            if ((link & FreeBit) != 0)
                throw Error(recordId, offset, "the chain of blocks runs into a free block");

            // Blocks that only ascend cannot repeat; from the first step back on all are remembered.
            if (link <= offset || seen is not null)
            {
                seen ??= head.Offsets();
                if (!seen.Add(link))
                    throw Error(recordId, offset, $"the chain of blocks comes back to 0x{link:X}");
            }

            offset = link;
        }

        return new ReadOnlySequence<byte>(head!, 0, tail!, tail!.Memory.Length);
    }

    private ReadOnlyMemory<byte> ReadBlock(uint offset, int length, uint? recordId, out uint link)
    {
        if (offset < DatHeader.ByteSize || (long)offset + LinkSize + length > file.Length)
            throw Error(recordId, offset, "a block lies outside the file");
        Interlocked.Increment(ref blocksRead);
        ReadOnlyMemory<byte> block = file.Slice(offset, LinkSize + length);
        link = BinaryPrimitives.ReadUInt32LittleEndian(block.Span);
        return block[LinkSize..];
    }

    private DatFormatException Error(uint? recordId, uint blockOffset, string message)
        => recordId is uint id
            ? new(name, id, 0, $"{message} (block at file offset 0x{blockOffset:X})")
            : new(name, null, blockOffset, message);

    private sealed class Segment : ReadOnlySequenceSegment<byte>
    {
        private readonly uint offset;

        public Segment(ReadOnlyMemory<byte> memory, uint offset, Segment? previous)
        {
            this.offset = offset;
            Memory = memory;
            if (previous is null)
                return;
            RunningIndex = previous.RunningIndex + previous.Memory.Length;
            previous.Next = this;
        }

        public HashSet<uint> Offsets()
        {
            var offsets = new HashSet<uint>();
            for (Segment? segment = this; segment is not null; segment = (Segment?)segment.Next)
                offsets.Add(segment.offset);
            return offsets;
        }
    }
}
