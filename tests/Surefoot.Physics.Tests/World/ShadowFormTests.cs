using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>
/// In which cells an object is listed, by its shape: specification 06, 5, and 05, 4.15 and 4.17. The cell A9B4001C is x and y from 72 to
/// 96.
/// </summary>
public sealed class ShadowFormTests
{
    private const uint Id = 0xA9B4001C;

    [Theory]
    [Behaviour("world.shadows.cylinders", "spec/05, 4.15; spec/06, 5: the first ten, low point and radius, without any scale")]
    [InlineData(10, 11.5f, 1f, 1f, "A9B4001C A9B40024")]
    [InlineData(11, 11.5f, 1f, 1f, "A9B4001C")]
    [InlineData(10, 0f, 5f, 3f, "A9B4001C")]
    [InlineData(10, 4f, 0.5f, 3f, "A9B4001C")]
    public void Cylinders_are_spheres_about_their_low_points(int last, float x, float radius, float scale, string cells)
    {
        CylSphere[] cylinders = [.. Enumerable.Repeat(new CylSphere(Vector3.Zero, 0.1f, 50), last - 1),
            new CylSphere(new Vector3(x, 0, 0), radius, 50)];
        SetupAsset setup = new SetupAsset { Cylinders = cylinders, Parts = [Part(30)], SortingSphere = new Sphere(Vector3.Zero, 20) }
            .With(0, [Frame.Identity]);
        Assert.Equal(cells, Cells(setup, new Vector3(84, 84, 0), scale, isStatic: true));
        Assert.Equal(cells, Cells(setup, new Vector3(84, 84, 0), scale, isStatic: false));
    }

    [Fact]
    [Behaviour("world.shadows.spheres-only", "spec/06, 5: boxes of its parts when static, the sorting sphere when moving")]
    public void An_object_of_spheres_is_listed_by_its_parts_or_by_its_sorting_sphere()
    {
        SetupAsset setup = new SetupAsset
        {
            Spheres = [new Sphere(Vector3.Zero, 13)],
            Parts = [Part(13)],
            SortingSphere = new Sphere(new Vector3(10, 0, 0), 2.5f),
        }.With(0, [Frame.Identity]);
        Assert.Equal(
            "A9B4001C A9B40013 A9B40014 A9B40015 A9B4001B A9B4001D A9B40023 A9B40024 A9B40025",
            Cells(setup, new Vector3(84, 84, 0), 1, isStatic: true));
        Assert.Equal("A9B4001C A9B40024", Cells(setup, new Vector3(84, 84, 0), 1, isStatic: false));
        // The scale moves neither the sorting sphere nor the box.
        Assert.Equal("A9B4001C A9B40024", Cells(setup, new Vector3(84, 84, 0), 0.5f, isStatic: false));
    }

    [Theory]
    [Behaviour("world.shadows.trees", "spec/06, 5; spec/05, 4.10: boxes of the parts, without the part's scale")]
    [InlineData(true)]
    [InlineData(false)]
    public void An_object_with_a_collision_tree_is_listed_by_its_boxes(bool isStatic)
    {
        GfxObjAsset slab = new PhysicsDataCache(new MemorySource().Add(Records.Slab())).GetGfxObj(Records.SlabId);
        SetupAsset setup = new SetupAsset
        {
            Cylinders = [new CylSphere(Vector3.Zero, 20, 1)],
            Parts = [new SetupPart(slab, new Vector3(20))],
        }.With(0, [Frame.Identity]);
        Assert.Equal("A9B4001C", Cells(setup, new Vector3(94.5f, 84, 0), 1, isStatic));
        Assert.Equal("A9B4001C A9B40024", Cells(setup, new Vector3(95.5f, 84, 0), 1, isStatic));
    }

    [Fact]
    [Behaviour("world.shadows.pictures", "spec/05, 4.10, Always2D: the box is the part's origin and the radius of its sphere")]
    public void A_picture_is_listed_by_its_sphere()
    {
        GfxObjAsset mesh = new()
        {
            BoundingBox = new BoundingBox(new Vector3(-30), new Vector3(30)),
            Always2D = true,
            DrawingSphere = new Sphere(new Vector3(40, 0, 0), 5),
        };
        SetupAsset setup = new SetupAsset { Parts = [new SetupPart(mesh, Vector3.One)] }.With(0, [Frame.Identity]);
        Assert.Equal("A9B4001C A9B40024", Cells(setup, new Vector3(92, 84, 0), 1, isStatic: true));
    }

    [Fact]
    [Behaviour("world.shadows.turned-box", "spec/05, 4.10, BBox::LocalToGlobal: all eight corners count")]
    public void The_box_of_a_turned_object_has_all_its_corners()
    {
        // Half a turn swaps the corners: a box that reaches 13 m to its own east reaches to the west.
        GfxObjAsset mesh = new() { BoundingBox = new BoundingBox(new Vector3(-1), new Vector3(13, 1, 1)) };
        SetupAsset setup = new SetupAsset { Parts = [new SetupPart(mesh, Vector3.One)] }.With(0, [Frame.Identity]);
        Assert.Equal("A9B4001C A9B40024", Cells(setup, new Vector3(84, 84, 0), 1, isStatic: true));
        Assert.Equal("A9B4001C A9B40014", Cells(setup, new Vector3(84, 84, 0), 1, isStatic: true, turn: 180));
        Assert.Equal("A9B4001C A9B4001B", Cells(setup, new Vector3(84, 84, 0), 1, isStatic: true, turn: 90));
    }

    private static SetupPart Part(float reach) =>
        new(new GfxObjAsset { BoundingBox = new BoundingBox(new Vector3(-reach), new Vector3(reach)) }, Vector3.One);

    private static string Cells(SetupAsset setup, Vector3 at, float scale, bool isStatic, float turn = 0)
    {
        PhysicsWorld world = CellListTests.Flat(0xA9B40000);
        LandCell cell = (LandCell)world.GetVisible(Id)!;
        Frame frame = new(at, Quaternion.Identity);
        frame.SetHeading(turn);
        Position place = new(Id, frame);
        CrossCells cross = new(world);
        if (isStatic)
        {
            cross.FindStatic(new StaticObject(setup, place, 1, cell, scale));
        }
        else
        {
            WorldObject body = new(1, setup, PhysicsState.Default) { Scale = scale };
            body.SeatAt(place, cell);
            cross.Find(body);
        }

        return CellListTests.Ids(cross.Cells);
    }
}
