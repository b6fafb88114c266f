using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using static Surefoot.Physics.Tests.Bodies.ShootingRange;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Arrows and spells on their way and at what they hit: specification 06, 6 and 7; 02, 4.4, 4.15 and 4.21.</summary>
public class MissileTests
{
    private static readonly Vector3 Start = new(84, 84, 30);

    [Fact, Behaviour("missile.bolt.flies-straight", "spec/06, 7; spec/02, 4.6")]
    public void A_spell_bolt_flies_straight_at_its_speed()
    {
        ShootingRange range = new();
        range.Shoot(Start, new Vector3(30, 40, 0));
        range.Fly(15);
        Assert.True(Vector3.Distance(Start + new Vector3(15, 20, 0), range.At) < 1e-3f, $"at {range.At}");
        Assert.Equal((new Vector3(30, 40, 0), 0), (range.Missile.Velocity, range.Hits.Count));
    }

    [Fact, Behaviour("missile.arrow.nose-follows-the-arc", "spec/02, 4.4, step 7: ALIGNPATH, the direction of the proposed displacement")]
    public void The_nose_of_an_arrow_follows_its_arc()
    {
        ShootingRange range = new();
        range.Shoot(Start, new Vector3(0, 20, 10), Arrow);
        for (int i = 0; i < 60; i++)
        {
            Vector3 before = range.At;
            range.Fly(1);
            Vector3 facing = range.Missile.Position.Frame.YAxis, way = Vector3.Normalize(range.At - before);
            Assert.True(Vector3.Distance(facing, way) < 1e-3f, $"faces {facing} on its way {way}");
        }

        // Two seconds at 9.8 m/s² from 10 m/s upwards: it looks down by now.
        Assert.InRange(range.Missile.Velocity.Z, -9.61f, -9.59f);
    }

    [Fact, Behaviour("missile.omega.spins", "spec/02, 4.6, step 8: grotate(q·w) in world axes; 4.9")]
    public void A_thrown_thing_spins_by_its_angular_velocity_about_the_worlds_axes()
    {
        ShootingRange range = new();
        range.Shoot(Start, new Vector3(0, 20, 0), Bolt & ~PhysicsState.AlignPath);
        range.Missile.SetOmega(new Vector3(0, 0, MathF.PI / 2));
        range.Fly(30);
        // A quarter of a turn to the left in a second: what looked north looks west.
        Assert.True(Vector3.Distance(-Vector3.UnitX, range.Missile.Position.Frame.YAxis) < 1e-3f);
        Assert.Equal(new Vector3(0, 20, 0), range.Missile.Velocity);
    }

    [Theory, Behaviour("missile.hits.who-is-alive", "spec/06, 6: a missile without a target stops at every player and creature")]
    [InlineData(Creature)]
    [InlineData(Player)]
    [InlineData(Player | WeenieTraits.PK)]
    [InlineData(Player | WeenieTraits.PKLite)]
    [InlineData(Player | WeenieTraits.Impenetrable)]
    [InlineData(WeenieTraits.Present)]
    public void A_missile_stops_at_every_creature_and_player(WeenieTraits who)
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), who);
        range.Shoot(Start, new Vector3(0, 50, 0));
        range.Fly(30);

        // Both are told, once: the missile of an attack, the one hit of a body, since the missile is none any more.
        Assert.Equal(
            [(MissileId, TargetId, true), (TargetId, MissileId, false)],
            range.Hits.Select(hit => (hit.Told, hit.Of, hit.IsAttack)));
        Impact impact = range.Hits[0].Impact;
        Assert.Equal(range.Hits[1].Impact, impact);
        // Radii 0.48 and 0.1: it ends less than a sub-step, one radius, before they touch.
        Assert.InRange(impact.Place.Frame.Origin.Y - Start.Y, 10 - 0.58f - Radius, 10 - 0.58f);
        Assert.True(Vector3.Distance(-Vector3.UnitY, impact.Normal) < 1e-4f, $"normal {impact.Normal}");
        Assert.Equal(PhysicsState.ReportCollisions, range.Missile.State);
        // Five hundredths of its speed come back.
        Assert.Equal(-2.5f, range.Missile.Velocity.Y, 1e-3f);
    }

    [Fact, Behaviour("missile.hits.static-thing", "spec/06, 6; spec/02, 4.15, 1: a static thing is environment")]
    public void A_missile_that_hits_a_static_thing_tells_of_the_environment_once()
    {
        ShootingRange range = new();
        range.Build(Start + new Vector3(0, 10, 0), new Vector3(2, 0.5f, 2));
        range.Shoot(Start, new Vector3(0, 50, 0));
        range.Fly(30);
        Hit hit = Assert.Single(range.Hits);
        Assert.Equal((MissileId, 0u, -Vector3.UnitY), (hit.Told, hit.Of, hit.Impact.Normal));
        Assert.InRange(hit.Impact.Place.Frame.Origin.Y - Start.Y, 9.5f - (2 * Radius), 9.5f - Radius);
    }

    [Fact, Behaviour("missile.hits.the-ground", "spec/06, 7; spec/02, 4.15")]
    public void An_arrow_that_hits_the_ground_tells_where_and_that_it_is_ground()
    {
        ShootingRange range = new();
        range.Shoot(new Vector3(84, 84, 3), new Vector3(0, 12, 0), Arrow);
        int quanta = 0;
        for (; range.Hits.Count == 0 && quanta < 60; quanta++) range.Fly(1);
        // In one quantum the ground is told once, and nothing else was in its way; an arrow that bounces off meets it once more.
        Hit hit = Assert.Single(range.Hits);
        Assert.Equal((MissileId, 0u, false, Vector3.UnitZ), (hit.Told, hit.Of, hit.IsAttack, hit.Impact.Normal));
        // 2.9 m down take 0.77 s, 9.2 m of way; a quantum more or less is 0.4 m.
        Assert.InRange(hit.Impact.Place.Frame.Origin.Y - 84, 8.7f, 9.7f);
        Assert.InRange(hit.Impact.Place.Frame.Origin.Z, Radius - 0.01f, 0.6f);
        Assert.InRange(quanta * Tick, 0.77f - Tick, 0.77f + (2 * Tick));
        range.Fly(60);
        Assert.All(range.Hits, other => Assert.Equal((0u, Vector3.UnitZ), (other.Of, other.Impact.Normal)));
        Assert.Equal(PhysicsState.None, range.Missile.State & (PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped));
    }

    [Theory, Behaviour("missile.passes.missile", "spec/03, 4.4, missile_ignore: other is a missile → 1; spec/06, 7")]
    [InlineData(WeenieTraits.None)]
    [InlineData(WeenieTraits.Present)]
    public void Missiles_pass_each_other_and_nobody_notices(WeenieTraits weenie)
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), weenie, Bolt);
        range.Shoot(Start, new Vector3(0, 50, 0));
        AssertFliesOn(range);
        Assert.Equal(Bolt, range.Missile.State);
    }

    [Fact, Behaviour("missile.passes.ethereal-weenie", "spec/03, 4.4, missile_ignore: other has a weenie and is ethereal → 1")]
    public void A_missile_does_not_notice_what_is_ethereal_and_known_to_the_game()
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), Creature, PhysicsState.ReportCollisions | PhysicsState.Ethereal);
        range.Shoot(Start, new Vector3(0, 50, 0));
        AssertFliesOn(range);
        Assert.Equal(Bolt, range.Missile.State);
    }

    [Fact, Behaviour("missile.touches.ethereal-thing", "spec/06, 6; spec/02, 4.21, step 8, and 4.15, 3b")]
    public void A_missile_touches_what_is_ethereal_without_a_weenie_flies_on_and_is_no_missile_any_more()
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), WeenieTraits.None, PhysicsState.ReportCollisions | PhysicsState.Ethereal);
        range.Shoot(Start, new Vector3(0, 50, 0));
        range.Fly(15);
        Assert.Equal(Start.Y + 25, range.At.Y, 0.01f);
        Hit hit = Assert.Single(range.Hits);
        Assert.Equal((MissileId, TargetId, true, Vector3.Zero), (hit.Told, hit.Of, hit.IsAttack, hit.Impact.Normal));
        Assert.Equal(PhysicsState.ReportCollisions, range.Missile.State);
    }

    [Fact, Behaviour("missile.passes.what-ignores-collisions", "spec/02, 4.21, step 1")]
    public void A_missile_is_not_stopped_by_what_is_ethereal_and_ignores_collisions()
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), WeenieTraits.None, PhysicsState.Ethereal | PhysicsState.IgnoreCollisions);
        range.Shoot(Start, new Vector3(0, 50, 0));
        AssertFliesOn(range);
    }

    [Fact, Behaviour("missile.path-clipped.does-not-slide", "spec/06, 7: the sweep ends at the first collision; spec/03, 4.6, 5 g")]
    public void A_missile_that_grazes_a_wall_ends_there_and_does_not_slide_along_it()
    {
        ShootingRange range = new();
        range.Build(Start + new Vector3(0, 5, 0), new Vector3(10, 0.5f, 10));
        range.Shoot(Start, new Vector3(40, 30, 0));
        for (int i = 0; i < 30 && range.Hits.Count == 0; i++) range.Fly(1);
        Hit hit = Assert.Single(range.Hits);
        Vector3 place = hit.Impact.Place.Frame.Origin - Start;
        // On its way of three in four still, and not further than the wall at 4.5 m lets it.
        Assert.Equal(place.Y * 4 / 3, place.X, 1e-3f);
        Assert.InRange(place.Y, 4.5f - (2 * Radius), 4.5f - Radius);
        Assert.Equal(-Vector3.UnitY, hit.Impact.Normal);
    }

    [Fact, Behaviour("missile.no-step-down", "spec/06, 7: no step down; spec/02, 2.4")]
    public void A_missile_that_skims_the_ground_is_not_drawn_down_to_it()
    {
        ShootingRange range = new();
        range.Shoot(new Vector3(84, 84, Radius + 0.01f), new Vector3(0, 20, 0));
        range.Fly(20);
        Assert.Equal(Radius + 0.01f, range.At.Z, 1e-5f);
        Assert.Equal((false, 0), (range.Missile.HasContact, range.Hits.Count));
    }

    [Fact, Behaviour("missile.hits.first-in-its-way", "spec/06, 7: the sweep ends at the first collision")]
    public void Behind_the_wall_that_stops_a_missile_nobody_is_hit()
    {
        ShootingRange range = new();
        range.Stand(Start + new Vector3(0, 10, -0.48f), Creature);
        range.Build(Start + new Vector3(0, 8, 0), new Vector3(2, 0.01f, 2), id: 3);
        range.Shoot(Start, new Vector3(0, 50, 0));
        range.Fly(10, 0.2f);
        Assert.Equal([(MissileId, 0u)], range.Hits.Select(hit => (hit.Told, hit.Of)));
    }

    [Fact, Behaviour("missile.allocates-nothing", "design, decision 4")]
    public void Missiles_on_their_way_allocate_nothing()
    {
        ShootingRange range = new();
        range.Build(Start + new Vector3(30, 0, 0), new Vector3(2, 2, 2));
        range.Shoot(Start, new Vector3(0, 10, 5), Arrow);
        range.Fly(20);
        long before = GC.GetAllocatedBytesForCurrentThread();
        range.Fly(40);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.Equal(Arrow, range.Missile.State);
    }

    private static void AssertFliesOn(ShootingRange range)
    {
        range.Fly(15);
        Assert.Equal(Start.Y + 25, range.At.Y, 0.01f);
        Assert.Empty(range.Hits);
    }
}
