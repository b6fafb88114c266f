using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>On which side of a plane something lies.</summary>
/// <remarks>Retail: Sidedness.</remarks>
internal enum PlaneSide
{
    /// <summary>In front: the side the normal points to.</summary>
    Positive = 0,

    /// <summary>Behind.</summary>
    Negative = 1,

    /// <summary>A point within the tolerance of the plane.</summary>
    InPlane = 2,

    /// <summary>A body with points on more than one side, or in the plane.</summary>
    Crossing = 3,
}

/// <summary>Questions about planes with unit normals, in retail's arithmetic.</summary>
internal static class PlaneQueries
{
    /// <summary>Side of a point; <paramref name="tolerance"/> (metres) on either side counts as in the plane.</summary>
    /// <remarks>Retail: Plane::which_side @0x00444720.</remarks>
    public static PlaneSide WhichSide(in Plane plane, in Vector3 point, float tolerance)
    {
        double distance = RetailMath.Distance(plane, point);
        if (distance > tolerance) return PlaneSide.Positive;
        return distance >= -tolerance ? PlaneSide.InPlane : PlaneSide.Negative;
    }

    /// <summary>Side of a box: crossing unless all eight corners are clearly on the same side.</summary>
    /// <remarks>Retail: Plane::intersect_box @0x005AA170.</remarks>
    public static PlaneSide IntersectBox(in Plane plane, in BoundingBox box)
    {
        PlaneSide side = WhichSide(plane, box.Min, RetailMath.Epsilon);
        if (side == PlaneSide.InPlane) return PlaneSide.Crossing;
        for (int i = 1; i < 8; i++)
        {
            if (WhichSide(plane, box.Corner(i), RetailMath.Epsilon) != side) return PlaneSide.Crossing;
        }

        return side;
    }

    /// <summary>Puts a point onto the plane by changing its z; false, unchanged, for a vertical plane.</summary>
    /// <remarks>Retail: Plane::set_height @0x0052F050.</remarks>
    public static bool SetHeight(in Plane plane, ref Vector3 point)
    {
        Vector3 n = plane.Normal;
        if (Math.Abs(n.Z) <= RetailMath.Epsilon) return false;
        point.Z = (float)-((((double)n.Y * point.Y) + ((double)n.X * point.X) + plane.D) / n.Z);
        return true;
    }
}
