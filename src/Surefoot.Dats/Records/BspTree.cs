using System.Collections.Immutable;
using System.Runtime.InteropServices;

namespace Surefoot.Dats.Records;

/// <summary>A tree of the kind that the record says, flat: node 0 is the root, children are indices (spec 07, 7.2).</summary>
/// <remarks>Retail: BSPTREE::UnPack @0x00539830, BSPNODE::UnPackChild @0x0053C770. Reading and writing keep their own stack, so depth
/// is bounded by the bytes only.</remarks>
public sealed class BspTree
{
    /// <summary>The nodes; as read, a node comes before its positive and that before its negative subtree.</summary>
    public required ImmutableArray<BspNode> Nodes { get; init; }

    /// <summary>A tree of one leaf.</summary>
    public static BspTree OfLeaf(BspNode leaf) => new() { Nodes = [leaf] };

    internal static BspTree Read(ref DatReader reader, BspKind kind)
    {
        var nodes = new List<BspNode>();
        var open = new Stack<Visit>();
        Begin(ref reader, kind, nodes, open);
        while (open.TryPop(out Visit visit))
        {
            Span<BspNode> known = CollectionsMarshal.AsSpan(nodes);
            BspNode node = known[visit.Node];
            if (visit.Next == Stage.Positive)
            {
                open.Push(visit with { Next = Stage.Negative });
                if (!BspNode.HasPositive(node.Tag))
                    continue;
                known[visit.Node] = node with { Positive = nodes.Count };
                Begin(ref reader, kind, nodes, open);
            }
            else if (visit.Next == Stage.Negative)
            {
                open.Push(visit with { Next = Stage.Rest });
                if (!BspNode.HasNegative(node.Tag))
                    continue;
                known[visit.Node] = node with { Negative = nodes.Count };
                Begin(ref reader, kind, nodes, open);
            }
            else
            {
                known[visit.Node] = ReadRest(ref reader, kind, node);
            }
        }

        return new() { Nodes = [.. nodes] };
    }

    internal void Write(DatWriter writer, BspKind kind)
    {
        DatWriter.Require(!Nodes.IsDefaultOrEmpty, "A tree needs a root; there is no empty tree.");
        var open = new Stack<Visit>();
        int visited = 0;
        open.Push(new(0, Stage.Start));
        while (open.TryPop(out Visit visit))
        {
            DatWriter.Require((uint)visit.Node < (uint)Nodes.Length, "A child index of a tree lies outside its nodes.");
            BspNode node = Nodes[visit.Node];
            switch (visit.Next)
            {
                case Stage.Start:
                    DatWriter.Require(visited++ < Nodes.Length, "A node of a tree is the child of two nodes.");
                    WriteStart(writer, kind, node);
                    if (!node.IsLeaf)
                        open.Push(visit with { Next = Stage.Positive });
                    break;
                case Stage.Positive:
                    open.Push(visit with { Next = Stage.Negative });
                    if (BspNode.HasPositive(node.Tag))
                        open.Push(new(node.Positive, Stage.Start));
                    break;
                case Stage.Negative:
                    open.Push(visit with { Next = Stage.Rest });
                    if (BspNode.HasNegative(node.Tag))
                        open.Push(new(node.Negative, Stage.Start));
                    break;
                default:
                    WriteRest(writer, kind, node);
                    break;
            }
        }
    }

    // Reads tag and whatever comes before the children; a leaf is complete then.
    private static void Begin(ref DatReader reader, BspKind kind, List<BspNode> nodes, Stack<Visit> open)
    {
        var tag = (BspTag)reader.ReadUInt32();
        if (tag == BspTag.Leaf)
        {
            nodes.Add(ReadLeaf(ref reader, kind));
            return;
        }

        if (tag == BspTag.Port && kind != BspKind.Drawing)
            reader.Remark("a PORT node outside a drawing tree", reader.Position - 4);
        open.Push(new(nodes.Count, Stage.Positive));
        nodes.Add(new BspNode { Tag = tag, Plane = reader.ReadPlane() });
    }

    private static BspNode ReadLeaf(ref DatReader reader, BspKind kind)
    {
        int index = reader.ReadInt32();
        return kind != BspKind.Physics
            ? new BspNode { LeafIndex = index }
            : new BspNode
            {
                LeafIndex = index,
                Solid = reader.ReadInt32(),
                Sphere = reader.ReadSphere(),
                Polygons = reader.ReadInt16Array(reader.ReadUInt32()),
            };
    }

    private static BspNode ReadRest(ref DatReader reader, BspKind kind, BspNode node)
    {
        if (!HasSphere(kind, node.Tag))
            return node;
        node = node with { Sphere = reader.ReadSphere() };
        if (kind == BspKind.Physics)
            return node;
        uint polygons = reader.ReadUInt32(), portals = node.Tag == BspTag.Port ? reader.ReadUInt32() : 0;
        return node with
        {
            Polygons = reader.ReadInt16Array(polygons),
            Portals = reader.ReadArray(portals, 4, static (ref r) => new BspPortal(r.ReadInt16(), r.ReadUInt16())),
        };
    }

    private static void WriteStart(DatWriter writer, BspKind kind, BspNode node)
    {
        writer.WriteUInt32((uint)node.Tag);
        if (!node.IsLeaf)
        {
            writer.WritePlane(node.Plane);
            return;
        }

        writer.WriteInt32(node.LeafIndex);
        if (kind != BspKind.Physics)
            return;
        writer.WriteInt32(node.Solid);
        writer.WriteSphere(node.Sphere);
        writer.WriteUInt32((uint)node.Polygons.Length);
        writer.WriteInt16Array(node.Polygons);
    }

    private static void WriteRest(DatWriter writer, BspKind kind, BspNode node)
    {
        if (!HasSphere(kind, node.Tag))
            return;
        writer.WriteSphere(node.Sphere);
        if (kind == BspKind.Physics)
            return;
        writer.WriteUInt32((uint)node.Polygons.Length);
        if (node.Tag == BspTag.Port)
            writer.WriteUInt32((uint)node.Portals.Length);
        writer.WriteInt16Array(node.Polygons);
        if (node.Tag != BspTag.Port)
            return;
        writer.WriteArray(node.Portals, static (w, portal) =>
        {
            w.WriteInt16(portal.Polygon);
            w.WriteUInt16(portal.Portal);
        });
    }

    // An inner physics node that is a PORT stores plane and children only.
    private static bool HasSphere(BspKind kind, BspTag tag)
        => kind == BspKind.Drawing || (kind == BspKind.Physics && tag != BspTag.Port);

    private enum Stage
    {
        Start,
        Positive,
        Negative,
        Rest,
    }

    private readonly record struct Visit(int Node, Stage Next);
}
