using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Bounces, the environment latch, masks, and who is told of what: specification 02, 4.14, 4.15, 6.8, 6.12 and 6.13.</summary>
public class CollisionReportTests
{
    private const WeenieTraits Creature = WeenieTraits.Present | WeenieTraits.Creature;

    public static TheoryData<Vector3, Vector3, float, bool, Vector3> Bounces => new()
    {
        { new(3, 0, -8), Vector3.UnitZ, 0.05f, false, new(3, 0, 0.399999619f) },
        { new(0, 5, -8), new(0, -0.6f, 0.8f), 0.05f, false, new(0, -0.922000408f, -0.103999615f) },
        { new(6, 2, 0), -Vector3.UnitX, 0.05f, false, new(-0.300000012f, 2, 0) },
        { new(6, 2, 0), -Vector3.UnitX, 0.1f, false, new(-0.600000024f, 2, 0) },
        { new(0, 0, 4), Vector3.UnitZ, 0.05f, false, new(0, 0, 4) },
        { new(3, 0, -8), Vector3.UnitZ, 0.05f, true, Vector3.Zero },
    };

    [Theory, MemberData(nameof(Bounces)), Behaviour("body.bounce.table", "spec/02, 6.8")]
    public void A_velocity_into_a_surface_is_reflected_by_the_elasticity(
        Vector3 velocity, Vector3 normal, float elasticity, bool inelastic, Vector3 expected)
    {
        BodyFixture f = new(inelastic ? PhysicsState.Default | PhysicsState.Inelastic : PhysicsState.Default);
        f.Body.SetElasticity(elasticity);
        f.Seat(new(12, 12, 10), velocity, TransientState.None);
        f.Body.Bounce(normal);
        Assert.Equal(expected, f.Body.Velocity);
    }

    [Fact, Behaviour("body.reports.environment-latch", "spec/02, 6.12")]
    public void The_environment_is_reported_when_a_touch_begins_and_not_while_it_lasts()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        f.Seat(new(12, 12, 10), Vector3.Zero, TransientState.None);
        int[] touches = [1, 1, 1, 0, 1, 0, 0], reports = [1, 0, 0, 0, 1, 0, 0];
        for (int i = 0; i < touches.Length; i++)
        {
            int before = witness.Environments;
            f.Body.HandleAllCollisions(Touching(touches[i] == 1), hadContact: false, hadWalkable: false, simulatedTime: i);
            Assert.Equal(reports[i], witness.Environments - before);
        }
    }

    [Fact, Behaviour("body.reports.landing", "spec/02, 6.12")]
    public void A_landing_is_reported_even_when_the_sweep_met_no_environment()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        f.Body.HandleAllCollisions(Touching(false), hadContact: false, hadWalkable: false, simulatedTime: 0);
        Assert.Equal(1, witness.Environments);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 0);
        Assert.Equal(1, witness.Environments);
    }

    [Fact, Behaviour("body.missile.masks", "spec/02, 6.13")]
    public void A_missile_that_has_hit_is_no_missile_any_more()
    {
        BodyFixture f = new((PhysicsState)0x00400F48);
        f.Seat(new(12, 12, 10), Vector3.Zero, TransientState.None);
        f.Body.HandleAllCollisions(Touching(true), hadContact: false, hadWalkable: false, simulatedTime: 0);
        Assert.Equal((PhysicsState)0x00400C08, f.Body.State);
    }

    [Theory, Behaviour("body.stationary-fall.masks", "spec/02, 6.13")]
    [InlineData(0xF3, 0, 0x83)]
    [InlineData(0xF3, 2, 0xF3)]
    [InlineData(0xF3, 3, 0x83)]
    [InlineData(0x83, 1, 0x93)]
    [InlineData(0x93, 2, 0xB3)]
    public void The_stationary_bits_follow_the_counter(int before, int counter, int after)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 0), Vector3.Zero, (TransientState)before);
        CollisionInfo info = Touching(false);
        info.FramesStationaryFall = counter;
        f.Body.HandleAllCollisions(info, hadContact: true, hadWalkable: true, simulatedTime: 0);
        Assert.Equal((TransientState)after, f.Body.Transient);
    }

    [Fact, Behaviour("body.leave-world.masks", "spec/02, 6.13 and 2.3")]
    public void Leaving_the_world_clears_every_transient_bit()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 0), Vector3.Zero, (TransientState)0x1FF);
        f.Body.LeaveWorld();
        Assert.Equal(TransientState.None, f.Body.Transient);
    }

    [Fact, Behaviour("body.reports.object-once-a-second", "spec/02, 4.15")]
    public void An_object_is_reported_once_and_its_end_a_second_after_the_last_touch()
    {
        (BodyFixture f, Witness witness, CollisionInfo touch) = TouchingAnother();
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1);
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1.5);
        Assert.Equal([2u], witness.Objects);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 2.5);
        Assert.Empty(witness.Ends);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 2.51);
        Assert.Equal([2u], witness.Ends);
    }

    [Fact, Behaviour("body.hidden.reports-nothing", "spec/02, 4.18 set_hidden")]
    public void A_body_that_is_hidden_ends_its_touches_and_one_that_is_shown_reports_again()
    {
        (BodyFixture f, Witness witness, CollisionInfo touch) = TouchingAnother();
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1);
        f.Body.SetState(f.Body.State | PhysicsState.Hidden);
        Assert.Equal([2u], witness.Ends);
        Assert.Equal(PhysicsState.IgnoreCollisions, f.Body.State & (PhysicsState.IgnoreCollisions | PhysicsState.ReportCollisions));

        // Touches go on being noted while nothing is told; showing tells them.
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 2);
        Assert.Equal([2u], witness.Objects);
        f.Body.SetState(f.Body.State & ~PhysicsState.Hidden);
        Assert.Equal([2u, 2u], witness.Objects);
        Assert.Equal(PhysicsState.ReportCollisions, f.Body.State & (PhysicsState.IgnoreCollisions | PhysicsState.ReportCollisions));
    }

    [Fact, Behaviour("body.reports.removed-while-told", "spec/02, 4.15 report_collision_end")]
    public void A_body_may_be_removed_by_the_one_who_is_told_of_an_end()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        CollisionInfo touch = Touching(false);
        for (uint id = 2; id < 6; id++) touch.AddObject(f.Engine.CreateBody(id, null, PhysicsState.Default));
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1);
        witness.AtEnd = () => f.Engine.RemoveBody(f.Body);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 9);
        Assert.Equal([2u, 3u, 4u, 5u], witness.Ends.Order());
        Assert.Null(f.Engine.Find(1));
    }

    [Fact, Behaviour("body.reports.as-environment", "spec/02, 4.15, 1")]
    public void An_object_that_counts_as_environment_is_reported_as_such_and_its_end_is_not()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        PhysicsBody wall = f.Engine.CreateBody(2, null, PhysicsState.Default | PhysicsState.ReportCollisionsAsEnvironment, Creature);
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        CollisionInfo touch = Touching(false);
        touch.AddObject(wall);
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1);
        Assert.Equal(1, witness.Environments);
        Assert.Empty(witness.Objects);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 3);
        Assert.Empty(witness.Ends);
    }

    [Fact, Behaviour("body.reports.ethereal-ends-at-once", "spec/02, 4.15 report_collision_end")]
    public void A_touch_of_something_ethereal_ends_with_the_next_time()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        PhysicsBody mist = f.Engine.CreateBody(2, null, PhysicsState.Default | PhysicsState.Ethereal, Creature);
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        CollisionInfo touch = Touching(false);
        touch.AddObject(mist);
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1);
        Assert.Empty(witness.Ends);
        f.Body.HandleAllCollisions(Touching(false), hadContact: true, hadWalkable: true, simulatedTime: 1.01);
        Assert.Equal([2u], witness.Ends);
    }

    [Fact, Behaviour("body.reports.missile-hits", "spec/02, 4.15, 3 and quadrant")]
    public void A_missile_tells_where_it_hit_and_its_target_hears_of_a_body_with_the_flags_retail_swaps()
    {
        BodyFixture f = new(PhysicsState.Default | PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped);
        Witness mine = new(), theirs = new();
        f.Body.SetWeenie(WeenieTraits.Present);
        f.Body.Listener = mine;
        PhysicsBody target = f.Engine.CreateBody(2, f.Body.Setup, PhysicsState.Default, Creature);
        target.Listener = theirs;
        target.Seat(
            new BodySeat(new(StubWorld.CellId, new Vector3(12, 12, 0)), new(0, 1, 0), TransientState.Contact, default, 0, Vector3.Zero));

        // Left of the target, behind it, and at 1 m of its 1.83 m in the middle third.
        f.Seat(new(11, 11, 1), new(0, 9, 0), TransientState.None);
        CollisionInfo touch = Touching(false);
        touch.AddObject(target);
        Assert.True(f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1));
        Assert.Equal([new AttackCollision(2, 8 | 64 | 2, default)], mine.Attacks.Select(hit => hit with { Impact = default }));
        Assert.Empty(mine.Profiles);
        Assert.Equal(
            [new ObjectCollision(1, new(0, 8, 0), WeenieTraits.Present, true, OtherIsMissile: true, OtherInContact: true, default)],
            Plain(theirs.Profiles));
        Assert.Equal(PhysicsState.Default, f.Body.State);
    }

    [Fact, Behaviour("body.reports.both-sides", "spec/02, 4.15, 3 and 4")]
    public void Both_sides_hear_of_each_other_unless_they_ignore_collisions()
    {
        (BodyFixture f, Witness mine) = Witnessed();
        Witness theirs = new();
        PhysicsBody other = f.Engine.CreateBody(2, null, PhysicsState.Default, WeenieTraits.Present);
        other.Listener = theirs;
        f.Seat(new(12, 12, 0), new(3, 0, 0), BodyFixture.Standing);
        CollisionInfo touch = Touching(false);
        touch.AddObject(other);
        f.Body.HandleAllCollisions(touch, hadContact: false, hadWalkable: true, simulatedTime: 1);
        Assert.Equal(
            [new ObjectCollision(2, new(3, 0, 0), WeenieTraits.Present, false, OtherIsMissile: false, OtherInContact: false, default)],
            Plain(mine.Profiles));
        Assert.Equal([new ObjectCollision(1, new(3, 0, 0), Creature, false, OtherIsMissile: false, OtherInContact: false, default)],
            Plain(theirs.Profiles));

        PhysicsBody shy = f.Engine.CreateBody(3, null, PhysicsState.Default | PhysicsState.IgnoreCollisions, WeenieTraits.Present);
        shy.Listener = theirs;
        touch = Touching(false);
        touch.AddObject(shy);
        f.Body.HandleAllCollisions(touch, hadContact: true, hadWalkable: true, simulatedTime: 1.1);
        Assert.Equal((1, 2), (mine.Profiles.Count, theirs.Profiles.Count));
    }

    private static (BodyFixture Fixture, Witness Witness) Witnessed()
    {
        BodyFixture f = new();
        f.Body.SetWeenie(Creature);
        Witness witness = new();
        f.Body.Listener = witness;
        return (f, witness);
    }

    /// <summary>One who stands, and what it collides with: a creature with id 2.</summary>
    private static (BodyFixture Fixture, Witness Witness, CollisionInfo Touch) TouchingAnother()
    {
        (BodyFixture f, Witness witness) = Witnessed();
        PhysicsBody other = f.Engine.CreateBody(2, null, PhysicsState.Default, Creature);
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        CollisionInfo touch = Touching(false);
        touch.AddObject(other);
        return (f, witness, touch);
    }

    private static IEnumerable<ObjectCollision> Plain(List<ObjectCollision> told) => told.Select(one => one with { Impact = default });

    private static CollisionInfo Touching(bool environment) => new() { CollidedWithEnvironment = environment };

    private sealed class Witness : ICollisionListener
    {
        public int Environments { get; private set; }

        public List<uint> Objects { get; } = [];

        public List<uint> Ends { get; } = [];

        public List<ObjectCollision> Profiles { get; } = [];

        public List<AttackCollision> Attacks { get; } = [];

        public Action? AtEnd { get; set; }

        public void OnEnvironmentCollision(PhysicsBody body, in EnvironmentCollision collision) => Environments++;

        public void OnObjectCollision(WorldObject body, in ObjectCollision collision)
        {
            Profiles.Add(collision);
            if (body.Id == 1) Objects.Add(collision.ObjectId);
        }

        public void OnAttackCollision(WorldObject body, in AttackCollision collision) => Attacks.Add(collision);

        public void OnCollisionEnd(WorldObject body, uint objectId)
        {
            if (body.Id != 1) return;
            Ends.Add(objectId);
            Action? act = AtEnd;
            AtEnd = null;
            act?.Invoke();
        }
    }
}
