using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Which cells spheres and parts reach, outdoors: specification 05, 6.6 and 6.11.</summary>
public sealed class CellListTests
{
    private const float Radius = 0.48f;

    [Theory]
    [Behaviour("world.cells.outdoor-list", "spec/05, 6.6; @0x00533630")]
    [InlineData(0xA9B40001u, "12 12", Radius, "A9B40001")]
    [InlineData(0xA9B40001u, "23.52 12", Radius, "A9B40001")]
    [InlineData(0xA9B40001u, "23.6 12", Radius, "A9B40001 A9B40009")]
    [InlineData(0xA9B4000Au, "47.75 47.75", Radius, "A9B4000A A9B40012 A9B40013 A9B4000B")]
    [InlineData(0xA9B4000Au, "24.25 47.75", Radius, "A9B4000A A9B40002 A9B40003 A9B4000B")]
    [InlineData(0xA9B4000Au, "47.75 24.25", Radius, "A9B4000A A9B40012 A9B40011 A9B40009")]
    [InlineData(0xA9B4000Au, "24.25 24.25", Radius, "A9B4000A A9B40002 A9B40001 A9B40009")]
    [InlineData(0xA9B4000Au, "24 24", Radius, "A9B4000A A9B40002 A9B40001 A9B40009")]
    [InlineData(0xA9B40001u, "0.1 0.1", Radius, "A9B40001 A8B40039 A8B30040 A9B30008")]
    [InlineData(0xA9B40001u, "-0.1 0.1", Radius, "A8B40039 A9B40001 A9B30008 A8B30040")]
    [InlineData(0xA9B40001u, "-0.0001 12", Radius, "A9B40001 A8B40039")]
    [InlineData(0xA9B40040u, "191.9 191.9", Radius, "A9B40040 AAB40008 AAB50001 A9B50039")]
    [InlineData(0xA9B4000Au, "47.75 36|47.2 47.8", Radius, "A9B4000A A9B40012 A9B4000B")]
    [InlineData(0xA9B4001Cu, "84 84", 13f, "A9B4001C A9B40024 A9B40025 A9B40023 A9B40014 A9B40015 A9B40013 A9B4001D A9B4001B")]
    [InlineData(0xA9B4001Cu, "84 84", 30f, "A9B4001C A9B40024 A9B40025 A9B40023 A9B40014 A9B40015 A9B40013 A9B4001D A9B4001B")]
    [InlineData(0xA9B40105u, "100 50.2", Radius, "A9B40023")]
    [InlineData(0x00000001u, "0.1 0.1", Radius, "00000001")]
    [InlineData(0x00000001u, "-0.3 5|5 5", Radius, "")]
    [InlineData(0x00000001u, "5 5|-0.3 5", Radius, "00000001")]
    public void Spheres_reach_land_cells_in_the_order_of_retail(uint id, string centers, float radius, string cells)
    {
        CellArray array = new();
        OutdoorCells.AddAll(new PhysicsWorld(), new Position(id, Vector3.Zero), Spheres(centers, radius), array);
        Assert.Equal(cells, Ids(array));
    }

    [Fact]
    [Behaviour("world.cells.outdoor-list.no-spheres", "spec/05, 6.6")]
    public void Without_spheres_the_origin_decides()
    {
        CellArray array = new();
        OutdoorCells.AddAll(new PhysicsWorld(), new Position(0xA9B40001, new Vector3(30, 5, 0)), [], array);
        Assert.Equal("A9B40009", Ids(array));
    }

    [Theory]
    [Behaviour("world.cells.outdoor-list.parts", "spec/05, 6.6; @0x00533360")]
    [InlineData(0xA9B40025u, "100 100", "90 95 130 101", "A9B4001C A9B4001D A9B40024 A9B40025 A9B4002C A9B4002D")]
    [InlineData(0xA9B40025u, "100 100", "125 100 130 101", "A9B40025 A9B4002D")]
    [InlineData(0xA9B40040u, "188 188", "185 185 197 190", "A9B40040 AAB40008")]
    [InlineData(0xA9B40001u, "2 2", "-1 -1 5 5|20 2 26 3", "A8B30040 A8B40039 A9B30008 A9B40001 A9B30010 A9B40009")]
    public void Parts_reach_the_rectangle_under_their_boxes(uint id, string origin, string boxes, string cells)
    {
        PhysicsWorld world = Flat(0xA9B40000);
        float[] place = Ground.Numbers(origin.Replace(' ', ','));
        List<PartExtent> parts = [];
        foreach (string box in boxes.Split('|'))
        {
            float[] n = Ground.Numbers(box.Replace(' ', ','));
            Vector3 at = new(place[0], place[1], 0);
            parts.Add(new PartExtent(
                new Position(id, at), new BoundingBox(new Vector3(n[0], n[1], 0) - at, new Vector3(n[2], n[3], 5) - at), default, false,
                false));
        }

        CellArray array = new();
        OutdoorCells.AddAll(world, parts.ToArray(), array);
        Assert.Equal(cells, Ids(array));
    }

    [Fact]
    [Behaviour("world.cells.home.border", "spec/05, 6.6; @0x0052B4E0")]
    public void On_a_corner_of_four_cells_the_last_one_listed_is_home()
    {
        PhysicsWorld world = Flat(0xA9B40000);
        Assert.Equal(0xA9B40009u, Home(world, 0xA9B4000A, "24 24", out _)?.Id);
        foreach (uint id in new uint[] { 0x0A, 0x02, 0x01, 0x09 })
            Assert.True(world.GetVisible(0xA9B40000 | id)!.PointInCell(new Vector3(24, 24, 0)));
    }

    [Fact]
    [Behaviour("world.cells.home.unloaded", "spec/05, 6.11")]
    public void Over_land_that_is_not_loaded_nothing_is_home()
    {
        PhysicsWorld world = Flat(0xA9B40000);
        Assert.Equal(0xA9B4003Du, Home(world, 0xA9B4003D, "191.9 100", out CellArray array)?.Id);
        Assert.Equal("A9B4003D AAB40005", Ids(array));
        Assert.Null(array[1].Cell);

        Assert.Null(Home(world, 0xA9B4003D, "192.2 100", out array));
        Assert.Equal("AAB40005 A9B4003D", Ids(array));

        // Off the map there is nothing to list.
        Assert.Null(Home(Flat(0xFEFE0000), 0xFEFE003D, "192.2 100", out array));
        Assert.Equal(0, array.Count);
    }

    [Fact]
    [Behaviour("world.edge.unloaded-is-not-a-wall", "spec/05, 4.19, 6.11; @0x0050AE50")]
    public void A_walk_into_what_is_not_loaded_parks_the_body_there()
    {
        PhysicsWorld world = Flat(0xA9B40000);
        PhysicsBody body = Enter(world, new Position(0xA9B4003D, new Vector3(191.9f, 100, 0)));
        Strides.Walk(body, new Vector3(0.3f, 0, 0));
        Assert.True(body.IsLost);
        Assert.Null(body.Cell);
        Assert.Equal(0xAAB40005u, body.Position.CellId);
        Assert.Equal(0.2f, body.Position.Frame.Origin.X, 1e-4f);
        Assert.Equal(0, body.ShadowCount);
    }

    [Fact]
    [Behaviour("world.edge.map-is-a-wall", "spec/05, 4.19, 6.11")]
    public void The_rim_of_the_map_is_a_wall()
    {
        PhysicsWorld world = Flat(0xFEFE0000);
        PhysicsBody body = Enter(world, new Position(0xFEFE003D, new Vector3(191.9f, 100, 0)));
        Strides.Walk(body, new Vector3(0.3f, 0, 0));
        Assert.False(body.IsLost);
        Assert.Equal(191.9f, body.Position.Frame.Origin.X);
    }

    [Theory]
    [Behaviour("world.restrictions.normal", "spec/05, 6.11; @0x00533070")]
    [InlineData(36, 23, 0, -1)]
    [InlineData(36, 49, 0, 1)]
    [InlineData(23, 36, -1, 0)]
    [InlineData(49, 36, 1, 0)]
    [InlineData(36, 36, 1, 0)]
    [InlineData(20, 20, 0, -1)]
    [InlineData(36, 24, 1, 0)]
    public void A_guarded_cell_pushes_back_over_the_side_one_came_from(float x, float y, float nx, float ny)
    {
        PhysicsWorld world = Flat(0xA9B40000);
        Transition transition = new(world);
        transition.Path.CurrPos = new Position(0xA9B4000A, new Vector3(x, y, 0));
        CellObstacle.PushBack((LandCell)world.GetVisible(0xA9B4000A)!, transition);
        Assert.Equal(new Vector3(nx, ny, 0), transition.Collision.CollisionNormal);
    }

    [Theory]
    [Behaviour("world.restrictions.entry", "spec/05, 4.16; @0x0052B6D0")]
    [InlineData(WeenieTraits.None, false, null, true)]
    [InlineData(WeenieTraits.Present | WeenieTraits.Creature, false, null, true)]
    [InlineData(WeenieTraits.Present | WeenieTraits.Player, false, null, false)]
    [InlineData(WeenieTraits.Present | WeenieTraits.Player, false, false, false)]
    [InlineData(WeenieTraits.Present | WeenieTraits.Player, false, true, true)]
    [InlineData(WeenieTraits.Present | WeenieTraits.Player, true, false, true)]
    public void Players_enter_a_guarded_cell_only_when_its_guard_lets_them(WeenieTraits weenie, bool bypass, bool? may, bool enters)
    {
        PhysicsWorld world = Flat(0xA9B40000);
        world.Restrictions = new Guard(bypass, may);
        ((LandCell)world.GetVisible(0xA9B40002)!).RestrictionObject = 0x70000001;
        PhysicsBody body = Enter(world, new Position(0xA9B40001, new Vector3(12, 23, 0)), weenie);
        for (int i = 0; i < 10; i++) Strides.Walk(body, new Vector3(0, 0.3f, 0));
        Assert.Equal(enters ? 0xA9B40002u : 0xA9B40001u, body.Position.CellId);
    }

    internal static PhysicsWorld Flat(params uint[] blocks)
    {
        PhysicsWorld world = new();
        foreach (uint block in blocks) world.Add(new Landblock(Ground.Flat(block)));
        return world;
    }

    internal static Sphere[] Spheres(string centers, float radius) => Array.ConvertAll(centers.Split('|'), text =>
    {
        float[] n = Ground.Numbers(text.Replace(' ', ','));
        return new Sphere(new Vector3(n[0], n[1], n.Length > 2 ? n[2] : 0), radius);
    });

    internal static string Ids(CellArray array) =>
        string.Join(' ', Enumerable.Range(0, array.Count).Select(i => array[i].Id.ToString("X8")));

    internal static PhysicsBody Enter(PhysicsWorld world, Position place, WeenieTraits weenie = WeenieTraits.None)
    {
        SetupAsset setup = new()
        {
            Spheres = [new Sphere(new Vector3(0, 0, Radius), Radius)],
            Height = 1.8f,
            Radius = Radius,
            StepUpHeight = 0.6f,
            StepDownHeight = 0.6f,
        };
        PhysicsBody body = new PhysicsEngine(world).CreateBody(1, setup, weenie: weenie);
        Assert.True(body.EnterWorld(place));
        return body;
    }

    private static ObjCell? Home(PhysicsWorld world, uint id, string center, out CellArray array)
    {
        ObjCell? home = null;
        array = new CellArray();
        world.FindCellList(array, new Position(id, Vector3.Zero), Spheres(center, Radius), true, ref home);
        return home;
    }

    private sealed class Guard(bool bypass, bool? may) : IMoveRestrictions
    {
        public bool CanBypass(WorldObject mover) => bypass;

        public bool? CanMoveInto(uint restrictionObject, WorldObject mover) => restrictionObject == 0x70000001 ? may : null;
    }
}
