using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>Where a way leads: the whole sweeps of specification 03, 6.8, asked from outside.</summary>
public sealed class SweepQueryTests
{
    private static readonly Vector3 West = new(-1, 0, 0);

    [Fact, Behaviour("query.sweep.walks", "spec/03, 6.8, case 2")]
    public void A_mover_on_the_ground_walks_the_whole_way()
    {
        SweepResult walk = Sweep(Flat(), Ask.Stub(0, 0, 0), Ask.Stub(1, 0, 0), Ask.Flat);
        Assert.True(walk is { Found: true, IsLoaded: true, LosesVelocity: false, CollidedWithEnvironment: false });
        Assert.True(walk is { CollisionNormal: null, SlidingNormal: null });
        Assert.Equal(0, (walk.Position.Frame.Origin - Vector3.UnitX).Length(), 1e-6f);
        Assert.Equal(Ask.Flat, walk.Contact);
        Assert.True(walk.Contact!.Value.IsWalkable);
    }

    [Fact, Behaviour("query.sweep.lands", "spec/03, 6.8, cases 1 and 1b")]
    public void A_mover_in_the_air_lands_where_its_way_meets_the_ground_and_only_there()
    {
        SweepResult landing = Sweep(Flat(), Ask.Stub(0, 0, 0.1f), Ask.Stub(0.02f, 0, -0.2f));
        Assert.True(landing is { Found: true, CollidedWithEnvironment: true, Contact: not null });
        Assert.Equal(new Vector3(0.02f, 0, 0), landing.Position.Frame.Origin, Near);
        Assert.Equal(Vector3.UnitZ, landing.CollisionNormal);
        Assert.Equal(Vector3.Zero, landing.SlidingNormal);

        SweepResult fall = Sweep(Flat(), Ask.Stub(0, 0, 1), Ask.Stub(0.02f, 0, 0.7f));
        Assert.True(fall is { Found: true, CollidedWithEnvironment: false, Contact: null });
        Assert.Equal(new Vector3(0.02f, 0, 0.7f), fall.Position.Frame.Origin, Near);
    }

    [Fact, Behaviour("query.sweep.goes-on", "spec/03, 6.8, cases 6 and 6b")]
    public void The_result_of_a_way_is_the_begin_of_the_next_one()
    {
        StubWorld world = Flat();
        world.Wall = (West, 0.6f, _ => true);
        SweepInput input = new(Ask.Walker, Ask.Stub(0, 0, 0), Ask.Stub(0.3f, 0.3f, 0)) { Contact = Ask.Flat };
        WorldQuery query = new PhysicsEngine(world).CreateQuery();
        SweepResult along = query.Sweep(input);
        Assert.Equal(new Vector3(0, 0.3f, 0), along.Position.Frame.Origin, Near);
        Assert.Equal(West, along.SlidingNormal);

        world.Wall = null;
        SweepResult next = query.Sweep(input with
        {
            From = along.Position,
            To = Ask.Stub(0.3f, 0.6f, 0),
            Contact = along.Contact,
            SlidingNormal = along.SlidingNormal,
        });
        // The wall is remembered although it has ended.
        Assert.Equal(new Vector3(0, 0.6f, 0), next.Position.Frame.Origin, Near);
        Assert.Null(next.SlidingNormal);
    }

    [Fact, Behaviour("query.sweep.blocked", "spec/03, 6.8, case 7")]
    public void A_way_straight_into_a_wall_ends_where_it_began_and_costs_the_velocity()
    {
        StubWorld world = Flat();
        world.Wall = (West, 0.6f, _ => true);
        SweepResult blocked = Sweep(world, Ask.Stub(0, 0, 0), Ask.Stub(0.3f, 0, 0), Ask.Flat);
        Assert.True(blocked is { Found: true, LosesVelocity: true });
        Assert.Equal(Vector3.Zero, blocked.Position.Frame.Origin);
        Assert.Equal(Ask.Flat, blocked.Contact);
    }

    [Fact, Behaviour("query.sweep.stands", "spec/03, 6.8, case 3")]
    public void A_mover_that_stands_cannot_go_down_and_stays()
    {
        SweepResult stays = Sweep(Flat(), Ask.Stub(0, 0, 0), Ask.Stub(0, 0, -0.02f), Ask.Flat);
        Assert.True(stays is { Found: false, IsLoaded: true });
        Assert.Equal(Ask.Stub(0, 0, 0), stays.Position);
    }

    [Fact, Behaviour("query.not-loaded.sweep", "design, decision 7; spec/05, 4.19")]
    public void A_way_where_nothing_is_loaded_is_no_error_and_the_result_says_so()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Position elsewhere = Ask.At(10, 10, 0, 0x01010001);
        SweepResult nowhere = query.Sweep(new SweepInput(Ask.Walker, elsewhere, Ask.At(11, 10, 0, 0x01010001)));
        Assert.True(nowhere is { Found: false, IsLoaded: false });
        Assert.Equal(elsewhere, nowhere.Position);

        SweepResult leaving = query.Sweep(new SweepInput(Ask.Walker, Ask.At(191, 100, 5, 0xA9B4003D), Ask.At(193, 100, 5, 0xA9B4003D)));
        Assert.True(leaving is { Found: true, IsLoaded: false });
        Assert.Equal(0xAAB40005u, leaving.Position.CellId);
    }

    [Fact, Behaviour("query.sweep.cell-put-right", "spec/05, 4.18")]
    public void A_way_that_begins_beside_its_cell_begins_in_the_cell_it_is_in()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        SweepResult sweep = query.Sweep(new SweepInput(Ask.Walker, Ask.At(100, 100, 5), Ask.At(101, 100, 5)));
        Assert.Equal(0xA9B40025u, sweep.Position.CellId);
        Assert.Equal(101, sweep.Position.Frame.Origin.X, 1e-4f);
    }

    [Theory, Behaviour("query.bad-input.sweep", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(float.NegativeInfinity)]
    public void Numbers_of_a_way_that_are_not_finite_are_refused_and_change_nothing(float bad)
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        ulong before = engine.HashState();
        WorldQuery query = engine.CreateQuery();
        SweepInput good = new(Ask.Walker, Ask.At(10, 10, 0), Ask.At(11, 10, 0));
        SweepResult answer = query.Sweep(good);
        Refuse(good with { From = Ask.At(bad, 10, 0) });
        Refuse(good with { To = Ask.At(10, bad, 0) });
        Refuse(good with { Contact = new Contact(new Plane(0, 0, 1, bad), Ask.Land) });
        Refuse(good with { Contact = new Contact(new Plane(bad, 0, 1, 0), Ask.Land) });
        Refuse(good with { SlidingNormal = new Vector3(bad, 0, 0) });
        Assert.Equal(answer, query.Sweep(good));
        Assert.Equal(before, engine.HashState());

        void Refuse(SweepInput input) => Assert.ThrowsAny<ArgumentException>(() => query.Sweep(input));
    }

    [Theory, Behaviour("query.bad-input.unknown-cell", "design, decision 7; spec/05, 2.1")]
    [InlineData(0u)]
    [InlineData(0xA9B40000u)]
    [InlineData(0xA9B40041u)]
    [InlineData(0xA9B400FFu)]
    [InlineData(0xA9B4FFFEu)]
    public void An_id_that_cannot_name_a_cell_is_refused(uint id)
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Position good = Ask.At(10, 10, 0), bad = Ask.At(10, 10, 0, id);
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(new SweepInput(Ask.Walker, bad, good)));
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(new SweepInput(Ask.Walker, good, bad)));
        Assert.ThrowsAny<ArgumentException>(() => query.Place(new PlaceInput(Ask.Walker, bad)));
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Walker, bad, 1)));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new SphereInput(id, new(Vector3.One, 1))));
        Assert.ThrowsAny<ArgumentException>(() => query.Overlap(new PointInput(id, Vector3.One)));
    }

    [Fact, Behaviour("query.bad-input.too-far", "design, decision 7")]
    public void A_way_of_more_sub_steps_than_one_question_takes_is_refused_and_says_what_to_do()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        SweepInput far = new(Ask.Walker, Ask.At(10, 10, 0), Ask.At(1e30f, 10, 0));
        ArgumentException e = Assert.ThrowsAny<ArgumentException>(() => query.Sweep(far));
        Assert.Contains("in parts", e.Message, StringComparison.Ordinal);
        Assert.ThrowsAny<ArgumentException>(() => query.ProbeDown(new ProbeDownInput(Ask.Walker, Ask.At(10, 10, 0), 1e30f)));
    }

    [Fact, Behaviour("query.bad-input.foreign-body", "design, decision 7")]
    public void A_body_of_another_engine_is_refused()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000), other = Ask.Engine(0xA9B40000);
        PhysicsBody body = other.CreateBody(1, Ask.Walker.Setup);
        Assert.True(body.EnterWorld(Ask.At(10, 10, 0)));
        Assert.ThrowsAny<ArgumentException>(() => engine.CreateQuery().Sweep(body, Ask.At(11, 10, 0)));
        Assert.True(other.CreateQuery().Sweep(body, Ask.At(11, 10, 0)).Found);
    }

    [Fact, Behaviour("engine.resolve", "design, seed names")]
    public void The_engine_answers_a_way_as_its_queries_do()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        Position from = Ask.At(10, 10, 0.1f), to = Ask.At(10.3f, 10, -0.3f);
        SweepResult resolved = engine.Resolve(Ask.Walker.Setup, from, to, Ask.Walker.State);
        Assert.Equal(engine.CreateQuery().Sweep(new SweepInput(Ask.Walker, from, to)), resolved);
        Assert.True(resolved is { Found: true, Contact: not null });
        Assert.ThrowsAny<ArgumentException>(() => engine.Resolve(Ask.Walker.Setup, Ask.At(float.NaN, 0, 0), to));
    }

    private static bool Near(Vector3 expected, Vector3 actual) => (expected - actual).Length() <= 1e-6f;

    private static StubWorld Flat() => new(_ => StubWorld.Flat(0));

    private static SweepResult Sweep(StubWorld world, in Position from, in Position to, Contact? contact = null) =>
        new PhysicsEngine(world).CreateQuery().Sweep(new SweepInput(Ask.Walker, from, to) { Contact = contact });
}
