using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// Whom and what a server would spawn: guards, creatures that wander, a crowd, a door. They enter the world as anybody's bodies do, wait
/// where nothing is loaded and come with their landblocks. The same seed and the same times give the same places.
/// </summary>
internal sealed class Inhabitants
{
    /// <summary>Ids of inhabitants begin here; players' count from 1.</summary>
    public const uint FirstId = 0x80000001;

    /// <summary>How far a player reaches for a door, metres.</summary>
    public const float Reach = 4f;

    private const double OpenFor = 6;
    private const double RetryAfter = 1;

    private readonly PhysicsEngine engine;
    private readonly List<Inhabitant> all = [];
    private readonly Dictionary<uint, Inhabitant> byId = [];
    private double retryAt = double.NegativeInfinity;

    /// <summary>Makes the bodies and lets them enter; those whose landblock is not loaded wait for it.</summary>
    /// <param name="engine">The world.</param>
    /// <param name="cache">Where their shapes are.</param>
    /// <param name="spawns">Who and what.</param>
    /// <param name="seed">Of the ways that wanderers take.</param>
    /// <exception cref="DatRecordMissingException">A setup or a motion table is missing.</exception>
    /// <exception cref="DatFormatException">One of them is malformed.</exception>
    public Inhabitants(PhysicsEngine engine, PhysicsDataCache cache, IReadOnlyList<DemoSpawn> spawns, ulong seed)
    {
        this.engine = engine;
        Dictionary<(uint Id, bool WithParts), MotionTableAsset> tables = [];
        for (int i = 0; i < spawns.Count; i++)
        {
            SetupAsset setup = cache.GetSetup(spawns[i].SetupId);
            (uint Id, bool WithParts) key = (setup.DefaultMotionTableId, setup.HasPhysicsBsp);
            if (key.Id != 0 && !tables.ContainsKey(key)) tables[key] = MotionTableLoader.Load(cache.Source, key.Id, key.WithParts);
            Inhabitant one = new(engine, FirstId + (uint)i, spawns[i], setup, tables.GetValueOrDefault(key), seed + (ulong)i);
            all.Add(one);
            byId[one.Body.Id] = one;
            one.Body.EnterWorld(one.Home);
        }
    }

    /// <summary>All of them, in the order of their ids.</summary>
    public IReadOnlyList<Inhabitant> All => all;

    /// <summary>The one with this body, or null.</summary>
    public Inhabitant? Find(uint bodyId) => byId.GetValueOrDefault(bodyId);

    /// <summary>They decide what to do next; before the world's tick.</summary>
    /// <param name="now">Seconds.</param>
    public void Act(double now)
    {
        foreach (Inhabitant one in all)
        {
            one.Mind?.Act(now);
            if (now >= one.ClosesAt) Close(one);
        }

        if (now < retryAt) return;
        retryAt = now + RetryAfter;

        // One that found no room when its landblock came back waits for nothing: it goes home.
        foreach (Inhabitant one in all)
            if (one.Body is { HasCell: false, IsLost: false }) one.Body.EnterWorld(one.Home);
    }

    /// <summary>They look how that goes; after the world's tick.</summary>
    public void LookOn()
    {
        foreach (Inhabitant one in all) one.Mind?.LookOn();
    }

    /// <summary>A person wants a creature to do something. Nothing happens where there is no such creature.</summary>
    /// <param name="body">Id of its body.</param>
    /// <param name="wish">What it is to do.</param>
    /// <param name="player">Id of the person's player.</param>
    public void Ask(uint body, CreatureWish wish, uint player) => Find(body)?.Mind?.Ask(wish, player, engine.Now);

    /// <summary>Opens the nearest door within reach, or closes it again; true when there is one.</summary>
    /// <param name="from">Where the one is who reaches.</param>
    /// <param name="now">Seconds.</param>
    public bool UseDoor(in Position from, double now)
    {
        Inhabitant? nearest = null;
        double best = Reach;
        foreach (Inhabitant one in all)
        {
            if (one.Kind != BodyKind.Door || !one.Body.HasCell) continue;
            double distance = one.Body.Position.DistanceTo(from);
            if (distance > best) continue;
            best = distance;
            nearest = one;
        }

        if (nearest is null) return false;
        if (nearest.IsOpen)
        {
            Close(nearest);
        }
        else
        {
            nearest.Body.SetEthereal(true);
            nearest.ClosesAt = now + OpenFor;
        }

        return true;
    }

    /// <summary>
    /// A door that would catch somebody stays open until they are out: the body looks at each tick whether it may be solid again.
    /// </summary>
    private static void Close(Inhabitant door)
    {
        door.ClosesAt = double.PositiveInfinity;
        door.Body.SetEthereal(false);
    }
}

/// <summary>One of them.</summary>
internal sealed class Inhabitant
{
    /// <summary>How fast they run when they must, as a factor of their motions' own speed: as a player of some skill.</summary>
    private const float RunRate = 2f;

    public Inhabitant(PhysicsEngine engine, uint id, DemoSpawn spawn, SetupAsset setup, MotionTableAsset? table, ulong seed)
    {
        Name = spawn.Name;
        Kind = spawn.Kind switch
        {
            DemoSpawnKind.Guard => BodyKind.Guard,
            DemoSpawnKind.Wanderer => BodyKind.Wanderer,
            DemoSpawnKind.Crowd => BodyKind.Crowd,
            _ => BodyKind.Door,
        };
        Position home = new(spawn.CellId, spawn.Origin);
        home.Frame.SetHeading(spawn.Heading);
        Home = home;
        bool creature = Kind != BodyKind.Door;
        Body = engine.CreateBody(
            id, setup, creature ? PhysicsState.Default : PhysicsState.ReportCollisions,
            creature ? WeenieTraits.Present | WeenieTraits.Creature : WeenieTraits.Present,
            motions: creature ? new BodyMotions(table, new OtherWeenie()) : null);
        Size = ShapeSize.Of(setup, Body.Scale);
        if (!creature) return;
        Seen = new SeenCreature(Body, setup, spawn.Name);
        CreatureDriver driver = new(engine, Body, Seen, new CreatureDriverOptions { RunRate = RunRate, Stamps = Seen.Stamps });
        Mind = new CreatureMind(driver, home, Kind == BodyKind.Wanderer ? spawn.WanderRadius : 0, OnGround, seed);

        Position? OnGround(Position place)
        {
            if (!place.AdjustToOutside() || engine.World.FindLandblock(place.CellId) is not { } block) return null;
            Vector3 at = place.Frame.Origin;
            if (!block.Terrain.TryGetHeight(at.X, at.Y, out float height)) return null;
            place.Frame.Origin.Z = height;
            return place;
        }
    }

    /// <summary>Unique name.</summary>
    public string Name { get; }

    /// <summary>What it is.</summary>
    public BodyKind Kind { get; }

    /// <summary>Its body.</summary>
    public PhysicsBody Body { get; }

    /// <summary>Where it belongs.</summary>
    public Position Home { get; }

    /// <summary>Extent of its collision shape along its own axes, metres.</summary>
    public Vector3 Size { get; }

    /// <summary>Its wits; a door has none.</summary>
    public CreatureMind? Mind { get; }

    /// <summary>What pages are told of it; a door is shown as it is.</summary>
    public SeenCreature? Seen { get; }

    /// <summary>A door that lets everybody through.</summary>
    public bool IsOpen => Kind == BodyKind.Door && (Body.State & PhysicsState.Ethereal) != 0;

    /// <summary>When the open door closes by itself, seconds.</summary>
    public double ClosesAt { get; set; } = double.PositiveInfinity;
}
