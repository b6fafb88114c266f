using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>A sphere as an obstacle: its answer to a transition, in the block frame of the check position.</summary>
/// <remarks>Retail: CSphere; specification 04, 4.7 and 4.8. The radius of the mover's foot serves for its head as well.</remarks>
internal static class BallObstacle
{
    /// <summary>Least share of a probe that may be left after resting on a ball; a double where a polygon's bound is a float.</summary>
    internal const double InterpFloor = -0.1;

    /// <summary>Tests an object's sphere.</summary>
    /// <param name="transition">The transition; it is moved and told what was met.</param>
    /// <param name="obstacle">The object's position.</param>
    /// <param name="scale">The object's scale.</param>
    /// <param name="sphere">The sphere in the object's frame at scale 1.</param>
    /// <param name="isCreature">The object is a creature or a missile: not a floor.</param>
    /// <remarks>Retail: CSphere::intersects_sphere @0x00537FD0.</remarks>
    internal static TransitionState IntersectsSphere(
        Transition transition, in Position obstacle, float scale, in Sphere sphere, bool isCreature)
    {
        Sphere placed = new(
            transition.Path.CheckPos.LocalToGlobal(obstacle, RetailMath.Scale(sphere.Center, scale)),
            (float)((double)scale * sphere.Radius));
        return IntersectsSphere(transition, placed, isCreature);
    }

    /// <summary>Tests a sphere given in the block frame of the check position. The order of the modes is load-bearing.</summary>
    /// <remarks>Retail: CSphere::intersects_sphere @0x00537A80.</remarks>
    internal static TransitionState IntersectsSphere(Transition transition, in Sphere obstacle, bool isCreature)
    {
        SpherePath path = transition.Path;
        ref readonly Sphere foot = ref path.GlobalSpheres[0];
        Vector3 offset = foot.Center - obstacle.Center;
        float radiusSum = (float)((double)obstacle.Radius + foot.Radius - RetailMath.Epsilon);
        bool footHits = CollisionPrimitives.SphereCollidesWithSphere(offset, radiusSum);
        bool headHits = path.SphereCount > 1 &&
                        CollisionPrimitives.SphereCollidesWithSphere(path.GlobalSpheres[1].Center - obstacle.Center, radiusSum);
        // In every mode a ball that is not touched answers OK.
        if (!footHits && !headHits) return TransitionState.OK;
        transition.Trace?.HitShape(transition, footHits ? 0 : 1, obstacle);

        if (path.ObstructionEthereal || path.InsertType == InsertType.Placement) return TransitionState.Collided;
        if (path.SteppingDown) return isCreature ? TransitionState.OK : StepSphereDown(transition, obstacle, offset, radiusSum);
        if (path.CheckingWalkable) return TransitionState.Collided;
        if (path.Collide) return isCreature ? TransitionState.OK : RestOnSphere(transition, offset, radiusSum);

        if (transition.Object.Has(MoverFlags.Contact | MoverFlags.OnWalkable))
        {
            if (footHits) return StepSphereUp(transition, obstacle, offset, radiusSum);
            return headHits ? SlideAway(transition, obstacle, 1) : TransitionState.OK;
        }

        if (transition.Object.Has(MoverFlags.PathClipped))
            return footHits ? CollideWithPoint(transition, obstacle, radiusSum, 0) : TransitionState.OK;
        if (footHits) return LandOnSphere(transition, obstacle);
        return headHits ? CollideWithPoint(transition, obstacle, radiusSum, 1) : TransitionState.OK;
    }

    /// <summary>The way back from the check position to the accepted one, in the check position's block frame.</summary>
    internal static Vector3 WayBack(SpherePath path) =>
        path.GlobalCurrCenters[0] - path.GlobalSpheres[0].Center - path.CurrToCheckBlockOffset;

    /// <summary>Pulls a landing foot back along its way until it rests on the ball.</summary>
    private static TransitionState RestOnSphere(Transition transition, Vector3 offset, float radiusSum)
    {
        SpherePath path = transition.Path;
        Sphere foot = path.GlobalSpheres[0];
        Vector3 back = WayBack(path);
        float reach = (float)((double)radiusSum + RetailMath.Epsilon);
        double a = RetailMath.LengthSquared(back), b = -RetailMath.Dot(back, offset);
        if (a < RetailMath.Epsilon) return TransitionState.Collided;

        double u = Math.Sqrt((b * b) - ((RetailMath.LengthSquared(offset) - ((double)reach * reach)) * a)) + b;
        // Compared before the division by a: retail's, and it decides.
        if (u > 1) u = (2 * b) - u;
        double t = u / a, left = (1 - t) * path.WalkInterp;
        // A ball that only the head touches may give no root; NaN is refused here.
        if (!(left < path.WalkInterp && left >= InterpFloor)) return TransitionState.Collided;

        back = RetailMath.Scale(back, t);
        Vector3 normal = RetailMath.Scale(offset + back, 1.0 / reach);
        if (!path.IsWalkableAllowable(normal.Z)) return TransitionState.OK;
        // Through the point under the centre before it is moved: off by the way back, and retail's.
        Plane plane = RetailMath.PlaneThrough(normal, RetailMath.AddScaled(foot.Center, -foot.Radius, normal));
        transition.Collision.SetContactPlane(plane, true, path.CheckPos.CellId);
        transition.Trace?.ContactTaken(transition);
        path.WalkInterp = (float)left;
        path.AddOffsetToCheckPos(back);
        return TransitionState.Adjusted;
    }

    /// <summary>Onto the ball when its top is within the step height, otherwise along it.</summary>
    /// <remarks>Retail: CSphere::step_sphere_up @0x00537900.</remarks>
    private static TransitionState StepSphereUp(Transition transition, in Sphere obstacle, in Vector3 offset, float radiusSum)
    {
        double reach = (double)radiusSum + RetailMath.Epsilon;
        if (transition.Object.StepUpHeight < reach - offset.Z)
        {
            transition.Trace?.Responded(transition, TransitionResponse.StepUp, Vector3.Zero, false, TraceReason.TooHigh);
            return SlideAround(transition, obstacle, offset, 0);
        }

        // Not made unit: a refused step slides with it as it is.
        Vector3 normal = transition.Path.GlobalCurrCenters[0] - obstacle.Center;
        return transition.StepUp(normal) ? TransitionState.OK : transition.StepUpSlide();
    }

    /// <summary>Lifts a probing foot straight up onto the ball.</summary>
    /// <remarks>Retail: CSphere::step_sphere_down @0x00536D20.</remarks>
    private static TransitionState StepSphereDown(Transition transition, in Sphere obstacle, in Vector3 offset, float radiusSum)
    {
        SpherePath path = transition.Path;
        double step = (double)path.StepDownAmount * path.WalkInterp;
        if (Math.Abs(step) < RetailMath.Epsilon) return TransitionState.Collided;

        double reachExact = (double)radiusSum + RetailMath.Epsilon;
        float stepStored = (float)step, reach = (float)reachExact;
        // One factor is stored, the other still in its register.
        double squared = (reachExact * reach) -
                         ((double)(float)((double)offset.X * offset.X) + (float)((double)offset.Y * offset.Y));
        double t = (Math.Sqrt(squared) - offset.Z) / stepStored, left = (1 - t) * path.WalkInterp;
        // A ball that only the head touches may give no root; NaN is refused here.
        if (!(left < path.WalkInterp && left >= InterpFloor)) return TransitionState.Collided;

        float lift = (float)(stepStored * t);
        double inverse = 1.0 / reach, normalZ = ((double)offset.Z + lift) * inverse;
        if (!path.IsWalkableAllowable(normalZ)) return TransitionState.OK;
        Vector3 normal = new((float)(offset.X * inverse), (float)(offset.Y * inverse), (float)normalZ);
        Plane plane = RetailMath.PlaneThrough(normal, RetailMath.AddScaled(obstacle.Center, obstacle.Radius, normal));
        transition.Collision.SetContactPlane(plane, true, path.CheckPos.CellId);
        transition.Trace?.ContactTaken(transition);
        path.WalkInterp = (float)left;
        path.AddOffsetToCheckPos(new Vector3(0, 0, lift));
        return TransitionState.Adjusted;
    }

    /// <summary>Asks for a landing on the ball.</summary>
    /// <remarks>Retail: CSphere::land_on_sphere @0x005379A0.</remarks>
    private static TransitionState LandOnSphere(Transition transition, in Sphere obstacle)
    {
        Vector3 normal = transition.Path.GlobalCurrCenters[0] - obstacle.Center;
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.Collided;
        transition.Path.SetCollide(normal);
        transition.Trace?.AsksToLand();
        transition.Path.WalkableAllowance = RetailMath.LandingZ;
        return TransitionState.Adjusted;
    }

    /// <summary>Stops a sphere; one that clips perfectly is put where it touches.</summary>
    /// <remarks>Retail: CSphere::collide_with_point @0x00537230.</remarks>
    private static TransitionState CollideWithPoint(Transition transition, in Sphere obstacle, float radiusSum, int i)
    {
        SpherePath path = transition.Path;
        Vector3 curr = path.GlobalCurrCenters[i], center = path.GlobalSpheres[i].Center, fromObstacle = curr - obstacle.Center;
        transition.Trace?.Responded(transition, TransitionResponse.Stop, fromObstacle, true);
        if (!transition.Object.Has(MoverFlags.PerfectClip))
        {
            if (!RetailMath.NormalizeCheckSmall(ref fromObstacle)) transition.Collision.SetCollisionNormal(fromObstacle);
            return TransitionState.Collided;
        }

        float reach = (float)((double)radiusSum + RetailMath.Epsilon);
        Vector3 movement = path.Displacement(center, curr);
        double t = CollisionPrimitives.TimeOfCollision(movement, fromObstacle, reach);
        if (!(t >= RetailMath.Epsilon && t <= 1)) return TransitionState.Collided;
        Vector3 offset = new(
            (float)((movement.X * t) - movement.X), (float)(movement.Y * t) - movement.Y, (float)(movement.Z * t) - movement.Z);
        double inverse = 1.0 / reach;
        transition.Collision.SetCollisionNormal(new Vector3(
            (float)(((double)offset.X + center.X - obstacle.Center.X) * inverse),
            (float)(((double)offset.Y + center.Y - obstacle.Center.Y) * inverse),
            (float)(((double)offset.Z + center.Z - obstacle.Center.Z) * inverse)));
        path.AddOffsetToCheckPos(offset);
        return TransitionState.Adjusted;
    }

    /// <summary>The head slides along the ball as along a wall.</summary>
    /// <remarks>Retail: CSphere::slide_sphere @0x00537A10.</remarks>
    private static TransitionState SlideAway(Transition transition, in Sphere obstacle, int i)
    {
        Vector3 curr = transition.Path.GlobalCurrCenters[i], normal = curr - obstacle.Center;
        return RetailMath.NormalizeCheckSmall(ref normal) ? TransitionState.Collided : transition.SlideSphere(i, ref normal, curr);
    }

    /// <summary>The foot slides around a ball that is too tall to climb.</summary>
    /// <remarks>Retail: CSphere::slide_sphere @0x00536F40.</remarks>
    private static TransitionState SlideAround(Transition transition, in Sphere obstacle, in Vector3 offset, int i)
    {
        Vector3 normal = transition.Path.GlobalCurrCenters[i] - obstacle.Center;
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.Collided;
        transition.Collision.SetCollisionNormal(normal);
        TransitionState state = SlideAlongCrease(transition, normal, offset, i);
        transition.Trace?.Responded(transition, TransitionResponse.Slide, normal, state == TransitionState.Slid, TraceReason.TooShort);
        return state;
    }

    private static TransitionState SlideAlongCrease(Transition transition, in Vector3 normal, in Vector3 offset, int i)
    {
        SpherePath path = transition.Path;
        CollisionInfo collision = transition.Collision;
        // Without a contact plane the last known one serves, valid or not.
        Vector3 floor = collision.ContactPlaneValid ? collision.ContactPlane.Normal : collision.LastKnownContactPlane.Normal;
        Vector3 crease = RetailMath.Cross(normal, floor);
        Vector3 movement = path.CurrToCheckDisplacement(i);
        double squared = RetailMath.LengthSquared(crease);
        if (squared >= RetailMath.Epsilon)
        {
            Vector3 kept = RetailMath.Scale(RetailMath.Scale(crease, RetailMath.Dot(crease, movement)), 1.0 / squared);
            if (RetailMath.LengthSquared(kept) < RetailMath.Epsilon) return TransitionState.Collided;
            path.AddOffsetToCheckPos(kept - movement);
            return TransitionState.Slid;
        }

        if (RetailMath.Dot(floor, offset) < 0) return TransitionState.Collided;
        path.AddOffsetToCheckPos(RetailMath.Scale(normal, -(float)RetailMath.Dot(normal, movement)));
        return TransitionState.Slid;
    }
}
