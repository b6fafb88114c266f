using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Transitions;

/// <content>Along a wall.</content>
internal sealed partial class Transition
{
    /// <summary>
    /// Removes from the step the part along <paramref name="normal"/>, so that what is left runs along the crease between obstacle and
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
        Path.StepUp = false;
        return SlideSphere(0, ref Path.StepUpNormal, Path.GlobalCurrCenters[0]);
    }
}
