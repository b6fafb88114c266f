namespace Surefoot.Dats;

/// <summary>Changes the directory's B-tree: splits on the way down when inserting, borrows or merges on the way down when deleting
/// (spec 07, 5.3).</summary>
internal sealed class DirectoryTree(BlockStore store)
{
    private readonly Dictionary<uint, DirectoryNode> nodes = [];
    private readonly HashSet<uint> dirty = [];

    public bool TryFind(uint id, out DatEntry entry)
    {
        entry = default;
        for (uint offset = id == 0 ? 0 : store.RootNode; offset != 0;)
        {
            DirectoryNode node = Node(offset);
            int position = node.PositionOf(id);
            if (node.HasAt(position, id))
            {
                entry = node.Entries[position];
                return true;
            }

            offset = node.IsLeaf ? 0 : node.Children[position];
        }

        return false;
    }

    /// <summary>Puts an entry in the place of the one with its id, which exists.</summary>
    public void Replace(in DatEntry entry)
    {
        DirectoryNode node = Root();
        int position = node.PositionOf(entry.Id);
        while (!node.HasAt(position, entry.Id))
        {
            node = Node(node.Children[position]);
            position = node.PositionOf(entry.Id);
        }

        node.Entries[position] = entry;
        dirty.Add(node.Offset);
    }

    /// <summary>Adds an entry whose id is not there.</summary>
    public void Insert(in DatEntry entry)
    {
        DirectoryNode node = Root();
        if (node.IsFull)
        {
            DirectoryNode root = NewNode();
            root.Children.Add(node.Offset);
            Split(root, 0);
            store.RootNode = root.Offset;
            node = root;
        }

        while (!node.IsLeaf)
        {
            int position = node.PositionOf(entry.Id);
            if (Node(node.Children[position]).IsFull)
            {
                Split(node, position);
                if (entry.Id > node.Entries[position].Id)
                    position++;
            }

            node = Node(node.Children[position]);
        }

        node.Entries.Insert(node.PositionOf(entry.Id), entry);
        dirty.Add(node.Offset);
    }

    /// <summary>Removes the entry of an id, which exists.</summary>
    public void Delete(uint id) => Delete(Root(), id);

    /// <summary>Writes all changed nodes.</summary>
    public void Flush()
    {
        foreach (uint offset in dirty)
            store.Overwrite(offset, nodes[offset].ToBytes());
        dirty.Clear();
    }

    private void Delete(DirectoryNode node, uint id)
    {
        while (true)
        {
            int position = node.PositionOf(id);
            bool here = node.HasAt(position, id);
            if (node.IsLeaf)
            {
                if (here)
                    RemoveEntry(node, position);
                return;
            }

            if (!here)
            {
                node = Thicken(node, position);
            }
            else if (CanLend(Node(node.Children[position])))
            {
                node.Entries[position] = TakeGreatest(Node(node.Children[position]));
                dirty.Add(node.Offset);
                return;
            }
            else if (CanLend(Node(node.Children[position + 1])))
            {
                node.Entries[position] = TakeSmallest(Node(node.Children[position + 1]));
                dirty.Add(node.Offset);
                return;
            }
            else
            {
                node = Merge(node, position);
            }
        }
    }

    private DatEntry TakeGreatest(DirectoryNode node)
    {
        while (!node.IsLeaf)
            node = Thicken(node, node.Entries.Count);
        DatEntry entry = node.Entries[^1];
        RemoveEntry(node, node.Entries.Count - 1);
        return entry;
    }

    private DatEntry TakeSmallest(DirectoryNode node)
    {
        while (!node.IsLeaf)
            node = Thicken(node, 0);
        DatEntry entry = node.Entries[0];
        RemoveEntry(node, 0);
        return entry;
    }

    /// <summary>Makes sure that the child to enter can lose an entry, and returns it or the node it became.</summary>
    private DirectoryNode Thicken(DirectoryNode parent, int index)
    {
        DirectoryNode child = Node(parent.Children[index]);
        if (CanLend(child))
            return child;
        if (index > 0 && CanLend(Node(parent.Children[index - 1])))
            return RotateFromLeft(parent, index, child);
        if (index < parent.Entries.Count && CanLend(Node(parent.Children[index + 1])))
            return RotateFromRight(parent, index, child);

        // A root without entries and with one child only occurs in files of other writers.
        return parent.Entries.Count == 0 ? child : Merge(parent, index < parent.Entries.Count ? index : index - 1);
    }

    private DirectoryNode RotateFromLeft(DirectoryNode parent, int index, DirectoryNode child)
    {
        DirectoryNode left = Node(parent.Children[index - 1]);
        child.Entries.Insert(0, parent.Entries[index - 1]);
        parent.Entries[index - 1] = left.Entries[^1];
        left.Entries.RemoveAt(left.Entries.Count - 1);
        if (!left.IsLeaf)
        {
            child.Children.Insert(0, left.Children[^1]);
            left.Children.RemoveAt(left.Children.Count - 1);
        }

        MarkDirty(parent, child, left);
        return child;
    }

    private DirectoryNode RotateFromRight(DirectoryNode parent, int index, DirectoryNode child)
    {
        DirectoryNode right = Node(parent.Children[index + 1]);
        child.Entries.Add(parent.Entries[index]);
        parent.Entries[index] = right.Entries[0];
        right.Entries.RemoveAt(0);
        if (!right.IsLeaf)
        {
            child.Children.Add(right.Children[0]);
            right.Children.RemoveAt(0);
        }

        MarkDirty(parent, child, right);
        return child;
    }

    // Child index and its right neighbour around their separator; a root left without entries gives way to its only child.
    private DirectoryNode Merge(DirectoryNode parent, int index)
    {
        DirectoryNode left = Node(parent.Children[index]), right = Node(parent.Children[index + 1]);
        left.Entries.Add(parent.Entries[index]);
        left.Entries.AddRange(right.Entries);
        left.Children.AddRange(right.Children);
        parent.Entries.RemoveAt(index);
        parent.Children.RemoveAt(index + 1);
        FreeNode(right);
        MarkDirty(parent, left, left);
        if (parent.Entries.Count == 0 && parent.Offset == store.RootNode)
        {
            store.RootNode = left.Offset;
            FreeNode(parent);
        }

        return left;
    }

    // Entry 30 of the child moves up; both halves keep 30 entries.
    private void Split(DirectoryNode parent, int index)
    {
        const int middle = DirectoryNode.MinEntries;
        DirectoryNode left = Node(parent.Children[index]), right = NewNode();
        right.Entries.AddRange(left.Entries[(middle + 1)..]);
        parent.Entries.Insert(index, left.Entries[middle]);
        left.Entries.RemoveRange(middle, left.Entries.Count - middle);
        if (!left.IsLeaf)
        {
            right.Children.AddRange(left.Children[(middle + 1)..]);
            left.Children.RemoveRange(middle + 1, left.Children.Count - middle - 1);
        }

        parent.Children.Insert(index + 1, right.Offset);
        MarkDirty(parent, left, right);
    }

    private static bool CanLend(DirectoryNode node) => node.Entries.Count > DirectoryNode.MinEntries;

    private void RemoveEntry(DirectoryNode node, int position)
    {
        node.Entries.RemoveAt(position);
        dirty.Add(node.Offset);
    }

    private void MarkDirty(DirectoryNode a, DirectoryNode b, DirectoryNode c)
    {
        dirty.Add(a.Offset);
        dirty.Add(b.Offset);
        dirty.Add(c.Offset);
    }

    private DirectoryNode Root()
    {
        if (store.RootNode == 0)
            store.RootNode = NewNode().Offset;
        return Node(store.RootNode);
    }

    private DirectoryNode Node(uint offset)
    {
        if (!nodes.TryGetValue(offset, out DirectoryNode? node))
        {
            node = DirectoryNode.Read(offset, store.Load(offset, DirectoryNode.ByteSize), out string problem)
                ?? throw new InvalidOperationException(problem);
            nodes.Add(offset, node);
        }

        return node;
    }

    private DirectoryNode NewNode()
    {
        uint offset = store.Store(new byte[DirectoryNode.ByteSize]);
        var node = new DirectoryNode(offset);
        nodes.Add(offset, node);
        dirty.Add(offset);
        return node;
    }

    private void FreeNode(DirectoryNode node)
    {
        nodes.Remove(node.Offset);
        dirty.Remove(node.Offset);
        store.Free(node.Offset);
    }
}
