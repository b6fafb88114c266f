using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics;

/// <summary>
/// The door: a world and the bodies in it. One thread at a time changes it; while nobody does, any number of threads may ask, each by a
/// <see cref="WorldQuery"/> of its own. Engines share nothing that is written, so each thread may have its own.
/// </summary>
/// <remarks>Retail: CPhysics.</remarks>
public sealed class PhysicsEngine : ILoadListener
{
    private readonly Population population;
    private readonly StaticAnimations statics = new();
    private WorldQuery? own;
    private double lastUpdate;

    /// <summary>An engine with a world of its own, of which nothing is loaded yet.</summary>
    /// <param name="assets">Shapes and records; may be shared with other engines.</param>
    /// <param name="options">Rules that hold from the beginning.</param>
    /// <exception cref="DatRecordMissingException">The options give no region, and the files have none.</exception>
    /// <exception cref="DatFormatException">The region is malformed.</exception>
    public PhysicsEngine(PhysicsDataCache assets, PhysicsEngineOptions? options = null)
        : this(MakeWorld(assets, options ??= new PhysicsEngineOptions()), options.Seed)
    {
    }

    /// <summary>An engine that takes over a world.</summary>
    /// <exception cref="InvalidOperationException">Another one owns it.</exception>
    internal PhysicsEngine(PhysicsWorld world, ulong seed = 1)
        : this(world, world, seed)
    {
        foreach (Landblock block in world.Landblocks) statics.Add(block, world, Now);
    }

    /// <summary>An engine over cells that are made up; <see cref="World"/> stays empty.</summary>
    internal PhysicsEngine(ICellWorld cells)
        : this(new PhysicsWorld(), cells, seed: 1)
    {
    }

    private PhysicsEngine(PhysicsWorld world, ICellWorld cells, ulong seed)
    {
        World = world;
        population = new Population(cells, seed, body => new SteeredPhysicsBody(body));
        world.Attach(this);
    }

    /// <summary>The landblocks that are loaded, and the cells in them. It belongs to this engine alone.</summary>
    public PhysicsWorld World { get; }

    /// <summary>The cells bodies move through: those of <see cref="World"/>.</summary>
    internal ICellWorld Cells => population.Cells;

    /// <summary>Time of the last call of <see cref="Tick"/>, seconds.</summary>
    public double Now => population.Now;

    /// <summary>The local player; bodies farther than 96 m from it sleep. Null, as on a server, keeps every body as it is.</summary>
    /// <exception cref="ArgumentException">The body belongs to another engine.</exception>
    public PhysicsBody? Player
    {
        get => population.Player;
        set
        {
            if (value is not null) population.ThrowIfForeign(value);
            population.Player = value;
        }
    }

    /// <summary>
    /// Keep a body where it is when a move would end in no loaded cell. Off, as in retail, where such a body is parked until its cell is
    /// loaded; servers want it on.
    /// </summary>
    public bool RefuseLeavingCells
    {
        get => population.RefuseLeavingCells;
        set => population.RefuseLeavingCells = value;
    }

    /// <summary>Bodies in the order in which they are updated.</summary>
    public IEnumerable<PhysicsBody> Bodies => population.Bodies;

    /// <summary>Makes a body that is not yet anywhere; <see cref="PhysicsBody.EnterWorld"/> puts it into the world.</summary>
    /// <param name="id">Its id, unique in this engine and not 0.</param>
    /// <param name="setup">Its shape.</param>
    /// <param name="state">Its physics state word.</param>
    /// <param name="weenie">What the server says of it.</param>
    /// <param name="scale">Uniform scale, more than 0.</param>
    /// <param name="motions">What moves it by itself; null for one that nothing but forces and orders move.</param>
    /// <param name="listed">
    /// False for one that is still being described: nobody finds it and no tick moves it until <see cref="Enlist"/>.
    /// </param>
    /// <exception cref="ArgumentException">The id is 0 or taken, or the scale is not a positive number.</exception>
    public PhysicsBody CreateBody(
        uint id, SetupAsset? setup, PhysicsState state = PhysicsState.Default, WeenieTraits weenie = WeenieTraits.None, float scale = 1f,
        BodyMotions? motions = null, bool listed = true)
    {
        if (id == 0 || population.Find(id) is not null) throw new ArgumentException($"The body id 0x{id:X8} is 0 or taken.", nameof(id));
        if (!(scale > 0) || !float.IsFinite(scale)) throw new ArgumentException("The scale is not a positive number.", nameof(scale));
        PhysicsBody body = new(population, id, setup, state & ~PhysicsState.Static, weenie, scale);
        body.ListContradictions();
        if (listed) population.Bodies.Add(body);
        if (motions is not null) SteeredPhysicsBody.Of(body).Attach(new MovementManager(body, motions.Table, motions.Weenie));
        return body;
    }

    /// <summary>From now on the body is found by its id, and ticks move it.</summary>
    /// <exception cref="ArgumentException">
    /// It belongs to another engine, is listed already, or its id has been taken since it was made.
    /// </exception>
    /// <exception cref="InvalidOperationException">It was removed.</exception>
    /// <remarks>Retail: the end of ACCObjectMaint::CreateObject @0x00558870.</remarks>
    public void Enlist(PhysicsBody body)
    {
        population.ThrowIfForeign(body);
        body.ThrowIfRemoved();
        if (population.Find(body.Id) is not null) throw new ArgumentException($"The body id 0x{body.Id:X8} is taken.", nameof(body));
        population.Bodies.Add(body);
    }

    /// <summary>
    /// Takes a body out of the world and forgets it: it cannot come back. What it holds is let go and stays known, in no cell. Nothing
    /// happens for one that was removed before.
    /// </summary>
    /// <exception cref="ArgumentException">The body belongs to another engine.</exception>
    public void RemoveBody(PhysicsBody body)
    {
        population.ThrowIfForeign(body);
        body.ExitWorld();
        body.LeaveWorld();
        population.Bodies.Remove(body);
        body.IsRemoved = true;
        body.UnsetParent();
        body.UnparentChildren();
        if (ReferenceEquals(Player, body)) Player = null;
    }

    /// <summary>
    /// The movement side of a body that was made with motions; also of one that got an interpreter by being ordered somewhere.
    /// </summary>
    /// <returns>Null for a body that has no motions.</returns>
    /// <exception cref="ArgumentException">The body belongs to another engine.</exception>
    public MovementManager? MovementOf(PhysicsBody body)
    {
        population.ThrowIfForeign(body);
        return SteeredPhysicsBody.Of(body).Movement as MovementManager;
    }

    /// <summary>
    /// The movement side of a body. One that has none gets an empty one, without an interpreter, and wakes: messages about its motions do
    /// nothing.
    /// </summary>
    /// <param name="body">The body.</param>
    /// <param name="weenie">What the game knows of it.</param>
    /// <exception cref="ArgumentException">The body belongs to another engine.</exception>
    /// <remarks>Retail: CPhysicsObj::MakeMovementManager @0x00510270, as CPhysicsObj::unpack_movement @0x00512040 calls it.</remarks>
    public MovementManager MakeMovement(PhysicsBody body, IWeenieObj? weenie = null)
    {
        population.ThrowIfForeign(body);
        SteeredPhysicsBody steered = SteeredPhysicsBody.Of(body);
        if (steered.Movement is not MovementManager manager) steered.Attach(manager = new MovementManager(body, table: null, weenie));
        return manager;
    }

    /// <summary>The body with this id, or null.</summary>
    public PhysicsBody? Find(uint id) => population.Find(id);

    /// <summary>
    /// Brings every body, then the parts of animated statics, to <paramref name="now"/>. Less than 1/30 s after the last tick nothing
    /// happens and the time is not lost: finer quanta would change how bodies fall.
    /// </summary>
    /// <param name="now">Seconds; a clock that starts anywhere and does not run backwards.</param>
    /// <returns>True when bodies were updated.</returns>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    /// <remarks>Retail: CPhysics::UseTime @0x00509950.</remarks>
    public bool Tick(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        population.Now = now;
        double elapsed = now - lastUpdate;
        if (elapsed < 0)
        {
            lastUpdate = now;
            return false;
        }

        if (elapsed < PhysicsBody.MinQuantum) return false;
        foreach (PhysicsBody body in population.Bodies) body.UpdateObject(now);
        lastUpdate = now;
        statics.Animate(now);
        return true;
    }

    /// <summary>
    /// Where a body of this shape would end that wants to go from one place to another in one quantum, standing where it begins when it
    /// touches the ground there: a <see cref="WorldQuery.Sweep(in SweepInput, TraceBuffer)"/> by the engine's own query. Nothing in the
    /// world changes. Threads that ask at once have a query each.
    /// </summary>
    /// <param name="setup">Shape of the body.</param>
    /// <param name="from">Begin.</param>
    /// <param name="to">End wanted.</param>
    /// <param name="state">Physics state word of the body.</param>
    /// <param name="weenie">What kind of body.</param>
    /// <exception cref="ArgumentException">
    /// A position is not finite, an id cannot name a cell, or the shape cannot move.
    /// </exception>
    public SweepResult Resolve(
        SetupAsset setup, in Position from, in Position to, PhysicsState state = PhysicsState.Default,
        WeenieTraits weenie = WeenieTraits.None) =>
        (own ??= new WorldQuery(population, population.Transitions)).Sweep(new SweepInput(Mover.OfBody(setup, state, weenie), from, to));

    /// <summary>Work objects for one more thread that asks about this world.</summary>
    public WorldQuery CreateQuery() => new(population, new TransitionPool(population.Cells));

    /// <summary>Bodies whose cell came with a landblock enter the world again, and its animated statics begin to move.</summary>
    /// <param name="block">The landblock.</param>
    void ILoadListener.OnLandblockLoaded(Landblock block)
    {
        statics.Add(block, Cells, Now);
        foreach (PhysicsBody body in population.Bodies)
            if (body.IsLost && CellIds.BlockOf(body.Position.CellId) == block.Id) body.ReenterVisibility();
    }

    /// <summary>Bodies in a landblock that goes away wait for it. To be called before it does.</summary>
    /// <param name="blockId">The landblock, 0xXXYY0000.</param>
    void ILoadListener.OnLandblockUnloading(uint blockId)
    {
        statics.Remove(blockId);
        foreach (PhysicsBody body in population.Bodies)
            if (body.Cell is not null && body.Parent is null && CellIds.BlockOf(body.Position.CellId) == blockId) body.LeaveVisibility();
    }

    /// <summary>A hash of the state of every body and every animated static, equal wherever the same inputs were given.</summary>
    public ulong HashState()
    {
        StateHash hash = new();
        population.AddTo(ref hash);
        statics.AddTo(ref hash);
        return hash.Value;
    }

    private static PhysicsWorld MakeWorld(PhysicsDataCache assets, PhysicsEngineOptions options)
    {
        ArgumentNullException.ThrowIfNull(assets);
        return new PhysicsWorld(assets, options.Region) { StrictLoading = options.StrictLoading };
    }
}

/// <summary>Rules of a <see cref="PhysicsEngine"/> that hold from the beginning.</summary>
public sealed record PhysicsEngineOptions
{
    /// <summary>Seed of scattered placements; part of the state.</summary>
    public ulong Seed { get; init; } = 1;

    /// <summary>The region; read from the files when not given. May be shared with other engines.</summary>
    public RegionAsset? Region { get; init; }

    /// <summary>
    /// Off, the usual case: what is missing or wrong in the files costs only the thing it belongs to, which
    /// <see cref="PhysicsWorld.LeftOut"/> then lists. On, for those who write worlds: a landblock with a fault does not load, and loading
    /// it throws. Retail's own omissions (buildings, objects and scenes whose own record is in no file) are no fault; they are listed
    /// either way.
    /// </summary>
    public bool StrictLoading { get; init; }
}

/// <summary>What moves a body by itself.</summary>
/// <param name="Table">
/// Its motions; null for a body that has none of its own: it gets an interpreter when it is first ordered somewhere.
/// </param>
/// <param name="Weenie">What the game knows of it; null counts as a creature with run rate 1.</param>
public sealed record BodyMotions(MotionTableAsset? Table, IWeenieObj? Weenie = null);
