using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics;

/// <summary>
/// The door: a world and the bodies in it. One thread at a time changes it; while nobody does, any number of threads may ask (<see cref="Resolve"/>,
/// <see cref="PhysicsBody.Probe(in Position, TraceBuffer)"/>). Worlds share nothing that is written, so each thread may have its own.
/// </summary>
/// <remarks>Retail: CPhysics.</remarks>
public sealed class PhysicsEngine
{
    private readonly BodyTable bodies = new();
    private readonly StaticAnimations statics = new();
    private readonly ThreadLocal<TransitionPool> questions;
    private double lastUpdate;
    private ulong rollState;

    /// <summary>An engine over a world.</summary>
    /// <param name="world">The cells bodies move through.</param>
    /// <param name="seed">Seed of scattered placements; part of the state.</param>
    public PhysicsEngine(ICellWorld world, ulong seed = 1)
    {
        ArgumentNullException.ThrowIfNull(world);
        World = world;
        Transitions = new TransitionPool(world);
        questions = new ThreadLocal<TransitionPool>(() => new TransitionPool(world));
        rollState = seed;
        if (world is not PhysicsWorld loaded) return;
        loaded.Attach(this);
        foreach (Landblock block in loaded.Landblocks) statics.Add(block, world, Now);
    }

    /// <summary>The cells bodies move through.</summary>
    public ICellWorld World { get; }

    /// <summary>Time of the last call of <see cref="Tick"/>, seconds.</summary>
    public double Now { get; private set; }

    /// <summary>The local player; bodies farther than 96 m from it sleep. Null, as on a server, keeps every body as it is.</summary>
    public PhysicsBody? Player { get; set; }

    /// <summary>
    /// Keep a body where it is when a move would end in no loaded cell. Off, as in retail, where such a body is parked until its cell is loaded; servers
    /// want it on.
    /// </summary>
    public bool RefuseLeavingCells { get; set; }

    /// <summary>The work objects of those who change bodies, one thread at a time.</summary>
    internal TransitionPool Transitions { get; }

    /// <summary>The work objects of those who only ask: each thread has its own, and threads share nothing that is written.</summary>
    internal TransitionPool Questions => questions.Value!;

    /// <summary>Bodies in the order in which they are updated.</summary>
    public IEnumerable<PhysicsBody> Bodies => bodies;

    /// <summary>Makes a body that is not yet anywhere; <see cref="PhysicsBody.EnterWorld"/> puts it into the world.</summary>
    /// <param name="id">Its id, unique in this engine and not 0.</param>
    /// <param name="setup">Its shape.</param>
    /// <param name="state">Its physics state word.</param>
    /// <param name="weenie">What the server says of it.</param>
    /// <param name="scale">Uniform scale, more than 0.</param>
    /// <exception cref="ArgumentException">The id is 0 or taken, or the scale is not a positive number.</exception>
    public PhysicsBody CreateBody(
        uint id, SetupAsset? setup, PhysicsState state = PhysicsState.Default, WeenieTraits weenie = WeenieTraits.None, float scale = 1f)
    {
        if (id == 0 || bodies.Find(id) is not null) throw new ArgumentException($"The body id 0x{id:X8} is 0 or taken.", nameof(id));
        if (!(scale > 0) || !float.IsFinite(scale)) throw new ArgumentException("The scale is not a positive number.", nameof(scale));
        PhysicsBody body = new(this, id, setup, state & ~PhysicsState.Static, weenie, scale);
        body.ListContradictions();
        bodies.Add(body);
        return body;
    }

    /// <summary>Takes a body out of the world and forgets it.</summary>
    public void RemoveBody(PhysicsBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        body.ExitWorld();
        body.LeaveWorld();
        bodies.Remove(body);
        if (ReferenceEquals(Player, body)) Player = null;
    }

    /// <summary>The body with this id, or null.</summary>
    public PhysicsBody? Find(uint id) => bodies.Find(id);

    /// <summary>
    /// Brings every body, then the parts of animated statics, to <paramref name="now"/>. Less than 1/30 s after the last tick nothing happens and the time is
    /// not lost: a finer step would change how bodies fall.
    /// </summary>
    /// <param name="now">Seconds; a clock that starts anywhere and does not run backwards.</param>
    /// <returns>True when bodies were updated.</returns>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    /// <remarks>Retail: CPhysics::UseTime @0x00509950.</remarks>
    public bool Tick(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        Now = now;
        double elapsed = now - lastUpdate;
        if (elapsed < 0)
        {
            lastUpdate = now;
            return false;
        }

        if (elapsed < PhysicsBody.MinQuantum) return false;
        foreach (PhysicsBody body in bodies) body.UpdateObject(now);
        lastUpdate = now;
        statics.Animate(now);
        return true;
    }

    /// <summary>
    /// Where a body of this shape would end that wants to go from one place to another in one quantum, standing where it
    /// begins when it touches the ground there. Nothing in the world changes, so any number of threads may ask while nobody changes it.
    /// </summary>
    /// <param name="setup">Shape of the body.</param>
    /// <param name="from">Begin.</param>
    /// <param name="to">End wanted.</param>
    /// <param name="state">Physics state word of the body.</param>
    /// <param name="weenie">What kind of body.</param>
    /// <returns>The outcome; <see cref="ResolveResult.Found"/> is false when the begin is nowhere.</returns>
    public ResolveResult Resolve(
        SetupAsset setup, in Position from, in Position to, PhysicsState state = PhysicsState.Default, WeenieTraits weenie = WeenieTraits.None)
    {
        ArgumentNullException.ThrowIfNull(setup);
        if (!RetailMath.IsFinite(from.Frame.Origin) || !RetailMath.IsFinite(to.Frame.Origin)) throw new ArgumentException("A position is not finite.");
        PhysicsBody probe = new(this, 0, setup, state, weenie, 1f);
        Position begin = from;
        World.AdjustPosition(ref begin, setup.Spheres.Length > 0 ? setup.Spheres[0].Center : Vector3.Zero, out ObjCell? cell);
        probe.SeatAt(begin, cell);
        return cell is null ? default : probe.Probe(to);
    }

    /// <summary>Bodies whose cell came with a landblock enter the world again, and its animated statics begin to move.</summary>
    /// <param name="block">The landblock.</param>
    internal void OnLandblockLoaded(Landblock block)
    {
        statics.Add(block, World, Now);
        foreach (PhysicsBody body in bodies)
            if (body.IsLost && CellIds.BlockOf(body.Position.CellId) == block.Id) body.ReenterVisibility();
    }

    /// <summary>Bodies in a landblock that goes away wait for it. To be called before it does.</summary>
    /// <param name="blockId">The landblock, 0xXXYY0000.</param>
    internal void OnLandblockUnloading(uint blockId)
    {
        statics.Remove(blockId);
        foreach (PhysicsBody body in bodies)
            if (body.Cell is not null && CellIds.BlockOf(body.Position.CellId) == blockId) body.LeaveVisibility();
    }

    /// <summary>A hash of the state of every body and every animated static, equal wherever the same inputs were given.</summary>
    public ulong HashState()
    {
        StateHash hash = new();
        hash.Add(rollState);
        foreach (PhysicsBody body in bodies) body.AddTo(ref hash);
        statics.AddTo(ref hash);
        return hash.Value;
    }

    /// <summary>What moves a body that does not move by itself.</summary>
    internal static IBodySteering MakeSteering(PhysicsBody body) => new SteeredPhysicsBody(body);

    /// <summary>A number in [-1, 1] from the engine's own seed.</summary>
    internal double NextRoll()
    {
        // SplitMix64: the generator is not retail's, whose rolls come from the C library.
        rollState += 0x9E3779B97F4A7C15;
        ulong z = rollState;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        z ^= z >> 31;
        return ((z >> 11) * (2.0 / ((1UL << 53) - 1))) - 1.0;
    }
}

/// <summary>Outcome of <see cref="PhysicsEngine.Resolve"/>.</summary>
/// <param name="Found">A valid position was found; it may be the begin.</param>
/// <param name="Position">Where the body ends.</param>
/// <param name="HasContact">It touches a plane there.</param>
/// <param name="ContactPlane">That plane.</param>
/// <param name="CollisionNormal">Unit normal of the last collision on the way, or null.</param>
/// <param name="CollidedWithEnvironment">It hit terrain, a building, a room or a static object without standing.</param>
/// <param name="SlidingNormal">Horizontal unit normal, or zero, of the wall it slides along next; null for none.</param>
/// <param name="LosesVelocity">A body that goes there loses its velocity, even when no valid position was found.</param>
public readonly record struct ResolveResult(
    bool Found, Position Position, bool HasContact, Plane ContactPlane, Vector3? CollisionNormal, bool CollidedWithEnvironment,
    Vector3? SlidingNormal, bool LosesVelocity)
{
    internal static ResolveResult Of(bool found, Transition transition)
    {
        CollisionInfo met = transition.Collision;
        return new ResolveResult(
            found, transition.Path.CurrPos, met.ContactPlaneValid, met.ContactPlane,
            met.CollisionNormalValid ? met.CollisionNormal : null, met.CollidedWithEnvironment,
            met.SlidingNormalValid ? met.SlidingNormal : null, met.StopsMover);
    }
}
