using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>
/// A body that moves: state words, velocity, contact. What happens to it has files of its own: <c>Integration</c>, <c>Commit</c>,
/// <c>Placement</c>, <c>StateWord</c>, <c>Parts</c>, <c>Steering</c>.
/// </summary>
/// <remarks>Retail: CPhysicsObj; specification 02.</remarks>
public sealed partial class PhysicsBody : WorldObject, IMotionBody, IHookTarget
{
    /// <summary>Fastest a body is set to move, m/s.</summary>
    public const float MaxVelocity = 50f;

    private const float DefaultFriction = 0.95f;
    private const float DefaultElasticity = 0.05f;
    private const float MaxElasticity = 0.1f;

    /// <summary>A body of two spheres rarely reaches more cells.</summary>
    private const int UsualShadows = 16;

    private readonly Population population;
    private readonly IBodyDriver driver;
    private readonly CollisionReporter collisions;
    private Vector3 velocity;
    private Vector3 omega;
    private Plane contactPlane;
    private double updateTime;

    internal PhysicsBody(Population population, uint id, SetupAsset? setup, PhysicsState state, WeenieTraits weenie, float scale)
        : base(id, setup, state)
    {
        this.population = population;
        driver = population.MakeDriver(this);
        collisions = new CollisionReporter(this);
        Weenie = weenie;
        Scale = scale;
        updateTime = population.Now;
        Shadows = new ShadowObject[UsualShadows];
        UpdateParts();
    }

    /// <summary>Changing bits: contact, on walkable, sliding, active.</summary>
    public TransientState Transient { get; private set; }

    /// <inheritdoc/>
    public override Vector3 Velocity => velocity;

    /// <summary>Acceleration, m/s², world axes.</summary>
    public Vector3 Acceleration { get; private set; }

    /// <summary>Angular velocity, rad/s, world axes.</summary>
    public Vector3 Omega => omega;

    /// <summary>Distance covered in the last quantum divided by the quantum, m/s.</summary>
    /// <remarks>Retail: CPhysicsObj::get_velocity @0x005113C0 returns this.</remarks>
    public Vector3 AchievedVelocity { get; private set; }

    /// <summary>
    /// The plane touched last, in the block frame of <see cref="ContactPlaneCellId"/>; it holds while <see cref="HasContact"/>.
    /// </summary>
    public Plane ContactPlane => contactPlane;

    /// <summary>Cell whose block frame <see cref="ContactPlane"/> is in.</summary>
    public uint ContactPlaneCellId { get; private set; }

    /// <summary>Horizontal unit normal of the wall slid along, or zero.</summary>
    public Vector3 SlidingNormal { get; private set; }

    /// <inheritdoc/>
    public override bool HasContact => Has(TransientState.Contact);

    /// <summary>Stands on a plane that can be walked on.</summary>
    public bool OnWalkable => Has(TransientState.OnWalkable);

    /// <summary>Is being simulated.</summary>
    public bool IsActive => Has(TransientState.Active);

    /// <summary>Fraction of the normal speed given back by a bounce, 0 to 0.1.</summary>
    public float Elasticity { get; private set; } = DefaultElasticity;

    /// <summary>Fraction of the speed lost in a second on the ground, 0 to 1.</summary>
    public float Friction { get; private set; } = DefaultFriction;

    /// <summary>Simulated time this body has reached, seconds.</summary>
    public double SimulatedTime => updateTime;

    /// <summary>Length of the last quantum simulated, seconds.</summary>
    public float LastQuantum { get; private set; }

    /// <summary>Where the body was at the beginning of the last quantum, for drawing between quanta.</summary>
    public Position PreviousPosition { get; private set; } = Position.Nowhere;

    /// <summary>Is told of collisions.</summary>
    public ICollisionListener? Listener { get; set; }

    /// <summary>Is told what the body's animations pass.</summary>
    public IHookListener? HookListener { get; set; }

    /// <summary>Is told each decision when the body is swept or placed; null, the usual case, costs nothing.</summary>
    public TraceBuffer? Trace { get; set; }

    /// <summary>The last motion was asked for here and not by a server.</summary>
    public bool LastMoveWasAutonomous { get; internal set; }

    /// <inheritdoc/>
    public bool HasGravity => State.Has(PhysicsState.Gravity);

    /// <inheritdoc/>
    public bool HasCell => Cell is not null;

    /// <inheritdoc/>
    public bool IsFullyConstrained => driver.IsFullyConstrained;

    /// <summary>The bodies it lives among.</summary>
    internal Population Population => population;

    /// <summary>What drives it.</summary>
    internal IBodyDriver Driver => driver;

    /// <summary>
    /// Sets the velocity, at most <see cref="MaxVelocity"/>, and wakes the body; a change within the tolerance is ignored.
    /// </summary>
    /// <param name="value">m/s, world axes.</param>
    /// <exception cref="ArgumentException">A component is NaN or infinite.</exception>
    /// <remarks>Retail: CPhysicsObj::set_velocity @0x005113F0.</remarks>
    public void SetVelocity(Vector3 value)
    {
        ThrowIfNotFinite(value, nameof(value));
        if (!RetailMath.NearlyEqual(value, velocity))
        {
            velocity = value;
            if (RetailMath.Length(velocity) > MaxVelocity) velocity = RetailMath.Scale(RetailMath.Normalize(velocity), MaxVelocity);
        }

        SetActive(true);
    }

    /// <summary>Sets the velocity from the body's own axes.</summary>
    /// <param name="velocity">m/s; x right, y ahead, z up.</param>
    /// <remarks>Retail: CPhysicsObj::set_local_velocity @0x005114D0.</remarks>
    internal void SetLocalVelocity(Vector3 velocity)
    {
        ThrowIfNotFinite(velocity, nameof(velocity));
        SetVelocity(PositionField.Frame.LocalToGlobalVector(velocity));
    }

    void IMotionBody.SetLocalVelocity(Vector3 velocity) => SetLocalVelocity(velocity);

    void IMotionBody.SetOnWalkable(bool on) => SetOnWalkable(on);

    bool IMotionBody.LastMoveWasAutonomous
    {
        get => LastMoveWasAutonomous;
        set => LastMoveWasAutonomous = value;
    }

    /// <summary>Velocity in the body's own axes, m/s.</summary>
    /// <remarks>Retail: CPhysicsObj::get_local_physics_velocity @0x00512140.</remarks>
    public Vector3 LocalVelocity => PositionField.Frame.GlobalToLocalVector(velocity);

    /// <summary>Sets the angular velocity, rad/s, world axes.</summary>
    /// <remarks>Retail: CPhysicsObj::set_omega @0x0050F6D0.</remarks>
    public void SetOmega(Vector3 value)
    {
        ThrowIfNotFinite(value, nameof(value));
        omega = value;
    }

    /// <summary>Sets what the server says of the body.</summary>
    public void SetWeenie(WeenieTraits value) => Weenie = value;

    /// <summary>Sets the elasticity, held between 0 and 0.1.</summary>
    /// <remarks>Retail: CPhysicsObj::set_elasticity @0x0050FD40.</remarks>
    public void SetElasticity(float value)
    {
        if (float.IsNaN(value)) throw new ArgumentException("The elasticity is not a number.", nameof(value));
        Elasticity = Math.Clamp(value, 0f, MaxElasticity);
    }

    /// <summary>Sets the friction; values outside 0 to 1 are ignored, as in retail.</summary>
    public void SetFriction(float value)
    {
        if (value is >= 0 and <= 1) Friction = value;
    }

    /// <summary>Turns the body to a compass heading in degrees (0 north, 90 east) without any test.</summary>
    /// <remarks>Retail: CPhysicsObj::set_heading @0x00514160.</remarks>
    public void SetHeading(float degrees)
    {
        if (!float.IsFinite(degrees)) throw new ArgumentException("The heading is not finite.", nameof(degrees));
        Frame turned = PositionField.Frame;
        turned.SetHeading(degrees);
        SetFrame(turned);
    }

    /// <summary>Wakes the body or puts it to sleep; statics stay asleep.</summary>
    /// <remarks>Retail: CPhysicsObj::set_active @0x0050FC40.</remarks>
    public bool SetActive(bool on)
    {
        if (!on)
        {
            Transient &= ~TransientState.Active;
            return true;
        }

        if (State.Has(PhysicsState.Static)) return false;
        if (!IsActive) updateTime = population.Now;
        Transient |= TransientState.Active;
        return true;
    }

    /// <summary>Writes the on-walkable bit, tells the movement side, and renews the acceleration.</summary>
    /// <remarks>Retail: CPhysicsObj::set_on_walkable @0x00511310.</remarks>
    internal void SetOnWalkable(bool on)
    {
        bool before = OnWalkable;
        Set(TransientState.OnWalkable, on);
        if (before && !on) driver.LeaveGround();
        else if (!before && on) driver.HitGround();
        CalcAcceleration();
    }

    /// <summary>
    /// Re-seats the body in the state of a recorded quantum, without any test: for replays, for saved states, and for servers that check a
    /// client's report.
    /// </summary>
    /// <param name="seat">The state. A velocity above the greatest is cut down to it by the next quantum, as any.</param>
    /// <exception cref="ArgumentException">
    /// A number of the state is not finite, the normal of its contact plane not of unit length, an id cannot name a cell, or it stands on
    /// what it does not touch; nothing has changed.
    /// </exception>
    public void Seat(in BodySeat seat)
    {
        seat.ThrowIfBad(nameof(seat));
        SeatAt(seat.Position, population.Cells.GetVisible(seat.Position.CellId));
        UpdateParts();
        UpdateHeld();
        velocity = seat.Velocity;
        Transient = (Transient & TransientState.Active) | (seat.Transient & ~TransientState.Active);
        contactPlane = seat.ContactPlane;
        ContactPlaneCellId = seat.ContactPlaneCellId;
        SlidingNormal = seat.SlidingNormal;
        collisions.TouchesEnvironment = seat.TouchesEnvironment;
        CalcAcceleration();
    }

    /// <summary>What the body is between two quanta.</summary>
    internal BodySeat CurrentSeat =>
        new(PositionField, velocity, Transient, contactPlane, ContactPlaneCellId, SlidingNormal, collisions.TouchesEnvironment);

    /// <summary>Adds what of the body is state to a hash.</summary>
    internal void AddTo(ref StateHash hash)
    {
        hash.Add(Id);
        hash.Add((ulong)State);
        hash.Add((ulong)Transient);
        hash.Add(PositionField);
        hash.Add(velocity);
        hash.Add(omega);
        hash.Add(contactPlane.Normal);
        hash.Add(contactPlane.D);
        hash.Add(ContactPlaneCellId);
        hash.Add(SlidingNormal);
        hash.Add(updateTime);
        driver.AddTo(ref hash);
        for (int i = 0; i < HeldCount; i++)
        {
            hash.Add(Held[i].Object.Id);
            hash.Add(Held[i].Location);
        }
    }

    /// <summary>Gravity, or nothing; a body that stands does not turn by itself either.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_acceleration @0x00510950.</remarks>
    private void CalcAcceleration()
    {
        if (HasContact && OnWalkable && !State.Has(PhysicsState.Sledding))
        {
            Acceleration = Vector3.Zero;
            omega = Vector3.Zero;
        }
        else
        {
            Acceleration = State.Has(PhysicsState.Gravity) ? new Vector3(0, 0, Gravity) : Vector3.Zero;
        }
    }

    private bool Has(TransientState bit) => (Transient & bit) != 0;

    private void Set(TransientState bit, bool on) => Transient = on ? Transient | bit : Transient & ~bit;

    private static void ThrowIfNotFinite(in Vector3 value, string name)
    {
        if (!RetailMath.IsFinite(value)) throw new ArgumentException($"A component of {value} is not finite.", name);
    }
}
