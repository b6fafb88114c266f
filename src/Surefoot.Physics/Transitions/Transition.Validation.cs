using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>Accepting a sub-step or taking it back, and what the body stands on afterwards.</content>
internal sealed partial class Transition
{
    /// <summary>
    /// Accepts the check position or undoes it, then settles contact, the count of sub-steps without progress and the wall to slide
    /// along next.
    /// </summary>
    /// <returns>OK also for an undone sub-step.</returns>
    /// <remarks>Retail: CTransition::validate_transition @0x0050AA70.</remarks>
    private TransitionState ValidateTransition(TransitionState answer)
    {
        TransitionState state = answer;
        bool moved = state == TransitionState.OK &&
                     !(Path.CheckPos.CellId == Path.CurrPos.CellId && Frame.NearlyEqual(Path.CheckPos.Frame, Path.CurrPos.Frame));
        if (state == TransitionState.OK)
        {
            AcceptCheckPos();
            Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        }
        else if (state != TransitionState.Invalid)
        {
            moved |= Undo();
            state = TransitionState.OK;
        }

        if (Collision.CollisionNormalValid) Collision.SetSlidingNormal(Collision.CollisionNormal);
        CountStationaryFall(moved);
        KeepContactAsLastKnown();
        Trace?.SubStepEnds(this, answer);
        return state;
    }

    private void AcceptCheckPos()
    {
        Path.CurrPos = Path.CheckPos;
        Path.CurrCell = Path.CheckCell;
        Path.CacheGlobalCurrCenter();
    }

    /// <summary>Takes the sub-step back; true when the body regained the ground it walks on.</summary>
    private bool Undo()
    {
        bool regained = false;
        if (Collision.LastKnownContactPlaneValid)
        {
            Collision.StopsMover = true;
            // Retail makes no block correction here: near a border the plane may fail to be regained.
            double distance = RetailMath.Distance(Collision.LastKnownContactPlane, Path.GlobalCurrCenters[0]);
            if ((double)Path.GlobalSpheres[0].Radius + RetailMath.Epsilon > Math.Abs(distance))
            {
                Collision.SetContactPlane(
                    Collision.LastKnownContactPlane, Collision.LastKnownContactPlaneIsWater, Collision.LastKnownContactPlaneCellId);
                Trace?.ContactRegained(this);
                regained = Object.Has(MoverFlags.OnWalkable);
            }
        }

        if (!Collision.CollisionNormalValid) Collision.SetCollisionNormal(Vector3.UnitZ);
        Path.SetCheckPos(Path.CurrPos, Path.CurrCell);
        BuildCellArray();
        return regained;
    }

    /// <summary>
    /// A body under gravity that fails to move for the third time gets a floor made up under its lowest point, so that nothing hangs in
    /// the air for ever.
    /// </summary>
    private void CountStationaryFall(bool moved)
    {
        if (Object.Has(MoverFlags.IsViewer) || !Object.State.Has(PhysicsState.Gravity)) return;
        if (moved)
        {
            Collision.FramesStationaryFall = 0;
            return;
        }

        if (Collision.FramesStationaryFall < 2)
        {
            Collision.FramesStationaryFall++;
            return;
        }

        Collision.FramesStationaryFall = 3;
        Sphere foot = Path.GlobalSpheres[0];
        Plane floor = new(Vector3.UnitZ, (float)((double)foot.Radius - foot.Center.Z));
        Collision.SetContactPlane(floor, false, Path.CheckPos.CellId);
        Trace?.ContactMadeUp(this);
        // The contact bit is still that of the sub-step before: it is rewritten only after this.
        if (!Object.Has(MoverFlags.Contact))
        {
            Collision.SetCollisionNormal(floor.Normal);
            Collision.CollidedWithEnvironment = true;
        }
    }

    private void KeepContactAsLastKnown()
    {
        Collision.LastKnownContactPlaneValid = Collision.ContactPlaneValid;
        Object.Flags &= ~(MoverFlags.Contact | MoverFlags.OnWalkable);
        if (!Collision.ContactPlaneValid) return;
        Collision.LastKnownContactPlane = Collision.ContactPlane;
        Collision.LastKnownContactPlaneCellId = Collision.ContactPlaneCellId;
        Collision.LastKnownContactPlaneIsWater = Collision.ContactPlaneIsWater;
        Object.Flags |= MoverFlags.Contact;
        if (ObjectInfo.IsValidWalkable(Collision.ContactPlane.Normal)) Object.Flags |= MoverFlags.OnWalkable;
    }
}
