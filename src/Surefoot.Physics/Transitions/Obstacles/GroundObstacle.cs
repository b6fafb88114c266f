using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>The ground as an obstacle: what it answers to a foot, and to the camera.</summary>
internal static class GroundObstacle
{
    /// <summary>Lowest value of the step-down interpolation that is still footing.</summary>
    private const float InterpFloor = -0.1f;

    /// <summary>
    /// The terrain's answer to sphere 0: the lowest point of the sphere is tested against the plane, both in the block frame of
    /// <paramref name="cellId"/>; the check position is lifted out of the ground directly.
    /// </summary>
    /// <param name="transition">The transition whose check position is tested.</param>
    /// <param name="sphere">Sphere 0 at the check position.</param>
    /// <param name="plane">Plane of the terrain triangle.</param>
    /// <param name="isWater">The cell is water.</param>
    /// <param name="waterDepth">How deep a body sinks in here, metres.</param>
    /// <param name="cellId">Cell whose block frame the sphere and the plane are in.</param>
    /// <remarks>Retail: OBJECTINFO::validate_walkable @0x0050D010.</remarks>
    internal static TransitionState ValidateWalkable(
        this Transition transition, in Sphere sphere, in Plane plane, bool isWater, float waterDepth, uint cellId)
    {
        SpherePath path = transition.Path;
        CollisionInfo collision = transition.Collision;
        ObjectInfo mover = transition.Object;
        if (mover.Has(MoverFlags.IsViewer)) return ValidateViewer(transition, sphere, plane, cellId);

        Vector3 low = sphere.Center;
        double distance = ((double)plane.Normal.X * low.X) + ((double)plane.Normal.Y * low.Y) +
                          (plane.Normal.Z * ((double)low.Z - sphere.Radius)) + plane.D + waterDepth;
        if (distance > RetailMath.Epsilon) return TransitionState.OK;

        bool mayStand = path.SteppingDown || !mover.Has(MoverFlags.OnWalkable) || ObjectInfo.IsValidWalkable(plane.Normal);
        transition.Trace?.HitGround(transition, plane, cellId, distance, mayStand ? TraceReason.None : TraceReason.TooSteep);
        TransitionState state = TransitionState.OK;
        if (distance >= -RetailMath.Epsilon)
        {
            if (mayStand) TakeContact(transition, plane, isWater, cellId);
        }
        else
        {
            if (path.CheckingWalkable) return TransitionState.Collided;
            float depth = (float)(distance / plane.Normal.Z);
            if (mayStand)
            {
                TakeContact(transition, plane, isWater, cellId);
                if (path.SteppingDown)
                {
                    double interp = UsedInterp(path.WalkInterp, path.StepDownAmount, depth);
                    if (interp >= path.WalkInterp || interp < InterpFloor) return TransitionState.Collided;
                    path.WalkInterp = (float)interp;
                }

                path.AddOffsetToCheckPos(new Vector3(0, 0, -depth));
                state = TransitionState.Adjusted;
            }
        }

        if (!mover.Has(MoverFlags.Contact) && !path.SteppingDown)
        {
            collision.SetCollisionNormal(plane.Normal);
            collision.CollidedWithEnvironment = true;
        }

        return state;
    }

    private static void TakeContact(Transition transition, in Plane plane, bool isWater, uint cellId)
    {
        transition.Collision.SetContactPlane(plane, isWater, cellId);
        transition.Trace?.ContactTaken(transition);
    }

    /// <summary>
    /// What is left of a downward probe after it found footing. Retail's formula divides by the present value; at exactly 0,
    /// where that is 0 times infinity, its continuation is used.
    /// </summary>
    private static double UsedInterp(double interp, double amount, double depth) =>
        interp == 0 ? depth / amount : (1.0 - ((-1.0 / (amount * interp)) * depth)) * interp;

    /// <summary>The camera stops where its sphere touches the ground instead of standing on it.</summary>
    private static TransitionState ValidateViewer(Transition transition, in Sphere sphere, in Plane plane, uint cellId)
    {
        SpherePath path = transition.Path;
        double distance = RetailMath.Distance(plane, sphere.Center) - sphere.Radius;
        if (distance > -RetailMath.Epsilon) return TransitionState.OK;
        Vector3 movement = sphere.Center - path.GlobalCurrCenters[0];
        double t = (float)distance / RetailMath.Dot(movement, plane.Normal);
        bool beganIndoors = path.HasBegin && !CellIds.IsOutdoor(path.BeginPos.CellId);
        if ((t <= 0 || t > 1) && beganIndoors) return TransitionState.OK;
        path.AddOffsetToCheckPos(RetailMath.Scale(movement, -t));
        transition.Collision.SetCollisionNormal(plane.Normal);
        transition.Collision.CollidedWithEnvironment = true;
        transition.Trace?.HitGround(transition, plane, cellId, distance, TraceReason.RunInto);
        transition.Trace?.Responded(transition, TransitionResponse.Stop, plane.Normal, true);
        return TransitionState.Adjusted;
    }
}
