using System.Numerics;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>A point or direction in double precision, so that shapes come out the same on every machine. Metres.</summary>
internal readonly record struct Point3(double X, double Y, double Z)
{
    public static Point3 operator +(Point3 a, Point3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Point3 operator -(Point3 a, Point3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Point3 operator *(Point3 a, double s) => new(a.X * s, a.Y * s, a.Z * s);

    /// <summary>Coordinate by axis: 0 x, 1 y, 2 z.</summary>
    public double this[int axis] => axis switch { 0 => X, 1 => Y, _ => Z };

    public double Length => Math.Sqrt(Dot(this));

    public static Point3 Cross(Point3 a, Point3 b)
        => new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    /// <summary>A point whose coordinates along three axes are given in the order axis, the next, the one after.</summary>
    public static Point3 Along(int axis, double first, double second, double third) => axis switch
    {
        0 => new(first, second, third),
        1 => new(third, first, second),
        _ => new(second, third, first),
    };

    public double Dot(Point3 other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    public Vector3 ToVector() => new((float)X, (float)Y, (float)Z);
}
