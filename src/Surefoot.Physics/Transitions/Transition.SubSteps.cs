using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>How a sweep is cut into steps, and how each step is bent before it is tried.</content>
internal sealed partial class Transition
{
    /// <summary>The steps of a sweep: how many, each how far, and the whole.</summary>
    internal readonly record struct StepPlan(int Count, Vector3 PerStep, Vector3 Offset, double Distance);

    /// <summary>Cuts the sweep into steps of at most one radius of sphere 0; the camera's are exactly one radius.</summary>
    /// <remarks>Retail: CTransition::calc_num_steps @0x0050A0B0.</remarks>
    internal StepPlan CalcNumSteps()
    {
        if (!Path.HasBegin) return new StepPlan(1, Vector3.Zero, Vector3.Zero, 0);

        Vector3 offset = Path.BeginPos.OffsetTo(Path.EndPos);
        double distance = RetailMath.Length(offset), quotient = distance / Path.LocalSpheres[0].Radius;
        if (Object.Has(MoverFlags.IsViewer))
        {
            return distance <= RetailMath.Epsilon
                ? new StepPlan(0, Vector3.Zero, offset, distance)
                : new StepPlan((int)Math.Floor(quotient) + 1, RetailMath.Scale(offset, 1.0 / quotient), offset, distance);
        }

        if (quotient > 1)
        {
            double count = Math.Ceiling(quotient);
            return new StepPlan((int)count, RetailMath.Scale(offset, 1.0 / count), offset, distance);
        }

        return offset == Vector3.Zero
            ? new StepPlan(0, Vector3.Zero, offset, distance)
            : new StepPlan(1, offset, offset, distance);
    }

    /// <summary>
    /// Bends a step along the floor, the wall or the crease between them, and lifts the check position out of the plane it has
    /// sunk into.
    /// </summary>
    /// <param name="offset">The step asked for, metres, world axes.</param>
    /// <returns>The step to take.</returns>
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
            v = new Vector3((float)(v.X - (k * wall.X)), (float)((double)v.Y - (float)(k * wall.Y)), (float)((double)v.Z - (float)(k * wall.Z)));
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
                (float)(v.X - ((double)into * n.X)), (float)(v.Y - ((double)into * n.Y)), (float)((double)v.Z - (float)((double)into * n.Z)));
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
    /// of the sphere, so on a slope every step begins with a small lift that its step-down takes back.
    /// </summary>
    private void Unsink(in Plane floor)
    {
        if (Collision.ContactPlaneIsWater || Collision.ContactPlaneCellId == 0) return;
        Vector3 block = CellIds.BlockOffset(Path.CheckPos.CellId, Collision.ContactPlaneCellId);
        Sphere foot = Path.GlobalSpheres[0];
        Vector3 n = floor.Normal;
        double height = (n.X * ((double)foot.Center.X - block.X)) + (n.Y * ((double)foot.Center.Y - block.Y)) + ((double)n.Z * foot.Center.Z) + floor.D;
        if (height >= (double)foot.Radius - RetailMath.Epsilon) return;
        double lift = (foot.Radius - height) / n.Z;
        if (!(foot.Radius > Math.Abs(lift))) return;
        Path.AddOffsetToCheckPos(new Vector3(0, 0, (float)lift));
        Trace?.Lifted(this, (float)lift);
    }
}
