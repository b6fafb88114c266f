using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
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
    public void A_room_tells_how_much_of_a_sphere_is_inside(float x, CellOverlap overlap)
    {
        EnvCell hall = (EnvCell)Rooms().GetVisible(Hall)!;
        Assert.Equal(overlap, hall.Shape.Cell.SphereIntersects(new Sphere(hall.Position.Frame.GlobalToLocal(new Vector3(x, 84, 23)), 0.48f)));
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
    [Behaviour("world.rooms.missing-neighbour", "spec/05, 4.14")]
    public void A_portal_to_a_room_that_does_not_exist_lists_it_without_a_cell()
    {
        (PhysicsWorld world, _, _) = HallWithADoorToNowhere();
        ObjCell? home = null;
        CellArray array = new();
        world.FindCellList(array, new Position(Hall, Vector3.Zero), CellListTests.Spheres("64.8 84 20.475", 0.48f), null, true, ref home);
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
            new(new Position(start, at.Center), new BoundingBox(new Vector3(-1, -1, 0), new Vector3(1, 1, 2)), new Sphere(new Vector3(0, 0, 1), 1.8f), true, false),
        ];
        CellArray array = new();
        array.Add(start, world.GetVisible(start));
        for (int k = 0; k < array.Count; k++) array[k].Cell?.FindTransitCells(world, parts, array);
        Assert.Equal(cells, CellListTests.Ids(array));
    }

    private static CellArray List(uint start, string center, bool doNotLoad, out ObjCell? home, out bool interior)
    {
        SpherePath path = new();
        CellArray array = new() { DoNotLoadCells = doNotLoad };
        home = null;
        Rooms().FindCellList(array, new Position(start, Vector3.Zero), CellListTests.Spheres(center, 0.48f), path, true, ref home);
        interior = path.HitsInteriorCell;
        return array;
    }

    private static PhysicsWorld Rooms()
    {
        PhysicsWorld world = new();
        Landblock block = new(Ground.Flat(0xA9B40000, 20));
        PortalPlane toBack = new(new Plane(1, 0, 0, -5), true, Back, 0), toYard = new(new Plane(0, -1, 0, -5), true, PortalPlane.Outdoors, 0);
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
                Tag = i < planes.Length - 1 ? BspTag.BPnn : BspTag.Bpnn, Plane = plane, Positive = i < planes.Length - 1 ? i + 1 : BspNode.None,
            }),
        ];
        return CellStructAsset.Build(0x0D000001, new CellStruct { CellTree = new BspTree { Nodes = nodes }, PhysicsTree = BspTree.OfLeaf(new BspNode()) });
    }
}
