using System.Collections.Immutable;
using System.Numerics;
using System.Runtime.InteropServices;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>
/// Flattens the shapes of one dat record and finds what would hurt later: missing polygons and vertices, numbers that are not finite. Every
/// error names the record.
/// </summary>
/// <remarks>
/// What a record refers to is referred to by position, as retail does; the keys in the file are ignored (specification 07, 7.1).
/// </remarks>
internal readonly struct RecordFlattener(DatRecord record)
{
    /// <summary>Positions of a record's vertices.</summary>
    public Vector3[] Vertices(DatVertexArray source)
    {
        Vector3[] points = new Vector3[source.Vertices.Length];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = source.Vertices[i].Position;
            if (!RetailMath.IsFinite(points[i])) throw Error($"vertex {i} is not a finite point");
        }

        return points;
    }

    /// <summary>Polygons over those vertices. A polygon without area is kept: nothing touches it.</summary>
    public PolygonSet Polygons(ReadOnlySpan<DatPolygon> source, ReadOnlySpan<Vector3> vertices, string kind)
    {
        PolygonSetBuilder builder = new(source.Length);
        Span<Vector3> corners = stackalloc Vector3[sbyte.MaxValue];
        for (int i = 0; i < source.Length; i++)
        {
            ImmutableArray<ushort> indices = source[i].Vertices;
            if (indices.Length is 0 or > sbyte.MaxValue) throw Error($"{kind} polygon {i} has {indices.Length} corners");
            for (int k = 0; k < indices.Length; k++)
            {
                if (indices[k] >= vertices.Length) throw Error($"{kind} polygon {i} names vertex {indices[k]} of {vertices.Length}");
                corners[k] = vertices[indices[k]];
            }

            builder.Add(corners[..indices.Length]);
        }

        return builder.Build();
    }

    /// <summary>
    /// A collision tree. A child that a node's tag does not promise is empty space: retail would follow a null there. A PORT node, which
    /// stores no sphere in these trees and which nobody writes, is never passed over.
    /// </summary>
    public PhysicsBsp PhysicsTree(BspTree tree, PolygonSet polygons)
    {
        try
        {
            PhysicsBspBuilder builder = new(polygons);
            int[] references = new int[tree.Nodes.Length];
            List<int> indices = [];
            for (int i = 0; i < references.Length; i++)
            {
                BspNode node = tree.Nodes[i];
                if (!node.IsLeaf)
                {
                    references[i] = builder.AddNode(node.Plane, BoundsOf(node));
                    continue;
                }

                indices.Clear();
                foreach (short polygon in node.Polygons) indices.Add(polygon);
                references[i] = builder.AddLeaf(BoundsOf(node), node.Solid != 0, CollectionsMarshal.AsSpan(indices));
            }

            for (int i = 0; i < references.Length; i++)
            {
                BspNode node = tree.Nodes[i];
                if (node.IsLeaf) continue;
                if (node.Positive != BspNode.None) builder.SetPositive(references[i], references[node.Positive]);
                if (node.Negative != BspNode.None) builder.SetNegative(references[i], references[node.Negative]);
            }

            return builder.Build(references[0], BoundsOf(tree.Nodes[0]));
        }
        catch (FormatException e)
        {
            throw Error(e.Message);
        }
    }

    /// <summary>A containment tree: the planes along the chain of positive children, up to a node without one or a leaf.</summary>
    public static CellBsp CellTree(BspTree tree)
    {
        List<Plane> planes = [];
        for (int at = 0; at != BspNode.None && !tree.Nodes[at].IsLeaf && planes.Count < tree.Nodes.Length; at = tree.Nodes[at].Positive)
            planes.Add(tree.Nodes[at].Plane);
        return new CellBsp(CollectionsMarshal.AsSpan(planes));
    }

    /// <summary>A frame whose numbers are finite; one that is not quite a rotation is taken as it is.</summary>
    public Frame Frame(in DatFrame frame, string what)
    {
        Quaternion q = frame.Rotation;
        bool finite = RetailMath.IsFinite(frame.Origin) && float.IsFinite(q.X) && float.IsFinite(q.Y) && float.IsFinite(q.Z) &&
            float.IsFinite(q.W);
        return finite ? new Frame(frame.Origin, q) : throw Error($"{what} has a frame that is not finite");
    }

    public Sphere Sphere(in DatSphere sphere, string what) =>
        new(Finite(sphere.Centre, what), Finite(sphere.Radius, what));

    public CylSphere Cylinder(in DatCylSphere cylinder, string what) =>
        new(Finite(cylinder.LowPoint, what), Finite(cylinder.Radius, what), Finite(cylinder.Height, what));

    public float Finite(float value, string what) => float.IsFinite(value) ? value : throw Error($"{what} is not a finite number");

    public Vector3 Finite(in Vector3 value, string what) => RetailMath.IsFinite(value) ? value : throw Error($"{what} is not finite");

    private static Sphere BoundsOf(in BspNode node) =>
        node.Tag == BspTag.Port ? new Sphere(Vector3.Zero, float.PositiveInfinity) : new Sphere(node.Sphere.Centre, node.Sphere.Radius);

    public DatFormatException Error(string message) => new(record.File, record.Id, 0, message);
}
