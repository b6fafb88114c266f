using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Taking over the result of a transition: place, contact, reports, bounce, stop.</content>
public sealed partial class PhysicsBody
{
    /// <summary>
    /// A transition may have decided that the body loses its velocity. To be asked as soon as it ends, whatever becomes of its result:
    /// retail stops the body from inside.
    /// </summary>
    private void TakeStop(Transition transition)
    {
        if (!transition.Collision.StopsMover) return;
        transition.Collision.StopsMover = false;
        SetVelocity(Vector3.Zero);
    }

    /// <summary>Takes over the result of a transition. The order of what follows is load-bearing.</summary>
    /// <remarks>Retail: CPhysicsObj::SetPositionInternal(CTransition*) @0x00515330.</remarks>
    private void Commit(Transition transition, double simulatedTime)
    {
        bool hadWalkable = OnWalkable, hadContact = HasContact;
        SpherePath path = transition.Path;
        CollisionInfo collision = transition.Collision;
        if (path.CurrCell is null)
        {
            GoToLostCell(path.CurrPos);
            return;
        }

        if (ReferenceEquals(path.CurrCell, Cell)) SetCellId(path.CurrPos.CellId);
        else ChangeCell(path.CurrCell);
        SetFrame(path.CurrPos.Frame);

        contactPlane = collision.ContactPlane;
        ContactPlaneCellId = collision.ContactPlaneCellId;
        Set(TransientState.Contact, collision.ContactPlaneValid);
        CalcAcceleration();
        Set(TransientState.WaterContact, collision.ContactPlaneIsWater);
        if (HasContact)
        {
            SetOnWalkable(ObjectInfo.IsValidWalkable(contactPlane.Normal));
        }
        else
        {
            bool stood = OnWalkable;
            Transient &= ~TransientState.OnWalkable;
            if (stood) driver.LeaveGround();
            CalcAcceleration();
        }

        SlidingNormal = collision.SlidingNormal;
        Set(TransientState.Sliding, collision.SlidingNormalValid);
        HandleAllCollisions(collision, hadContact, hadWalkable, simulatedTime);

        if (Cell is null) return;
        if (State.Has(PhysicsState.HasPhysicsBsp)) population.Cells.CalcCrossCells(this);
        else if (transition.Cells.Count > 0) population.Cells.PlaceShadows(this, transition.Cells);
    }

    /// <summary>Reports, then bounces or stops, then keeps count of failed moves.</summary>
    /// <returns>True when something was reported.</returns>
    /// <remarks>Retail: CPhysicsObj::handle_all_collisions @0x00514780. Reports see the velocity before the bounce.</remarks>
    internal bool HandleAllCollisions(CollisionInfo info, bool hadContact, bool hadWalkable, double simulatedTime)
    {
        bool nowWalkable = OnWalkable;
        bool mayBounce = !hadWalkable || !nowWalkable || State.Has(PhysicsState.Sledding);
        bool reported = collisions.Report(info, hadContact, landed: !hadWalkable && nowWalkable, simulatedTime);

        int stationary = info.FramesStationaryFall;
        if (stationary >= 2) velocity = Vector3.Zero;
        else if (mayBounce && info.CollisionNormalValid) Bounce(info.CollisionNormal);

        if (stationary is 0 or 3) Transient &= ~TransientState.StationaryMask;
        else if (stationary == 1) Transient |= TransientState.StationaryFall;
        else if (stationary == 2) Transient |= TransientState.StationaryStop;
        return reported;
    }

    /// <summary>Reflects the velocity into the obstacle, nearly all of it lost.</summary>
    internal void Bounce(in Vector3 normal)
    {
        if (State.Has(PhysicsState.Inelastic))
        {
            velocity = Vector3.Zero;
            return;
        }

        double dot = RetailMath.Dot(velocity, normal);
        if (dot >= 0) return;
        double k = -(dot * ((double)Elasticity + 1.0));
        velocity = new Vector3(
            (float)((k * normal.X) + velocity.X),
            (float)((float)(k * normal.Y) + (double)velocity.Y),
            (float)((float)(k * normal.Z) + (double)velocity.Z));
    }

    /// <summary>Stores a frame; one whose orientation alone is broken gets a zero quaternion, as in retail.</summary>
    /// <remarks>Retail: CPhysicsObj::set_frame @0x00514090.</remarks>
    private void SetFrame(in Frame frame)
    {
        if (frame.Origin != PositionField.Frame.Origin) ChangedAt = population.Now;
        PositionField.Frame = !frame.IsValid && !HasNaN(frame.Origin) && HasNaN(frame.Rotation)
            ? new Frame(frame.Origin, default)
            : frame;
        UpdateParts();
        UpdateHeld();
    }

    private static bool HasNaN(Vector3 v) => float.IsNaN(v.X) || float.IsNaN(v.Y) || float.IsNaN(v.Z);

    private static bool HasNaN(Quaternion q) => float.IsNaN(q.X) || float.IsNaN(q.Y) || float.IsNaN(q.Z) || float.IsNaN(q.W);
}
