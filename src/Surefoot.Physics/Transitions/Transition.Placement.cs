using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>Putting a body somewhere.</content>
internal sealed partial class Transition
{
    /// <summary>
    /// Puts the body at the requested position, or, where sliding is allowed, at the first free one of the rings around it; then sets it on
    /// the floor when one is within the step-down height.
    /// </summary>
    /// <remarks>Retail: CTransition::find_placement_position @0x0050C170.</remarks>
    private bool FindPlacementPosition()
    {
        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        Path.InsertType = InsertType.InitialPlacement;
        if (ValidatePlacement(PlacementInsert(), adjust: true) != TransitionState.OK) return false;

        Path.InsertType = InsertType.Placement;
        if (!FindPlacementPos()) return false;
        if (!Object.KeepsToGround) return ValidatePlacement(TransitionState.OK, adjust: true) == TransitionState.OK;

        Path.WalkableAllowance = RetailMath.LandingZ;
        Path.SaveCheckPos();
        Path.BackupInsertType = Path.InsertType;
        Path.InsertType = InsertType.Transition;
        float height = Object.StepDownHeight;
        if (!ProbeDown(ref height, RetailMath.LandingZ))
        {
            Path.RestoreCheckPos();
            Collision.VoidContactPlane();
        }

        // The backup is one slot, which a successful probe has overwritten.
        Path.InsertType = Path.BackupInsertType;
        Path.Walkable = default;
        return ValidatePlacement(TransitionState.OK, adjust: true) == TransitionState.OK;
    }

    /// <summary>Tries the position itself, then rings around it out to 4 m (small bodies: 2 m).</summary>
    /// <remarks>Retail: CTransition::find_placement_pos @0x0050BA50.</remarks>
    private bool FindPlacementPos()
    {
        const float reach = 4f, smallReach = 2f, smallRadius = 0.125f, leastRadius = 0.48f, nearlyPi = 3.1416f;

        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        if (TryPlace() == TransitionState.OK) return true;
        if (!Path.PlacementAllowsSliding) return false;

        double radius = Path.LocalSpheres[0].Radius, distanceMax = reach, quotient;
        if (radius >= smallRadius)
        {
            radius = Math.Max(radius, leastRadius);
            quotient = reach / radius;
        }
        else
        {
            distanceMax = smallReach;
            quotient = reach / radius / 2;
        }

        if (quotient <= 1) return false;
        int rings = (int)Math.Ceiling(quotient);
        float ringStep = (float)(distanceMax / rings), halfCountStep = (float)(ringStep / radius * nearlyPi);
        float distance = 0, halfCount = 0;
        for (int ring = 0; ring < rings; ring++)
        {
            distance = (float)((double)distance + ringStep);
            double half = (double)halfCount + halfCountStep;
            halfCount = (float)half;
            if (TryRing(distance, 2 * (int)Math.Ceiling(half))) return true;
        }

        return false;
    }

    private bool TryRing(float distance, int samples)
    {
        float degrees = (float)(360.0 / samples);
        Frame facing = Frame.Identity;
        for (int s = 0; s < samples; s++)
        {
            Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
            facing.SetHeading((float)((double)s * degrees));
            Path.GlobalOffset = AdjustOffset(RetailMath.Scale(facing.YAxis, distance));
            if (RetailMath.EpsilonSquared > RetailMath.LengthSquared(Path.GlobalOffset)) continue;
            Path.AddOffsetToCheckPos(Path.GlobalOffset);
            if (TryPlace() == TransitionState.OK) return true;
        }

        return false;
    }

    private TransitionState TryPlace()
    {
        Collision.SlidingNormalValid = false;
        Collision.VoidContactPlane();
        return ValidatePlacementTransition(TransitionalInsert(AttemptsPerSubStep));
    }

    /// <summary>Does the object overlap the body where it stands?</summary>
    /// <remarks>Retail: CTransition::check_collisions @0x0050AA00.</remarks>
    internal bool CheckCollisions(WorldObject target)
    {
        Path.InsertType = InsertType.Placement;
        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        return target.FindObjCollisions(this) != TransitionState.OK;
    }

    /// <summary>
    /// Do the spheres, where they are, reach into anything solid? Nobody is asked whether the mover may be there, and open water stops
    /// nobody.
    /// </summary>
    /// <param name="loaded">False when they reach into a cell that is not loaded.</param>
    internal bool Overlaps(out bool loaded)
    {
        Path.InsertType = InsertType.Placement;
        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        BuildCellArray();
        loaded = true;
        for (int i = 0; i < Cells.Count; i++)
        {
            if (Cells[i].Cell is not { } cell)
            {
                loaded = false;
                continue;
            }

            Trace?.Asks(cell);
            if (cell.FindOverlap(this) != TransitionState.OK) return true;
        }

        return false;
    }

    /// <remarks>Retail: CTransition::placement_insert @0x0050B1D0.</remarks>
    private TransitionState PlacementInsert()
    {
        if (Path.CheckCell is null) return TransitionState.Collided;
        TransitionState state = InsertIntoCell(Path.CheckCell, AttemptsPerSubStep);
        return state == TransitionState.OK ? CheckOtherCells(Path.CheckCell) : state;
    }

    /// <remarks>Retail: CTransition::validate_placement @0x0050B210.</remarks>
    private TransitionState ValidatePlacement(TransitionState state, bool adjust)
    {
        if (Path.CheckCell is null) return TransitionState.Collided;
        if (state == TransitionState.OK) AcceptCheckPos();
        else if (adjust && state is (TransitionState.Adjusted or TransitionState.Slid))
            return ValidatePlacement(PlacementInsert(), adjust: false);
        return state;
    }

    /// <remarks>Retail: CTransition::validate_placement_transition @0x0050ADC0.</remarks>
    private TransitionState ValidatePlacementTransition(TransitionState state)
    {
        if (Path.CheckCell is null) return TransitionState.Collided;
        if (state == TransitionState.OK) AcceptCheckPos();
        else if (Path.PlacementAllowsSliding && state != TransitionState.Invalid) Collision.Clear();
        return state;
    }
}
