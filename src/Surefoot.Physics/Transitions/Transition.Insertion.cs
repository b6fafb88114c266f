using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>Trying one position: the cells' answers, and what follows when they all say OK.</content>
internal sealed partial class Transition
{
    private const int AttemptsPerSubStep = 3;
    private const int AttemptsPerProbe = 5;

    /// <summary>Step height of a body that is not on walkable ground, metres.</summary>
    private const float AirborneProbe = 0.04f;

    /// <summary>
    /// Tries the check position up to <paramref name="attempts"/> times: first its cells, then, when all are free, the landing, the
    /// deferred hit, and the floor under the feet.
    /// </summary>
    /// <remarks>Retail: CTransition::transitional_insert @0x0050B6F0. The order of the checks is load-bearing.</remarks>
    private TransitionState TransitionalInsert(int attempts)
    {
        if (Path.CheckCell is null) return TransitionState.OK;

        TransitionState state = TransitionState.Invalid;
        for (int attempt = 0; attempt < attempts; attempt++)
        {
            state = InsertIntoCell(Path.CheckCell, attempts);
            switch (state)
            {
                case TransitionState.OK:
                    state = CheckOtherCells(Path.CheckCell);
                    if (state != TransitionState.OK) Path.NegPolyHit = false;
                    break;
                case TransitionState.Slid:
                    Collision.VoidContactPlane();
                    Path.NegPolyHit = false;
                    break;
                default:
                    Path.NegPolyHit = false;
                    break;
            }

            if (state == TransitionState.Collided) return state;
            if (state != TransitionState.OK) continue;

            if (Path.Collide) return ConfirmLanding(attempts);

            if (Path.NegPolyHit && !Path.SteppingDown && !Path.SteppingUp)
            {
                state = AnswerDeferredHit(state);
                continue;
            }

            if (Collision.ContactPlaneValid || !Object.Has(MoverFlags.Contact) || Path.SteppingDown || Path.CheckCell is null ||
                !Object.KeepsToGround)
                return TransitionState.OK;

            if (KeepToGround(out float height, out float walkableZ)) return TransitionState.OK;
            if (EdgeSlide(ref state, height, walkableZ)) return state;
        }

        return state;
    }

    /// <summary>
    /// An airborne body touched something: it lands where there is footing and room, otherwise the position is taken back.
    /// </summary>
    private TransitionState ConfirmLanding(int attempts)
    {
        Path.Collide = false;
        Trace?.TakesUpLanding();
        Trace?.Tries(this, TransitionResponse.Landing, Path.StepUpNormal);
        TraceReason refusal = Collision.ContactPlaneValid ? TraceReason.BarelySupported : TraceReason.NoFooting;
        bool lands = Collision.ContactPlaneValid && CheckWalkable(RetailMath.LandingZ);
        if (lands)
        {
            refusal = TraceReason.NoRoom;
            Path.BackupInsertType = Path.InsertType;
            Path.InsertType = InsertType.Placement;
            TransitionState state = TransitionalInsert(attempts);
            Path.InsertType = Path.BackupInsertType;
            lands = state == TransitionState.OK;
        }

        Path.Walkable = default;
        Trace?.Settles(this, TransitionResponse.Landing, Path.StepUpNormal, lands, refusal);
        if (lands) return TransitionState.OK;

        Path.RestoreCheckPos();
        Collision.VoidContactPlane();
        if (Collision.LastKnownContactPlaneValid)
        {
            Collision.StopsMover = true;
            Collision.LastKnownContactPlaneValid = false;
        }
        else
        {
            Collision.SetCollisionNormal(Path.StepUpNormal);
        }

        return TransitionState.Collided;
    }

    /// <summary>Answers a polygon that was overlapped without running against it: steps onto it or slides along it.</summary>
    private TransitionState AnswerDeferredHit(TransitionState state)
    {
        Path.NegPolyHit = false;
        Trace?.TakesUpDeferred();
        if (!Path.NegStepUp) return SlideSphere(0, ref Path.NegCollisionNormal, Path.GlobalCurrCenters[0]);
        return StepUp(Path.NegCollisionNormal) ? state : StepUpSlide();
    }

    /// <summary>The body stood, and there is no floor here: looks for one within the step-down height.</summary>
    private bool KeepToGround(out float height, out float walkableZ)
    {
        height = AirborneProbe;
        walkableZ = RetailMath.LandingZ;
        if (Object.Has(MoverFlags.OnWalkable))
        {
            walkableZ = RetailMath.FloorZ;
            height = Object.StepDownHeight;
        }

        Path.WalkableAllowance = walkableZ;
        Path.SaveCheckPos();
        Trace?.AsksNobody();
        bool found = ProbeDown(ref height, walkableZ);
        if (found) Path.Walkable = default;
        return found;
    }

    /// <summary>
    /// One probe down by <paramref name="height"/>, or, where that is more than the sphere's diameter, two of half, the second going on
    /// from the first. The height is left at what one probe used.
    /// </summary>
    private bool ProbeDown(ref float height, float walkableZ)
    {
        float radius = Path.GlobalSpheres[0].Radius;
        double diameter = 2.0 * radius;
        if (Path.SphereCount < 2 && diameter < height) height = (float)(radius / 2.0);
        if (diameter >= height) return StepDown(height, walkableZ);
        height = (float)(height / 2.0);
        return StepDown(height, walkableZ) || StepDown(height, walkableZ);
    }

    /// <summary>Tests one cell, again while its answers move the position.</summary>
    /// <remarks>Retail: CTransition::insert_into_cell @0x00509E70.</remarks>
    private TransitionState InsertIntoCell(ObjCell? cell, int attempts)
    {
        if (cell is null) return TransitionState.Collided;
        TransitionState state = TransitionState.OK;
        for (int i = 0; i < attempts; i++)
        {
            Trace?.Asks(cell);
            state = cell.FindCollisions(this);
            Trace?.CellAnswered(this, cell, state);
            if (state is TransitionState.OK or TransitionState.Collided) return state;
            if (state == TransitionState.Slid) Collision.VoidContactPlane();
        }

        return state;
    }

    /// <summary>Rebuilds the cell list around the check position.</summary>
    /// <remarks>Retail: CTransition::build_cell_array @0x00509EE0.</remarks>
    private void BuildCellArray()
    {
        ObjCell? home = null;
        World.FindCellList(Cells, Path.CheckPos, Path.CheckSpheres, wantHome: false, ref home);
    }

    /// <summary>Tests the other cells that the spheres reach, and finds the cell the body is in now.</summary>
    /// <remarks>
    /// Retail: CTransition::check_other_cells @0x0050AE50. A step-up inside a cell's test rebuilds the same list; the loop carries on with
    /// its index over the new content, as retail does.
    /// </remarks>
    private TransitionState CheckOtherCells(ObjCell? current)
    {
        ObjCell? home = null;
        World.FindCellList(Cells, Path.CheckPos, Path.CheckSpheres, wantHome: true, ref home);
        for (int i = 0; i < Cells.Count; i++)
        {
            ObjCell? cell = Cells[i].Cell;
            if (cell is null || ReferenceEquals(cell, current)) continue;
            Trace?.Asks(cell);
            TransitionState state = cell.FindCollisions(this);
            Trace?.CellAnswered(this, cell, state);
            if (state == TransitionState.Slid) Collision.VoidContactPlane();
            if (state != TransitionState.OK) return state;
        }

        Path.CheckCell = home;
        if (!ReferenceEquals(home, current)) Trace?.CellEntered(this, home);
        if (home is not null)
        {
            Path.AdjustCheckPos(home.Id);
            return TransitionState.OK;
        }

        if (Path.SteppingDown) return TransitionState.Collided;
        Position place = Path.CheckPos;
        if (CellIds.IsOutdoor(place.CellId)) place.AdjustToOutside();
        if (place.CellId == 0) return TransitionState.Collided;
        Path.SetCheckPos(place, null);
        return TransitionState.OK;
    }
}
