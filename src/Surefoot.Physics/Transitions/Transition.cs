using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>
/// One attempt of a body to get from here to there, or to be put somewhere. A work object: it is reset and reused, and its
/// result is read before the next use.
/// </summary>
/// <remarks>
/// Retail: CTransition; specification 03. This file is the sweep itself; each response has a file of its own.
/// </remarks>
internal sealed partial class Transition
{
    /// <summary>A work object for a world.</summary>
    public Transition(ICellWorld world)
    {
        ArgumentNullException.ThrowIfNull(world);
        World = world;
    }

    /// <summary>The world moved through.</summary>
    public ICellWorld World { get; }

    /// <summary>Who moves.</summary>
    public ObjectInfo Object { get; } = new();

    /// <summary>Where from, where to, and where now.</summary>
    public SpherePath Path { get; } = new();

    /// <summary>What was met.</summary>
    public CollisionInfo Collision { get; } = new();

    /// <summary>The cells the path reaches.</summary>
    public CellArray Cells { get; } = new();

    /// <summary>Is told each decision; null, the usual case, costs nothing.</summary>
    public TraceBuffer? Trace { get; set; }

    /// <summary>Makes the object as good as new.</summary>
    /// <remarks>
    /// Retail: CTransition::init @0x00509DD0. Planes and normals of an earlier user are zeroed too (specification 03, 7.1).
    /// </remarks>
    internal void Reset()
    {
        Object.Reset();
        Path.Reset();
        Collision.Reset();
        Cells.Clear();
        Cells.DoNotLoadCells = false;
    }

    /// <summary>Seeds the plane the body stands on.</summary>
    /// <remarks>Retail: CTransition::init_contact_plane @0x0050E850.</remarks>
    internal void InitContactPlane(uint cellId, in Plane plane, bool isWater)
    {
        InitLastKnownContactPlane(cellId, plane, isWater);
        Collision.LastKnownContactPlaneCellId = cellId;
        Collision.SetContactPlane(plane, isWater);
    }

    /// <summary>Seeds the plane the body is just leaving.</summary>
    /// <remarks>
    /// Retail: CTransition::init_last_known_contact_plane @0x0050E8E0. The id goes to the contact plane's cell, not to the last known
    /// one's: load-bearing for the un-sink after an undone sub-step.
    /// </remarks>
    internal void InitLastKnownContactPlane(uint cellId, in Plane plane, bool isWater)
    {
        Collision.LastKnownContactPlaneValid = true;
        Collision.LastKnownContactPlane = plane;
        Collision.LastKnownContactPlaneIsWater = isWater;
        Collision.ContactPlaneCellId = cellId;
    }

    /// <summary>Runs the attempt; true when a valid position was found, which may be the old one.</summary>
    /// <remarks>Retail: CTransition::find_valid_position @0x0050C310.</remarks>
    internal bool FindValidPosition()
    {
        Trace?.SweepBegins(this);
        bool found = Path.InsertType == InsertType.Transition ? FindTransitionalPosition() : FindPlacementPosition();
        Trace?.SweepEnds(this, found);
        return found;
    }

    /// <summary>Sweeps the spheres from begin to end in sub-steps of at most one radius.</summary>
    /// <returns>True also when every sub-step was refused and undone.</returns>
    /// <remarks>Retail: CTransition::find_transitional_position @0x0050BDF0.</remarks>
    public bool FindTransitionalPosition()
    {
        if (Path.BeginCell is null) return false;

        SubStepPlan plan = SubStepPlan.Of(Path, Object.Has(MoverFlags.IsViewer));
        if (Object.Has(MoverFlags.FreeRotate)) Path.CurrPos.Frame.SetRotation(Path.EndPos.Frame.Rotation);
        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        if (plan.Count == 0)
        {
            if (!Object.Has(MoverFlags.FreeRotate)) Path.CurrPos.Frame.SetRotation(Path.EndPos.Frame.Rotation);
            Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
            BuildCellArray();
            return true;
        }

        TransitionState state = TransitionState.OK;
        for (int i = 0; i < plan.Count; i++)
        {
            Vector3 offset = plan.PerSubStep;
            if (Object.Has(MoverFlags.IsViewer) && i == plan.Count - 1 && plan.Distance > RetailMath.Epsilon)
            {
                double radius = Path.LocalSpheres[0].Radius;
                offset = RetailMath.Scale(plan.Offset, (plan.Distance - (radius * (plan.Count - 1))) / plan.Distance);
            }

            Trace?.SubStepBegins(this, i, plan.Count, offset);
            Path.GlobalOffset = AdjustOffset(offset);
            if (!Object.Has(MoverFlags.IsViewer) && RetailMath.EpsilonSquared > RetailMath.LengthSquared(Path.GlobalOffset))
            {
                Trace?.SubStepEnds(this, TransitionState.Invalid, TraceReason.TooShort);
                if (i == 0) return false;
                break;
            }

            if (!Object.Has(MoverFlags.FreeRotate))
                Path.CheckPos.Frame.InterpolateRotation(Path.BeginPos.Frame, Path.EndPos.Frame, (float)((i + 1) / (double)plan.Count));
            Collision.SlidingNormalValid = false;
            Collision.VoidContactPlane();

            Path.AddOffsetToCheckPos(Path.GlobalOffset);
            state = ValidateTransition(TransitionalInsert(AttemptsPerSubStep));
            if (Collision.FramesStationaryFall != 0) break;
            if (Collision.CollisionNormalValid && Object.Has(MoverFlags.PathClipped)) break;
        }

        return state == TransitionState.OK;
    }
}
