using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>What is at a place of a world.</summary>
public sealed class OverlapQueryTests
{
    [Theory, Behaviour("query.overlap.ground", "spec/03, 6.6: the lowest point against the plane, within 0.0002 m")]
    [InlineData(0.5f, false)]
    [InlineData(0.4999f, false)]
    [InlineData(0.4997f, true)]
    [InlineData(-3f, true)]
    public void A_sphere_reaches_into_the_ground_when_its_lowest_point_is_below(float z, bool overlaps)
    {
        SphereInput input = new(Ask.Land, new Sphere(new Vector3(10, 10, z), 0.5f));
        SphereOverlap found = Ask.Engine(0xA9B40000).CreateQuery().Overlap(input);
        Assert.Equal((overlaps, true, Ask.Land), (found.Overlaps, found.IsLoaded, found.CellId));
        Assert.Equal(overlaps ? TraceSubjectKind.Ground : TraceSubjectKind.None, found.Subject.Kind);
    }

    [Fact, Behaviour("query.overlap.open-water", "spec/05, 4.16: open water stops bodies, but is not solid")]
    public void A_sphere_over_open_water_reaches_into_nothing()
    {
        PhysicsWorld world = new();
        world.Add(new Landblock(Tests.World.Ground.Flat(0xA9B40000, type: 16)));
        WorldQuery query = new PhysicsEngine(world).CreateQuery();
        Assert.False(query.Overlap(new SphereInput(Ask.Land, new Sphere(new Vector3(10, 10, 1), 0.5f))).Overlaps);
        Assert.False(query.Place(new PlaceInput(Ask.Ball, Ask.At(10, 10, 1))).Found);
    }

    [Theory, Behaviour("query.overlap.cylinder", "spec/04, 6.13: above the rim")]
    [InlineData(9.7f, 1.48f, false)]
    [InlineData(9.7f, 1.4797f, true)]
    [InlineData(9.0203f, 1f, true)]
    [InlineData(9.01f, 1f, false)]
    public void A_sphere_reaches_into_a_body_of_a_cylinder(float x, float z, bool overlaps)
    {
        (PhysicsEngine engine, PhysicsBody post) = Post();
        SphereInput input = new(Ask.Land, new Sphere(new Vector3(x, 10, z), 0.48f));
        SphereOverlap found = engine.CreateQuery().Overlap(input);
        Assert.Equal(overlaps, found.Overlaps);
        Assert.Equal(overlaps ? post.Id : 0, found.Subject.ObjectId);
        Assert.False(engine.CreateQuery().Overlap(input with { Except = post }).Overlaps);
    }

    [Fact, Behaviour("query.overlap.ethereal", "spec/02, 4.21: the ethereal stop nobody")]
    public void The_ethereal_count_for_nothing()
    {
        (PhysicsEngine engine, PhysicsBody post) = Post();
        WorldQuery query = engine.CreateQuery();
        SphereInput sphere = new(Ask.Land, new Sphere(new Vector3(10, 10, 1), 0.48f));
        PointInput point = new(Ask.Land, new Vector3(10, 10, 0.5f));
        Assert.True(query.Overlap(sphere).Overlaps && query.Overlap(point).IsSolid);
        Assert.True(post.SetEthereal(true));
        Assert.False(query.Overlap(sphere).Overlaps || query.Overlap(point).IsSolid);
    }

    [Fact, Behaviour("query.overlap.border", "spec/05, 4.10 and 4.19")]
    public void A_sphere_that_reaches_over_the_edge_of_what_is_loaded_says_so()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Sphere high = new(new Vector3(191.8f, 100, 5), 0.5f);
        Assert.True(query.Overlap(new SphereInput(0xA9B4003D, high)) is { Overlaps: false, IsLoaded: false, CellId: 0xA9B4003D });
        Assert.True(query.Overlap(new SphereInput(0xA9B4003D, high with { Radius = 0.1f })) is { Overlaps: false, IsLoaded: true });
    }

    [Theory, Behaviour("query.point", "spec/05, 4.4 and 4.18; spec/04, 6.13")]
    [InlineData(50, 50, 0.1f, 0xA9B40013u, TraceSubjectKind.None)]
    [InlineData(50, 50, -0.1f, 0xA9B40013u, TraceSubjectKind.Ground)]
    [InlineData(10.4f, 10, 0.9f, Ask.Land, TraceSubjectKind.Body)]
    [InlineData(10.6f, 10, 0.9f, Ask.Land, TraceSubjectKind.None)]
    [InlineData(10.4f, 10, 1.1f, Ask.Land, TraceSubjectKind.None)]
    public void A_point_is_in_a_cell_and_perhaps_in_something_solid(float x, float y, float z, uint cell, TraceSubjectKind kind)
    {
        (PhysicsEngine engine, _) = Post();
        PointOverlap found = engine.CreateQuery().Overlap(new PointInput(Ask.Land, new Vector3(x, y, z)));
        Assert.Equal((kind != TraceSubjectKind.None, true, cell, kind), (found.IsSolid, found.IsLoaded, found.CellId, found.Subject.Kind));
    }

    [Theory, Behaviour("query.point.tree", "spec/04, 6.7: point_intersects_solid, the part where it stands")]
    [InlineData(10.49f, 0.75f, true)]
    [InlineData(10.51f, 0.75f, false)]
    [InlineData(10f, 1.26f, false)]
    [InlineData(10f, 1.24f, true)]
    public void A_point_is_inside_a_body_of_trees_where_its_parts_are(float x, float z, bool solid)
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        SetupAsset crate = new SetupAsset { Id = 0x02000008, Parts = [new SetupPart(Ask.Cube, Vector3.One)] }.With(0, [Frame.Identity]);
        PhysicsBody body = engine.CreateBody(8, crate, PhysicsState.ReportCollisions);
        Assert.Equal(PlacementResult.OK, body.SetPosition(new PlacementRequest(Ask.At(10, 10, 0.75f))));
        PointOverlap found = engine.CreateQuery().Overlap(new PointInput(Ask.Land, new Vector3(x, 10, z)));
        Assert.Equal(solid, found.IsSolid);
        Assert.Equal(solid ? 8u : 0, found.Subject.ObjectId);
        if (solid) Assert.Equal(0, found.Subject.Part);
    }

    [Theory, Behaviour("query.bad-input.overlap", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void Numbers_of_a_point_or_sphere_that_are_not_finite_are_refused_and_change_nothing(float bad)
    {
        (PhysicsEngine engine, _) = Post();
        ulong before = engine.HashState();
        WorldQuery query = engine.CreateQuery();
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new PointInput(Ask.Land, new Vector3(1, bad, 1))));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new SphereInput(Ask.Land, new Sphere(new Vector3(1, 1, bad), 1))));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new SphereInput(Ask.Land, new Sphere(Vector3.One, bad))));
        Assert.Equal(before, engine.HashState());
    }

    [Theory, Behaviour("query.bad-input.zero-radius", "design, decision 7")]
    [InlineData(0f)]
    [InlineData(-1f)]
    public void A_sphere_without_a_radius_is_refused(float radius) => Assert.ThrowsAny<ArgumentException>(
        () => Ask.Engine(0xA9B40000).CreateQuery().Overlap(new SphereInput(Ask.Land, new Sphere(Vector3.One, radius))));

    /// <summary>The cylinder of specification 04, 6.13, ten metres into a block.</summary>
    private static (PhysicsEngine Engine, PhysicsBody Post) Post()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody post = engine.CreateBody(7, new SetupAsset { Id = 0x02000009, Cylinders = [new CylSphere(Vector3.Zero, 0.5f, 1)] });
        Assert.Equal(PlacementResult.OK, post.SetPosition(new PlacementRequest(Ask.At(10, 10, 0))));
        return (engine, post);
    }
}
