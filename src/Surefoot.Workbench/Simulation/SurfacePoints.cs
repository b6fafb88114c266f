using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Workbench.Simulation;

/// <summary>Points on surfaces.</summary>
internal static class SurfacePoints
{
    /// <summary>The point of a convex polygon that is nearest to a point.</summary>
    /// <param name="polygon">Three corners or more.</param>
    /// <param name="point">In the polygon's frame.</param>
    public static Vector3 Nearest(in ConvexPolygon polygon, Vector3 point)
    {
        ReadOnlySpan<Vector3> corners = polygon.Corners;
        Vector3 onPlane = point - (polygon.Plane.Normal * (float)RetailMath.Distance(polygon.Plane, point));
        Vector3 nearest = onPlane;
        float least = float.PositiveInfinity;
        bool inside = true;
        for (int i = 0; i < corners.Length; i++)
        {
            Vector3 from = corners[i], edge = corners[(i + 1) % corners.Length] - from;
            if (Vector3.Dot(Vector3.Cross(edge, onPlane - from), polygon.Plane.Normal) < 0) inside = false;
            float length = edge.LengthSquared();
            Vector3 on = length > 0 ? from + (edge * Math.Clamp(Vector3.Dot(point - from, edge) / length, 0f, 1f)) : from;
            float distance = Vector3.DistanceSquared(on, point);
            if (distance >= least) continue;
            least = distance;
            nearest = on;
        }

        return inside ? onPlane : nearest;
    }
}
