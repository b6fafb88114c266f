using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using BuildingPortalRecord = Surefoot.Dats.Records.BuildingPortal;
using EnvCellRecord = Surefoot.Dats.Records.EnvCell;
using Frame = Surefoot.Physics.Geometry.Frame;
using StaticObject = Surefoot.Physics.World.StaticObject;
using StaticRecord = Surefoot.Dats.Records.StaticObject;

namespace Surefoot.Physics.Tests.World;

/// <summary>What becomes of the records of a block: specification 05, 2.5 and 4.7.</summary>
public sealed class BlockContentTests
{
    private const uint Thing = 0x02000001, Shapes = 0x0D000001, Room = 0xA9B40100, West = 0xA9B40000, East = 0xAAB40000;

    [Fact]
    [Behaviour("world.loading.portal-flags", "spec/05, 2.5: bit 1 clear is side 1, bit 2 opens to the outdoors, bit 0 takes no part")]
    public void Flags_of_a_portal_say_its_side_and_whether_it_leads_outdoors()
    {
        Landblock block = Block(new LandBlockInfo { Id = WorldRecords.Info, CellCount = 1 }, new EnvCellRecord
        {
            Id = Room,
            CellId = Room,
            Flags = EnvCellFlags.SeenOutside,
            EnvironmentId = Shapes,
            Position = DatFrame.Identity,
            Portals =
            [
                new CellPortal(PortalFlags.None, 5, 0x0123, 2),
                new CellPortal(PortalFlags.ExactMatch | PortalFlags.NormalPointsIn, 6, 0x0124, 0xFFFF),
                new CellPortal(PortalFlags.Outside, 5, 0x0125, 0),
            ],
            VisibleCells = [0x0101, 0x0177],
        });
        Surefoot.Physics.World.EnvCell room = block.Rooms[0];
        Assert.Equal([0xA9B40123u, 0xA9B40124u, PortalPlane.Outdoors], room.Portals.ToArray().Select(p => p.OtherCellId));
        Assert.Equal([true, false, true], room.Portals.ToArray().Select(p => p.NormalPointsOut));
        Assert.Equal([false, false, true], room.Portals.ToArray().Select(p => p.IsExit));
        Assert.Equal(-1, room.Portals[1].OtherPortal);
        Assert.Equal([0xA9B40101u, 0xA9B40177u], room.StabList.ToArray());
        Assert.True(room.SeenOutside);

        // The polygons are named by key: 5 is the floor, 6 the wall.
        Assert.Equal(Vector3.UnitZ, room.Portals[0].Plane.Normal);
        Assert.Equal(Vector3.UnitX, room.Portals[1].Plane.Normal);
    }

    [Fact]
    [Behaviour("world.portals.outdoors-by-flag-alone", "spec/05, 2.5")]
    public void A_portal_to_cell_FFFF_without_the_flag_leads_to_a_cell_that_never_exists()
    {
        PhysicsWorld world = Records(new LandBlockInfo { Id = WorldRecords.Info, CellCount = 1 }, new EnvCellRecord
        {
            Id = Room,
            CellId = Room,
            Flags = EnvCellFlags.SeenOutside,
            EnvironmentId = Shapes,
            Position = DatFrame.Identity,
            Portals = [new CellPortal(PortalFlags.ExactMatch, 5, 0xFFFF, 0)],
        }).World();
        Surefoot.Physics.World.EnvCell room = (Surefoot.Physics.World.EnvCell)world.GetVisible(Room)!;
        Assert.False(room.Portals[0].IsExit);

        // A sphere at the portal's plane reaches that cell, which nobody has, and not the land.
        CellArray reached = new();
        ObjCell? home = null;
        world.FindCellList(reached, new Position(Room, Vector3.Zero), [new Sphere(new Vector3(0.5f, 0.5f, 0), 0.1f)], false, ref home);
        Assert.Equal("A9B40100 A9B4FFFF", CellListTests.Ids(reached));
        Assert.Null(reached[1].Cell);
    }

    [Fact]
    [Behaviour("world.loading.buildings", "spec/05, 4.7, 3: the cell under the origin, the file's frame, the first of a cell")]
    public void A_building_belongs_to_the_cell_under_its_origin_and_the_first_of_a_cell_wins()
    {
        BuildingPortalRecord door = new(PortalFlags.NormalPointsIn, 0x0100, 3, []),
            closed = new(PortalFlags.None, 0x0101, 0xFFFF, [0x0100, 0x0101, 0x0102]);
        Landblock block = Block(new LandBlockInfo
        {
            Id = WorldRecords.Info,
            Buildings =
            [
                new Building(Thing, WorldRecords.At(-0.0001f, 191.99f, 3), 0, [door, closed]),
                new Building(Thing, WorldRecords.At(192, 10), 0, []),
                new Building(Thing, WorldRecords.At(10, -0.0003f), 0, []),
                new Building(Thing, WorldRecords.At(24, 24), 0, []),
                new Building(Thing, WorldRecords.At(47, 47), 0, [door]),
            ],
        });
        Assert.Equal([0xA9B40008u, 0xA9B4000Au, 0xA9B4000Au], block.Buildings.Select(b => b.Shell.Position.CellId));
        Assert.Equal(new Vector3(-0.0001f, 191.99f, 3), block.Buildings[0].Shell.Position.Frame.Origin);
        Assert.Same(block.Buildings[0], block.LandCells[7].Building);
        Assert.Same(block.Buildings[1], block.LandCells[9].Building);
        Assert.Equal(2, block.LandCells.ToArray().Count(c => c.Building is not null));
        Assert.Equal(
            [
                new Surefoot.Physics.World.BuildingPortal(0xA9B40100, 3),
                new Surefoot.Physics.World.BuildingPortal(0xA9B40101, -1)], block.Buildings[0].Portals.ToArray());
        // A shell is no object of a cell's list.
        Assert.Empty(block.StaticObjects);
        Assert.All(block.LandCells.ToArray(), cell => Assert.Equal(0, cell.ShadowCount));
    }

    [Fact]
    [Behaviour("world.loading.restrictions", "spec/05, 4.7, 5: entries of land cells of this block with a value other than 0")]
    public void The_restriction_table_guards_land_cells()
    {
        Landblock block = Block(new LandBlockInfo
        {
            Id = WorldRecords.Info,
            Flags = LandBlockInfoFlags.HasRestrictions,
            RestrictionBuckets = 8,
            Restrictions =
            [
                new CellRestriction(0xA9B40001, 0x70000001), new CellRestriction(0xA9B40002, 0),
                new CellRestriction(0xA9B50003, 0x70000002),
                new CellRestriction(0xA9B40040, 0x70000003), new CellRestriction(0xA9B40041, 0x70000004),
            ],
        });
        for (int i = 0; i < 64; i++)
            Assert.Equal(i switch { 0 => 0x70000001u, 63 => 0x70000003u, _ => 0u }, block.LandCells[i].RestrictionObject);
    }

    [Fact]
    [Behaviour("world.loading.order-of-statics",
        "spec/05, 4.7, 5 and 7: objects of the block in the file's order, then those of its rooms")]
    public void Statics_are_listed_in_the_order_in_which_retail_creates_them()
    {
        Landblock block = Block(
            new LandBlockInfo
            {
                Id = WorldRecords.Info,
                CellCount = 1,
                Objects = [new StaticRecord(Thing, WorldRecords.At(13, 12)), new StaticRecord(Thing, WorldRecords.At(11, 12)),
                    new StaticRecord(Thing, WorldRecords.At(12, 12))],
            },
            new EnvCellRecord
            {
                Id = Room,
                CellId = Room,
                Flags = EnvCellFlags.HasStaticObjects,
                EnvironmentId = Shapes,
                Position = DatFrame.Identity,
                StaticObjects = [new StaticRecord(0, DatFrame.Identity), new StaticRecord(Thing, WorldRecords.At(500, 1)),
                    new StaticRecord(Thing, WorldRecords.At(-9, 2))],
            });
        Assert.Equal([13f, 11, 12, 500, -9], block.StaticObjects.Select(o => o.Position.Frame.Origin.X));
        Assert.Equal([13f, 11, 12], LoadingTests.Listed(block.LandCells[0]).Select(o => o.Position.Frame.Origin.X));
        // Where a room's objects are does not matter: they are in the room that lists them.
        Assert.Equal([500f, -9], LoadingTests.Listed(block.Rooms[0]).Select(o => o.Position.Frame.Origin.X));
    }

    [Fact]
    [Behaviour("world.loading.part-over-the-border", "spec/05, 4.10, 4.11: what is loaded decides, not the order in which it was")]
    public void An_object_whose_first_part_is_over_the_next_block_reaches_the_same_cells_in_any_order_of_loading()
    {
        string[] lists = [.. new uint[][] { [West, East], [East, West] }.Select(order =>
        {
            PhysicsWorld world = new();
            StaticObject? item = null;
            foreach (uint id in order)
            {
                Landblock block = new(Ground.Flat(id));
                if (id == West) block.AddStatic(item = Outlier(block.LandCells[60]));
                world.Add(block);
            }

            // The part is at x = 194, and its box of two metres reaches over the border: the base cell, and from there to x = 193 only.
            return string.Join(' ', Enumerable.Range(0, item!.ShadowCount).Select(i => item.ShadowAt(i).CellId.ToString("X8")));
        })];
        Assert.Equal("A9B4003D AAB40005", lists[0]);
        Assert.Equal(lists[0], lists[1]);

        // Without that block the list is the object's own cell, also after the block went away.
        PhysicsWorld alone = new();
        Landblock west = new(Ground.Flat(West));
        StaticObject outlier = Outlier(west.LandCells[60]);
        west.AddStatic(outlier);
        alone.Add(west);
        Assert.Equal(1, outlier.ShadowCount);
        alone.Add(new Landblock(Ground.Flat(East)));
        Assert.Equal(2, outlier.ShadowCount);
        alone.UnloadLandblock(East);
        Assert.Equal(1, outlier.ShadowCount);
        alone.Add(new Landblock(Ground.Flat(East)));
        Assert.Equal(2, outlier.ShadowCount);
    }

    private static StaticObject Outlier(LandCell cell)
    {
        GfxObjAsset mesh = new() { Id = 0x01000001, BoundingBox = new BoundingBox(new Vector3(-1), new Vector3(1)) };
        SetupAsset setup = new SetupAsset { Id = Thing, Parts = [new SetupPart(mesh, Vector3.One)] }.With(0,
            [new Frame(new Vector3(3, 0, 0), Quaternion.Identity)]);
        return new StaticObject(setup, new Position(cell.Id, new Vector3(191, 100, 0)), 1, cell, 1);
    }

    private static Landblock Block(LandBlockInfo info, params DatRecord[] more) => Records(info, more).Load();

    private static WorldRecords Records(LandBlockInfo info, params DatRecord[] more) => new WorldRecords().Ground(info: true).Add(
        info,
        new Setup { Id = Thing, CylSpheres = [new DatCylSphere(Vector3.Zero, 0.3f, 1)] },
        new CellEnvironment
        {
            Id = Shapes,
            Cells =
            [
                new CellStruct
                {
                    Vertices = Assets.Records.Vertices(new(0, 0, 0), new(1, 0, 0), new(1, 1, 0), new(0, 1, 0), new(0, 0, 1)),
                    Polygons = [new DatPolygon { Key = 6, Vertices = [0, 3, 4] }, new DatPolygon { Key = 5, Vertices = [0, 1, 2, 3] }],
                    PortalPolygons = [1, 0],
                    CellTree = BspTree.OfLeaf(new BspNode()),
                    PhysicsTree = BspTree.OfLeaf(new BspNode()),
                },
            ],
        }).Add(more);
}
