using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Transitions;

/// <content>Where the floor ends: walking off, sliding along the edge, sliding along a cliff.</content>
internal sealed partial class Transition
{
    /// <summary>The body stood and found no floor within reach. True ends the insertion with <paramref name="state"/>.</summary>
    /// <remarks>
    /// Retail: CTransition::edge_slide @0x0050B3D0. In each case the position is restored before the slide, which therefore survives.
    /// </remarks>
    private bool EdgeSlide(ref TransitionState state, float height, float walkableZ)
    {
        if (!Object.Has(MoverFlags.OnWalkable) || !Object.Has(MoverFlags.EdgeSlide))
        {
            Path.Walkable = default;
            return WalkOff(out state, TraceReason.Careless);
        }

        if (Collision.ContactPlaneValid && Collision.ContactPlane.Normal.Z < walkableZ)
        {
            Path.Walkable = default;
            Path.RestoreCheckPos();
            state = CliffSlide(Collision.ContactPlane);
            Collision.VoidContactPlane();
            return false;
        }

        if (!Path.Walkable.IsNone)
        {
            Path.RestoreCheckPos();
            Collision.VoidContactPlane();
            state = PrecipiceSlide();
            return state == TransitionState.Collided;
        }

        if (Collision.ContactPlaneValid) return WalkOff(out state, TraceReason.None);
        return ProbeBehind(out state, height, walkableZ);
    }

    private bool WalkOff(out TransitionState state, TraceReason reason)
    {
        Path.RestoreCheckPos();
        Collision.VoidContactPlane();
        Trace?.WalkedOff(this, reason);
        state = TransitionState.OK;
        return true;
    }

    /// <summary>Looks for the polygon the body came from, under where it stood, and slides along that polygon's edge.</summary>
    private bool ProbeBehind(out TransitionState state, float height, float walkableZ)
    {
        Path.AddOffsetToCheckPos(Path.GlobalCurrCenters[0] - Path.GlobalSpheres[0].Center);
        StepDown(height, walkableZ);
        Collision.VoidContactPlane();
        Path.RestoreCheckPos();
        if (Path.Walkable.IsNone)
        {
            Trace?.Responded(this, TransitionResponse.EdgeSlide, Vector3.Zero, false, TraceReason.NothingBehind);
            state = TransitionState.Collided;
            return true;
        }

        Path.CacheLocalSpaceSpheres(Path.WalkablePos, Path.WalkableScale);
        Path.WalkableCheckPos = Path.LocalSpaceSpheres[0];
        state = PrecipiceSlide();
        return state == TransitionState.Collided;
    }

    /// <summary>Takes the part of the sub-step that leads across the edge of the walkable polygon out of it.</summary>
    /// <remarks>Retail: SPHEREPATH::precipice_slide @0x0050CC80.</remarks>
    private TransitionState PrecipiceSlide()
    {
        bool crossed = Path.Walkable.FindCrossedEdge(Path.WalkableCheckPos, Path.WalkableUp, out Vector3 edge);
        Path.Walkable = default;
        if (!crossed)
        {
            Trace?.Responded(this, TransitionResponse.PrecipiceSlide, Vector3.Zero, false, TraceReason.NoEdgeCrossed);
            return TransitionState.Collided;
        }

        Path.SteppingUp = false;
        Vector3 normal = Path.WalkablePos.Frame.LocalToGlobalVector(edge);
        if (RetailMath.Dot(normal, Path.CurrToCheckDisplacement(0)) > 0) normal = -normal;
        Trace?.Responded(this, TransitionResponse.PrecipiceSlide, normal, true);
        return SlideSphere(0, ref normal, Path.GlobalCurrCenters[0]);
    }

    /// <summary>Pushes the position under test along the foot or the brink of a slope that is too steep.</summary>
    /// <remarks>
    /// Retail: CTransition::cliff_slide @0x0050A6D0. For a slope that rises ahead the push doubles the sub-step instead of removing it;
    /// that stop-and-go along steep hillsides is retail's (specification 03, 4.7).
    /// </remarks>
    internal TransitionState CliffSlide(in Plane plane)
    {
        Vector3 along = RetailMath.Cross(plane.Normal, Collision.LastKnownContactPlane.Normal);
        Vector3 normal = new(-along.Y, along.X, 0);
        if (RetailMath.NormalizeCheckSmall(ref normal)) return TransitionState.OK;

        double advance = RetailMath.Dot(Path.CurrToCheckDisplacement(0), normal);
        if (advance > 0)
        {
            Path.AddOffsetToCheckPos(RetailMath.Scale(normal, -advance));
            normal = -normal;
        }
        else
        {
            Path.AddOffsetToCheckPos(RetailMath.Scale(normal, advance));
        }

        Collision.SetCollisionNormal(normal);
        Trace?.Responded(this, TransitionResponse.CliffSlide, normal, true);
        return TransitionState.Adjusted;
    }
}
