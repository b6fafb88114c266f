using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>Along floors, walls and the creases between them.</content>
internal sealed partial class Transition
{
    /// <summary>
    /// Bends a sub-step along the floor, the wall or the crease between them, and lifts the check position out of the plane it has
    /// sunk into.
    /// </summary>
    /// <param name="offset">The sub-step asked for, metres, world axes.</param>
    /// <returns>The sub-step to take.</returns>
    /// <remarks>Retail: CTransition::adjust_offset @0x0050A370.</remarks>
    internal Vector3 AdjustOffset(in Vector3 offset)
    {
        Vector3 v = offset;
        Vector3 wall = Collision.SlidingNormal;
        bool slides = false;
        if (Collision.SlidingNormalValid)
        {
            slides = RetailMath.Dot(v, wall) < 0;
            if (!slides) Collision.SlidingNormalValid = false;
        }

        if (!Collision.ContactPlaneValid)
        {
            if (!slides) return v;
            double k = RetailMath.Dot(v, wall);
            v = new Vector3(
                (float)(v.X - (k * wall.X)), (float)((double)v.Y - (float)(k * wall.Y)), (float)((double)v.Z - (float)(k * wall.Z)));
            Trace?.Bent(this, TraceReason.AlongWall, wall, v);
            return v;
        }

        Plane floor = Collision.ContactPlane;
        float into = (float)RetailMath.Dot(v, floor.Normal);
        if (slides)
        {
            Vector3 crease = RetailMath.Cross(floor.Normal, wall);
            v = RetailMath.NormalizeCheckSmall(ref crease) ? Vector3.Zero : RetailMath.Scale(crease, RetailMath.Dot(crease, v));
            Trace?.Bent(this, TraceReason.AlongCrease, wall, v);
        }
        else if (into <= 0)
        {
            Vector3 n = floor.Normal;
            v = new Vector3(
                (float)(v.X - ((double)into * n.X)),
                (float)(v.Y - ((double)into * n.Y)),
                (float)((double)v.Z - (float)((double)into * n.Z)));
            Trace?.Bent(this, TraceReason.AlongFloor, n, v);
        }
        else
        {
            RetailMath.SnapToPlane(floor, ref v);
            Trace?.Bent(this, TraceReason.DownTheFloor, floor.Normal, v);
        }

        Unsink(floor);
        return v;
    }

    /// <summary>
    /// Lifts the check position until sphere 0 touches its contact plane tangentially. Terrain contact is made with the lowest point
    /// of the sphere, so on a slope every sub-step begins with a small lift that its step-down takes back.
    /// </summary>
    private void Unsink(in Plane floor)
    {
        if (Collision.ContactPlaneIsWater || Collision.ContactPlaneCellId == 0) return;
        Vector3 block = CellIds.BlockOffset(Path.CheckPos.CellId, Collision.ContactPlaneCellId);
        Sphere foot = Path.GlobalSpheres[0];
        Vector3 n = floor.Normal;
        double height =
            (n.X * ((double)foot.Center.X - block.X)) + (n.Y * ((double)foot.Center.Y - block.Y)) + ((double)n.Z * foot.Center.Z) + floor.D;
        if (height >= (double)foot.Radius - RetailMath.Epsilon) return;
        double lift = (foot.Radius - height) / n.Z;
        if (!(foot.Radius > Math.Abs(lift))) return;
        Path.AddOffsetToCheckPos(new Vector3(0, 0, (float)lift));
        Trace?.Lifted(this, (float)lift);
    }

    /// <summary>
    /// Removes from the sub-step the part along <paramref name="normal"/>, so that what is left runs along the crease between obstacle and
    /// floor. The vector is the caller's own: in the last case it is overwritten.
    /// </summary>
    /// <param name="sphere">Which sphere of the path.</param>
    /// <param name="normal">Normal of the obstacle, world axes; the zero vector moves half-way back.</param>
    /// <param name="curr">Centre of that sphere at the accepted position, in its block frame.</param>
    /// <remarks>Retail: CSphere::slide_sphere @0x00537440.</remarks>
    internal TransitionState SlideSphere(int sphere, ref Vector3 normal, in Vector3 curr)
    {
        Vector3 center = Path.GlobalSpheres[sphere].Center;
        if (normal == Vector3.Zero)
        {
            Path.AddOffsetToCheckPos(RetailMath.Scale(curr - center, 0.5));
            Trace?.Responded(this, TransitionResponse.Slide, normal, false, TraceReason.NoDirection);
            return TransitionState.Adjusted;
        }

        Collision.SetCollisionNormal(normal);
        Vector3 movement = Path.Displacement(center, curr);
        // Without a contact plane the last known one serves, valid or not.
        Vector3 floor = Collision.ContactPlaneValid ? Collision.ContactPlane.Normal : Collision.LastKnownContactPlane.Normal;

        double creaseY = ((double)normal.Z * floor.X) - ((double)normal.X * floor.Z);
        double creaseZ = ((double)normal.X * floor.Y) - ((double)normal.Y * floor.X);
        Vector3 crease = RetailMath.Cross(normal, floor);
        // One factor of the last product is still in its register: stored in the other, and in everything that follows.
        double squared = ((double)crease.X * crease.X) + (creaseY * creaseY) + (crease.Z * creaseZ);
        if (squared >= RetailMath.Epsilon)
        {
            double along = ((double)crease.X * movement.X) + (creaseY * movement.Y) + ((double)crease.Z * movement.Z);
            double inverse = 1.0 / (float)squared;
            float inverseStored = (float)inverse;
            double keptX = crease.X * along * inverse;
            float keptY = (float)((float)(creaseY * along) * (double)inverseStored);
            float keptZ = (float)((float)(crease.Z * along) * (double)inverseStored);
            double length = (keptX * keptX) + ((double)keptY * keptY) + ((double)keptZ * keptZ);
            bool slides = length >= RetailMath.Epsilon;
            Trace?.Responded(this, TransitionResponse.Slide, normal, slides, TraceReason.TooShort);
            if (!slides) return TransitionState.Collided;
            Path.AddOffsetToCheckPos(new Vector3(
                (float)(keptX - movement.X), (float)((double)keptY - movement.Y), (float)((double)keptZ - movement.Z)));
            return TransitionState.Slid;
        }

        if (RetailMath.Dot(normal, floor) >= 0)
        {
            // The share is stored before it is used (specification 04, 4.7).
            Path.AddOffsetToCheckPos(RetailMath.Scale(normal, -(float)RetailMath.Dot(movement, normal)));
            Trace?.Responded(this, TransitionResponse.Slide, normal, true);
            return TransitionState.Slid;
        }

        Trace?.Responded(this, TransitionResponse.Slide, normal, false, TraceReason.AgainstTheFloor);
        normal = -movement;
        if (!RetailMath.NormalizeCheckSmall(ref normal)) Collision.SetCollisionNormal(normal);
        return TransitionState.Collided;
    }

    /// <summary>Slides along what could not be stepped onto.</summary>
    /// <remarks>Retail: SPHEREPATH::step_up_slide @0x0050C3B0.</remarks>
    internal TransitionState StepUpSlide()
    {
        Collision.VoidContactPlane();
        Path.SteppingUp = false;
        return SlideSphere(0, ref Path.StepUpNormal, Path.GlobalCurrCenters[0]);
    }
}
