using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>An axis-aligned box, metres.</summary>
/// <remarks>Retail: BBox.</remarks>
internal struct BoundingBox : IEquatable<BoundingBox>
{
    /// <summary>A box between two corners.</summary>
    public BoundingBox(Vector3 min, Vector3 max)
    {
        Min = min;
        Max = max;
    }

    /// <summary>The box of nothing: its minimum is above its maximum, so that the first point included becomes both.</summary>
    /// <remarks>Retail: BBox::InitForAdjustment @0x005B1DF0.</remarks>
    public static BoundingBox Empty => new(new Vector3(float.MaxValue), new Vector3(-float.MaxValue));

    /// <summary>Corner with the smallest coordinates.</summary>
    public Vector3 Min;

    /// <summary>Corner with the largest coordinates.</summary>
    public Vector3 Max;

    /// <summary>True while no point was included; such a box has no place in the world.</summary>
    public readonly bool IsEmpty => Min.X > Max.X || Min.Y > Max.Y || Min.Z > Max.Z;

    /// <summary>Box of all points; empty without points.</summary>
    /// <remarks>Retail: CVertexArray::BuildBoundingBox @0x0053BF10.</remarks>
    public static BoundingBox Of(ReadOnlySpan<Vector3> points)
    {
        BoundingBox box = Empty;
        foreach (Vector3 point in points) box.Include(point);
        return box;
    }

    /// <summary>Widens the box to a point; a NaN coordinate widens nothing.</summary>
    /// <remarks>Retail: BBox::AdjustBBox @0x00534150.</remarks>
    public void Include(in Vector3 point)
    {
        if (point.X < Min.X) Min.X = point.X;
        if (point.X > Max.X) Max.X = point.X;
        if (point.Y < Min.Y) Min.Y = point.Y;
        if (point.Y > Max.Y) Max.Y = point.Y;
        if (point.Z < Min.Z) Min.Z = point.Z;
        if (point.Z > Max.Z) Max.Z = point.Z;
    }

    /// <summary>
    /// One of the eight corners: bit 0 of <paramref name="index"/> takes the larger x, bit 1 y, bit 2 z; 0 is <see cref="Min"/>.
    /// </summary>
    public readonly Vector3 Corner(int index) => new(
        (index & 1) == 0 ? Min.X : Max.X, (index & 2) == 0 ? Min.Y : Max.Y, (index & 4) == 0 ? Min.Z : Max.Z);

    /// <inheritdoc/>
    public readonly bool Equals(BoundingBox other) => Min == other.Min && Max == other.Max;

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is BoundingBox other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode() => HashCode.Combine(Min, Max);

    /// <summary>Same corners.</summary>
    public static bool operator ==(BoundingBox left, BoundingBox right) => left.Equals(right);

    /// <summary>Other corners.</summary>
    public static bool operator !=(BoundingBox left, BoundingBox right) => !left.Equals(right);

    /// <inheritdoc/>
    public override readonly string ToString() => $"[{Min} {Max}]";
}
