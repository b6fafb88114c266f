using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Arrows and spells that a server describes: specification 09, 5.5 and 5.8; 06, 7.</summary>
public sealed class RemoteMissileTests(DemoFiles files) : IClassFixture<DemoFiles>, ICollisionListener
{
    private const PhysicsState Bolt =
        PhysicsState.ReportCollisions | PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped;

    /// <summary>High over the meadow, so that nothing of the land is in the way.</summary>
    private static readonly Vector3 Sky = new(100, 60, 150);

    private readonly List<(uint Told, uint Of, Impact Impact)> hits = [];

    [Fact]
    [Behaviour("remote.missile.flies-as-described", "spec/09, 5.8: velocity and omega of the description; spec/06, 7")]
    public void A_missile_flies_with_the_velocity_and_spins_with_the_omega_of_its_description()
    {
        RemoteFixture f = Over();
        PhysicsBody missile = Shoot(f, new Vector3(30, 40, 0), Bolt & ~PhysicsState.AlignPath, new Vector3(0, 0, MathF.PI / 2));
        f.Frames(30);
        AssertNear(Sky + new Vector3(30, 40, 0), missile.Position.Frame.Origin);
        AssertNear(-Vector3.UnitX, missile.Position.Frame.YAxis);
    }

    [Fact]
    [Behaviour("remote.missile.hit-is-told-once", "spec/02, 4.15; spec/06, 6")]
    public void What_a_missile_hits_is_told_once_with_place_and_normal_and_the_server_takes_it_away()
    {
        RemoteFixture f = Over();
        ObjectDescription described = Describe(Other, Sky + new Vector3(0, 20, -0.475f));
        PhysicsBody target = f.Create(
            described with { Physics = described.Physics with { State = (uint)PhysicsState.ReportCollisions } }).Body;
        PhysicsBody missile = Shoot(f, new Vector3(0, 50, 0));
        target.Listener = this;
        f.Frames(60);
        Assert.Equal([(One, Other), (Other, One)], hits.Select(hit => (hit.Told, hit.Of)));
        // Radii 0.48 and 0.1; the missile's sphere is 0.1 above its place and ends less than its radius before they touch.
        AssertNear(-Vector3.UnitY, hits[0].Impact.Normal with { Z = 0 }, 0.03f);
        Assert.InRange(hits[0].Impact.Place.Frame.Origin.Y - Sky.Y, 20 - 0.68f, 20 - 0.57f);
        Assert.Equal(PhysicsState.ReportCollisions, missile.State);

        f.Say(new DeleteObject(One, 1));
        Assert.Null(f.Remote.Find(One));
        f.Frames(5);
        Assert.Equal(2, hits.Count);
    }

    [Fact]
    [Behaviour("remote.missile.vector-update", "spec/09, 5.5: velocity and omega; 02, 4.9: at most 50 m/s")]
    public void A_new_velocity_turns_a_missile_on_its_way()
    {
        RemoteFixture f = Over();
        PhysicsBody missile = Shoot(f, new Vector3(0, 40, 0));
        f.Frames(15);
        f.Say(new VectorUpdate(One, new Vector3(80, 0, 0), Vector3.Zero, 1, 1));
        f.Frames(30);
        AssertNear(Sky + new Vector3(50, 20, 0), missile.Position.Frame.Origin);
        AssertNear(Vector3.UnitX, missile.Position.Frame.YAxis);
    }

    [Fact]
    [Behaviour("remote.missile.becomes-one-by-state", "spec/09, 5.5, SetState; spec/03, 4.4, missile_ignore")]
    public void What_a_server_makes_a_missile_passes_missiles_from_then_on()
    {
        RemoteFixture f = Over();
        ObjectDescription described = DescribeThing(Other, Sky + new Vector3(0, 20, 0));
        f.Create(described with { Physics = described.Physics with { State = (uint)Bolt } });
        PhysicsBody thing = Shoot(f, new Vector3(0, 10, 0), PhysicsState.ReportCollisions);
        f.Say(new SetState(One, (uint)Bolt, 1, 1));
        f.Frames(90);
        AssertNear(Sky + new Vector3(0, 30, 0), thing.Position.Frame.Origin);
        Assert.Empty(hits);
    }

    private RemoteFixture Over()
    {
        PhysicsEngine engine = files.CreateEngine();
        engine.World.EnsureLoadedAround(new Position(Physics.Tests.Transitions.StubWorld.CellId, Sky), 1);
        return new RemoteFixture(engine: engine);
    }

    private PhysicsBody Shoot(RemoteFixture f, Vector3 velocity, PhysicsState state = Bolt, Vector3 omega = default)
    {
        ObjectDescription described = DescribeThing(One, Sky);
        PhysicsBody missile = f.Create(
            described with { Physics = described.Physics with { State = (uint)state, Velocity = velocity, Omega = omega } }).Body;
        missile.Listener = this;
        return missile;
    }

    private static void AssertNear(Vector3 expected, Vector3 actual, float tolerance = 0.01f) =>
        Assert.True(Vector3.Distance(expected, actual) < tolerance, $"{actual} instead of {expected}");

    void ICollisionListener.OnEnvironmentCollision(PhysicsBody body, in EnvironmentCollision collision) =>
        hits.Add((body.Id, 0, collision.Impact));

    void ICollisionListener.OnObjectCollision(WorldObject body, in ObjectCollision collision) =>
        hits.Add((body.Id, collision.ObjectId, collision.Impact));

    void ICollisionListener.OnAttackCollision(WorldObject body, in AttackCollision collision) =>
        hits.Add((body.Id, collision.ObjectId, collision.Impact));

    void ICollisionListener.OnCollisionEnd(WorldObject body, uint objectId)
    {
    }
}
