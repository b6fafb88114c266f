using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>How much of a sphere is in a room.</summary>
/// <remarks>Retail: BoundingType.</remarks>
internal enum CellOverlap
{
    /// <summary>None.</summary>
    Outside = 0,

    /// <summary>It reaches through a bounding plane.</summary>
    Partly = 1,

    /// <summary>All of it.</summary>
    Inside = 2,
}

/// <summary>
/// The containment tree of a room, which is a chain: a point is in the room when it is behind none of the planes. Immutable.
/// </summary>
/// <remarks>
/// Retail: the cell trees of BSPTREE; only the positive children are followed. A leaf ends the chain (specification 04, 4.5 and 7.5).
/// </remarks>
internal sealed class CellBsp
{
    /// <summary>How much further than its radius a sphere reaches in a containment test: 0.01 m.</summary>
    internal const float Fudge = 0.01f;

    private readonly Plane[] planes;

    /// <summary>The room in front of all of <paramref name="planes"/>, which have unit normals.</summary>
    public CellBsp(params ReadOnlySpan<Plane> planes) => this.planes = planes.ToArray();

    /// <summary>The bounding planes in the order of the chain, normals inwards.</summary>
    public ReadOnlySpan<Plane> Planes => planes;

    /// <summary>Is a point, in the room's frame, inside? A point less than the tolerance behind a plane still is; NaN is not.</summary>
    /// <remarks>Retail: BSPNODE::point_inside_cell_bsp @0x0053C1F0.</remarks>
    public bool PointInside(in Vector3 point)
    {
        foreach (ref readonly Plane plane in planes.AsSpan())
        {
            if (!(RetailMath.Distance(plane, point) >= -RetailMath.Epsilon)) return false;
        }

        return true;
    }

    /// <summary>How much of a sphere, made 1 cm larger, is inside?</summary>
    /// <remarks>Retail: BSPNODE::sphere_intersects_cell_bsp @0x0053C260.</remarks>
    public CellOverlap SphereIntersects(in Sphere sphere)
    {
        double reach = (double)sphere.Radius + Fudge, stored = (float)reach;
        CellOverlap overlap = CellOverlap.Inside;
        // Retail calls itself after a straddled plane, and each call begins with the sum unrounded.
        bool unrounded = true;
        foreach (ref readonly Plane plane in planes.AsSpan())
        {
            double distance = RetailMath.Distance(plane, sphere.Center), r = unrounded ? reach : stored;
            if (distance <= -r) return CellOverlap.Outside;
            unrounded = distance < r;
            if (unrounded) overlap = CellOverlap.Partly;
        }

        return overlap;
    }

    /// <summary>Is any of a box, in the room's frame, inside as far as single planes can tell?</summary>
    /// <remarks>Retail: BSPNODE::box_intersects_cell_bsp @0x0053C880.</remarks>
    public bool BoxIntersects(in BoundingBox box)
    {
        foreach (ref readonly Plane plane in planes.AsSpan())
        {
            if (PlaneQueries.IntersectBox(plane, box) == PlaneSide.Negative) return false;
        }

        return true;
    }
}
