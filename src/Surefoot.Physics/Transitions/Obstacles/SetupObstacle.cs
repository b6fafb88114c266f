using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>The shapes of a setup as an obstacle: which of them are tested.</summary>
internal static class SetupObstacle
{
    private const double FarMargin = 0.1;

    /// <summary>
    /// Tests the check position against an object of a setup: its parts' trees if its state word says so, else its cylinders, else its
    /// spheres; the first answer other than OK counts.
    /// </summary>
    /// <param name="setup">The setup.</param>
    /// <param name="transition">The transition.</param>
    /// <param name="target">The object.</param>
    /// <param name="creature">It is a creature or a missile: its spheres are not a floor.</param>
    /// <remarks>Retail: the shapes of CPhysicsObj::FindObjCollisions @0x0050F050, CPartArray::FindObjCollisions.</remarks>
    internal static TransitionState FindCollisions(this SetupAsset setup, Transition transition, WorldObject target, bool creature)
    {
        Position position = target.Position;
        float scale = target.Scale;
        if (target.State.Has(PhysicsState.HasPhysicsBsp))
        {
            int count = target.PlacedPartCount;
            for (int i = 0; i < count; i++)
            {
                GfxObjAsset mesh = setup.Parts[i].Mesh;
                if (mesh.Physics is null) continue;
                if (double.IsFinite(transition.Object.PassesChangedSince) && target is StaticObject still && still.MovesPart(i)) continue;
                float partScale = (float)((double)setup.Parts[i].DefaultScale.Z * scale);
                double reach = Math.Abs((double)partScale) * (mesh.PhysicsReach + FarMargin);
                if (IsFarAway(transition.Path, position.CellId, target.PartOrigin(i), reach))
                {
                    transition.Trace?.SkippedPart(transition, i);
                    continue;
                }

                transition.Trace?.AsksPart(i);
                TransitionState state = mesh.FindCollisions(transition, new Position(position.CellId, target.PartFrame(i)), partScale);
                if (state != TransitionState.OK) return state;
            }

            return TransitionState.OK;
        }

        foreach (ref readonly CylSphere cylinder in setup.Cylinders)
        {
            TransitionState state = CylinderObstacle.IntersectsSphere(transition, position, scale, cylinder);
            if (state != TransitionState.OK) return state;
        }

        if (setup.Cylinders.Length > 0) return TransitionState.OK;
        if (IsFarAway(transition.Path, position.CellId, position.Frame.Origin, Math.Abs((double)scale) * setup.SpheresReach))
        {
            transition.Trace?.Skipped(transition, target, TraceReason.TooFar);
            return TransitionState.OK;
        }

        foreach (ref readonly Sphere sphere in setup.Spheres)
        {
            TransitionState state = BallObstacle.IntersectsSphere(transition, position, scale, sphere, creature);
            if (state != TransitionState.OK) return state;
        }

        return TransitionState.OK;
    }

    /// <summary>
    /// True when the body is so far from a point that nothing within <paramref name="reach"/> metres of it is touched, however what is
    /// there is turned; saves turning it. Never true where retail's own test would not end in OK: a tenth of a metre, in either frame,
    /// covers the roundings.
    /// </summary>
    private static bool IsFarAway(SpherePath path, uint cellId, in Vector3 point, double reach)
    {
        Vector3 origin = point + CellIds.BlockOffset(path.CheckPos.CellId, cellId);
        // From the position, not from the global spheres: those do not see a turn of the position under test, the part's test does.
        double limit = reach + FarMargin + path.LocalReach;
        // False, so that nothing is skipped, when a scale is NaN.
        return RetailMath.LengthSquared(path.CheckPos.Frame.Origin - origin) > limit * limit;
    }
}
