using System.Numerics;
using System.Runtime.CompilerServices;

namespace Surefoot.Physics.Geometry;

/// <summary>
/// A view of one convex collision polygon: a plane and its corners, counter-clockwise seen from the side the normal points to,
/// in the frame of the mesh or room that owns it (metres).
/// </summary>
/// <remarks>
/// Retail: CPolygon; specification 04, 4.4. A polygon of no area, or of fewer than three corners, has a plane of NaN: nothing
/// touches it and nothing stands on it.
/// </remarks>
internal readonly ref struct ConvexPolygon
{
    /// <summary>A view of a polygon whose plane is known.</summary>
    public ConvexPolygon(scoped in Plane plane, ReadOnlySpan<Vector3> corners)
    {
        Plane = plane;
        Corners = corners;
    }

    /// <summary>The plane; its unit normal points to the front.</summary>
    public Plane Plane { get; }

    /// <summary>The corners in order.</summary>
    public ReadOnlySpan<Vector3> Corners { get; }

    /// <summary>
    /// The plane of a polygon, which the dat files do not store: the normal is the sum of the fan's cross products, the constant is
    /// the mean over all corners, so no corner of a warped polygon need lie on it.
    /// </summary>
    /// <remarks>Retail: CPolygon::make_plane @0x005383D0. It checks nothing: without area the result is NaN.</remarks>
    public static Plane MakePlane(ReadOnlySpan<Vector3> corners)
    {
        double sumX = 0, sumY = 0;
        float sumZ = 0;
        for (int k = 1; k < corners.Length - 1; k++)
        {
            Vector3 b = corners[k] - corners[0];
            double bz = (double)corners[k].Z - corners[0].Z;
            double cx = (double)corners[k + 1].X - corners[0].X;
            double cy = (double)corners[k + 1].Y - corners[0].Y;
            double cz = (double)corners[k + 1].Z - corners[0].Z;
            sumX += (float)((b.Y * cz) - (bz * cy));
            sumY += (float)((bz * cx) - (cz * b.X));
            sumZ = (float)((cy * b.X) - (b.Y * cx) + sumZ);
        }

        double inverse = 1.0 / Math.Sqrt(((double)sumZ * sumZ) + (sumY * sumY) + (sumX * sumX));
        float stored = (float)inverse;
        Vector3 normal = new((float)(inverse * sumX), (float)(stored * sumY), (float)((double)stored * sumZ));
        double mean = 0;
        foreach (Vector3 corner in corners)
            mean = mean + ((double)normal.Z * corner.Z) + ((double)normal.Y * corner.Y) + ((double)normal.X * corner.X);
        return new Plane(normal, (float)-(mean / corners.Length));
    }

    /// <summary>
    /// Does a sphere overlap the polygon by more than the tolerance? When it reaches the plane, <paramref name="contact"/> is the foot of
    /// the perpendicular from its centre, also when the polygon itself is missed.
    /// </summary>
    /// <remarks>Retail: CPolygon::polygon_hits_sphere_slow_but_sure @0x00538A10.</remarks>
    public bool HitsSphere(in Sphere sphere, ref Vector3 contact)
    {
        double distance = RetailMath.Distance(Plane, sphere.Center);
        double reach = (double)sphere.Radius - RetailMath.Epsilon;
        if (reach < Math.Abs(distance)) return false;

        float radiusSquared = (float)((reach * reach) - (distance * distance));
        Vector3 n = Plane.Normal, c = sphere.Center;
        contact = new Vector3((float)(c.X - (distance * n.X)), (float)(c.Y - (distance * n.Y)), c.Z - (float)(distance * n.Z));
        // The two walks round differently, and the second starts with "no": a foot of the perpendicular that is on the line of an edge to
        // the last bit may be outside for the first and inside for the second, and is then missed. Retail's.
        return IsInsideEveryEdge(contact) || DiscTouches(contact, radiusSquared, false);
    }

    /// <summary>Overlap without a contact point.</summary>
    /// <remarks>Retail: CPolygon::hits_sphere @0x00539540.</remarks>
    public bool HitsSphere(in Sphere sphere)
    {
        Vector3 scratch = default;
        return HitsSphere(sphere, ref scratch);
    }

    /// <summary>
    /// Overlap that counts: the sphere moves against the normal. <paramref name="overlaps"/> tells of an overlap whatever the direction.
    /// </summary>
    /// <remarks>Retail: CPolygon::pos_hits_sphere @0x005394F0.</remarks>
    public bool IsRunInto(in Sphere sphere, in Vector3 movement, ref Vector3 contact, out bool overlaps)
    {
        overlaps = HitsSphere(sphere, ref contact);
        return overlaps && !(RetailMath.Dot(Plane.Normal, movement) >= 0);
    }

    /// <summary>Overlap with a polygon that is level enough: N·<paramref name="up"/> above <paramref name="allowance"/>.</summary>
    /// <remarks>Retail: CPolygon::walkable_hits_sphere @0x00539560.</remarks>
    public bool IsWalkableAndHit(in Sphere sphere, in Vector3 up, float allowance) =>
        RetailMath.Dot(Plane.Normal, up) > allowance && HitsSphere(sphere);

    /// <summary>
    /// Does the polygon support a foot of the sphere's radius, the centre carried along <paramref name="up"/> onto the plane? The distance
    /// along
    /// <paramref name="up"/> does not matter, and a polygon that faces down is accepted.
    /// </summary>
    /// <remarks>Retail: CPolygon::check_walkable @0x00538E60.</remarks>
    public bool SupportsFoot(in Sphere sphere, in Vector3 up) =>
        TryCarryOntoPlane(sphere.Center, up, out Vector3 point) && DiscTouches(point, (float)((double)sphere.Radius * sphere.Radius), true);

    /// <summary>The same for a foot of half the radius.</summary>
    /// <remarks>Retail: CPolygon::check_small_walkable @0x005390B0.</remarks>
    public bool SupportsSmallFoot(in Sphere sphere, in Vector3 up) =>
        TryCarryOntoPlane(sphere.Center, up, out Vector3 point) &&
        DiscTouches(point, (float)((double)sphere.Radius * sphere.Radius * 0.25), true);

    /// <summary>
    /// The first edge beyond which the sphere's centre lies, carried along <paramref name="up"/> onto the plane; <paramref name="normal"/>
    /// is that edge's unit normal in the plane and points into the polygon. Untouched when the centre is inside.
    /// </summary>
    /// <remarks>Retail: CPolygon::find_crossed_edge @0x00539300.</remarks>
    public bool FindCrossedEdge(in Sphere sphere, in Vector3 up, ref Vector3 normal)
    {
        if (Corners.IsEmpty || !TryCarryOntoPlane(sphere.Center, up, out Vector3 point)) return false;
        Vector3 previous = Corners[^1];
        foreach (Vector3 corner in Corners)
        {
            Inward(corner - previous, out double mx, out double my, out double mz);
            double side =
                (((double)point.Z - previous.Z) * mz) + (((double)point.Y - previous.Y) * my) + (((double)point.X - previous.X) * mx);
            if (side < 0)
            {
                normal = RetailMath.Normalize(new Vector3((float)mx, (float)my, (float)mz));
                return true;
            }

            previous = corner;
        }

        return false;
    }

    /// <summary>
    /// Rests the sphere on the plane: pulls it back along <paramref name="movement"/> until it is tangent and takes that share off
    /// <paramref name="walkInterp"/>. Refused when the movement does not run into the plane, when the sphere does not reach it, or when
    /// less than −0.5 of the movement would be left.
    /// </summary>
    /// <remarks>
    /// Retail: CPolygon::adjust_sphere_to_plane @0x00538210. The interpolation may already be negative; then the accepted range is the
    /// other one, and the formulas stay as they are.
    /// </remarks>
    public bool AdjustSphereToPlane(ref Sphere sphere, in Vector3 movement, ref float walkInterp)
    {
        Vector3 c = sphere.Center;
        double distance = RetailMath.Distance(Plane, c), along = RetailMath.Dot(Plane.Normal, movement), numerator;
        if (along <= RetailMath.Epsilon)
        {
            if (along >= -RetailMath.Epsilon) return false;
            numerator = distance - sphere.Radius;
        }
        else
        {
            numerator = -sphere.Radius - distance;
        }

        double t = numerator / along;
        double left = (1.0 - t) * walkInterp;
        // Phrased so that NaN (a scale of 0) is refused.
        if (!(left < walkInterp && (float)left >= -0.5f)) return false;
        sphere.Center = new Vector3(
            (float)(c.X - (t * movement.X)), c.Y - (float)(t * movement.Y), c.Z - (float)(t * movement.Z));
        walkInterp = (float)left;
        return true;
    }

    /// <summary>
    /// The share of <paramref name="movement"/> after which a sphere starting at <paramref name="curr"/> touches the plane: exactly 1 when
    /// it overlaps the plane already, 0 when it moves along it, otherwise unclamped.
    /// </summary>
    /// <remarks>Retail: CPolygon::adjust_sphere_to_poly @0x00538170.</remarks>
    public double TimeOfTouch(float radius, in Vector3 curr, in Vector3 movement)
    {
        float distance = (float)RetailMath.Distance(Plane, curr);
        if (radius > Math.Abs(distance)) return 1.0;
        double along = RetailMath.Dot(Plane.Normal, movement);
        if (Math.Abs(along) < RetailMath.Epsilon) return 0.0;
        return ((distance <= 0 ? -(double)radius : radius) - distance) / along;
    }

    /// <summary>Pushes a sphere, and <paramref name="other"/> with it, along the normal out of what the polygon bounds.</summary>
    /// <param name="sphere">The sphere that overlaps.</param>
    /// <param name="other">The body's other sphere; moved as well.</param>
    /// <param name="radius">How far from the plane the centre shall end, metres.</param>
    /// <param name="centerSolid">The centre was found inside matter.</param>
    /// <param name="solidCheck">
    /// Centres inside matter count. The two reversals below are independent: both together push to the front.
    /// </param>
    /// <remarks>Retail: CPolygon::adjust_to_placement_poly @0x00538CE0.</remarks>
    public void PushOut(ref Sphere sphere, ref Sphere other, float radius, bool centerSolid, bool solidCheck)
    {
        double distance = RetailMath.Distance(Plane, sphere.Center), push = radius;
        if (solidCheck)
        {
            if (centerSolid) push = -push;
            if (distance <= 0) push = -push;
        }

        push -= distance;
        Vector3 n = Plane.Normal;
        double x = push * n.X;
        float y = (float)(push * n.Y), z = (float)(push * n.Z);
        sphere.Center = new Vector3((float)(sphere.Center.X + x), sphere.Center.Y + y, sphere.Center.Z + z);
        other.Center = new Vector3((float)(other.Center.X + x), other.Center.Y + y, other.Center.Z + z);
    }

    /// <summary>
    /// Does a disc around a point of the plane touch the polygon? One walk over the edges: outside an edge by more than the radius ends it,
    /// nearest inside an edge ends it, otherwise the corners decide.
    /// </summary>
    private bool DiscTouches(in Vector3 point, float radiusSquared, bool start)
    {
        bool touches = start;
        if (Corners.IsEmpty) return touches;
        Vector3 n = Plane.Normal, previous = Corners[^1];
        foreach (Vector3 corner in Corners)
        {
            // z differences take part unrounded where retail had them in a register, rounded elsewhere.
            Vector3 edge = corner - previous, w = point - previous;
            double edgeZ = (double)corner.Z - previous.Z, wZ = (double)point.Z - previous.Z;
            double mx = (n.Y * edgeZ) - ((double)n.Z * edge.Y);
            double my = ((double)n.Z * edge.X) - ((double)n.X * edge.Z);
            double mz = ((double)n.X * edge.Y) - ((double)n.Y * edge.X);
            double side = (wZ * mz) + (w.Y * my) + (w.X * mx);
            if (side < 0)
            {
                if (((mx * mx) + (my * my) + (mz * mz)) * radiusSquared < side * side) return false;
                double along = RetailMath.Dot(w, edge);
                if (along >= 0 && along <= RetailMath.LengthSquared(edge)) return true;
                touches = false;
            }

            if (RetailMath.LengthSquared(w) <= radiusSquared) return true;
            previous = corner;
        }

        return touches;
    }

    private bool IsInsideEveryEdge(in Vector3 point)
    {
        if (Corners.IsEmpty) return true;
        Vector3 n = Plane.Normal, previous = Corners[^1];
        foreach (Vector3 corner in Corners)
        {
            double ex = (double)corner.X - previous.X, ey = (double)corner.Y - previous.Y, ez = (double)corner.Z - previous.Z;
            float mx = (float)((n.Y * ez) - (n.Z * ey)), my = (float)((n.Z * ex) - (n.X * ez));
            double mz = (n.X * ey) - (n.Y * ex);
            double side =
                (((double)point.Z - previous.Z) * mz) + (((double)point.Y - previous.Y) * my) + (((double)point.X - previous.X) * mx);
            if (!(side >= 0)) return false;
            previous = corner;
        }

        return true;
    }

    /// <summary>N × edge: in the plane, pointing inside, not unit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Inward(in Vector3 edge, out double x, out double y, out double z)
    {
        Vector3 n = Plane.Normal;
        x = ((double)n.Y * edge.Z) - ((double)n.Z * edge.Y);
        y = ((double)n.Z * edge.X) - ((double)n.X * edge.Z);
        z = ((double)n.X * edge.Y) - ((double)n.Y * edge.X);
    }

    private bool TryCarryOntoPlane(in Vector3 center, in Vector3 up, out Vector3 point)
    {
        double lean = RetailMath.Dot(Plane.Normal, up);
        if (Math.Abs(lean) < RetailMath.Epsilon)
        {
            point = default;
            return false;
        }

        double t = RetailMath.Distance(Plane, center) / lean;
        point = new Vector3((float)(center.X - (t * up.X)), center.Y - (float)(t * up.Y), center.Z - (float)(t * up.Z));
        return true;
    }
}
