using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using EnvCell = Surefoot.Physics.World.EnvCell;
using Frame = Surefoot.Physics.Geometry.Frame;
using StaticObject = Surefoot.Physics.World.StaticObject;

namespace Surefoot.Physics.Tests.World;

/// <summary>Two rooms and a building: specification 05, 6.7.</summary>
public sealed class RoomTests
{
    private const uint Hall = 0xA9B40100, Back = 0xA9B40101, Yard = 0xA9B40014;

    [Theory]
    [Behaviour("world.rooms.cell-list", "spec/05, 6.7; @0x0052C820, @0x0052C680, @0x0052B4E0")]
    [InlineData(Hall, "60 84 20.475", "A9B40100", Hall, true)]
    [InlineData(Hall, "64.8 84 20.475", "A9B40100 A9B40101", Hall, true)]
    [InlineData(Hall, "65 84 20.475", "A9B40100 A9B40101", Hall, true)]
    [InlineData(Hall, "65.1 84 20.475", "A9B40100 A9B40101", Back, true)]
    [InlineData(Hall, "60 79.3 20.475", "A9B40100 A9B40014", Hall, true)]
    [InlineData(Hall, "60 78.9 20.475", "A9B40100 A9B40014", Yard, true)]
    [InlineData(Yard, "60 78.4 20.475", "A9B40014", Yard, false)]
    [InlineData(Yard, "60 78.8 20.475", "A9B40014 A9B40100", Yard, true)]
    [InlineData(Yard, "60 79.2 20.475", "A9B40014 A9B40100", Hall, true)]
    [InlineData(Yard, "64.9 79.2 20.475", "A9B40014 A9B40100 A9B40101", Hall, true)]
    [InlineData(Hall, "60 84 26.3", "A9B40100", 0u, true)]
    public void Spheres_reach_rooms_through_portals(uint start, string center, string cells, uint home, bool interior)
    {
        CellArray array = List(start, center, false, out ObjCell? found, out bool hits);
        Assert.Equal(cells, CellListTests.Ids(array));
        Assert.Equal(home, found?.Id ?? 0);
        Assert.Equal(interior, hits);
    }

    [Fact]
    [Behaviour("world.rooms.cell-list.pruned", "spec/05, 6.7")]
    public void Cells_that_are_not_seen_from_a_room_are_dropped_when_none_may_be_made()
    {
        CellArray array = List(Hall, "60 79.3 20.475", true, out ObjCell? home, out _);
        Assert.Equal("A9B40100", CellListTests.Ids(array));
        Assert.Equal(Hall, home?.Id);
    }

    [Fact]
    [Behaviour("world.cells.array.swap-removal", "spec/05, 6.7; @0x006B4E80")]
    public void The_last_cell_takes_the_place_of_a_removed_one()
    {
        CellArray array = new();
        foreach (uint id in new uint[] { 0x0100, 0x0014, 0x001C, 0x0101 }) array.Add(id, null);
        array.RemoveAt(1);
        Assert.Equal("00000100 00000101 0000001C", CellListTests.Ids(array));
        array.RemoveAt(2);
        Assert.Equal("00000100 00000101", CellListTests.Ids(array));
    }

    [Theory]
    [Behaviour("world.rooms.point-in-cell", "spec/05, 6.7; @0x0052C300")]
    [InlineData(55f, true)]
    [InlineData(54.9999f, true)]
    [InlineData(54.9998f, true)]
    [InlineData(54.9997f, false)]
    public void A_room_contains_a_point_up_to_the_tolerance(float x, bool inside) =>
        Assert.Equal(inside, Rooms().GetVisible(Hall)!.PointInCell(new Vector3(x, 84, 21)));

    [Theory]
    [Behaviour("world.rooms.sphere-in-cell", "spec/05, 6.7; @0x0053C260")]
    [InlineData(55.5f, CellOverlap.Inside)]
    [InlineData(55.4f, CellOverlap.Partly)]
    [InlineData(54.6f, CellOverlap.Partly)]
    [InlineData(54.511f, CellOverlap.Partly)]
    [InlineData(54.509f, CellOverlap.Outside)]
    public void A_room_tells_how_much_of_a_sphere_is_inside(float x, object overlap)
    {
        EnvCell hall = (EnvCell)Rooms().GetVisible(Hall)!;
        Assert.Equal(overlap,
            (object)hall.Shape.Cell.SphereIntersects(new Sphere(hall.Position.Frame.GlobalToLocal(new Vector3(x, 84, 23)), 0.48f)));
    }

    [Fact]
    [Behaviour("world.rooms.sealed", "spec/05, 4.14")]
    public void A_room_without_portals_contains_nothing()
    {
        EnvCell room = new(new EnvCellContent { Id = Hall, Frame = Frame.Identity, Shape = Shape() });
        Assert.False(room.PointInCell(new Vector3(0, 0, 3)));
    }

    [Theory]
    [Behaviour("world.rooms.adjust-position", "spec/05, 4.18; @0x00511D80")]
    [InlineData(Hall, 60, 84, 20, Hall)]
    [InlineData(Hall, 70, 84, 20, Back)]
    [InlineData(Hall, 60, 70, 20, 0xA9B40013u)]
    [InlineData(Back, 60, 70, 20, 0u)]
    [InlineData(0xA9B40001u, 60, 84, 20, Yard)]
    [InlineData(0xA9B40108u, 60, 84, 20, 0u)]
    public void A_position_is_put_into_the_cell_it_is_in(uint id, float x, float y, float z, uint cell)
    {
        Position place = new(id, new Vector3(x, y, z));
        Assert.Equal(cell != 0, Rooms().AdjustPosition(ref place, new Vector3(0, 0, 0.5f), out ObjCell? found));
        Assert.Equal(cell, found?.Id ?? 0);
        if (cell != 0) Assert.Equal(cell, place.CellId);
    }

    [Fact]
    [Behaviour("world.rooms.adjust-position.rooms-only", "spec/05, 4.14: the cells that are seen are looked up among the rooms")]
    public void A_list_of_seen_cells_that_names_land_puts_nobody_there()
    {
        PhysicsWorld world = new();
        Landblock block = new(Ground.Flat(0xA9B40000, 20));
        PortalPlane exit = new(new Plane(0, -1, 0, -5), true, PortalPlane.Outdoors, 0);
        block.SetRooms([Room(Hall, 60, [exit], [Yard, Back], false), Room(Back, 70, [exit], [Hall], false)]);
        world.Add(block);
        Position place = new(Hall, new Vector3(60, 76, 20));
        Assert.True(world.GetVisible(Yard)!.PointInCell(place.Frame.Origin));
        Assert.False(world.AdjustPosition(ref place, new Vector3(0, 0, 0.5f), out ObjCell? found));
        Assert.Null(found);
        place.Frame.Origin.X = 70;
        place.Frame.Origin.Y = 84;
        Assert.True(world.AdjustPosition(ref place, new Vector3(0, 0, 0.5f), out found));
        Assert.Equal(Back, found?.Id);
    }

    [Fact]
    [Behaviour("world.rooms.missing-neighbour", "spec/05, 4.14")]
    public void A_portal_to_a_room_that_does_not_exist_lists_it_without_a_cell()
    {
        (PhysicsWorld world, _, _) = HallWithADoorToNowhere();
        ObjCell? home = null;
        CellArray array = new();
        world.FindCellList(array, new Position(Hall, Vector3.Zero), CellListTests.Spheres("64.8 84 20.475", 0.48f), true, ref home);
        Assert.Equal("A9B40100 A9B40777", CellListTests.Ids(array));
        Assert.Null(array[1].Cell);
        Assert.Equal(Hall, home?.Id);
    }

    [Theory]
    [Behaviour("world.rooms.parts", "spec/05, 4.14; @0x0052C5D0, @0x0052CAE0")]
    [InlineData(Yard, "60 76 20", "A9B40014")]
    [InlineData(Yard, "60 78.5 20", "A9B40014 A9B40100")]
    [InlineData(Yard, "64.5 79.5 20", "A9B40014 A9B40100 A9B40101")]
    [InlineData(Hall, "60 84 20", "A9B40100")]
    [InlineData(Hall, "64.5 84 20", "A9B40100 A9B40101")]
    [InlineData(Hall, "60 79.5 20", "A9B40100 A9B40014")]
    public void Parts_reach_rooms_through_portals(uint start, string origin, string cells)
    {
        PhysicsWorld world = Rooms();
        Sphere at = CellListTests.Spheres(origin, 0)[0];
        PartExtent[] parts =
        [
            new(new Position(start, at.Center), new BoundingBox(new Vector3(-1, -1, 0), new Vector3(1, 1, 2)),
                new Sphere(new Vector3(0, 0, 1), 1.8f), true, false),
        ];
        CellArray array = new();
        array.Add(start, world.GetVisible(start));
        for (int k = 0; k < array.Count; k++) array[k].Cell?.FindTransitCells(world, parts, array);
        Assert.Equal(cells, CellListTests.Ids(array));
    }

    [Theory]
    [Behaviour("world.rooms.over-the-border",
        "spec/05, 4.14: spheres are taken as they come, without any offset between blocks; parts are not")]
    [InlineData(0xA9B4003Du, 191.9f, "A9B4003D AAB40005", 0xA9B4003Du)]
    [InlineData(0xAAB40005u, -0.1f, "A9B4003D AAB40005 AAB40100", 0xAAB40100u)]
    public void A_room_of_the_next_block_is_entered_from_its_own_coordinates_only(uint id, float x, string cells, uint home)
    {
        const uint outside = 0xAAB40005, inside = 0xAAB40100;
        PhysicsWorld world = new();
        world.Add(new Landblock(Ground.Flat(0xA9B40000, 20)));
        Landblock east = new(Ground.Flat(0xAAB40000, 20));
        east.SetRooms([new EnvCell(new EnvCellContent
        {
            Id = inside,
            Frame = new Frame(new Vector3(3, 100, 20), Quaternion.Identity),
            Shape = Shape(),
            Portals = [new PortalPlane(new Plane(-1, 0, 0, -5), true, PortalPlane.Outdoors, 0)],
        })]);
        LandCell cell = (LandCell)east.Find(outside)!;
        east.AddBuilding(
            cell, new BuildingObject(new StaticObject(new SetupAsset(), new Position(outside, new Vector3(3, 100, 20)), 0, cell, 1),
                [new(inside, 0)]));
        world.Add(east);

        CellArray array = new();
        ObjCell? found = null;
        Vector3 at = new(x, 100, 20.5f);
        world.FindCellList(array, new Position(id, Vector3.Zero), [new Sphere(at, 0.48f)], true, ref found);
        Assert.Equal(cells, CellListTests.Ids(array));
        Assert.Equal(home, found?.Id);

        PartExtent[] parts =
            [new(new Position(id, at), new BoundingBox(new Vector3(-0.5f), new Vector3(0.5f)), new Sphere(Vector3.Zero, 1), true, false)];
        array.Clear();
        array.Add(outside, cell);
        for (int k = 0; k < array.Count; k++) array[k].Cell?.FindTransitCells(world, parts, array);
        Assert.Contains(inside, Enumerable.Range(0, array.Count).Select(k => array[k].Id));
    }

    [Fact]
    [Behaviour("world.rooms.statics-pruned",
        "spec/05, 4.15, 4.17: a static of cylinders gets no shadow outdoors through a doorway, one of boxes does")]
    public void A_static_of_cylinders_stays_inside_and_one_of_boxes_reaches_out()
    {
        PhysicsWorld world = Rooms();
        GfxObjAsset mesh =
            new() { BoundingBox = new BoundingBox(new Vector3(-1), new Vector3(1)), DrawingSphere = new Sphere(Vector3.Zero, 1.8f) };
        SetupAsset boxes = new SetupAsset { Parts = [new SetupPart(mesh, Vector3.One)] }.With(0, [Frame.Identity]);
        SetupAsset cylinders = new() { Cylinders = [new CylSphere(Vector3.Zero, 0.48f, 1)] };
        Assert.Equal("A9B40100", Listed(world, cylinders, new Vector3(60, 79.3f, 20.5f), isStatic: true));
        Assert.Equal("A9B40100 A9B40014", Listed(world, cylinders, new Vector3(60, 79.3f, 20.5f), isStatic: false));
        Assert.Equal("A9B40100 A9B40014", Listed(world, boxes, new Vector3(60, 79.3f, 21), isStatic: true));
        Assert.Equal("A9B40100 A9B40101", Listed(world, cylinders, new Vector3(64.8f, 84, 20.5f), isStatic: true));
    }

    private static string Listed(PhysicsWorld world, SetupAsset setup, Vector3 at, bool isStatic)
    {
        ObjCell room = world.GetVisible(Hall)!;
        CrossCells cross = new(world);
        StaticObject item = new(setup, new Position(Hall, at), 1, room, 1);
        if (isStatic) cross.FindStatic(item);
        else cross.Find(item);
        return CellListTests.Ids(cross.Cells);
    }

    private static CellArray List(uint start, string center, bool doNotLoad, out ObjCell? home, out bool interior)
    {
        CellArray array = new() { DoNotLoadCells = doNotLoad };
        home = null;
        Rooms().FindCellList(array, new Position(start, Vector3.Zero), CellListTests.Spheres(center, 0.48f), true, ref home);
        interior = array.HitsInteriorCell;
        return array;
    }

    private static PhysicsWorld Rooms()
    {
        PhysicsWorld world = new();
        Landblock block = new(Ground.Flat(0xA9B40000, 20));
        PortalPlane toBack = new(new Plane(1, 0, 0, -5), true, Back, 0),
            toYard = new(new Plane(0, -1, 0, -5), true, PortalPlane.Outdoors, 0);
        PortalPlane toHall = new(new Plane(-1, 0, 0, -5), true, Hall, 0);
        block.SetRooms([Room(Hall, 60, [toBack, toYard], [Back], true), Room(Back, 70, [toHall], [Hall], false)]);
        LandCell cell = (LandCell)block.Find(Yard)!;
        block.AddBuilding(cell, new BuildingObject(
            new StaticObject(new SetupAsset(), new Position(Yard, new Vector3(60, 84, 20)), 0, cell, 1), [new(Hall, 1)]));
        world.Add(block);
        return world;
    }

    /// <summary>A hall without anything beyond the door in its eastern wall; its id, and a place in its middle.</summary>
    internal static (PhysicsWorld World, uint Hall, Vector3 Middle) HallWithADoorToNowhere()
    {
        PhysicsWorld world = new();
        Landblock block = new(Ground.Flat(0xA9B40000));
        block.SetRooms([Room(Hall, 60, [new PortalPlane(new Plane(1, 0, 0, -5), true, 0xA9B40777, 0)], [], false)]);
        world.Add(block);
        return (world, Hall, new Vector3(60, 84, 20));
    }

    private static EnvCell Room(uint id, float x, PortalPlane[] portals, uint[] stabs, bool seenOutside) => new(new EnvCellContent
    {
        Id = id,
        Frame = new Frame(new Vector3(x, 84, 20), Quaternion.Identity),
        Shape = Shape(),
        Portals = portals,
        StabList = stabs,
        SeenOutside = seenOutside,
    });

    /// <summary>Ten metres square and six high.</summary>
    private static CellStructAsset Shape()
    {
        Plane[] planes = [new(1, 0, 0, 5), new(-1, 0, 0, 5), new(0, 1, 0, 5), new(0, -1, 0, 5), new(0, 0, 1, 0), new(0, 0, -1, 6)];
        ImmutableArray<BspNode> nodes =
        [
            .. planes.Select((plane, i) => new BspNode
            {
                Tag = i < planes.Length - 1 ? BspTag.BPnn : BspTag.Bpnn, Plane = plane,
                Positive = i < planes.Length - 1 ? i + 1 : BspNode.None,
            }),
        ];
        CellStruct structure = new() { CellTree = new BspTree { Nodes = nodes }, PhysicsTree = BspTree.OfLeaf(new BspNode()) };
        return CellStructAsset.Build(new CellEnvironment { Id = 0x0D000001, Cells = [structure] }, structure);
    }
}
