using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>Points and spheres against shapes: the tables of specification 04, asked from outside.</summary>
public sealed class ShapeQueryTests
{
    private static readonly Vector3 Down = new(0, 0, -1), Up = new(0, 0, 1);

    [Theory, Behaviour("query.shape.point", "spec/04, 6.7: point_intersects_solid")]
    [InlineData("0 0 0", true)]
    [InlineData(".49 0 0", true)]
    [InlineData(".5 0 0", false)]
    [InlineData("0 0 -.5", false)]
    [InlineData("0 0 -.6", false)]
    public void A_point_is_inside_a_mesh_or_not(string point, bool inside) =>
        Assert.Equal(inside, ShapeQuery.Contains(Ask.Cube, At(point)));

    [Theory, Behaviour("query.shape.sphere", "spec/04, 6.7: sphere_intersects_solid, and sphere_intersects_poly with each movement")]
    [InlineData("0 0 0", 0.1f, true, false, "")]
    [InlineData("0 0 .55", 0.1f, true, true, "0 0 1")]
    [InlineData("0 0 .5997", 0.1f, true, true, "0 0 1")]
    [InlineData("0 0 .5999", 0.1f, false, false, "")]
    [InlineData(".55 .55 0", 0.1f, true, false, "0 1 0")]
    [InlineData(".58 .58 0", 0.1f, false, false, "")]
    [InlineData(".56 .56 .55", 0.1f, true, true, "0 0 1")]
    [InlineData(".45 0 0", 0.1f, true, false, "1 0 0")]
    [InlineData("0 0 1.4", 0.1f, false, false, "")]
    [InlineData("0 0 .7", 0.5f, true, true, "0 0 1")]
    public void A_sphere_meets_a_polygon_of_a_mesh_or_not(string center, float radius, bool overlaps, bool runsIntoByFalling, string normal)
    {
        Sphere sphere = new(At(center), radius);
        ShapeOverlap falling = ShapeQuery.Overlap(Ask.Cube, sphere, Down), rising = ShapeQuery.Overlap(Ask.Cube, sphere, Up);
        Assert.Equal((overlaps, runsIntoByFalling), (falling.Overlaps, falling.RunsInto));
        Assert.Equal((overlaps, false), (rising.Overlaps, rising.RunsInto));
        Assert.Equal(normal.Length > 0, falling.Polygon >= 0);
        if (normal.Length > 0) Assert.Equal(At(normal), falling.Plane.Normal);
    }

    [Fact, Behaviour("query.shape.contact", "spec/04, 6.7, second row: contact (0,0,.5)")]
    public void A_sphere_touches_a_polygon_below_its_centre()
    {
        ShapeOverlap met = ShapeQuery.Overlap(Ask.Cube, new Sphere(new Vector3(0, 0, 0.55f), 0.1f), Down);
        Assert.Equal(new Vector3(0, 0, 0.5f), met.Point);
        Assert.Equal(-0.5f, met.Plane.D);
    }

    [Fact, Behaviour("query.shape.setup-parts", "spec/06, 3: every object is made with placement 0x65; parts at their default scale")]
    public void A_setup_is_met_where_its_parts_rest_and_as_large_as_they_are()
    {
        SetupAsset pile = new SetupAsset { Parts = [new SetupPart(Ask.Cube, Vector3.One), new SetupPart(Ask.Cube, new Vector3(2))] }
            .With(0, [Frame.Identity, Frame.Identity])
            .With(
                SetupAsset.Resting,
                [new Frame(new Vector3(5, 0, 0), Quaternion.Identity), new Frame(new Vector3(0, 0, 1), Quaternion.Identity)]);
        Assert.True(ShapeQuery.Contains(pile, new Vector3(5, 0, 0)));
        Assert.True(ShapeQuery.Contains(pile, new Vector3(0.9f, 0, 1)));
        Assert.False(ShapeQuery.Contains(pile, new Vector3(0, 0, -0.1f)));

        // The second part's top is 2 m high; the sphere of 0.5 reaches 0.3 m into it.
        ShapeOverlap met = ShapeQuery.Overlap(pile, new Sphere(new Vector3(0, 0, 2.2f), 0.5f), Down);
        Assert.Equal((true, 1, true), (met.Overlaps, met.Part, met.RunsInto));
        Assert.Equal(0, (met.Point - new Vector3(0, 0, 2)).Length(), 1e-5f);
        Assert.Equal(-2f, met.Plane.D, 1e-5f);
    }

    [Theory, Behaviour("query.shape.cylinder", "spec/04, 6.13: above the rim, and 4.9")]
    [InlineData("-.3 0 1.48", false)]
    [InlineData("-.3 0 1.4797", true)]
    [InlineData("-.9 .2 .48", true)]
    [InlineData("-1.2 0 .48", false)]
    public void A_sphere_reaches_into_a_cylinder_or_not(string center, bool overlaps)
    {
        SetupAsset post = new() { Cylinders = [new CylSphere(Vector3.Zero, 0.5f, 1)], Spheres = [new Sphere(new Vector3(0, 0, 5), 10)] };
        Assert.Equal(overlaps, ShapeQuery.Overlap(post, new Sphere(At(center), 0.48f)).Overlaps);
        Assert.True(ShapeQuery.Contains(post, new Vector3(0.4f, 0, 0.9f)));
        Assert.False(ShapeQuery.Contains(post, new Vector3(0.4f, 0.4f, 0.9f)));
        Assert.False(ShapeQuery.Contains(post, new Vector3(0.4f, 0, 1.1f)));
    }

    [Theory, Behaviour("query.shape.ball", "spec/04, 6.12: touch at .98, less the tolerance of 0.0002")]
    [InlineData("-.9799 0 .5", false)]
    [InlineData("-.9797 0 .5", true)]
    public void A_sphere_reaches_into_a_ball_or_not(string center, bool overlaps)
    {
        SetupAsset ball = new() { Spheres = [new Sphere(new Vector3(0, 0, 0.5f), 0.5f)] };
        Assert.Equal(overlaps, ShapeQuery.Overlap(ball, new Sphere(At(center), 0.48f)).Overlaps);
        Assert.True(ShapeQuery.Contains(ball, new Vector3(0, 0.49f, 0.5f)));
        Assert.False(ShapeQuery.Contains(ball, new Vector3(0, 0.51f, 0.5f)));
    }

    [Fact, Behaviour("query.shape.hollow", "spec/06, 4: a mesh without a collision tree stops nothing")]
    public void A_mesh_without_a_tree_is_nothing_to_meet()
    {
        GfxObjAsset hollow = new() { Id = 0x01000002 };
        Assert.False(ShapeQuery.Contains(hollow, Vector3.Zero));
        Assert.False(ShapeQuery.Overlap(hollow, new Sphere(Vector3.Zero, 1)).Overlaps);
    }

    [Theory, Behaviour("query.bad-input.shape", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void Numbers_that_are_not_finite_are_refused(float bad)
    {
        SetupAsset setup = new() { Spheres = [new Sphere(Vector3.Zero, 1)] };
        Sphere good = new(Vector3.Zero, 1);
        Vector3 vector = new(0, bad, 0);
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Contains(Ask.Cube, vector));
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Contains(setup, vector));
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Overlap(Ask.Cube, good with { Center = vector }));
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Overlap(Ask.Cube, good with { Radius = bad }));
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Overlap(setup, good, vector));
        Assert.ThrowsAny<ArgumentException>(() => ShapeQuery.Overlap(setup, good with { Radius = 0 }));
    }

    private static Vector3 At(string numbers)
    {
        float[] n = Ground.Numbers(numbers.Replace(' ', ','));
        return new Vector3(n[0], n[1], n[2]);
    }
}
