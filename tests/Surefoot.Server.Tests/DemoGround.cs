using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Server.Tests;

/// <summary>The demo world's files, written once and read by all tests that need ground.</summary>
public sealed class DemoGround : IDisposable
{
    internal const uint HumanSetup = 0x02000001;
    private const uint HumanMotions = 0x09000001;
    private readonly string folder = Directory.CreateTempSubdirectory("surefoot-ground-").FullName;
    private readonly DatSet dats;

    public DemoGround()
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

    internal SetupAsset Human => Cache.GetSetup(HumanSetup);

    /// <summary>A place by name, metres to its right and ahead of it.</summary>
    internal static Position At(string name, float right = 0, float ahead = 0, float up = 0)
    {
        Assert.True(DemoPlaces.TryFind(name, out NamedPlace place));
        Frame frame = new(place.Origin, place.Orientation);
        frame.Origin = frame.LocalToGlobal(new Vector3(right, ahead, up));
        Position position = new(place.CellId, frame);
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        return position;
    }

    /// <summary>An engine whose world is loaded around a place.</summary>
    internal PhysicsEngine EngineAt(string name)
    {
        PhysicsEngine engine = new(Cache, new PhysicsEngineOptions { Region = Region });
        engine.World.EnsureLoadedAround(At(name), 1);
        return engine;
    }

    /// <summary>Somebody with a human's shape and motions.</summary>
    internal PhysicsBody Spawn(PhysicsEngine engine, uint id, in Position place)
    {
        PhysicsBody body = engine.CreateBody(
            id, Human, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature,
            motions: new BodyMotions(Motions, new OtherWeenie()));
        Assert.True(body.EnterWorld(place));
        return body;
    }

    /// <summary>The door that the demo world has spawned, shut.</summary>
    internal PhysicsBody SpawnDoor(PhysicsEngine engine, uint id)
    {
        DemoSpawn door = DemoSpawns.All.Single(spawn => spawn.Kind == DemoSpawnKind.Door);
        PhysicsBody body = engine.CreateBody(id, Cache.GetSetup(door.SetupId), PhysicsState.ReportCollisions, WeenieTraits.Present);
        Assert.True(body.EnterWorld(new Position(door.CellId, new Frame(door.Origin, door.Orientation))));
        return body;
    }

    public void Dispose()
    {
        dats.Dispose();
        Directory.Delete(folder, recursive: true);
    }
}
