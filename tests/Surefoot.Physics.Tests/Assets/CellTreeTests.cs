using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>The room of specification 04, 6.14.</summary>
public class CellTreeTests
{
    private static readonly CellBsp Room = new(
        new Plane(1, 0, 0, 0), new Plane(-1, 0, 0, 10), new Plane(0, 1, 0, 0), new Plane(0, -1, 0, 10), new Plane(0, 0, 1, 0),
        new Plane(0, 0, -1, 4));

    [Theory, Behaviour("cell.contains.point", "spec/04, 6.14, BSPNODE::point_inside_cell_bsp @0x0053C1F0")]
    [InlineData(5, 5, 2, true)]
    [InlineData(-0.0001, 5, 2, true)]
    [InlineData(-0.0002, 5, 2, true)]
    [InlineData(-0.0003, 5, 2, false)]
    [InlineData(5, 5, 4.1, false)]
    public void A_point_within_the_tolerance_behind_a_wall_is_inside(float x, float y, float z, bool inside) =>
        Assert.Equal(inside, Room.PointInside(new(x, y, z)));

    [Theory]
    [Behaviour("cell.contains.nan",
        "spec/04, 1.2 and 4.2: no comparison with NaN holds, so a NaN distance is neither in front nor in the plane")]
    [InlineData(float.NaN, 5, 2)]
    [InlineData(5, float.NaN, 2)]
    [InlineData(5, 5, float.NaN)]
    public void A_point_that_is_no_point_is_in_no_room(float x, float y, float z) => Assert.False(Room.PointInside(new(x, y, z)));

    [Theory, Behaviour("cell.contains.sphere", "spec/04, 6.14, BSPNODE::sphere_intersects_cell_bsp @0x0053C260")]
    [InlineData(5, 5, CellOverlap.Inside)]
    [InlineData(0.5, 5, CellOverlap.Partly)]
    [InlineData(0.505, 5, CellOverlap.Partly)]
    [InlineData(0.511, 5, CellOverlap.Inside)]
    [InlineData(-0.505, 5, CellOverlap.Partly)]
    [InlineData(-0.511, 5, CellOverlap.Outside)]
    [InlineData(-0.3, -0.3, CellOverlap.Partly)]
    public void A_sphere_reaches_a_centimetre_further_than_its_radius(float x, float y, object overlap) =>
        Assert.Equal(overlap, (object)Room.SphereIntersects(new Sphere(new(x, y, 2), 0.5f)));

    [Theory, Behaviour("cell.contains.box", "spec/04, 6.14, BSPNODE::box_intersects_cell_bsp @0x0053C880")]
    [InlineData(1, 2, true)]
    [InlineData(-1, -0.5, false)]
    [InlineData(-1, 0, true)]
    [InlineData(-1, -0.00015, true)]
    [InlineData(-1, -0.0003, false)]
    public void A_box_is_outside_only_when_it_is_behind_one_wall(float minX, float maxX, bool intersects) =>
        Assert.Equal(intersects, Room.BoxIntersects(new BoundingBox(new(minX, 1, 1), new(maxX, 2, 2))));

    [Fact, Behaviour("cell.contains.no-planes", "spec/04, question 5: a leaf ends the chain")]
    public void A_tree_that_is_one_leaf_contains_everything()
    {
        CellBsp everything = new();
        Assert.True(everything.PointInside(new(1e6f, 0, 0)));
        Assert.Equal(CellOverlap.Inside, everything.SphereIntersects(new Sphere(Vector3.Zero, 1)));
    }
}
