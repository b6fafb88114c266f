using System.Buffers.Binary;

namespace Surefoot.Dats;

/// <summary>A node of the directory's B-tree (spec 07, 4.3).</summary>
internal sealed class DirectoryNode(uint offset)
{
    public const int ByteSize = 1716;
    public const int MaxEntries = 61;
    public const int MinEntries = 30;
    private const int MaxChildren = MaxEntries + 1;
    private const int CountOffset = 4 * MaxChildren;
    private const int EntriesOffset = CountOffset + 4;

    // What another library leaves in the children of its leaves.
    private const uint UnusedChild = 0xCDCDCDCD;

    /// <summary>Offset of its first block.</summary>
    public uint Offset { get; } = offset;

    /// <summary>Entries, ascending by id.</summary>
    public List<DatEntry> Entries { get; } = new(MaxEntries);

    /// <summary>One more than entries in an inner node; none in a leaf.</summary>
    public List<uint> Children { get; } = [];

    public bool IsLeaf => Children.Count == 0;

    public bool IsFull => Entries.Count == MaxEntries;

    /// <summary>Reads the payload of a node; null and a reason when its count is impossible.</summary>
    public static DirectoryNode? Read(uint offset, ReadOnlySpan<byte> bytes, out string problem)
    {
        uint count = BinaryPrimitives.ReadUInt32LittleEndian(bytes[CountOffset..]);
        if (count > MaxEntries)
        {
            problem = $"a node of the directory with {count} entries; at most {MaxEntries} are possible";
            return null;
        }

        problem = string.Empty;
        var node = new DirectoryNode(offset);
        for (int i = 0; i < count; i++)
            node.Entries.Add(DatEntry.Read(bytes[(EntriesOffset + (i * DatEntry.ByteSize))..]));
        uint first = BinaryPrimitives.ReadUInt32LittleEndian(bytes);
        for (int i = 0; first is not (0 or UnusedChild) && i <= count; i++)
            node.Children.Add(BinaryPrimitives.ReadUInt32LittleEndian(bytes[(4 * i)..]));
        return node;
    }

    /// <summary>The payload, everything unused zero.</summary>
    public byte[] ToBytes()
    {
        var bytes = new byte[ByteSize];
        for (int i = 0; i < Children.Count; i++)
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(4 * i), Children[i]);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(CountOffset), (uint)Entries.Count);
        for (int i = 0; i < Entries.Count; i++)
            Entries[i].Write(bytes.AsSpan(EntriesOffset + (i * DatEntry.ByteSize)));
        return bytes;
    }

    /// <summary>How many entries have an id below; also the child to enter for an id that is not here.</summary>
    public int PositionOf(uint id)
    {
        int low = 0, high = Entries.Count;
        while (low < high)
        {
            int middle = (low + high) / 2;
            if (Entries[middle].Id < id)
                low = middle + 1;
            else
                high = middle;
        }

        return low;
    }

    /// <summary>Whether the entry at a position has this id.</summary>
    public bool HasAt(int position, uint id) => position < Entries.Count && Entries[position].Id == id;
}
