using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.World;
using BuildingPortal = Surefoot.Dats.Records.BuildingPortal;
using EnvCell = Surefoot.Dats.Records.EnvCell;
using StaticObject = Surefoot.Dats.Records.StaticObject;

namespace Surefoot.Physics.Tests.World;

/// <summary>
/// Landblocks whose records promise what is not there: loaded strictly each is refused, naming the culprit. <see cref="LeftOutTests"/> has
/// the usual way.
/// </summary>
public sealed class HostileWorldTests
{
    internal const uint Block =
        0xA9B4FFFF, Info = 0xA9B4FFFE, Room = 0xA9B40100, Shapes = 0x0D000001, Mesh = 0x01000001, Thing = 0x02000001;

    [Fact]
    [Behaviour("world.hostile.none", "spec/05, 4.7")]
    public void A_complete_block_loads()
    {
        PhysicsWorld world = new Records().World();
        Assert.True(world.LoadLandblock(Block));
        Assert.NotNull(world.GetVisible(Room));
    }

    [Fact]
    [Behaviour("world.strict.missing-info", "spec/05, 4.7")]
    public void Strict_loading_names_a_promised_info_record_that_is_missing() =>
        Fails<DatRecordMissingException>(new Records { [Info] = null }, Info);

    [Fact]
    [Behaviour("world.strict.missing-room", "spec/07, 7.13")]
    public void Strict_loading_names_a_promised_room_that_is_missing() =>
        Fails<DatRecordMissingException>(new Records { [Room] = null }, Room);

    [Fact]
    [Behaviour("world.strict.room-count", "spec/07, 7.13")]
    public void Strict_loading_refuses_more_rooms_than_a_block_can_have() =>
        Fails<DatFormatException>(new Records { [Info] = new LandBlockInfo { Id = Info, CellCount = 0xFFFFFFFF } }, Info);

    [Fact]
    [Behaviour("world.strict.missing-environment", "spec/07, 9.1; spec/05, 7.5")]
    public void Strict_loading_names_the_environment_that_a_room_lacks() =>
        Fails<DatRecordMissingException>(new Records { [Shapes] = null }, Shapes);

    [Fact]
    [Behaviour("world.strict.missing-structure", "spec/07, 9.1; spec/05, 7.5")]
    public void Strict_loading_names_a_room_of_a_structure_that_does_not_exist() =>
        Fails<DatFormatException>(new Records { [Room] = RoomRecord(structure: 7) }, Room);

    [Fact]
    [Behaviour("world.strict.missing-portal-polygon", "spec/07, 9.1; spec/05, 7.5")]
    public void Strict_loading_names_a_room_whose_portal_has_no_polygon() =>
        Fails<DatFormatException>(new Records { [Room] = RoomRecord(portals: new CellPortal(PortalFlags.Outside, 99, 0, 0)) }, Room);

    [Fact]
    [Behaviour("world.strict.bad-frame", "spec/07, 2")]
    public void Strict_loading_names_a_room_that_is_nowhere() => Fails<DatFormatException>(
        new Records { [Room] = RoomRecord(frame: new DatFrame(new Vector3(float.NaN, 0, 0), Quaternion.Identity)) }, Room);

    [Fact]
    [Behaviour("world.hostile.objects", "spec/05, 4.7")]
    public void Objects_without_a_record_or_off_the_block_are_left_out()
    {
        PhysicsWorld world = new Records
        {
            [Info] = new LandBlockInfo
            {
                Id = Info,
                CellCount = 1,
                Objects = [At(0x02000099, 10), At(Thing, 10), At(Thing, -10), At(Thing, 1e30f), At(0, 10)],
                Buildings =
                [
                    new Building(0x02000099, At(0, 30).Frame, 0, []),
                    new Building(Thing, At(0, 30).Frame, 0,
                        [new BuildingPortal(PortalFlags.None, 0x777, 3, []), new BuildingPortal(PortalFlags.None, 0x100, 0xFFFF, [])]),
                    new Building(Thing, At(0, 31).Frame, 0, []),
                ],
            },
        }.World();
        Assert.True(world.LoadLandblock(Block));
        Landblock block = world.FindLandblock(Block)!;
        Assert.Single(block.StaticObjects);
        Assert.Equal(2, block.Buildings.Count);
        Assert.Same(block.Buildings[0], ((LandCell)world.GetVisible(0xA9B40009)!).Building);

        // Its portals lead nowhere, and nobody enters.
        ObjCell? home = null;
        CellArray array = new();
        world.FindCellList(array, new Position(0xA9B40009, Vector3.Zero), CellListTests.Spheres("30 12 0", 0.5f), true, ref home);
        Assert.Equal("A9B40009", CellListTests.Ids(array));
    }

    [Fact]
    [Behaviour("world.hostile.huge-object", "spec/05, 4.10")]
    public void An_object_of_many_kilometres_is_listed_near_by_only()
    {
        GfxObj mesh = new()
        {
            Id = Mesh,
            Vertices = new DatVertexArray([Vertex(0, -1e30f), Vertex(1, 1e30f)]),
        };
        PhysicsWorld world = new Records { [Mesh] = mesh, [Info] = new LandBlockInfo { Id = Info, Objects = [At(Mesh, 10)] } }.World();
        Assert.True(world.LoadLandblock(Block));
        Assert.InRange(world.FindLandblock(Block)!.StaticObjects[0].ShadowCount, 64, 65 * 65);
    }

    [Fact]
    [Behaviour("world.hostile.crowded-cell", "spec/05, 4.17")]
    public void Ten_thousand_objects_in_one_cell_load()
    {
        PhysicsWorld world = new Records
        {
            [Info] = new LandBlockInfo { Id = Info, Objects = [.. Enumerable.Range(0, 10_000).Select(i => At(Thing, 1 + (i * 0.001f)))] },
        }.World();
        Assert.True(world.LoadLandblock(Block));
        Assert.Equal(10_000, world.GetVisible(0xA9B40001)!.ShadowCount);
        Assert.True(world.UnloadLandblock(Block));
    }

    private static void Fails<T>(Records records, uint culprit)
        where T : Exception
    {
        PhysicsWorld world = records.World(strict: true);
        T error = Assert.Throws<T>(() => world.LoadLandblock(Block));
        Assert.Contains($"{culprit:X8}", error.Message, StringComparison.Ordinal);
        Assert.Empty(world.Landblocks);
        Assert.Null(world.GetVisible(0xA9B40001));
        Assert.Empty(world.LeftOut);
    }

    private static DatVertex Vertex(ushort key, float at) => new(key, new Vector3(at), Vector3.UnitZ);

    internal static StaticObject At(uint id, float x) => new(id, new DatFrame(new Vector3(x, 12, 0), Quaternion.Identity));

    internal static EnvCell RoomRecord(ushort structure = 0, DatFrame? frame = null, params ImmutableArray<CellPortal> portals) => new()
    {
        Id = Room,
        CellId = Room,
        EnvironmentId = Shapes,
        Structure = structure,
        Position = frame ?? DatFrame.Identity,
        Portals = portals,
    };

    /// <summary>A flat block with one room and one thing, some of its records replaced or taken away.</summary>
    internal sealed class Records
    {
        private readonly Dictionary<uint, DatRecord> records = [];

        public Records()
        {
            this[Block] = new LandBlock { Id = Block, InfoFlag = 1, Terrain = [.. new ushort[81]], Heights = [.. new byte[81]] };
            this[Info] = new LandBlockInfo { Id = Info, CellCount = 1 };
            this[Room] = RoomRecord();
            this[Shapes] = new CellEnvironment
            {
                Id = Shapes,
                Cells = [new CellStruct { CellTree = BspTree.OfLeaf(new BspNode()), PhysicsTree = BspTree.OfLeaf(new BspNode()) }],
            };
            this[Thing] = new Setup { Id = Thing, CylSpheres = [new DatCylSphere(Vector3.Zero, 0.5f, 2)] };
        }

        public DatRecord? this[uint id]
        {
            set
            {
                if (value is null) records.Remove(id);
                else records[id] = value;
            }
        }

        public PhysicsWorld World(Region? region = null, bool strict = false)
        {
            MemorySource source = new MemorySource().Add([.. records.Values]);
            RegionAsset land = region is null ? new RegionAsset([0f]) : new RegionAsset(region, source);
            return new PhysicsWorld(new PhysicsDataCache(source), land) { StrictLoading = strict };
        }
    }
}
