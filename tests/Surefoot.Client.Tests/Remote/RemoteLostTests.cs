using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Objects whose cell is not loaded, in the demo world with its own files: specification 09, 5.10.</summary>
public sealed class RemoteLostTests : IClassFixture<DemoFiles>
{
    private const uint Sword = 0x90000001;

    private readonly PhysicsWorld world;
    private readonly WirePosition place;
    private readonly uint block;
    private RemoteFixture f;

    public RemoteLostTests(DemoFiles files)
    {
        Assert.True(DemoPlaces.TryFind("meadow", out NamedPlace meadow));
        place = new WirePosition(meadow.CellId, meadow.Origin, meadow.Orientation);
        block = CellIds.BlockOf(meadow.CellId);
        PhysicsEngine engine = new(files.Cache);
        world = engine.World;
        world.LoadLandblock(block);
        f = new RemoteFixture(engine: engine, assets: new DatObjectAssets(files.Cache, world.LeftOut));
    }

    [Fact]
    [Behaviour("remote.lost.timer", "spec/09, 5.10; GotoLostCell @0x00508210")]
    public void An_object_whose_land_goes_is_forgotten_25_seconds_later()
    {
        Create();
        f.FramesUntil(10);
        world.UnloadLandblock(block);
        Assert.True(f.Body.IsLost);
        double gone = f.Now;
        f.FramesUntil(gone + 25);
        Assert.NotNull(f.Remote.Find(One));
        f.Frames(1);
        Assert.Equal((null, null), (f.Remote.Find(One), f.Engine.Find(One)));
    }

    [Fact]
    [Behaviour("remote.lost.comes-back", "spec/09, 5.10: prepare_to_enter_world stops the timer")]
    public void An_object_whose_land_comes_back_stays()
    {
        Create();
        f.FramesUntil(10);
        world.UnloadLandblock(block);
        f.FramesUntil(30);
        world.LoadLandblock(block);
        Assert.False(f.Body.IsLost);
        f.FramesUntil(60);
        Assert.NotNull(f.Remote.Find(One));
    }

    [Fact]
    [Behaviour("remote.lost.created-there", "spec/09, 5.3, 5.8 and 5.10")]
    public void An_object_that_is_created_where_no_land_is_waits_25_seconds_and_again_after_each_place()
    {
        world.UnloadLandblock(block);
        Create();
        Assert.Equal((true, place.Cell), (f.Body.IsLost, f.Body.Position.CellId));
        f.FramesUntil(20);
        f.Say(new UpdatePosition(One, new PositionPack(place, true, 1, 1, 0, 0)));
        f.FramesUntil(44.9);
        Assert.NotNull(f.Remote.Find(One));
        f.FramesUntil(45.2);
        Assert.Null(f.Remote.Find(One));
    }

    [Fact]
    [Behaviour("remote.lost.with-what-it-holds", "spec/09, 5.10: self and direct children")]
    public void What_it_holds_is_forgotten_with_it()
    {
        f = new RemoteFixture(engine: f.Engine, assets: new StubAssets());
        Create();
        f.Create(Describe(Sword));
        f.Say(new ParentEvent(One, Sword, Hand, 0, 1, 1));
        f.FramesUntil(10);
        Assert.Same(f.Body.Cell, f.Remote.Find(Sword)!.Body.Cell);
        world.UnloadLandblock(block);
        f.FramesUntil(34.9);
        Assert.Equal(2, f.Remote.Objects.Count);
        f.FramesUntil(35.2);
        Assert.Empty(f.Remote.Objects);
    }

    [Fact]
    [Behaviour("remote.assets.from-dat-files", "spec/06; spec/01b")]
    public void Shapes_and_motions_come_from_the_dat_files_once_and_what_is_missing_is_no_error()
    {
        Assert.True(f.Assets.TryGetSetup(Human, out SetupAsset? setup));
        Assert.True(f.Assets.TryGetMotions(HumanTable, setup, out MotionTableAsset? table));
        Assert.True(f.Assets.TryGetMotions(HumanTable, setup, out MotionTableAsset? again));
        Assert.Same(table, again);
        foreach (uint id in (uint[])[0, 0x02FFFFFF, 0x01FFFFFF, HumanTable, 0xFFFFFFFF]) Assert.False(f.Assets.TryGetSetup(id, out _));
        foreach (uint id in (uint[])[0, 0x09FFFFFF, Human]) Assert.False(f.Assets.TryGetMotions(id, setup, out _));
        Create();
        f.Say(MotionOf(1, 1, Run()));
        Vector3 start = f.Origin;
        f.FramesUntil(3);
        Assert.InRange(Vector3.Distance(start, f.Origin), 8, 13);
    }

    private void Create()
    {
        ObjectDescription described = Describe(One);
        f.Create(described with { Physics = described.Physics with { Position = place } });
        f.Frames(2);
    }
}
