using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>The engine is the door: what comes through it belongs to it.</summary>
public sealed class EngineDoorTests
{
    [Fact, Behaviour("engine.one-world", "design: PhysicsEngine owns a world")]
    public void A_world_that_belongs_to_an_engine_is_taken_over_by_no_other()
    {
        PhysicsWorld world = Tests.World.CellListTests.Flat(0xA9B40000);
        Assert.Same(world, new PhysicsEngine(world).World);
        Assert.Throws<InvalidOperationException>(() => new PhysicsEngine(world));
    }

    [Fact, Behaviour("engine.body-with-motions", "spec/09b, 3; design: motions are given where a body is created")]
    public void A_body_that_is_made_with_motions_has_them_from_the_beginning_and_one_made_without_has_none()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody walker = engine.CreateBody(1, Ask.Walker.Setup, motions: new BodyMotions(HumanoidTable.Create(), FakeBody.Player()));
        Assert.Equal(MotionSummary.Standing, engine.MovementOf(walker)!.Motions);
        Assert.NotNull(engine.MovementOf(walker)!.Animation);
        Assert.True(walker.IsActive);
        Assert.Null(engine.MovementOf(engine.CreateBody(2, Ask.Walker.Setup)));
    }

    [Fact, Behaviour("engine.foreign-body", "design, decision 7")]
    public void A_body_of_another_engine_is_refused_and_nothing_changes()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000), other = Ask.Engine(0xA9B40000);
        PhysicsBody own = engine.CreateBody(1, Ask.Walker.Setup), foreign = other.CreateBody(1, Ask.Walker.Setup);
        Assert.True(foreign.EnterWorld(Ask.At(10, 10, 0)));
        ulong before = other.HashState();
        Assert.ThrowsAny<ArgumentException>(() => engine.RemoveBody(foreign));
        Assert.ThrowsAny<ArgumentException>(() => engine.MovementOf(foreign));
        Assert.ThrowsAny<ArgumentException>(() => engine.Player = foreign);
        Assert.Null(engine.Player);
        Assert.Same(own, engine.Find(1));
        Assert.Equal(before, other.HashState());
    }

    [Fact, Behaviour("engine.removed-body", "design, decision 7")]
    public void A_body_that_was_removed_stays_away_and_who_has_its_id_now_is_left_alone()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody gone = engine.CreateBody(1, Ask.Walker.Setup);
        engine.RemoveBody(gone);
        PhysicsBody next = engine.CreateBody(1, Ask.Walker.Setup);
        Assert.True(next.EnterWorld(Ask.At(10, 10, 0)));
        engine.RemoveBody(gone);
        Assert.Same(next, engine.Find(1));
        Assert.Throws<InvalidOperationException>(() => gone.EnterWorld(Ask.At(20, 10, 0)));
        Assert.Throws<InvalidOperationException>(() => gone.SetPositionSimple(Ask.At(20, 10, 0), sliding: true));
        Assert.Throws<InvalidOperationException>(() => gone.SetParent(next, 1));
        Assert.Throws<InvalidOperationException>(() => next.SetParent(gone, 1));
        Assert.False(gone.HasCell);
        Assert.Equal([next], engine.Bodies);
    }

    [Theory, Behaviour("body.seat.bad-input", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_state_whose_numbers_are_not_finite_is_refused_and_nothing_changes(float bad)
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody body = engine.CreateBody(1, Ask.Walker.Setup);
        BodySeat good = new(Ask.At(10, 10, 0), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero);
        body.Seat(good);
        ulong before = engine.HashState();
        Assert.ThrowsAny<ArgumentException>(() => body.Seat(good with { Position = Ask.At(bad, 10, 0) }));
        Assert.ThrowsAny<ArgumentException>(() => body.Seat(good with { Position = Ask.At(10, 10, 0, 0xA9B40041) }));
        Assert.ThrowsAny<ArgumentException>(() => body.Seat(good with { Velocity = new Vector3(bad, 0, 0) }));
        Assert.ThrowsAny<ArgumentException>(() => body.Seat(good with { ContactPlane = new Plane(0, 0, 1, bad) }));
        Assert.ThrowsAny<ArgumentException>(() => body.Seat(good with { SlidingNormal = new Vector3(0, bad, 0) }));
        Assert.Equal(before, engine.HashState());
    }

    [Theory, Behaviour("asset.spheres.bad-input", "design, decision 7")]
    [InlineData(0f, 0f)]
    [InlineData(-1f, 0f)]
    [InlineData(float.NaN, 0f)]
    [InlineData(float.PositiveInfinity, 0f)]
    [InlineData(1f, -1f)]
    [InlineData(1f, float.NaN)]
    public void A_shape_without_spheres_or_with_numbers_out_of_range_is_refused(float radius, float height)
    {
        Assert.ThrowsAny<ArgumentException>(() => SetupAsset.OfSpheres(1, [new Sphere(Vector3.Zero, radius)], height, 0.1f));
        Assert.ThrowsAny<ArgumentException>(() => SetupAsset.OfSpheres(1, [new Sphere(Vector3.Zero, radius)], 0.1f, height));
        Assert.ThrowsAny<ArgumentException>(() => SetupAsset.OfSpheres(1, []));
    }
}
