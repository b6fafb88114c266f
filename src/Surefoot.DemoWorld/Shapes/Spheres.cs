using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>Bounding spheres.</summary>
internal static class Spheres
{
    /// <summary>A sphere about the middle of the points' box that encloses them, with a millimetre to spare for rounding.</summary>
    public static DatSphere Around(IReadOnlyCollection<Point3> points)
    {
        Point3 low = new(points.Min(p => p.X), points.Min(p => p.Y), points.Min(p => p.Z));
        Point3 high = new(points.Max(p => p.X), points.Max(p => p.Y), points.Max(p => p.Z));
        Point3 centre = (low + high) * 0.5;
        return new(centre.ToVector(), (float)(points.Max(p => (p - centre).Length) + 0.001));
    }
}
