using System.Buffers;

namespace Surefoot.Dats;

/// <summary>Walks the directory with bounds (spec 07, 5.4). A subtree that breaks a rule is left out and reported.</summary>
internal sealed class DirectoryReader(BlockReader blocks, long fileLength)
{
    private const int MaxDepth = 8;

    private readonly HashSet<uint> visited = [];
    private readonly List<DatEntry> entries = [];
    private readonly List<DatRemark> damage = [];
    private readonly byte[] buffer = new byte[DirectoryNode.ByteSize];

    // Nodes do not share bytes, so a file holds no more than this.
    private long nodesLeft = (fileLength / DirectoryNode.ByteSize) + 1;

    /// <summary>All entries below a root, ascending by id, and what is damaged.</summary>
    public (DatEntry[] Entries, IReadOnlyList<DatRemark> Damage) ReadAll(uint root)
    {
        if (root != 0)
            Walk(root, -1, (long)uint.MaxValue + 1, 1);
        return ([.. entries], damage);
    }

    /// <summary>Reads one node; null and a reason when that fails.</summary>
    public DirectoryNode? ReadNode(uint offset, out string problem)
    {
        try
        {
            blocks.Read(offset, DirectoryNode.ByteSize, null).CopyTo(buffer);
            return DirectoryNode.Read(offset, buffer, out problem);
        }
        catch (DatFormatException e)
        {
            problem = e.Reason;
            return null;
        }
    }

    // All ids of the subtree lie strictly between the separators around it.
    private void Walk(uint offset, long above, long below, int depth)
    {
        if (depth > MaxDepth)
        {
            Damage(offset, $"the directory is deeper than {MaxDepth} nodes");
            return;
        }

        if (!visited.Add(offset) || nodesLeft-- == 0)
        {
            Damage(offset, "a node of the directory is reached twice");
            return;
        }

        DirectoryNode? node = ReadNode(offset, out string problem);
        if (node is null)
        {
            Damage(offset, problem);
            return;
        }

        long last = above;
        foreach (DatEntry entry in node.Entries)
        {
            if (entry.Id <= last || entry.Id >= below)
            {
                Damage(offset, $"a node of the directory holds 0x{entry.Id:X8} out of order");
                return;
            }

            last = entry.Id;
        }

        if (node.IsLeaf)
        {
            entries.AddRange(node.Entries);
            return;
        }

        last = above;
        for (int i = 0; i < node.Children.Count; i++)
        {
            bool isLast = i == node.Entries.Count;
            Walk(node.Children[i], last, isLast ? below : node.Entries[i].Id, depth + 1);
            if (isLast)
                continue;
            entries.Add(node.Entries[i]);
            last = node.Entries[i].Id;
        }
    }

    private void Damage(uint offset, string message) => damage.Add(new DatRemark(null, offset, message));
}
