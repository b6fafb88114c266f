using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

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
        Motions = MotionTableLoader.Load(dats, HumanMotions);
    }

    internal PhysicsDataCache Cache { get; }

    internal MotionTableAsset Motions { get; }

    public void Dispose()
    {
        dats.Dispose();
        Directory.Delete(folder, recursive: true);
    }
}

/// <summary>A player at a named place of the demo world, with a world that ticks 30 times a second.</summary>
internal sealed class DemoWalk
{
    private const uint HumanSetup = 0x02000001;
    private readonly PhysicsEngine engine;
    private readonly PhysicsWorld world;
    private int frames;

    internal DemoWalk(DemoFiles files, string place, CharacterStats stats, float eastward = 0, float northward = 0)
    {
        Assert.True(DemoPlaces.TryFind(place, out NamedPlace named));
        world = new PhysicsWorld(files.Cache);
        engine = new PhysicsEngine(world);
        Position position = new(named.CellId, new Frame(named.Origin + new Vector3(eastward, northward, 0), named.Orientation));
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        world.EnsureLoadedAround(position, 1);
        Player = LocalPlayer.Spawn(
            engine, 0x50000001, files.Cache.GetSetup(HumanSetup), files.Motions, position, stats, new LocalPlayerOptions { Observer = Sent })!;
        engine.Player = Player.Body;
        Hold(MovementKeys.None, 10);
        Start = Player.Body.Position;
        RestHeight = Start.Frame.Origin.Z;
    }

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
}
