using System.Collections.Immutable;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>A flat convex polygon of a shape.</summary>
/// <param name="Points">Corners, counter-clockwise seen from the side it faces.</param>
/// <param name="Surface">Surface id that it is drawn with; 0 for a portal, which is neither drawn nor solid.</param>
internal sealed record Face(ImmutableArray<Point3> Points, uint Surface)
{
    /// <summary>Direction it faces, of length 1.</summary>
    public Point3 Normal { get; } = NormalOf(Points);

    /// <summary>The plane's constant: points p on the face satisfy Normal · p + Offset = 0.</summary>
    public double Offset { get; } = -NormalOf(Points).Dot(Points[0]);

    /// <summary>True for an opening to another cell.</summary>
    public bool IsPortal => Surface == 0;

    /// <summary>Signed distance of a point in front of the face.</summary>
    public double DistanceTo(Point3 point) => Normal.Dot(point) + Offset;

    /// <summary>The same polygon, facing the other way.</summary>
    public Face Flipped() => new([.. Points.Reverse()], Surface);

    private static Point3 NormalOf(ImmutableArray<Point3> points)
    {
        var sum = new Point3(0, 0, 0);
        for (int i = 1; i + 1 < points.Length; i++)
            sum += Point3.Cross(points[i] - points[0], points[i + 1] - points[0]);
        return sum * (1.0 / sum.Length);
    }
}
