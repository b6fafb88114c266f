using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Seeding a transition from the body, and taking over its result.</content>
public sealed partial class PhysicsBody
{
    private static readonly Sphere[] DummySphere = [new(new Vector3(0, 0, 0.1f), 0.1f)];

    /// <summary>Runs a transition of this body from where it is to <paramref name="to"/>; false when no valid position was found.</summary>
    /// <remarks>Retail: CPhysicsObj::transition @0x00512DC0.</remarks>
    internal bool Sweep(Transition transition, in Position to)
    {
        SeedMover(transition, SeedContact(transition));
        transition.Path.InitPath(Cell, hasBegin: true, PositionField, to);
        transition.Collision.FramesStationaryFall =
            Has(TransientState.StationaryStuck) ? 3 : Has(TransientState.StationaryStop) ? 2 : Has(TransientState.StationaryFall) ? 1 : 0;
        return transition.FindValidPosition();
    }

    /// <summary>Where the body would end if it went from where it is to <paramref name="to"/> in one sweep; the body itself stays as it is.</summary>
    /// <exception cref="ArgumentException">The position is not finite.</exception>
    public ResolveResult Probe(in Position to)
    {
        ThrowIfNotFinite(to.Frame.Origin, nameof(to));
        if (!engine.Transitions.TryRent(out Transition? transition)) return default;
        Vector3 before = velocity;
        TransientState bits = Transient;
        double time = updateTime;
        bool found = Sweep(transition, to);
        (velocity, Transient, updateTime) = (before, bits, time);
        engine.Transitions.Return();
        return ResolveResult.Of(found, transition);
    }

    private void SeedMover(Transition transition, MoverFlags flags)
    {
        transition.Object.Init(this, flags);
        if (Setup is { Spheres.Length: > 0 }) transition.Path.InitSpheres(Setup.Spheres, Scale);
        else transition.Path.InitSpheres(DummySphere, 1f);
    }

    /// <summary>What the body stands on and slides along goes into the transition.</summary>
    /// <remarks>Retail: CPhysicsObj::get_object_info @0x00511CC0.</remarks>
    private MoverFlags SeedContact(Transition transition)
    {
        MoverFlags flags = MoverFlags.None;
        if (State.Has(PhysicsState.EdgeSlide)) flags |= MoverFlags.EdgeSlide;
        if (HasContact)
        {
            bool water = Has(TransientState.WaterContact);
            if (CheckContact())
            {
                transition.InitContactPlane(ContactPlaneCellId, contactPlane, water);
                flags |= MoverFlags.Contact;
                if (OnWalkable) flags |= MoverFlags.OnWalkable;
            }
            else
            {
                transition.InitLastKnownContactPlane(ContactPlaneCellId, contactPlane, water);
            }
        }

        if (Has(TransientState.Sliding)) transition.Collision.SetSlidingNormal(SlidingNormal);
        if (Setup is { AllowFreeHeading: true }) flags |= MoverFlags.FreeRotate;
        if (State.Has(PhysicsState.Missile)) flags |= MoverFlags.PathClipped;
        return flags;
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

        if (ReferenceEquals(path.CurrCell, Cell)) PositionField.CellId = path.CurrPos.CellId;
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
        if (State.Has(PhysicsState.HasPhysicsBsp)) engine.World.CalcCrossCells(this);
        else if (transition.Cells.Count > 0) engine.World.PlaceShadows(this, transition.Cells);
    }

    /// <summary>Stores a frame; one whose orientation alone is broken gets a zero quaternion, as in retail.</summary>
    /// <remarks>Retail: CPhysicsObj::set_frame @0x00514090.</remarks>
    private void SetFrame(in Frame frame)
    {
        PositionField.Frame = !frame.IsValid && !HasNaN(frame.Origin) && HasNaN(frame.Rotation)
            ? new Frame(frame.Origin, default)
            : frame;
        UpdateParts();
    }

    private static bool HasNaN(Vector3 v) => float.IsNaN(v.X) || float.IsNaN(v.Y) || float.IsNaN(v.Z);

    private static bool HasNaN(Quaternion q) => float.IsNaN(q.X) || float.IsNaN(q.Y) || float.IsNaN(q.Z) || float.IsNaN(q.W);
}
