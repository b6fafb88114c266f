using System.Numerics;
using Surefoot.Dats.Records;
using StaticObject = Surefoot.Physics.World.StaticObject;

namespace Surefoot.Physics.Tests.World;

/// <summary>
/// The rules of specification 05, 4.8, one by one, on a block where one vertex is wooded. Mostly vertex (3, 4) of A9B4, global (1355,
/// 1444): by 6.10 its numbers for object 0 are frequency .897205804, X .637407001, Y .937552771, quadrant .969455623 (so the object goes to
/// (Y, −X)), rotation .429462582, scale .689885244.
/// </summary>
public sealed class SceneryRuleTests
{
    private const uint Tree = 0x02000001, House = 0x02000002;

    [Fact]
    [Behaviour("world.scenery.place", "spec/05, 4.8, 6.10: displacement, quadrant, rotation")]
    public void A_tree_is_displaced_and_turned_by_the_numbers_of_its_vertex()
    {
        StaticObject tree =
            Assert.Single(Grow(Always with { DisplaceX = 10, DisplaceY = 10, MaxRotation = 360, MinScale = 1.5f, MaxScale = 1.5f }));
        Near(new Vector3(72 + 9.37552771f, 96 - 6.37407001f, 0), tree);
        Assert.Equal(0.429462582 * 360, tree.Position.Frame.Heading, 1e-3);
        Assert.Equal(0xA9B4001Cu, tree.Position.CellId);
        Assert.Equal(1.5f, tree.Scale);
        Assert.True(tree.IsScenery);
    }

    [Fact]
    [Behaviour("world.scenery.undisplaced", "spec/05, 4.8, 3b: the base counts where nothing is displaced, and is turned by the quadrant")]
    public void A_tree_that_is_not_displaced_stands_at_its_base()
    {
        StaticObject tree = Assert.Single(Grow(Always with { BaseFrame = WorldRecords.At(2, 3, 50) }));
        Near(new Vector3(75, 94, 0), tree);
        Assert.Equal(0, tree.Position.Frame.Heading, 1e-4);
    }

    [Theory]
    [Behaviour("world.scenery.who-grows", "spec/05, 4.8, 3a: the number must be below the frequency; a server's objects do not grow")]
    [InlineData(0.8973f, 0u, true)]
    [InlineData(0.8972f, 0u, false)]
    [InlineData(0f, 0u, false)]
    [InlineData(1f, 1u, false)]
    public void What_grows_is_decided_by_frequency(float frequency, uint weenie, bool grows) =>
        Assert.Equal(grows ? 1 : 0, Grow(Always with { Frequency = frequency, WeenieObject = weenie }).Length);

    [Theory]
    [Behaviour("world.scenery.scale", "spec/05, 4.8, 3f")]
    [InlineData(1f, 2f, 1.613155)]
    [InlineData(2f, 0.5f, 0.768560)]
    [InlineData(0.7f, 0.7f, 0.7)]
    public void A_scale_lies_between_two_on_a_logarithmic_measure(float least, float most, double scale) =>
        Assert.Equal(scale, Assert.Single(Grow(Always with { MinScale = least, MaxScale = most })).Scale, 1e-5);

    [Theory]
    [Behaviour("world.scenery.roads", "spec/05, 4.6, 4.8, 3c: (81.376, 89.626) is 9.376 east and 17.626 north in its cell")]
    [InlineData("1000", true)]
    [InlineData("0110", false)]
    [InlineData("1001", true)]
    [InlineData("1010", true)]
    [InlineData("0101", true)]
    [InlineData("1111", false)]
    public void Nothing_grows_on_a_road(string corners, bool grows) => Assert.Equal(
        grows ? 1 : 0,
        Grow(
            Always with { DisplaceX = 10, DisplaceY = 10 },
            new WorldRecords()
                .Ground((i, j) => Wood(i, j) | (i is 3 or 4 && j is 3 or 4 && corners[(2 * (i - 3)) + j - 3] == '1' ? 1 : 0))).Length);

    [Theory]
    [Behaviour("world.scenery.slopes", "spec/05, 4.8, 3d: both limits are allowed")]
    [InlineData(0, 1f, 1f, true)]
    [InlineData(0, 1.0001f, 2f, false)]
    [InlineData(0, 0f, 0.9999f, false)]
    [InlineData(6, 0.97f, 0.9702f, true)]
    [InlineData(6, 0f, 0.97f, false)]
    public void Ground_must_be_as_steep_as_the_tree_likes_it(int rise, float least, float most, bool grows) => Assert.Equal(
        grows ? 1 : 0,
        Grow(
            Always with { BaseFrame = WorldRecords.At(2, 3), MinSlope = least, MaxSlope = most },
            new WorldRecords().Ground(Wood, (i, _) => rise * i)).Length);

    [Fact]
    [Behaviour("world.scenery.aligned", "spec/05, 4.8, 3e: the heading is that of the ground's normal turned round, whatever the rotation")]
    public void An_aligned_tree_faces_up_the_slope_and_stands_on_it()
    {
        WorldRecords records = new WorldRecords().Ground(Wood, (i, _) => 6 * i);
        StaticObject tree = Assert.Single(Grow(Always with { DisplaceX = 10, DisplaceY = 10, MaxRotation = 360, Align = 1 }, records));
        // The normal of ground that rises 6 m in 24 m to the east is (−.2425, 0, .9701).
        Assert.Equal(90, tree.Position.Frame.Heading, 1e-3);
        Near(new Vector3(81.3755277f, 89.62593f, 81.3755277f / 4), tree);
        Assert.Equal(
            0, Assert.Single(Grow(Always with { MaxRotation = 360, Align = 1, BaseFrame = WorldRecords.At(2, 3) })).Position.Frame.Heading,
            1e-4);
    }

    [Theory]
    [Behaviour("world.scenery.buildings", "spec/05, 4.8, 3d: nothing grows in the cell of a building, whatever the building covers")]
    [InlineData(95, 73, false)]
    [InlineData(97, 90, true)]
    [InlineData(81, 96.5f, true)]
    public void Nothing_grows_in_the_cell_of_a_building(float x, float y, bool grows)
    {
        WorldRecords records = new WorldRecords().Ground(Wood, info: true).Add(
            new Setup { Id = House },
            new LandBlockInfo { Id = WorldRecords.Info, Buildings = [new Building(House, WorldRecords.At(x, y), 0, [])] });
        Assert.Equal(grows ? 1 : 0, Grow(Always with { DisplaceX = 10, DisplaceY = 10 }, records).Length);
    }

    [Theory]
    [Behaviour("world.scenery.within-block",
        "spec/05, 4.8, 3f, obj_within_block: cylinders by their own radius, spheres by the sorting sphere, others by the origin")]
    [InlineData("cylinder", 81.3f, true)]
    [InlineData("cylinder", 81.4f, false)]
    [InlineData("spheres", 81.3f, true)]
    [InlineData("spheres", 81.4f, false)]
    [InlineData("bare", 500f, true)]
    public void A_tree_that_reaches_over_the_border_does_not_grow(string kind, float radius, bool grows)
    {
        Setup setup = new()
        {
            Id = Tree,
            CylSpheres = kind == "cylinder" ? [new DatCylSphere(Vector3.Zero, 0.1f, 1), new DatCylSphere(Vector3.Zero, radius, 1)] : [],
            Spheres = kind == "spheres" ? [new DatSphere(Vector3.Zero, 0.1f)] : [],
            // Of a setup with cylinders it is not looked at.
            SortingSphere = new DatSphere(Vector3.Zero, kind == "cylinder" ? 500 : radius),
        };
        Assert.Equal(grows ? 1 : 0, Grow(Always with { DisplaceX = 10, DisplaceY = 10, MaxScale = 3, MinScale = 3 }, setup: setup).Length);
    }

    [Fact]
    [Behaviour("world.scenery.ninth-column",
        "spec/05, 4.8, 6.10: (1360, 1447), object 2: frequency .070452728, Y .272412302, quadrant .981127624")]
    public void The_far_border_grows_what_is_displaced_into_the_block()
    {
        SceneObject never = Always with { Frequency = 0 };
        SceneObject inwards = Always with { Frequency = 0.0705f, BaseFrame = WorldRecords.At(0, -20), DisplaceY = 10 };
        WorldRecords records = new WorldRecords().Ground((i, j) => (i, j) == (8, 7) ? WorldRecords.Wooded : 0);
        Near(new Vector3(192 - 20 + 2.72412302f, 168, 0), Assert.Single(Grow([never, never, inwards], records)));
        Assert.Empty(Grow([never, never, inwards with { BaseFrame = WorldRecords.At(0, 0) }], records));
    }

    [Theory]
    [Behaviour("world.scenery.pick", "spec/05, 4.8, 2: (1355, 1444) has .076810571")]
    [InlineData(1, 0)]
    [InlineData(13, 0)]
    [InlineData(14, 1)]
    [InlineData(20, 1)]
    [InlineData(100, 7)]
    public void One_of_the_scenes_of_the_ground_is_drawn(int count, int drawn)
    {
        WorldRecords records =
            new WorldRecords { Scenes = [.. Enumerable.Range(0, count).Select(k => k == drawn ? WorldRecords.Scene : 0)] }.Ground(Wood);
        Assert.Single(Grow(Always, records));
    }

    [Theory]
    [Behaviour("world.scenery.ground", "spec/05, 2.6, 4.8, 1: the terrain's type and the scenery type of its word name the scenes")]
    [InlineData(WorldRecords.Wooded, 1)]
    [InlineData((1 << 2) | (1 << 11), 0)]
    [InlineData(1 << 2, 0)]
    [InlineData((1 << 2) | (3 << 11), 0)]
    [InlineData(2 << 11, 0)]
    [InlineData((31 << 2) | (2 << 11), 0)]
    public void Only_ground_with_scenes_grows_something(int word, int trees) =>
        Assert.Equal(trees, Grow(Always, new WorldRecords().Ground((i, j) => (i, j) == (3, 4) ? word : 0)).Length);

    private static SceneObject Always => new()
    {
        ObjectId = Tree,
        BaseFrame = WorldRecords.At(0, 0),
        Frequency = 1,
        MinScale = 1,
        MaxScale = 1,
        MinSlope = 0,
        MaxSlope = 1,
    };

    private static int Wood(int i, int j) => (i, j) == (3, 4) ? WorldRecords.Wooded : 0;

    private static StaticObject[] Grow(SceneObject thing, WorldRecords? records = null, Setup? setup = null) =>
        Grow([thing], records, setup);

    private static StaticObject[] Grow(SceneObject[] things, WorldRecords? records = null, Setup? setup = null) =>
        [.. (records ?? new WorldRecords().Ground(Wood))
            .Add(setup ?? new Setup { Id = Tree }, new Scene { Id = WorldRecords.Scene, Objects = [.. things] })
            .Load().StaticObjects];

    private static void Near(Vector3 expected, StaticObject tree)
    {
        Vector3 at = tree.Position.Frame.Origin;
        Assert.Equal(0, (at - expected).Length(), 5e-5f);
    }
}
