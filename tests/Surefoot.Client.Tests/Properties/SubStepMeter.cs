using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>Measures each sub-step of a sweep: what was asked, what answered, and how far the body was accepted.</summary>
internal static class SubStepMeter
{
    /// <summary>The sub-steps that were told.</summary>
    internal static List<SubStep> Read(TraceBuffer trace)
    {
        List<SubStep> subSteps = [];
        Position begin = default;
        SubStep open = default;
        foreach (ref readonly TraceEntry entry in trace.Entries)
        {
            Position place = new(entry.CellId, entry.Origin);
            switch (entry.Kind)
            {
                case TraceKind.SubStepBegins:
                    begin = place;
                    open = new SubStep(entry.Offset, entry.Plane == default ? null : entry.Plane);
                    break;
                case TraceKind.SubStepEnds:
                    subSteps.Add(open with { Moved = begin.OffsetTo(place), End = place });
                    break;
                case TraceKind.Responded when entry.Succeeded:
                    open = entry.Response switch
                    {
                        TransitionResponse.CliffSlide => open with { CliffSlide = true },
                        TransitionResponse.Landing => open with { Landed = true },
                        TransitionResponse.Slide => open with { Slid = true },
                        _ => open,
                    };
                    break;
            }
        }

        return subSteps;
    }

    /// <summary>One sub-step of a sweep.</summary>
    /// <param name="Asked">Displacement asked for, metres.</param>
    /// <param name="Floor">Plane touched at its beginning, or null.</param>
    internal readonly record struct SubStep(Vector3 Asked, Plane? Floor)
    {
        /// <summary>Displacement accepted, metres.</summary>
        internal Vector3 Moved { get; init; }

        /// <summary>Where it ended.</summary>
        internal Position End { get; init; }

        internal bool CliffSlide { get; init; }

        internal bool Landed { get; init; }

        internal bool Slid { get; init; }

        public override string ToString() =>
            $"asked {Asked} moved {Moved} on {Floor} to {End}, cliff {CliffSlide}, landed {Landed}, slid {Slid}";
    }
}

/// <summary>
/// How far a sub-step may lead: as far as asked, plus the step heights. Each property that allows more is an exception that the
/// specification makes, and is pinned with its numbers by a behaviour of its own: <c>transition.offset.bends</c>,
/// <c>transition.offset.unsinks</c>, <c>transition.slide.table</c>, <c>transition.cliff-slide.table</c>,
/// <c>transition.terrain-contact.table</c>, <c>bsp.step-down.reach</c>, <c>polygon.rest.before-the-begin</c>.
/// </summary>
internal readonly struct Reach(SubStepMeter.SubStep subStep, PhysicsBody body)
{
    private const double Rounding = 0.001;

    /// <summary>
    /// Who is not on walkable ground steps up and down by this much (specification 03, 4.6, transitional_insert, and 4.7, step_up).
    /// </summary>
    private const double UnsteadyStep = 0.04;

    private double Asked => subStep.Asked.Length();

    private float Radius => body.Setup!.Spheres[0].Radius * body.Scale;

    /// <summary>
    /// Meshes are stepped onto up to one and a half times the height that terrain is: the floor of the probe is −0.5 for polygons
    /// (specification 04, 4.13).
    /// </summary>
    private double StepUpOntoMeshes => 1.5 * Math.Max(body.StepUpHeight, UnsteadyStep);

    /// <summary>
    /// Away from the floor x and y are kept and z is taken from the plane (specification 03, 4.6, adjust_offset, step 3).
    /// </summary>
    private double DownhillSnap
    {
        get
        {
            if (subStep.Floor is not { } floor) return 0;
            double steepness = Math.Sqrt(1 - ((double)floor.Normal.Z * floor.Normal.Z)) / floor.Normal.Z;
            return steepness * Level(subStep.Asked);
        }
    }

    /// <summary>
    /// A body that stands deeper than tangent is lifted, by less than its radius (specification 03, 4.6, adjust_offset, step 4).
    /// </summary>
    private double UnSink => subStep.Floor is null ? 0 : Radius;

    /// <summary>A slide projects the sub-step together with the lift before it onto its crease (specification 03, 4.8.1, step 4).</summary>
    private double SlideOfLift => subStep.Slid ? UnSink : 0;

    /// <summary>
    /// A slope that rises ahead doubles the part of the sub-step across it, in each of three attempts (specification 03, 4.7, cliff_slide).
    /// </summary>
    private double CliffSlide => subStep.CliffSlide ? 7 * Asked : 0;

    /// <summary>
    /// Who lands is drawn back along its way until it is tangent to the polygon, which may be before where it began: the floor of −0.5 is
    /// compared after multiplying with what earlier polygons left (specification 04, 4.4, adjust_sphere_to_plane, step 4).
    /// </summary>
    private bool IsDrawnBackAlongItsWay
    {
        get
        {
            if (!subStep.Landed || Asked == 0) return false;
            Vector3 way = Vector3.Normalize(subStep.Asked);
            return (subStep.Moved - (way * Vector3.Dot(subStep.Moved, way))).Length() < 0.01f;
        }
    }

    /// <summary>
    /// The ground lifts whoever enters it straight up to its surface, however steep it is (specification 03, 4.4, step 4).
    /// </summary>
    private bool IsLiftedByGround(PhysicsWorld world)
    {
        Vector3 at = subStep.End.Frame.Origin;
        double low = at.Z + ((body.Setup!.Spheres[0].Center.Z - body.Setup!.Spheres[0].Radius) * body.Scale);
        return world.GetVisible(subStep.End.CellId) is LandCell land && land.Landblock.Terrain.TryGetHeight(at.X, at.Y, out float height) &&
            low < height + 0.002;
    }

    /// <summary>Null when the sub-step kept to its bounds, otherwise what it exceeded.</summary>
    internal string? Excess(PhysicsWorld world)
    {
        if (IsDrawnBackAlongItsWay) return null;
        Vector3 moved = subStep.Moved;
        double level = Level(moved);
        if (level > Asked + CliffSlide + Rounding) return $"{level} m on the level, {Asked} m asked";
        if (moved.Z > Asked + UnSink + StepUpOntoMeshes + Rounding && !IsLiftedByGround(world)) return $"{moved.Z} m up, {Asked} m asked";
        double down = Math.Max(Asked, DownhillSnap) + SlideOfLift + Math.Max(body.StepDownHeight, UnsteadyStep);
        return -moved.Z > down + Rounding ? $"{-moved.Z} m down, {down} m allowed" : null;
    }

    private static double Level(in Vector3 v) => Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y));
}
