using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>The collision polygons of one mesh or room, flat: a plane and a run of corners for each.</summary>
public sealed class PolygonSet
{
    private readonly Plane[] planes;
    private readonly int[] firstCorner;
    private readonly Vector3[] corners;

    /// <summary>Polygon i has the corners <c>firstCorner[i] .. firstCorner[i + 1]</c>.</summary>
    internal PolygonSet(Plane[] planes, int[] firstCorner, Vector3[] corners)
    {
        this.planes = planes;
        this.firstCorner = firstCorner;
        this.corners = corners;
    }

    /// <summary>Number of polygons.</summary>
    public int Count => planes.Length;

    /// <summary>Plane of a polygon: the side its normal points to is the front.</summary>
    public ref readonly Plane PlaneOf(int polygon) => ref planes[polygon];

    /// <summary>Corners of a polygon, in order.</summary>
    public ReadOnlySpan<Vector3> CornersOf(int polygon) => corners.AsSpan(firstCorner[polygon], firstCorner[polygon + 1] - firstCorner[polygon]);
}

/// <summary>One polygon of a set; the default value is no polygon.</summary>
/// <param name="Set">The set, null for no polygon.</param>
/// <param name="Index">Index inside the set.</param>
public readonly record struct PolygonRef(PolygonSet? Set, int Index)
{
    /// <summary>True for no polygon.</summary>
    public bool IsNone => Set is null;

    /// <summary>Is a sphere carried along <paramref name="up"/> onto the plane supported by the polygon? All in the polygon's frame.</summary>
    /// <remarks>Retail: CPolygon::check_walkable @0x00538E60.</remarks>
    public bool CheckWalkable(in Sphere sphere, in Vector3 up)
    {
        if (!TryCarryOntoPlane(sphere.Center, up, out Vector3 p)) return false;
        Vector3 normal = Set!.PlaneOf(Index).Normal;
        ReadOnlySpan<Vector3> corners = Set.CornersOf(Index);
        double radiusSquared = (double)sphere.Radius * sphere.Radius;
        bool inside = true;
        Vector3 previous = corners[^1];
        foreach (Vector3 corner in corners)
        {
            Vector3 edge = corner - previous, w = p - previous, inward = RetailMath.Cross(normal, edge);
            double side = RetailMath.Dot(w, inward);
            if (side < 0)
            {
                if (RetailMath.LengthSquared(inward) * radiusSquared < side * side) return false;
                double along = RetailMath.Dot(w, edge);
                if (along >= 0 && along <= RetailMath.LengthSquared(edge)) return true;
                inside = false;
            }

            if (RetailMath.LengthSquared(w) <= radiusSquared) return true;
            previous = corner;
        }

        return inside;
    }

    /// <summary>
    /// The first edge beyond which the sphere's centre, carried along <paramref name="up"/> onto the plane, lies;
    /// <paramref name="normal"/> is the edge's unit normal in the plane, pointing inside.
    /// </summary>
    /// <remarks>Retail: CPolygon::find_crossed_edge @0x00539300.</remarks>
    public bool FindCrossedEdge(in Sphere sphere, in Vector3 up, out Vector3 normal)
    {
        normal = default;
        if (!TryCarryOntoPlane(sphere.Center, up, out Vector3 p)) return false;
        Vector3 planeNormal = Set!.PlaneOf(Index).Normal;
        ReadOnlySpan<Vector3> corners = Set.CornersOf(Index);
        Vector3 previous = corners[^1];
        foreach (Vector3 corner in corners)
        {
            Vector3 inward = RetailMath.Cross(planeNormal, corner - previous);
            if (RetailMath.Dot(p - previous, inward) < 0)
            {
                normal = RetailMath.Normalize(inward);
                return true;
            }

            previous = corner;
        }

        return false;
    }

    private bool TryCarryOntoPlane(in Vector3 center, in Vector3 up, out Vector3 onPlane)
    {
        ref readonly Plane plane = ref Set!.PlaneOf(Index);
        double u = RetailMath.Dot(plane.Normal, up);
        onPlane = default;
        if (Math.Abs(u) < RetailMath.Epsilon) return false;
        onPlane = RetailMath.AddScaled(center, -(RetailMath.Distance(plane, center) / u), up);
        return true;
    }
}
