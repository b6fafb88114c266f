using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>
/// The trees of the worked examples, built as specification 04, 6.7, describes: a chain of outward planes, solid behind the last.
/// </summary>
internal static class Trees
{
    internal enum Face
    {
        PlusX,
        MinusX,
        PlusY,
        MinusY,
        PlusZ,
        MinusZ,
    }

    /// <summary>The unit cube of 6.7.</summary>
    internal static PhysicsBsp UnitCube() => Box(
        new(-0.5f), new(0.5f), new Sphere(Vector3.Zero, 0.8660254f), Face.PlusX, Face.MinusX, Face.PlusY, Face.MinusY, Face.PlusZ,
        Face.MinusZ);

    /// <summary>A box as in 6.16: planes and polygons in the order top, bottom, +x, −x, +y, −y.</summary>
    internal static PhysicsBsp Box(Vector3 min, Vector3 max)
    {
        Vector3 center = (min + max) / 2;
        return Box(
            min, max, new Sphere(center, (float)RetailMath.Length(max - center)), Face.PlusZ, Face.MinusZ, Face.PlusX, Face.MinusX,
            Face.PlusY, Face.MinusY);
    }

    internal static PhysicsBsp Box(Vector3 min, Vector3 max, Sphere bounds, params ReadOnlySpan<Face> order)
    {
        Vector3[][] faces = new Vector3[order.Length][];
        for (int i = 0; i < faces.Length; i++) faces[i] = Corners(order[i], min, max);
        return Chain(faces, bounds);
    }

    /// <summary>Polygons given by their corners; the planes are worked out.</summary>
    internal static PolygonSet Polygons(params ReadOnlySpan<Vector3[]> polygons)
    {
        PolygonSetBuilder builder = new(polygons.Length);
        foreach (Vector3[] polygon in polygons) builder.Add(polygon);
        return builder.Build();
    }

    /// <summary>A convex solid: in front of each face nothing, behind all of them a solid leaf with every face.</summary>
    internal static PhysicsBsp Chain(Vector3[][] faces, Sphere bounds)
    {
        PolygonSet polygons = Polygons(faces);
        PhysicsBspBuilder builder = new(polygons);
        int below = builder.AddLeaf(bounds, true, [.. Enumerable.Range(0, faces.Length)]);
        for (int i = faces.Length - 1; i >= 0; i--)
        {
            int node = builder.AddNode(polygons.PlaneOf(i), bounds);
            builder.SetNegative(node, below);
            below = node;
        }

        return builder.Build(below, bounds);
    }

    /// <summary>One wall or floor: nothing in front, a solid leaf with the polygon behind.</summary>
    internal static PhysicsBsp OneFace(params Vector3[] corners) => Chain([corners], new Sphere(corners[0], 100));

    /// <summary>Corners of a face of a box, counter-clockwise seen from outside.</summary>
    internal static Vector3[] Corners(Face face, Vector3 a, Vector3 b) => face switch
    {
        Face.PlusX => [new(b.X, a.Y, a.Z), new(b.X, b.Y, a.Z), new(b.X, b.Y, b.Z), new(b.X, a.Y, b.Z)],
        Face.MinusX => [new(a.X, a.Y, a.Z), new(a.X, a.Y, b.Z), new(a.X, b.Y, b.Z), new(a.X, b.Y, a.Z)],
        Face.PlusY => [new(a.X, b.Y, a.Z), new(a.X, b.Y, b.Z), new(b.X, b.Y, b.Z), new(b.X, b.Y, a.Z)],
        Face.MinusY => [new(a.X, a.Y, a.Z), new(b.X, a.Y, a.Z), new(b.X, a.Y, b.Z), new(a.X, a.Y, b.Z)],
        Face.PlusZ => [new(a.X, a.Y, b.Z), new(b.X, a.Y, b.Z), new(b.X, b.Y, b.Z), new(a.X, b.Y, b.Z)],
        _ => [new(a.X, a.Y, a.Z), new(a.X, b.Y, a.Z), new(b.X, b.Y, a.Z), new(b.X, a.Y, a.Z)],
    };
}
