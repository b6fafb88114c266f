using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>A way out of a room: the plane of its portal, and what is behind it.</summary>
/// <param name="Plane">Plane of the portal's polygon in the room's frame.</param>
/// <param name="NormalPointsOut">The polygon's normal points out of the room (retail: portal_side 1).</param>
/// <param name="OtherCellId">Full id of the cell behind it; <see cref="Outdoors"/> where it opens to the outdoors.</param>
/// <param name="OtherPortal">Index into the other cell's portals; negative for none.</param>
/// <remarks>
/// Retail: CCellPortal. The polygon itself takes no part in movement: a sphere anywhere along the plane of a portal to the outdoors, inside
/// the room, brings in the outdoors.
/// </remarks>
internal readonly record struct PortalPlane(Plane Plane, bool NormalPointsOut, uint OtherCellId, short OtherPortal)
{
    /// <summary>What <see cref="OtherCellId"/> is where a portal opens to the outdoors.</summary>
    public const uint Outdoors = 0xFFFFFFFF;

    /// <summary>Opens to the outdoors.</summary>
    public bool IsExit => OtherCellId == Outdoors;

    /// <summary>Does a sphere touch the plane, from either side?</summary>
    /// <param name="x">Centre in the room's frame.</param>
    /// <param name="y">Centre in the room's frame.</param>
    /// <param name="z">Centre in the room's frame, unrounded as in retail.</param>
    /// <param name="radius">Radius, metres.</param>
    internal bool Touches(float x, float y, double z, float radius)
    {
        float reach = (float)((double)radius + RetailMath.Epsilon);
        double distance = ((double)Plane.Normal.Y * y) + (Plane.Normal.Z * z) + ((double)Plane.Normal.X * x) + Plane.D;
        return -reach < distance && distance < reach;
    }

    /// <summary>Does a sphere, in the room's frame, reach the way out?</summary>
    internal bool IsReachedBy(in Vector3 center, float radius)
    {
        double reach = (double)radius + RetailMath.Epsilon, distance = RetailMath.Distance(Plane, center);
        return NormalPointsOut ? distance > -reach : distance < reach;
    }

    /// <summary>The side of the plane on which the room is.</summary>
    internal PlaneSide Side => NormalPointsOut ? PlaneSide.Negative : PlaneSide.Positive;
}
