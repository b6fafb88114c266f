using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using static Surefoot.Physics.Tests.World.HostileWorldTests;
using EnvCell = Surefoot.Dats.Records.EnvCell;
using MemorySource = Surefoot.Physics.Tests.Assets.MemorySource;

namespace Surefoot.Physics.Tests.World;

/// <summary>What is missing or wrong in the files costs only itself, and the world lists it.</summary>
public sealed class LeftOutTests
{
    private const uint SecondRoom = Room + 1, ThirdRoom = Room + 2, BadMesh = 0x01000002, Hollow = 0x02000002, Scene = 0x12000001,
        Absent = 0x02000099;

    [Fact]
    [Behaviour("world.left-out.nothing", "spec/07, 9.1: the control of the tests beside it")]
    public void A_sound_block_leaves_nothing_out()
    {
        PhysicsWorld world = new Records().World();
        Assert.True(world.LoadLandblock(Block));
        Assert.Empty(world.LeftOut);
        Assert.Equal((0, 0), (world.LeftOut.Total, world.LeftOut.Unlisted));
    }

    [Fact]
    [Behaviour("world.left-out.block.missing-info", "spec/05, 4.7; spec/07, 9.1")]
    public void A_block_whose_promised_info_record_is_missing_does_not_load_and_is_listed()
    {
        LeftOutItem item = OnlyOne(new Records { [Info] = null }, loads: false);
        Assert.Equal((LeftOutKind.Landblock, Block, 1), (item.Kind, item.Id, item.Count));
        Assert.Equal("LandBlockInfo 0xA9B4FFFE is not in the dat files; record 0xA9B4FFFF asks for it", item.Reason);
    }

    [Fact]
    [Behaviour("world.left-out.block.room-count", "spec/07, 7.13, 9.1")]
    public void A_block_that_promises_more_rooms_than_it_can_have_is_listed_with_the_place_of_the_count()
    {
        LeftOutItem item = OnlyOne(new Records { [Info] = new LandBlockInfo { Id = Info, CellCount = 0xFFFFFFFF } }, loads: false);
        Assert.Equal((LeftOutKind.Landblock, Block, 4), (item.Kind, item.Id, item.Offset));
        Assert.Contains("record 0xA9B4FFFE: 4294967295 rooms", item.Reason, StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("world.left-out.block.fails-alone", "spec/07, 9.1")]
    public void A_block_that_cannot_be_read_keeps_no_other_away()
    {
        MemorySource source = new();
        uint[] blocks =
            [0xA8B30000, 0xA8B40000, 0xA8B50000, 0xA9B30000, 0xA9B40000, 0xA9B50000, 0xAAB30000, 0xAAB40000, 0xAAB50000];
        foreach (uint id in blocks)
            source.Add(new LandBlock { Id = id | 0xFFFF, Terrain = [.. new ushort[81]], Heights = [.. new byte[81]] });
        source.Add(0xA8B4FFFF, 0xFF, 0xFF, 0xB4, 0xA8, 0);
        PhysicsWorld world = new(new PhysicsDataCache(source), new RegionAsset([0f]));
        world.EnsureLoadedAround(new Position(0xA9B40001, default), 1);
        Assert.Equal(blocks.Where(id => id != 0xA8B40000), world.Landblocks.Select(block => block.Id));
        LeftOutItem item = Assert.Single(world.LeftOut);
        Assert.Equal((LeftOutKind.Landblock, 0xA8B4FFFF, 4), (item.Kind, item.Id, item.Offset));

        PhysicsWorld strict = new(new PhysicsDataCache(source), new RegionAsset([0f])) { StrictLoading = true };
        Assert.Throws<DatFormatException>(() => strict.EnsureLoadedAround(new Position(0xA9B40001, default), 1));
    }

    [Theory]
    [Behaviour("world.left-out.room", "spec/05, 7.5; spec/07, 9.1")]
    [InlineData("missing", "EnvCell 0xA9B40101 is not in the dat files; record 0xA9B4FFFE asks for it")]
    [InlineData("environment", "Environment 0x0D000009 is not in the dat files")]
    [InlineData("structure", "structure 7 of environment 0x0D000001 does not exist")]
    [InlineData("portal", "portal 0 names polygon 99, which is no portal of its structure")]
    [InlineData("frame", "the room has a frame that is not finite")]
    public void A_bad_room_leaves_the_other_rooms_of_its_block(string fault, string reason)
    {
        EnvCell? bad = fault switch
        {
            "environment" => RoomAt(SecondRoom, environment: 0x0D000009),
            "structure" => RoomAt(SecondRoom, structure: 7),
            "portal" => RoomAt(SecondRoom, portals: [new CellPortal(PortalFlags.Outside, 99, 0, 0)]),
            "frame" => RoomAt(SecondRoom, frame: new DatFrame(new Vector3(float.PositiveInfinity, 0, 0), Quaternion.Identity)),
            _ => null,
        };
        PhysicsWorld world = new Records
        {
            [Info] = new LandBlockInfo { Id = Info, CellCount = 3, Objects = [At(Thing, 10)] },
            [SecondRoom] = bad,
            [ThirdRoom] = RoomAt(ThirdRoom, things: At(Thing, 5)),
        }.World();
        Assert.True(world.LoadLandblock(Block));
        Landblock block = world.FindLandblock(Block)!;
        Assert.Equal([Room, ThirdRoom], block.Rooms.ToArray().Select(room => room.Id));
        Assert.Same(block.Rooms[0], world.GetVisible(Room));
        Assert.Null(world.GetVisible(SecondRoom));
        Assert.Same(block.Rooms[1], world.GetVisible(ThirdRoom));
        Assert.Null(world.GetVisible(ThirdRoom + 1));
        Assert.Equal(2, block.StaticObjects.Count);
        Assert.Equal([new LeftOutItem(LeftOutKind.Room, SecondRoom, reason) { FirstIn = Info }], world.LeftOut);
    }

    [Fact]
    [Behaviour("world.left-out.room.missing-in-a-row", "spec/07, 9.1; design.md, decision 7")]
    public void Rooms_that_are_missing_in_a_row_are_one_item_with_their_number()
    {
        PhysicsWorld world = new Records
        {
            [Info] = new LandBlockInfo { Id = Info, CellCount = 0x8000 },
            [Room + 5] = RoomAt(Room + 5),
        }.World();
        Assert.True(world.LoadLandblock(Block));
        Assert.Equal([(SecondRoom, 4), (Room + 6, 0x8000 - 6)], world.LeftOut.Select(item => (item.Id, item.Count)));
        Assert.EndsWith("asks for it, nor for the 3 after it", world.LeftOut[0].Reason, StringComparison.Ordinal);
        Assert.Equal(0x8000 - 2, world.LeftOut.Total);
    }

    [Theory]
    [Behaviour("world.left-out.static", "spec/07, 9.1; spec/06, 2")]
    [InlineData(Absent, "Setup 0x02000099 is not in the dat files")]
    [InlineData(Hollow, "GfxObj 0x01000099 is not in the dat files; record 0x02000002 asks for it")]
    [InlineData(BadMesh, "the record ends here")]
    public void Statics_whose_setup_or_mesh_is_missing_or_unreadable_are_left_out_wherever_they_stand(uint model, string reason)
    {
        PhysicsWorld world = DamagedTown(model).World(SceneryOnOneVertex);
        Assert.True(world.LoadLandblock(Block));
        Landblock block = world.FindLandblock(Block)!;
        Assert.Equal([Thing, Thing, Thing], block.StaticObjects.Select(item => item.Setup!.Id));
        Assert.Equal(Thing, Assert.Single(block.Buildings).Shell.Setup!.Id);
        Assert.Equal(
            [(LeftOutKind.Building, 1), (LeftOutKind.Object, 3), (LeftOutKind.Scenery, 1)],
            world.LeftOut.Select(item => (item.Kind, item.Count)));
        Assert.All(world.LeftOut, item => Assert.Equal(model, item.Id));
        Assert.All(world.LeftOut, item => Assert.Contains(reason, item.Reason, StringComparison.Ordinal));
        Assert.Equal([Info, Info, Scene], world.LeftOut.Select(item => item.FirstIn));
    }

    [Theory]
    [Behaviour("world.strict.static", "spec/07, 9.1; spec/05, 4.7")]
    [InlineData(Absent, true)]
    [InlineData(Hollow, false)]
    [InlineData(BadMesh, false)]
    public void Strict_loading_does_without_what_retail_does_without_and_lists_it(uint model, bool loads)
    {
        PhysicsWorld world = DamagedTown(model).World(SceneryOnOneVertex, strict: true);
        if (loads)
        {
            Assert.True(world.LoadLandblock(Block));
            Assert.Equal(5, world.LeftOut.Total);
            return;
        }

        Exception error = Assert.ThrowsAny<Exception>(() => world.LoadLandblock(Block));
        Assert.True(error is DatFormatException or DatRecordMissingException);
        Assert.Empty(world.Landblocks);
    }

    [Fact]
    [Behaviour("world.left-out.scene", "spec/05, 4.8; spec/07, 9.1")]
    public void A_scene_that_is_missing_or_unreadable_is_left_out()
    {
        PhysicsWorld missing = Wooded([]).World(SceneryOnOneVertex);
        Assert.True(missing.LoadLandblock(Block));
        LeftOutItem item = Assert.Single(missing.LeftOut);
        Assert.Equal((LeftOutKind.Scene, Scene, Block, "Scene 0x12000001 is not in the dat files"),
            (item.Kind, item.Id, item.FirstIn, item.Reason));

        MemorySource source = new();
        source.Add(new LandBlock { Id = Block, Terrain = [.. OneWooded], Heights = [.. new byte[81]] }).Add(Scene, 1, 0, 0, 0x12, 9);
        PhysicsWorld unreadable = new(new PhysicsDataCache(source), new RegionAsset(SceneryOnOneVertex, source));
        Assert.True(unreadable.LoadLandblock(Block));
        item = Assert.Single(unreadable.LeftOut);
        Assert.Equal((LeftOutKind.Scene, Scene, 4), (item.Kind, item.Id, item.Offset));
        PhysicsWorld strict = new(new PhysicsDataCache(source), new RegionAsset(SceneryOnOneVertex, source)) { StrictLoading = true };
        Assert.Throws<DatFormatException>(() => strict.LoadLandblock(Block));
    }

    [Theory]
    [Behaviour("world.left-out.scenery-without-a-size", "spec/05, 4.8; spec/07, 9.1")]
    [InlineData(0, 0, 0)]
    [InlineData(1, float.PositiveInfinity, 0)]
    [InlineData(1, 1, float.PositiveInfinity)]
    public void Scenery_without_a_size_or_a_heading_is_left_out(float least, float most, float turn)
    {
        SceneObject thing = Everywhere(Thing) with { MinScale = least, MaxScale = most, MaxRotation = turn };
        PhysicsWorld world = Wooded([thing, Everywhere(Thing)]).World(SceneryOnOneVertex);
        Assert.True(world.LoadLandblock(Block));
        Assert.Single(world.FindLandblock(Block)!.StaticObjects);
        LeftOutItem item = Assert.Single(world.LeftOut);
        Assert.Equal((LeftOutKind.Scenery, Thing, Scene), (item.Kind, item.Id, item.FirstIn));
        Assert.StartsWith("record 0x12000001: object 0 ", item.Reason, StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("world.left-out.counted-once", "spec/07, 9.1")]
    public void A_block_that_is_loaded_again_or_tried_again_is_counted_once()
    {
        PhysicsWorld world = DamagedTown(Hollow).World(SceneryOnOneVertex);
        for (int i = 0; i < 3; i++)
        {
            Assert.True(world.LoadLandblock(Block));
            Assert.True(world.UnloadLandblock(Block));
        }

        Assert.Equal(5, world.LeftOut.Total);
        PhysicsWorld failing = new Records { [Info] = null }.World();
        for (int i = 0; i < 3; i++) Assert.False(failing.LoadLandblock(Block));
        Assert.Equal(1, failing.LeftOut.Total);
    }

    [Fact]
    [Behaviour("world.left-out.model-read-once", "design.md, decision 7")]
    public void A_model_that_cannot_be_used_is_read_once_however_many_things_name_it()
    {
        MemorySource source = new();
        source.Add(new LandBlock { Id = Block, InfoFlag = 1, Terrain = [.. new ushort[81]], Heights = [.. new byte[81]] });
        source.Add(new LandBlockInfo { Id = Info, Objects = [.. Enumerable.Range(0, 1000).Select(i => At(BadMesh, 1 + (i % 190)))] });
        source.Add(BadMesh, 2, 0, 0, 1, 9);
        PhysicsWorld world = new(new PhysicsDataCache(source), new RegionAsset([0f]));
        Assert.True(world.LoadLandblock(Block));
        Assert.Equal((1000, 3), (Assert.Single(world.LeftOut).Count, source.Reads));
    }

    /// <summary>
    /// One building, two objects outdoors, one in a room and one of a scene with this model, and of all but the room's a sound one beside
    /// it.
    /// </summary>
    private static Records DamagedTown(uint model) => new()
    {
        [BadMesh] = new RawRecord(DatRecordType.GfxObj) { Id = BadMesh, Bytes = [2, 0, 0, 1, 9] },
        [Block] = new LandBlock { Id = Block, InfoFlag = 1, Terrain = [.. OneWooded], Heights = [.. new byte[81]] },
        [Info] = new LandBlockInfo
        {
            Id = Info,
            CellCount = 1,
            Objects = [At(model, 10), At(Thing, 10), At(model, 150)],
            Buildings = [new Building(model, At(0, 60).Frame, 0, []), new Building(Thing, At(0, 90).Frame, 0, [])],
        },
        [Room] = RoomAt(Room, things: [At(model, 5), At(Thing, 5)]),
        [Hollow] = new Setup { Id = Hollow, PartIds = [0x01000099] },
        [Scene] = new Scene { Id = Scene, Objects = [Everywhere(model), Everywhere(Thing)] },
    };

    private static Records Wooded(params SceneObject[] objects) => new()
    {
        [Block] = new LandBlock { Id = Block, Terrain = [.. OneWooded], Heights = [.. new byte[81]] },
        [Scene] = objects.Length == 0 ? null : new Scene { Id = Scene, Objects = [.. objects] },
    };

    /// <summary>Bare ground but for one vertex in the middle, which is of type 1.</summary>
    private static ushort[] OneWooded => [.. Enumerable.Range(0, 81).Select(k => (ushort)(k == 40 ? 1 << 2 : 0))];

    private static Region SceneryOnOneVertex { get; } = new()
    {
        Id = DatIds.Region,
        HeightTable = [.. new float[256]],
        SceneTypes = [new SceneType(SceneType.NoSound, [Scene])],
        TerrainTypes = [new TerrainType("bare", default, []), new TerrainType("wood", default, [0])],
    };

    /// <summary>Stands on every vertex that the scene comes to.</summary>
    private static SceneObject Everywhere(uint model) =>
        new() { ObjectId = model, BaseFrame = DatFrame.Identity, Frequency = 2, MinScale = 1, MaxScale = 1, MaxSlope = 2 };

    private static EnvCell RoomAt(
        uint id, ushort structure = 0, uint environment = Shapes, DatFrame? frame = null, CellPortal[]? portals = null,
        params Dats.Records.StaticObject[] things) => new()
        {
            Id = id,
            CellId = id,
            EnvironmentId = environment,
            Structure = structure,
            Position = frame ?? DatFrame.Identity,
            Portals = [.. portals ?? []],
            Flags = things.Length > 0 ? EnvCellFlags.HasStaticObjects : 0,
            StaticObjects = [.. things],
        };

    private static LeftOutItem OnlyOne(Records records, bool loads)
    {
        PhysicsWorld world = records.World();
        Assert.Equal(loads, world.LoadLandblock(Block));
        return Assert.Single(world.LeftOut);
    }
}
