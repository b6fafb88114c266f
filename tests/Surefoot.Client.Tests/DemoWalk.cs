using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Scenes;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

/// <summary>The demo world's files, written once and read by all who walk in it.</summary>
public sealed class DemoFiles : IDisposable
{
    private const uint HumanMotions = 0x09000001;
    private readonly string folder = Directory.CreateTempSubdirectory("surefoot-walk-").FullName;
    private readonly DatSet dats;

    public DemoFiles()
    {
        DemoWorldBuilder.Write(folder);
        dats = DatSet.Open(folder);
        Cache = new PhysicsDataCache(dats);
        Region = RegionAsset.Load(dats);
        Motions = MotionTableLoader.Load(dats, HumanMotions);
    }

    internal PhysicsDataCache Cache { get; }

    internal RegionAsset Region { get; }

    internal MotionTableAsset Motions { get; }

    /// <summary>An engine with a world of its own, of which nothing is loaded.</summary>
    internal PhysicsEngine CreateEngine() => new(Cache, new PhysicsEngineOptions { Region = Region });

    internal static Position PlaceOf(DemoSpawn spawn) => new(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation));

    /// <summary>The body of something to be spawned, not yet anywhere.</summary>
    internal PhysicsBody CreateBody(PhysicsEngine engine, uint id, DemoSpawn spawn)
    {
        bool door = spawn.Kind == DemoSpawnKind.Door;
        return engine.CreateBody(
            id, Cache.GetSetup(spawn.SetupId), door ? PhysicsState.ReportCollisions : PhysicsState.Default,
            door ? WeenieTraits.Present : WeenieTraits.Present | WeenieTraits.Creature);
    }

    public void Dispose()
    {
        dats.Dispose();
        Directory.Delete(folder, recursive: true);
    }
}

/// <summary>A player at a named place of the demo world, with a world that ticks 30 times a second.</summary>
internal sealed class DemoWalk
{
    private const uint PlayerId = 0x50000001, HumanSetup = 0x02000001;
    private readonly DemoFiles files;
    private readonly PhysicsEngine engine;
    private readonly PhysicsWorld world;
    private readonly Position placed;
    private int frames;

    /// <summary>A player near a place.</summary>
    /// <param name="files">The world.</param>
    /// <param name="place">Name of the place.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="eastward">Metres from the place to the east.</param>
    /// <param name="northward">Metres from the place to the north.</param>
    /// <param name="upward">Metres from the place upwards.</param>
    /// <param name="heading">Degrees clockwise from north; that of the place when null.</param>
    internal DemoWalk(
        DemoFiles files, string place, CharacterStats stats, float eastward = 0, float northward = 0, float upward = 0,
        float? heading = null)
    {
        this.files = files;
        Assert.True(DemoPlaces.TryFind(place, out NamedPlace named));
        engine = files.CreateEngine();
        world = engine.World;
        placed = new(named.CellId, new Frame(named.Origin, named.Orientation));
        Position position = new(named.CellId, new Frame(named.Origin + new Vector3(eastward, northward, upward), named.Orientation));
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        world.EnsureLoadedAround(position, 1);
        Player = LocalPlayer.Spawn(
            engine, PlayerId, files.Cache.GetSetup(HumanSetup), files.Motions, position, new LoopbackServer(PlayerId, stats, engine.Now),
            new LocalPlayerOptions { Observer = Sent })!;
        engine.Player = Player.Body;
        if (heading is { } degrees) Body.SetHeading(degrees);
        if (upward == 0) Hold(MovementKeys.None, 10);
        Start = Player.Body.Position;
        RestHeight = Start.Frame.Origin.Z;
    }

    internal PhysicsEngine Engine => engine;

    internal LocalPlayer Player { get; }

    internal Recorder Sent { get; } = new();

    internal Position Start { get; }

    /// <summary>Height at which the body stood at the beginning.</summary>
    internal float RestHeight { get; }

    internal PhysicsBody Body => Player.Body;

    internal Position Position => Body.Position;

    internal float Z => Body.Position.Frame.Origin.Z;

    internal double Now => frames * WalkFixture.FrameTime;

    /// <summary>Way from the start, metres.</summary>
    internal Vector3 Moved => Start.OffsetTo(Body.Position);

    /// <summary>Way from the named place, metres.</summary>
    internal Vector3 FromPlace => placed.OffsetTo(Body.Position);

    /// <summary>Holds keys for a number of frames.</summary>
    internal void Hold(MovementKeys keys, int count, Action? each = null)
    {
        for (int i = 0; i < count; i++)
        {
            frames++;
            world.EnsureLoadedAround(Position, 1);
            Player.Update(keys, Now);
            engine.Tick(Now);
            each?.Invoke();
        }
    }

    /// <summary>Turns at once, degrees clockwise from north.</summary>
    internal void Face(float heading) => Body.SetHeading(heading);

    /// <summary>Spawns what the demo world wants spawned, as a server would.</summary>
    internal List<PhysicsBody> Spawn(DemoSpawnKind kind)
    {
        List<PhysicsBody> spawned = [];
        foreach (DemoSpawn spawn in DemoSpawns.All.Where(spawn => spawn.Kind == kind))
        {
            PhysicsBody body = files.CreateBody(engine, 0x80000001 + (uint)spawned.Count, spawn);
            Assert.True(body.EnterWorld(DemoFiles.PlaceOf(spawn)), spawn.Name);
            spawned.Add(body);
        }

        return spawned;
    }

    /// <summary>Spawns humans before the player who run in circles, in rows of twenty.</summary>
    internal IReadOnlyList<PhysicsBody> SpawnRunners(int count, float spacing)
    {
        Position south = Start;
        south.Frame.Origin += new Vector3(0, 2 * spacing, 0);
        return Runners.Spawn(engine, files.Cache.GetSetup(HumanSetup), files.Motions, south, count, spacing);
    }

    /// <summary>A frame of the world without any keys.</summary>
    internal void Tick()
    {
        frames++;
        Assert.True(engine.Tick(Now));
    }
}
