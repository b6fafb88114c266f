using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>What fits where, and what is below: specification 03, 6.9, asked from outside.</summary>
public sealed class PlaceQueryTests
{
    [Theory, Behaviour("query.place", "spec/03, 6.9")]
    [InlineData(0.3f, 2.98023224e-8f, true)]
    [InlineData(1f, 1f, false)]
    [InlineData(-0.2f, 0f, true)]
    public void A_mover_put_near_the_floor_is_set_on_it(float z, float rests, bool contact)
    {
        PlaceResult placed = Query(Flat()).Place(new PlaceInput(Ask.Walker, Ask.Stub(0, 0, z)));
        Assert.True(placed is { Found: true, IsLoaded: true });
        Assert.Equal(rests, placed.Position.Frame.Origin.Z, 1e-7f);
        Assert.Equal(contact, placed.Contact is not null);
    }

    [Theory, Behaviour("query.place.short-reach", "spec/03, 6.9: one sphere, probe of half its radius")]
    [InlineData(0.1f, 7.4505806e-9f, true)]
    [InlineData(0.3f, 0.3f, false)]
    public void A_mover_of_one_small_sphere_reaches_down_half_its_radius(float z, float rests, bool contact)
    {
        PlaceResult placed = Query(Flat()).Place(new PlaceInput(Ask.SmallBall, Ask.Stub(0, 0, z)));
        Assert.Equal(rests, placed.Position.Frame.Origin.Z, 1e-7f);
        Assert.Equal(contact, placed.Contact is not null);
    }

    [Fact, Behaviour("query.place.slides", "spec/03, 6.9: the 19th try, third ring straight north")]
    public void A_mover_whose_place_is_taken_is_put_beside_it_or_nowhere()
    {
        StubWorld world = Flat();
        world.Blocks = t => t.Path.InsertType == Surefoot.Physics.Transitions.InsertType.Placement &&
            RetailMath.Length(t.Path.GlobalSpheres[0].Center - new Vector3(0, 0, 0.48f)) <= 0.96 - RetailMath.Epsilon;
        WorldQuery query = Query(world);
        PlaceResult beside = query.Place(new PlaceInput(Ask.Walker, Ask.Stub(0, 0, 0)));
        Assert.True(beside.Found);
        Assert.Equal(0, (beside.Position.Frame.Origin - new Vector3(0, 1.33333337f, 0)).Length(), 1e-6f);

        PlaceResult taken = query.Place(new PlaceInput(Ask.Walker, Ask.Stub(0, 0, 0), Slides: false));
        Assert.True(taken is { Found: false, IsLoaded: true });
        Assert.Equal(Ask.Stub(0, 0, 0), taken.Position);
    }

    [Fact, Behaviour("query.place.hangs", "spec/02, 4.16: hooks, chests and corpses are forced into their cell")]
    public void What_hangs_where_it_is_put_is_put_there_without_a_test()
    {
        StubWorld world = Flat();
        world.Blocks = _ => true;
        Mover chest = new(Ask.Walker.Setup, weenie: WeenieTraits.Present | WeenieTraits.Storage);
        PlaceResult placed = Query(world).Place(new PlaceInput(chest, Ask.Stub(0, 0, -3)));
        Assert.True(placed is { Found: true, Contact: null });
        Assert.Equal(Ask.Stub(0, 0, -3), placed.Position);
    }

    [Fact, Behaviour("query.not-loaded.place", "design, decision 7")]
    public void A_place_where_nothing_is_loaded_is_no_error_and_the_result_says_so()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Position elsewhere = Ask.At(10, 10, 5, 0x01010001);
        Assert.True(query.Place(new PlaceInput(Ask.Walker, elsewhere)) is { Found: false, IsLoaded: false });
        Assert.True(query.ProbeDown(new ProbeDownInput(Ask.Walker, elsewhere, 10)) is { Found: false, IsLoaded: false });
        SphereOverlap sphere = query.Overlap(new SphereInput(0x01010001, new Sphere(Vector3.One, 1)));
        Assert.True(sphere is { Overlaps: false, IsLoaded: false, CellId: 0 });
        Assert.True(query.Overlap(new PointInput(0x01010001, Vector3.One)) is { IsSolid: false, IsLoaded: false, CellId: 0 });
    }

    [Fact, Behaviour("query.probe-down.lands", "spec/03, 4.4 and 6.6, row 4: contact is made with the lowest point")]
    public void A_mover_let_down_from_five_metres_rests_on_the_ground()
    {
        ProbeDownResult below = Ask.Engine(0xA9B40000).CreateQuery().ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10, 10, 5), 10));
        Assert.True(below is { Found: true, IsLoaded: true });
        Assert.Equal(0, (below.Position.Frame.Origin - new Vector3(10, 10, 0)).Length(), 1e-5f);
        Assert.Equal(5, below.Depth, 1e-5f);
        Assert.Equal(new Plane(0, 0, 1, 0), below.Contact!.Value.Plane);
        Assert.Equal((TraceSubjectKind.Ground, Ask.Land), (below.Subject.Kind, below.Subject.CellId));
    }

    [Fact, Behaviour("query.probe-down.depth", "spec/03, 6.8, case 1b")]
    public void A_mover_let_down_by_less_than_there_is_air_touches_nothing()
    {
        ProbeDownResult below = Ask.Engine(0xA9B40000).CreateQuery().ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10, 10, 5), 4));
        Assert.True(below is { Found: false, IsLoaded: true, Contact: null });
        Assert.Equal(1, below.Position.Frame.Origin.Z, 1e-5f);
        Assert.Equal(TraceSubject.None, below.Subject);
    }

    [Theory, Behaviour("query.probe-down.slope", "spec/03, 6.8, cases 11 and 15: bodies slide down, a probe does not")]
    [InlineData(1, true)]
    [InlineData(2, true)]
    [InlineData(4, true)]
    [InlineData(6, true)]
    [InlineData(30, false)]
    public void A_mover_let_down_on_a_slope_rests_straight_below(int rise, bool walkable)
    {
        PhysicsWorld world = new();
        world.Add(new Landblock(Ground.Of(0xA9B40000, (i, _) => rise * i)));
        Position from = Ask.At(30, 40, 50, 0xA9B4000A);
        ProbeDownResult below = new PhysicsEngine(world).CreateQuery().ProbeDown(new ProbeDownInput(Ask.Ball, from, 60));
        Assert.True(below.Found);
        // Heights are told every 24 m.
        Assert.Equal(new Vector3(30, 40, 30f / 24 * rise), below.Position.Frame.Origin, static (a, b) => (a - b).Length() < 1e-4f);
        Assert.Equal(walkable, below.Contact!.Value.IsWalkable);
    }

    [Fact, Behaviour("query.probe-down.object", "spec/04, 6.13: the top of a cylinder is a floor")]
    public void A_mover_let_down_over_a_body_rests_on_it()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        SetupAsset post = new() { Id = 0x02000009, Cylinders = [new CylSphere(Vector3.Zero, 0.5f, 1)], Height = 1, Radius = 0.5f };
        Assert.True(engine.CreateBody(7, post).EnterWorld(Ask.At(10, 10, 0)));
        ProbeDownResult below = engine.CreateQuery().ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10.1f, 10, 5), 10));
        Assert.True(below.Found);
        Assert.Equal(1, below.Position.Frame.Origin.Z, 1e-5f);
        Assert.Equal((TraceSubjectKind.Body, 7u, 0x02000009u), (below.Subject.Kind, below.Subject.ObjectId, below.Subject.SetupId));
    }

    [Theory, Behaviour("query.bad-input.place", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void Numbers_of_a_place_that_are_not_finite_are_refused_and_change_nothing(float bad)
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        ulong before = engine.HashState();
        WorldQuery query = engine.CreateQuery();
        Assert.ThrowsAny<ArgumentException>(() => query.Place(new PlaceInput(Ask.Ball, Ask.At(bad, 10, 0))));
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10, 10, bad), 1)));
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10, 10, 1), bad)));
        Assert.Equal(before, engine.HashState());
    }

    [Theory, Behaviour("query.bad-input.no-depth", "design, decision 7")]
    [InlineData(0f)]
    [InlineData(-1f)]
    public void A_depth_of_nothing_is_refused(float depth)
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Ball, Ask.At(10, 10, 1), depth)));
    }

    [Fact, Behaviour("query.bad-input.no-mover", "design, decision 7")]
    public void Nobody_is_refused()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(default));
        Assert.ThrowsAny<ArgumentException>(() => query.Place(default));
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(default));
    }

    [Theory, Behaviour("query.bad-input.mover", "design, decision 7")]
    [InlineData(0f)]
    [InlineData(-0.1f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_mover_whose_numbers_are_not_positive_and_finite_is_refused(float bad)
    {
        Sphere good = new(Vector3.Zero, 0.5f);
        Assert.ThrowsAny<ArgumentException>(() => new Mover([new Sphere(Vector3.Zero, bad)], 0.6f, 0.6f));
        Assert.ThrowsAny<ArgumentException>(() => new Mover([good, new Sphere(Vector3.Zero, bad)], 0.6f, 0.6f));
        Assert.ThrowsAny<ArgumentException>(() => new Mover(new SetupAsset { Spheres = [new Sphere(Vector3.Zero, bad)] }));
        Assert.ThrowsAny<ArgumentException>(() => new Mover(Ask.Ball.Setup, scale: bad));
        Assert.ThrowsAny<ArgumentException>(() => Mover.OfBody(Ask.Ball.Setup, scale: bad));
        if (bad == 0) return;
        Assert.ThrowsAny<ArgumentException>(() => new Mover([good], bad, 0.6f));
        Assert.ThrowsAny<ArgumentException>(() => new Mover([good], 0.6f, bad));
    }

    [Theory, Behaviour("query.bad-input.sphere-count", "design, decision 7; spec/03, 2.4")]
    [InlineData(0)]
    [InlineData(3)]
    public void A_mover_of_no_sphere_or_of_more_than_the_engine_takes_is_refused(int count) => Assert.ThrowsAny<ArgumentException>(
        () => new Mover([.. Enumerable.Repeat(new Sphere(Vector3.Zero, 0.5f), count)], 0.6f, 0.6f));

    [Fact, Behaviour("query.bad-input.spheres-of-a-shape", "design, decision 7; spec/03, 2.4")]
    public void A_shape_of_more_spheres_than_the_engine_takes_is_a_mover_only_as_a_body_is_one()
    {
        Sphere[] spheres = [new(Vector3.Zero, 0.5f), new(Vector3.UnitZ, 0.5f), new(new Vector3(0, 0, 2), float.NaN)];
        SetupAsset setup = new() { Spheres = spheres };
        Assert.Equal("setup", Assert.Throws<ArgumentException>(() => new Mover(setup)).ParamName);
        Assert.Same(setup, Mover.OfBody(setup).Setup);
        Assert.Equal("setup", Assert.Throws<ArgumentException>(() => Mover.OfBody(new() { Spheres = [spheres[1], spheres[2]] })).ParamName);
    }

    [Theory, Behaviour("query.bad-input.scaled-radius", "design, decision 7")]
    [InlineData(1e30f, 1e30f)]
    [InlineData(1e-30f, 1e-30f)]
    public void A_mover_whose_scaled_radius_is_no_number_or_zero_is_refused(float radius, float scale) =>
        Assert.Equal("scale", Assert.Throws<ArgumentException>(
            () => new Mover(new SetupAsset { Spheres = [new Sphere(Vector3.Zero, radius)] }, scale: scale)).ParamName);

    /// <summary>The last column and the last row of ids hold no land, and neither does the id 0.</summary>
    [Theory, Behaviour("query.bad-input.off-the-map", "design, decision 7; spec/05, 1.1: inbound_valid_cellid")]
    [InlineData(0xFF010001u)]
    [InlineData(0x01FF0001u)]
    [InlineData(0xFFFF0100u)]
    [InlineData(0u)]
    public void A_cell_that_is_not_on_the_map_is_refused_by_every_question(uint id)
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Position here = Ask.At(10, 10, 1), nowhere = Ask.At(10, 10, 1, id);
        Contact ground = new(new Plane(Vector3.UnitZ, 0), id);
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody body = engine.CreateBody(1, Ask.Walker.Setup);
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(new SweepInput(Ask.Walker, nowhere, here)));
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(new SweepInput(Ask.Walker, here, nowhere)));
        if (id != 0)
        {
            BodySeat seat = body.CurrentSeat with { Position = here, ContactPlane = ground.Plane, ContactPlaneCellId = id };
            Assert.ThrowsAny<ArgumentException>(() => query.Sweep(new SweepInput(Ask.Walker, here, here) { Contact = ground }));
            Assert.ThrowsAny<ArgumentException>(() => engine.CreateQuery().Sweep(body, seat, here));
        }

        Assert.ThrowsAny<ArgumentException>(() => engine.CreateQuery().Sweep(body, nowhere));
        Assert.ThrowsAny<ArgumentException>(() => engine.CreateQuery().Sweep(body, body.CurrentSeat with { Position = nowhere }, here));
        Assert.ThrowsAny<ArgumentException>(() => query.Place(new PlaceInput(Ask.Walker, nowhere)));
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Walker, nowhere, 1)));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new SphereInput(id, new Sphere(Vector3.Zero, 1))));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new PointInput(id, Vector3.Zero)));
    }

    private static StubWorld Flat() => new(_ => StubWorld.Flat(0));

    private static WorldQuery Query(StubWorld world) => new PhysicsEngine(world).CreateQuery();
}
