using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Taking over the result of a transition.</content>
public sealed partial class PhysicsBody
{
    /// <summary>What the body is between two quanta.</summary>
    internal BodySeat CurrentSeat =>
        new(PositionField, velocity, Transient, contactPlane, ContactPlaneCellId, SlidingNormal, collidingWithEnvironment);

    /// <summary>
    /// A transition may have decided that the body loses its velocity. To be asked as soon as it ends, whatever becomes of its result: retail stops the body from
    /// inside.
    /// </summary>
    private void TakeStop(Transition transition)
    {
        if (!transition.Collision.StopsMover) return;
        transition.Collision.StopsMover = false;
        SetVelocity(Vector3.Zero);
    }

    /// <summary>Takes over the result of a transition. The order of the steps is load-bearing.</summary>
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
            if (stood) Movement?.LeaveGround();
            CalcAcceleration();
        }

        SlidingNormal = collision.SlidingNormal;
        Set(TransientState.Sliding, collision.SlidingNormalValid);
        LastHitCount = collision.ObjectCount;
        LastCollisionNormal = collision.CollisionNormalValid ? collision.CollisionNormal : null;
        LastCollidedWithEnvironment = collision.CollidedWithEnvironment;
        HandleAllCollisions(collision, hadContact, hadWalkable, simulatedTime);

        if (Cell is null) return;
        if (State.Has(PhysicsState.HasPhysicsBsp)) engine.Cells.CalcCrossCells(this);
        else if (transition.Cells.Count > 0) engine.Cells.PlaceShadows(this, transition.Cells);
    }

    /// <summary>Stores a frame; one whose orientation alone is broken gets a zero quaternion, as in retail.</summary>
    /// <remarks>Retail: CPhysicsObj::set_frame @0x00514090.</remarks>
    private void SetFrame(in Frame frame)
    {
        PositionField.Frame = !frame.IsValid && !HasNaN(frame.Origin) && HasNaN(frame.Rotation)
            ? new Frame(frame.Origin, default)
            : frame;
        UpdateParts();
        UpdateHeld();
    }

    private static bool HasNaN(Vector3 v) => float.IsNaN(v.X) || float.IsNaN(v.Y) || float.IsNaN(v.Z);

    private static bool HasNaN(Quaternion q) => float.IsNaN(q.X) || float.IsNaN(q.Y) || float.IsNaN(q.Z) || float.IsNaN(q.W);
}
