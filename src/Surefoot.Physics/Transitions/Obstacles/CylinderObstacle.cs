using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>An upright cylinder as an obstacle: its answer to a transition, in the block frame of the check position.</summary>
/// <remarks>
/// Retail: CCylSphere; specification 04, 4.9. The radius of the mover's foot serves for its head as well, except for the height.
/// </remarks>
internal static class CylinderObstacle
{
    /// <summary>Tests an object's cylinder. The object's turn moves the cylinder's foot but does not tilt the cylinder.</summary>
    /// <param name="transition">The transition; it is moved and told what was met.</param>
    /// <param name="obstacle">The object's position.</param>
    /// <param name="scale">The object's scale.</param>
    /// <param name="cylinder">The cylinder in the object's frame at scale 1.</param>
    /// <remarks>Retail: CCylSphere::intersects_sphere @0x0053B8F0.</remarks>
    internal static TransitionState IntersectsSphere(Transition transition, in Position obstacle, float scale, in CylSphere cylinder)
    {
        SpherePath path = transition.Path;
        CylSphere placed = new(
            path.CheckPos.LocalToGlobal(obstacle, RetailMath.Scale(cylinder.LowPoint, scale)),
            (float)((double)scale * cylinder.Radius),
            (float)((double)scale * cylinder.Height));
        return IntersectsSphere(transition, placed, obstacle);
    }

    /// <summary>
    /// Tests a cylinder given in the block frame of the check position; <paramref name="obstacle"/> is its object. The order of the modes
    /// is load-bearing.
    /// </summary>
    /// <remarks>Retail: CCylSphere::intersects_sphere @0x0053B440.</remarks>
    private static TransitionState IntersectsSphere(Transition transition, in CylSphere cylinder, in Position obstacle)
    {
        SpherePath path = transition.Path;
        ref readonly Sphere foot = ref path.GlobalSpheres[0];
        Vector3 offset = foot.Center - cylinder.LowPoint, headOffset = path.GlobalSpheres[1].Center - cylinder.LowPoint;
        float radiusSum = (float)((double)cylinder.Radius - RetailMath.Epsilon + foot.Radius);
        bool footHits = CollisionPrimitives.CylinderCollidesWithSphere(foot.Radius, offset, radiusSum, cylinder.Height);
        bool headHits = path.SphereCount > 1 &&
                        CollisionPrimitives.CylinderCollidesWithSphere(path.GlobalSpheres[1].Radius, headOffset, radiusSum,
                            cylinder.Height);
        // In every mode a cylinder that is not touched answers OK.
        if (!footHits && !headHits) return TransitionState.OK;
        // Retail does this before it looks; only the turned normal of a step-up reads it.
        path.CacheLocalSpaceSpheres(obstacle, 1f);
        transition.Trace?.HitShape(transition, footHits ? 0 : 1, 0);

        if (path.InsertType == InsertType.Placement || path.ObstructionEthereal) return TransitionState.Collided;
        if (path.SteppingDown) return StepSphereDown(transition, cylinder, offset);
        if (path.CheckingWalkable) return TransitionState.Collided;
        if (path.Collide) return RestOnTop(transition, cylinder, offset, radiusSum);

        if (transition.Object.Has(MoverFlags.Contact | MoverFlags.OnWalkable))
        {
            if (footHits) return StepSphereUp(transition, cylinder, offset, radiusSum);
            return headHits ? SlideSphere(transition, cylinder, headOffset, radiusSum, 1) : TransitionState.OK;
        }

        if (transition.Object.Has(MoverFlags.PathClipped))
            return footHits ? CollideWithPoint(transition, cylinder, offset, radiusSum, 0) : TransitionState.OK;
        if (footHits) return LandOnCylinder(transition, cylinder, offset, radiusSum);
        return headHits ? CollideWithPoint(transition, cylinder, headOffset, radiusSum, 1) : TransitionState.OK;
    }

    /// <summary>
    /// The normal of the surface met: horizontal, not unit, when the sphere was outside the radius before; otherwise up or down.
    /// </summary>
    /// <param name="path">The path.</param>
    /// <param name="cylinder">The cylinder.</param>
    /// <param name="offset">From the cylinder's low point to the sphere's centre now.</param>
    /// <param name="radiusSum">Radii together, less the tolerance.</param>
    /// <param name="i">Which sphere.</param>
    /// <param name="normal">The normal.</param>
    /// <returns>False when the sphere came from outside the radius and from above or below: it may meet the end first.</returns>
    /// <remarks>Retail: CCylSphere::normal_of_collision @0x0053AB50.</remarks>
    internal static bool NormalOfCollision(
        SpherePath path, in CylSphere cylinder, in Vector3 offset, float radiusSum, int i, out Vector3 normal)
    {
        Vector3 curr = path.GlobalCurrCenters[i], low = cylinder.LowPoint;
        double x = (double)curr.X - low.X, y = (double)curr.Y - low.Y, z = (double)curr.Z - low.Z;
        if ((double)radiusSum * radiusSum < (x * x) + (y * y))
        {
            normal = new Vector3((float)x, (float)y, 0);
            return CollisionPrimitives.IsLevelWith(path.GlobalSpheres[i].Radius, z, cylinder.Height) ||
                   Math.Abs(z - offset.Z) <= RetailMath.Epsilon;
        }

        normal = new Vector3(0, 0, offset.Z - z <= 0 ? 1 : -1);
        return true;
    }

    /// <summary>Pulls a landing foot back along its way until it rests on the top.</summary>
    private static TransitionState RestOnTop(Transition transition, in CylSphere cylinder, in Vector3 offset, float radiusSum)
    {
        SpherePath path = transition.Path;
        Sphere foot = path.GlobalSpheres[0];
        Vector3 back = BallObstacle.WayBack(path);
        if (Math.Abs(back.Z) < RetailMath.Epsilon) return TransitionState.Collided;

        double t = ((double)cylinder.Height + foot.Radius - offset.Z) / back.Z;
        Vector3 move = RetailMath.Scale(back, (float)t);
        double x = (double)move.X + offset.X, y = (double)move.Y + offset.Y;
        if ((double)radiusSum * radiusSum < (y * y) + (x * x)) return TransitionState.OK;
        double left = (1 - t) * path.WalkInterp;
        if (!(left < path.WalkInterp && left >= BallObstacle.InterpFloor)) return TransitionState.Collided;

        Vector3 low = foot.Center + move;
        low.Z -= foot.Radius;
        transition.Collision.SetContactPlane(RetailMath.PlaneThrough(Vector3.UnitZ, low), true, path.CheckPos.CellId);
        transition.Trace?.ContactTaken(transition);
        path.WalkInterp = (float)left;
        path.AddOffsetToCheckPos(move);
        return TransitionState.Adjusted;
    }

    /// <summary>Onto the top when it is within the step height, otherwise along the side.</summary>
    /// <remarks>Retail: CCylSphere::step_sphere_up @0x0053B310.</remarks>
    private static TransitionState StepSphereUp(Transition transition, in CylSphere cylinder, in Vector3 offset, float radiusSum)
    {
        SpherePath path = transition.Path;
        if (transition.Object.StepUpHeight < (double)path.GlobalSpheres[0].Radius + cylinder.Height - offset.Z)
        {
            transition.Trace?.Responded(transition, TransitionResponse.StepUp, Vector3.Zero, false, TraceReason.TooHigh);
            return SlideSphere(transition, cylinder, offset, radiusSum, 0);
        }

        NormalOfCollision(path, cylinder, offset, radiusSum, 0, out Vector3 normal);
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.Collided;
        // Global already, and turned with the object all the same: retail's.
        normal = path.LocalSpacePos.Frame.LocalToGlobalVector(normal);
        return transition.StepUp(normal) ? TransitionState.OK : transition.StepUpSlide();
    }

    /// <summary>Lifts a probing foot straight up onto the top.</summary>
    /// <remarks>Retail: CCylSphere::step_sphere_down @0x0053A9B0.</remarks>
    private static TransitionState StepSphereDown(Transition transition, in CylSphere cylinder, in Vector3 offset)
    {
        SpherePath path = transition.Path;
        Sphere foot = path.GlobalSpheres[0];
        double step = (double)path.StepDownAmount * path.WalkInterp;
        if (Math.Abs(step) < RetailMath.Epsilon) return TransitionState.Collided;

        double exact = (double)cylinder.Height + foot.Radius - offset.Z, left = (1 - (exact / step)) * path.WalkInterp;
        if (!(left < path.WalkInterp && left >= BallObstacle.InterpFloor)) return TransitionState.Collided;

        float lift = (float)exact;
        Vector3 low = new(foot.Center.X, foot.Center.Y, (float)((double)lift - foot.Radius + foot.Center.Z));
        transition.Collision.SetContactPlane(RetailMath.PlaneThrough(Vector3.UnitZ, low), true, path.CheckPos.CellId);
        transition.Trace?.ContactTaken(transition);
        path.WalkInterp = (float)left;
        path.AddOffsetToCheckPos(new Vector3(0, 0, lift));
        return TransitionState.Adjusted;
    }

    /// <summary>Asks for a landing on the cylinder.</summary>
    /// <remarks>Retail: CCylSphere::land_on_cylinder @0x0053B3D0.</remarks>
    private static TransitionState LandOnCylinder(Transition transition, in CylSphere cylinder, in Vector3 offset, float radiusSum)
    {
        SpherePath path = transition.Path;
        NormalOfCollision(path, cylinder, offset, radiusSum, 0, out Vector3 normal);
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.Collided;
        path.SetCollide(normal);
        transition.Trace?.AsksToLand();
        path.WalkableAllowance = RetailMath.LandingZ;
        return TransitionState.Adjusted;
    }

    /// <summary>Along the side, or off the end.</summary>
    /// <remarks>Retail: CCylSphere::slide_sphere @0x0053B2A0.</remarks>
    private static TransitionState SlideSphere(Transition transition, in CylSphere cylinder, in Vector3 offset, float radiusSum, int i)
    {
        NormalOfCollision(transition.Path, cylinder, offset, radiusSum, i, out Vector3 normal);
        return RetailMath.NormalizeCheckSmall(ref normal)
            ? TransitionState.Collided
            : transition.SlideSphere(i, ref normal, transition.Path.GlobalCurrCenters[i]);
    }

    /// <summary>Stops a sphere; one that clips perfectly is put where it touches the side or an end.</summary>
    /// <remarks>Retail: CCylSphere::collide_with_point @0x0053ACB0.</remarks>
    private static TransitionState CollideWithPoint(
        Transition transition, in CylSphere cylinder, in Vector3 offset, float radiusSum, int i)
    {
        SpherePath path = transition.Path;
        bool definite = NormalOfCollision(path, cylinder, offset, radiusSum, i, out Vector3 normal);
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.Collided;
        transition.Trace?.Responded(transition, TransitionResponse.Stop, normal, true);
        if (!transition.Object.Has(MoverFlags.PerfectClip))
        {
            transition.Collision.SetCollisionNormal(normal);
            return TransitionState.Collided;
        }

        // Sphere 0's accepted centre, also when sphere 1 met the cylinder; and its block frame is taken for the check position's. Both are
        // retail's.
        Sphere moving = path.GlobalSpheres[i];
        Vector3 curr = path.GlobalCurrCenters[0];
        Clip clip = new(path.Displacement(moving.Center, curr), curr - cylinder.LowPoint, (float)((double)radiusSum + RetailMath.Epsilon));
        double t;
        Vector3 way;
        if (definite && normal.Z != 0)
        {
            if (Math.Abs(clip.Movement.Z) < RetailMath.Epsilon) return TransitionState.Collided;
            t = clip.TimeOfEnd(moving.Radius, cylinder.Height);
            way = RetailMath.Scale(clip.Movement, (float)t);
        }
        else if (definite)
        {
            if (!(clip.Discriminant(clip.ReachSquared) >= 0 && clip.FlatSquared >= RetailMath.Epsilon)) return TransitionState.Collided;
            t = clip.TimeOfSide(clip.ReachSquared);
            way = RetailMath.Scale(clip.Movement, (float)t);
            normal = clip.SideNormal(curr, way, cylinder.LowPoint);
        }
        else
        {
            if (Math.Abs(clip.Movement.Z) < RetailMath.Epsilon) return TransitionState.Collided;
            t = clip.TimeOfEnd(moving.Radius, cylinder.Height);
            normal = new Vector3(0, 0, clip.Movement.Z > 0 ? -1 : 1);
            way = RetailMath.Scale(clip.Movement, t);
            double x = (double)way.X + clip.Offset.X, y = (double)way.Y + clip.Offset.Y;
            // Here the square is stored; for the side alone, above, it is not.
            float reachSquared = (float)clip.ReachSquared;
            if ((x * x) + (y * y) >= reachSquared)
            {
                // The end is passed by: the side is met, or with no root the end's time serves with the side's normal.
                if (clip.FlatSquared < RetailMath.Epsilon) return TransitionState.Collided;
                if (clip.Discriminant(reachSquared) >= 0 && clip.FlatSquared > RetailMath.Epsilon)
                {
                    t = clip.TimeOfSide(reachSquared);
                    way = RetailMath.Scale(clip.Movement, (float)t);
                }

                normal = clip.SideNormal(curr, way, cylinder.LowPoint);
            }
        }

        if (!(t >= 0 && t <= 1)) return TransitionState.Collided;
        transition.Collision.SetCollisionNormal(normal);
        path.AddOffsetToCheckPos(curr + way - moving.Center);
        return TransitionState.Adjusted;
    }

    /// <summary>The algebra of a moving sphere and an upright cylinder.</summary>
    /// <param name="Movement">Displacement of the sphere.</param>
    /// <param name="Offset">From the cylinder's low point to where the sphere begins.</param>
    /// <param name="Reach">Radii together.</param>
    private readonly record struct Clip(Vector3 Movement, Vector3 Offset, float Reach)
    {
        /// <summary>Squared horizontal length of the movement.</summary>
        public double FlatSquared => ((double)Movement.X * Movement.X) + ((double)Movement.Y * Movement.Y);

        public double ReachSquared => (double)Reach * Reach;

        public double Discriminant(double reachSquared)
        {
            double outside = ((double)Offset.X * Offset.X) + ((double)Offset.Y * Offset.Y) - reachSquared;
            return (Approach * Approach) - (outside * FlatSquared);
        }

        /// <summary>Share of the movement at which the side is met.</summary>
        public double TimeOfSide(double reachSquared)
        {
            double root = Math.Sqrt(Discriminant(reachSquared));
            return (Approach - root < 0 ? root + Approach : Approach - root) / FlatSquared;
        }

        private double Approach => -(((double)Movement.X * Offset.X) + ((double)Movement.Y * Offset.Y));

        /// <summary>Share of the movement at which the nearer end is met: the bottom when moving up, the top when moving down.</summary>
        public double TimeOfEnd(float radius, float height) => Movement.Z > 0
            ? -(((double)Offset.Z + radius) / Movement.Z)
            : ((double)radius + height - Offset.Z) / Movement.Z;

        /// <summary>Horizontal normal where the sphere then is.</summary>
        public Vector3 SideNormal(in Vector3 curr, in Vector3 way, in Vector3 low)
        {
            Vector3 normal = RetailMath.Scale(curr + way - low, 1.0 / Reach);
            normal.Z = 0;
            return normal;
        }
    }
}
