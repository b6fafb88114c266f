using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

/// <summary>Questions to a shape, answered from its polygons alone, without its tree.</summary>
internal static class Solids
{
    /// <summary>Corners of a polygon.</summary>
    public static Vector3[] Points(DatVertexArray vertices, DatPolygon polygon)
        => [.. polygon.Vertices.Select(index => vertices.Vertices[index].Position)];

    /// <summary>Normal by Newell's sum.</summary>
    public static Vector3 Normal(Vector3[] points)
    {
        var sum = Vector3.Zero;
        for (int i = 1; i + 1 < points.Length; i++)
            sum += Vector3.Cross(points[i] - points[0], points[i + 1] - points[0]);
        return Vector3.Normalize(sum);
    }

    /// <summary>Whether a point lies inside closed faces: the nearest face along a slanting ray is met from behind.</summary>
    public static bool Contains(IReadOnlyList<Vector3[]> faces, Vector3 point)
    {
        var ray = Vector3.Normalize(new(0.3127f, 0.5713f, 0.7591f));
        int crossings = 0;
        foreach (var face in faces)
        {
            for (int i = 1; i + 1 < face.Length; i++)
                crossings += Hits(point, ray, face[0], face[i], face[i + 1]) ? 1 : 0;
        }

        return (crossings & 1) == 1;
    }

    /// <summary>The leaf that a point falls into.</summary>
    public static BspNode LeafAt(BspTree tree, Vector3 point)
    {
        var node = tree.Nodes[0];
        while (!node.IsLeaf)
            node = tree.Nodes[Vector3.Dot(node.Plane.Normal, point) + node.Plane.D > 0 ? node.Positive : node.Negative];
        return node;
    }

    /// <summary>A point on a convex polygon, by random shares of its corners.</summary>
    public static Vector3 PointOn(Vector3[] points, Random random)
    {
        float sum = 0;
        var at = Vector3.Zero;
        foreach (var point in points)
        {
            float share = 0.05f + random.NextSingle();
            at += point * share;
            sum += share;
        }

        return at / sum;
    }

    private static bool Hits(Vector3 from, Vector3 ray, Vector3 a, Vector3 b, Vector3 c)
    {
        Vector3 ab = b - a, ac = c - a, p = Vector3.Cross(ray, ac);
        double det = Vector3.Dot(ab, p);
        if (Math.Abs(det) < 1e-9)
            return false;
        var s = from - a;
        double u = Vector3.Dot(s, p) / det;
        var q = Vector3.Cross(s, ab);
        double v = Vector3.Dot(ray, q) / det, t = Vector3.Dot(ac, q) / det;
        return u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    }
}
