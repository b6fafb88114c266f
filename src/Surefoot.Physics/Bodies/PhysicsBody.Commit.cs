using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Seeding a transition from the body, and taking over its result.</content>
public sealed partial class PhysicsBody
{
    private static readonly Sphere[] DummySphere = [new(new Vector3(0, 0, 0.1f), 0.1f)];

    /// <summary>What the body is between two quanta.</summary>
    private BodySeat CurrentSeat =>
        new(PositionField, velocity, Transient, contactPlane, ContactPlaneCellId, SlidingNormal, collidingWithEnvironment);

    /// <summary>
    /// Where the body would end if it went from where it is to <paramref name="to"/> in one sweep. Nothing changes, so any number of threads may ask while nobody
    /// changes the world.
    /// </summary>
    /// <param name="to">Where it wants to go.</param>
    /// <param name="trace">Is told each decision; the body's own <see cref="Trace"/> is not.</param>
    /// <exception cref="ArgumentException">The position is not finite.</exception>
    public ResolveResult Probe(in Position to, TraceBuffer? trace = null) => Probe(CurrentSeat, Cell, to, trace);

    /// <summary>
    /// Where the body would end if it were in another state and went from there to <paramref name="to"/> in one sweep: how a server checks a movement that a
    /// client claims. Nothing changes, so any number of threads may ask while nobody changes the world.
    /// </summary>
    /// <param name="from">The state it begins in.</param>
    /// <param name="to">Where it wants to go.</param>
    /// <param name="trace">Is told each decision; the body's own <see cref="Trace"/> is not.</param>
    /// <returns>The outcome; <see cref="ResolveResult.Found"/> is false when the cell it begins in is not loaded.</returns>
    /// <exception cref="ArgumentException">A position or the velocity is not finite.</exception>
    public ResolveResult Probe(in BodySeat from, in Position to, TraceBuffer? trace = null)
    {
        ThrowIfNotFinite(from.Position.Frame.Origin, nameof(from));
        ThrowIfNotFinite(from.Velocity, nameof(from));
        return Probe(from, engine.Cells.GetVisible(from.Position.CellId), to, trace);
    }

    private ResolveResult Probe(in BodySeat from, ObjCell? cell, in Position to, TraceBuffer? trace)
    {
        ThrowIfNotFinite(to.Frame.Origin, nameof(to));
        TransitionPool pool = engine.Questions;
        if (!pool.TryRent(out Transition? transition, trace)) return default;
        try
        {
            return ResolveResult.Of(Sweep(transition, from, cell, to), transition);
        }
        finally
        {
            pool.Return();
        }
    }

    /// <summary>Runs a transition of this body from a state to a place; false when no valid position was found. The body stays as it is.</summary>
    /// <remarks>Retail: CPhysicsObj::transition @0x00512DC0.</remarks>
    private bool Sweep(Transition transition, in BodySeat from, ObjCell? cell, in Position to)
    {
        SeedMover(transition, SeedContact(transition, from));
        transition.Path.InitPath(cell, hasBegin: true, from.Position, to);
        transition.Collision.FramesStationaryFall = (from.Transient & TransientState.StationaryStuck) != 0 ? 3
            : (from.Transient & TransientState.StationaryStop) != 0 ? 2
            : (from.Transient & TransientState.StationaryFall) != 0 ? 1 : 0;
        return transition.FindValidPosition();
    }

    private void SeedMover(Transition transition, MoverFlags flags)
    {
        transition.Object.Init(this, flags);
        if (Setup is { Spheres.Length: > 0 }) transition.Path.InitSpheres(Setup.Spheres, Scale);
        else transition.Path.InitSpheres(DummySphere, 1f);
    }

    /// <summary>What the body stands on and slides along goes into the transition; a plane that its velocity leads away from is left behind.</summary>
    /// <remarks>Retail: CPhysicsObj::get_object_info @0x00511CC0, check_contact @0x0050F5B0.</remarks>
    private MoverFlags SeedContact(Transition transition, in BodySeat from)
    {
        MoverFlags flags = MoverFlags.None;
        if (State.Has(PhysicsState.EdgeSlide)) flags |= MoverFlags.EdgeSlide;
        if ((from.Transient & TransientState.Contact) != 0)
        {
            bool water = (from.Transient & TransientState.WaterContact) != 0;
            if (RetailMath.Dot(from.Velocity, from.ContactPlane.Normal) > RetailMath.Epsilon)
            {
                transition.InitLastKnownContactPlane(from.ContactPlaneCellId, from.ContactPlane, water);
            }
            else
            {
                transition.InitContactPlane(from.ContactPlaneCellId, from.ContactPlane, water);
                flags |= MoverFlags.Contact;
                if ((from.Transient & TransientState.OnWalkable) != 0) flags |= MoverFlags.OnWalkable;
            }
        }

        if ((from.Transient & TransientState.Sliding) != 0) transition.Collision.SetSlidingNormal(from.SlidingNormal);
        if (Setup is { AllowFreeHeading: true }) flags |= MoverFlags.FreeRotate;
        if (State.Has(PhysicsState.Missile)) flags |= MoverFlags.PathClipped;
        return flags;
    }

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
    }

    private static bool HasNaN(Vector3 v) => float.IsNaN(v.X) || float.IsNaN(v.Y) || float.IsNaN(v.Z);

    private static bool HasNaN(Quaternion q) => float.IsNaN(q.X) || float.IsNaN(q.Y) || float.IsNaN(q.Z) || float.IsNaN(q.W);
}
