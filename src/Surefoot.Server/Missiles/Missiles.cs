using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>What a missile hit.</summary>
/// <param name="MissileId">The missile.</param>
/// <param name="ObjectId">What it hit; 0 for the ground, a building, a room or a static thing.</param>
/// <param name="Quadrant">Where an object was hit: 8 left or 16 right, 32 front or 64 back, 1 high, 2 medium or 4 low; else 0.</param>
/// <param name="Impact">Where the missile ended, and the normal of what it hit.</param>
/// <param name="Time">Time of the tick in which it hit, seconds.</param>
public readonly record struct MissileHit(uint MissileId, uint ObjectId, int Quadrant, Impact Impact, double Time);

/// <summary>How missiles are launched.</summary>
public sealed record MissileOptions
{
    /// <summary>Id of the first missile; the next ones count up from there, over ids that are taken, and begin anew at the end.</summary>
    public uint FirstId { get; init; } = 0xC0000001;

    /// <summary>Most missiles in the air at a time.</summary>
    public int MostFlying { get; init; } = 256;

    /// <summary>How long a missile that hits nothing flies, seconds.</summary>
    public double Lifetime { get; init; } = 10;

    internal void ThrowIfBad()
    {
        if (MostFlying < 1) throw new ArgumentException("At least one missile is to fly at a time.", nameof(MostFlying));
        if (!(Lifetime > 0) || !double.IsFinite(Lifetime))
            throw new ArgumentException("The lifetime of a missile is not a positive number of seconds.", nameof(Lifetime));
    }
}

/// <summary>
/// Arrows and spells of a server: launched, told of once when they hit, and taken away then or when their time is over. They stop at
/// creatures, players and whatever is solid; they pass each other and what is ethereal.
/// </summary>
/// <remarks>Specification 06, 7, and 02, 4.15.</remarks>
public sealed class Missiles : ICollisionListener
{
    private readonly PhysicsEngine engine;
    private readonly MissileOptions options;
    private readonly List<(PhysicsBody Body, double Until)> flying = [];
    private readonly Queue<MissileHit> hits = [];
    private readonly HashSet<uint> spent = [];
    private uint nextId;

    /// <summary>Missiles in an engine's world.</summary>
    /// <param name="engine">The engine.</param>
    /// <param name="options">Ids and bounds.</param>
    /// <exception cref="ArgumentException">A bound is not a positive number.</exception>
    public Missiles(PhysicsEngine engine, MissileOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        this.engine = engine;
        this.options = options ?? new MissileOptions();
        this.options.ThrowIfBad();
        nextId = this.options.FirstId;
    }

    /// <summary>Number of missiles in the air.</summary>
    public int FlyingCount => flying.Count;

    /// <summary>The missiles in the air, the oldest first.</summary>
    public IEnumerable<PhysicsBody> Flying => flying.Select(one => one.Body);

    /// <summary>Launches a missile. It begins outside of whoever shoots: it knows no friend.</summary>
    /// <param name="shape">Its shape; one without spheres would stay where it is.</param>
    /// <param name="from">Where it begins.</param>
    /// <param name="velocity">m/s, world axes; cut down to 50 m/s.</param>
    /// <param name="falls">It has weight, as an arrow; a spell has none.</param>
    /// <param name="omega">Angular velocity of one that spins, rad/s, world axes; null for one whose nose follows its way.</param>
    /// <returns>Its body; null when there is no room for it there, or too many are in the air.</returns>
    /// <exception cref="ArgumentException">
    /// The shape has no sphere, or a number is not finite, or the cell id names no cell; nothing has changed.
    /// </exception>
    public PhysicsBody? Launch(SetupAsset shape, in Position from, Vector3 velocity, bool falls, Vector3? omega = null)
    {
        ArgumentNullException.ThrowIfNull(shape);
        if (shape.Spheres.Length == 0) throw new ArgumentException("A missile needs a sphere to fly by.", nameof(shape));
        if (flying.Count >= options.MostFlying) return null;
        PhysicsState state = PhysicsState.ReportCollisions | PhysicsState.Missile | PhysicsState.PathClipped;
        if (falls) state |= PhysicsState.Gravity;
        if (omega is null) state |= PhysicsState.AlignPath;
        PhysicsBody body = engine.CreateBody(FreeId(), shape, state, WeenieTraits.Present);
        try
        {
            body.SetOmega(omega ?? Vector3.Zero);
            body.SetVelocity(velocity);
            if (!body.EnterWorld(from, slide: false) || !body.HasCell)
            {
                engine.RemoveBody(body);
                return null;
            }
        }
        catch
        {
            engine.RemoveBody(body);
            throw;
        }

        body.Listener = this;
        flying.Add((body, engine.Now + options.Lifetime));
        return body;
    }

    /// <summary>Takes away what has hit or flown long enough. To be called after <see cref="PhysicsEngine.Tick"/>.</summary>
    public void Update()
    {
        for (int i = flying.Count - 1; i >= 0; i--)
        {
            (PhysicsBody body, double until) = flying[i];
            if (!spent.Remove(body.Id) && engine.Now < until && body.HasCell && engine.Find(body.Id) == body) continue;
            flying.RemoveAt(i);
            engine.RemoveBody(body);
        }
    }

    /// <summary>The oldest hit that was not taken yet. Each is told once.</summary>
    public bool TryTakeHit(out MissileHit hit) => hits.TryDequeue(out hit);

    void ICollisionListener.OnEnvironmentCollision(PhysicsBody body, in EnvironmentCollision collision) =>
        Hit(body, 0, 0, collision.Impact);

    void ICollisionListener.OnAttackCollision(WorldObject body, in AttackCollision collision) =>
        Hit((PhysicsBody)body, collision.ObjectId, collision.Quadrant, collision.Impact);

    void ICollisionListener.OnObjectCollision(WorldObject body, in ObjectCollision collision)
    {
        // Somebody ran into a missile that is none any more, in the quantum in which it hit.
    }

    void ICollisionListener.OnCollisionEnd(WorldObject body, uint objectId)
    {
    }

    // What it strikes on its way to the ground, spent, is no hit.
    private void Hit(PhysicsBody body, uint objectId, int quadrant, in Impact impact)
    {
        if (spent.Add(body.Id)) hits.Enqueue(new MissileHit(body.Id, objectId, quadrant, impact, engine.Now));
    }

    private uint FreeId()
    {
        while (true)
        {
            if (nextId < options.FirstId || nextId == 0) nextId = Math.Max(options.FirstId, 1);
            uint id = nextId++;
            if (engine.Find(id) is null) return id;
        }
    }
}
