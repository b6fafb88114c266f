using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>The whole sweeps of specification 03, 6.8. Positions are the printed ones, within a micrometre of binary32.</summary>
public class SweepTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags Careful = Standing | MoverFlags.EdgeSlide;

    private static readonly Func<Vector3, Plane?> FlatGround = _ => StubWorld.Flat(0);

    private static StubWorld LedgeWorld(Plane? beyond) => new(p => p.X <= 1 ? StubWorld.Flat(0) : beyond);

    private static StubWorld WallWorld(Func<Vector3, bool>? reaches = null) =>
        new(FlatGround) { Wall = (new Vector3(-1, 0, 0), 0.6f, reaches ?? (_ => true)) };

    private static void AssertEndsAt(Transition t, float x, float y, float z, MoverFlags contact)
    {
        Vector3 end = t.Path.CurrPos.Frame.Origin;
        Assert.True(
            Math.Abs(end.X - x) < 2e-6 && Math.Abs(end.Y - y) < 2e-6 && Math.Abs(end.Z - z) < 2e-6,
            $"ended at {end}, not at ({x}, {y}, {z})");
        Assert.Equal(contact, t.Object.Flags & Standing);
    }

    [Fact, Behaviour("transition.landing.on-flat-ground", "spec/03, 6.8 case 1")]
    public void A_falling_body_lands_on_flat_ground()
    {
        Transition t = new StubWorld(FlatGround).Sweep(new(0, 0, 0.1f), new(0.02f, 0, -0.3f), MoverFlags.None);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0.02f, 0, 0, Standing);
        Assert.Equal(Vector3.UnitZ, t.Collision.CollisionNormal);
        Assert.True(t.Collision.CollidedWithEnvironment);
        Assert.True(t.Collision.SlidingNormalValid);
        Assert.Equal(Vector3.Zero, t.Collision.SlidingNormal);
    }

    [Fact, Behaviour("transition.fall.free", "spec/03, 6.8 case 1b")]
    public void A_body_far_above_the_ground_falls_freely()
    {
        Transition t = new StubWorld(FlatGround).Sweep(new(0, 0, 1), new(0.02f, 0, -0.3f), MoverFlags.None);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0.02f, 0, 0.7f, MoverFlags.None);
        Assert.Equal(0, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("transition.walk.flat", "spec/03, 6.8 case 2")]
    public void A_walker_covers_flat_ground_in_sub_steps_of_at_most_one_radius()
    {
        Transition t = new StubWorld(FlatGround).Sweep(Vector3.Zero, new(1, 0, 0), Standing);
        t.Trace = new TraceBuffer();
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1, 0, 0, Standing);
        Assert.Equal(3, t.Trace.SubStepCount());
    }

    [Fact, Behaviour("transition.stand.under-gravity-fails", "spec/03, 6.8 case 3")]
    public void A_body_that_stands_under_gravity_has_nowhere_to_go() =>
        Assert.False(new StubWorld(FlatGround).Sweep(Vector3.Zero, new(0, 0, -0.02f), Standing).FindValidPosition());

    [Fact, Behaviour("transition.slope.up-from-flat", "spec/03, 6.8 case 4")]
    public void A_walker_goes_from_flat_ground_onto_a_slope()
    {
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(30, rising: true)).Sweep(new(0.8f, 0, 0), new(0.4f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1.2f, 0, 0.115470082f, Standing);
    }

    [Theory, Behaviour("transition.slope.progress", "spec/03, 6.8 cases 5, 5b")]
    [InlineData(0.3f, 2.2249999f, 0.707253933f)]
    [InlineData(-0.3f, 1.70000005f, 0.404145122f)]
    public void Uphill_progress_is_cos_squared_and_downhill_all_of_it(float dx, float x, float z)
    {
        Vector3 start = new(2, 0, (float)Math.Tan(Math.PI / 6));
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(30, rising: true)).Sweep(start, new(dx, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, x, 0, z, Standing);
    }

    [Fact, Behaviour("transition.wall.slide", "spec/03, 6.8 cases 6, 6b")]
    public void A_wall_takes_the_whole_normal_part_of_a_sub_step()
    {
        StubWorld world = WallWorld();
        Transition t = world.Sweep(Vector3.Zero, new(0.3f, 0.3f, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0.3f, 0, Standing);
        Assert.Equal(new Vector3(-1, 0, 0), t.Collision.SlidingNormal);

        Transition next = world.Sweep(new(0, 0.3f, 0), new(0.3f, 0.3f, 0), Standing, sliding: new Vector3(-1, 0, 0));
        Assert.True(next.FindValidPosition());
        AssertEndsAt(next, 0, 0.6f, 0, Standing);
        Assert.False(next.Collision.SlidingNormalValid);
    }

    [Fact, Behaviour("transition.wall.head-on", "spec/03, 6.8 case 7")]
    public void Running_head_on_into_a_wall_stops_without_losing_the_ground()
    {
        Transition t = WallWorld().Sweep(Vector3.Zero, new(0.3f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0, 0, Standing);
        Assert.Equal(0, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("transition.wall.in-the-air", "spec/03, 6.8 case 8")]
    public void Flying_into_a_wall_is_undone_and_counted()
    {
        Transition t = WallWorld().Sweep(new(0, 0, 1), new(0.3f, 0.1f, 0.05f), MoverFlags.None);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0, 1, MoverFlags.None);
        Assert.Equal(new Vector3(-1, 0, 0), t.Collision.CollisionNormal);
        Assert.Equal(1, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("transition.edge.walks-off", "spec/03, 6.8 case 9")]
    public void Without_edge_slide_a_body_walks_off_a_ledge()
    {
        Transition t = LedgeWorld(null).Sweep(new(0.9f, 0, 0), new(0.3f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1.2f, 0, 0, MoverFlags.None);
    }

    [Fact, Behaviour("transition.edge.slide-without-polygon-stops", "spec/03, 6.8 case 9b")]
    public void With_edge_slide_a_ledge_without_a_known_polygon_stops()
    {
        Transition t = LedgeWorld(null).Sweep(new(0.9f, 0, 0), new(0.3f, 0, 0), Careful);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0.9f, 0, 0, Standing);
        Assert.Equal(Vector3.UnitZ, t.Collision.CollisionNormal);
    }

    [Theory, Behaviour("transition.step-down.reach", "spec/03, 6.8 cases 10, 10b")]
    [InlineData(-0.5f, -0.5f, true)]
    [InlineData(-0.7f, 0f, false)]
    public void A_floor_within_the_step_down_height_keeps_the_body_on_the_ground(float floor, float endZ, bool stands)
    {
        Transition t = LedgeWorld(StubWorld.Flat(floor)).Sweep(new(0.9f, 0, 0), new(0.3f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1.2f, 0, endZ, stands ? Standing : MoverFlags.None);
    }

    [Fact, Behaviour("transition.cliff.walks-off", "spec/03, 6.8 case 11")]
    public void Without_edge_slide_a_body_walks_off_a_cliff()
    {
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(60, rising: false)).Sweep(new(0.9f, 0, 0), new(0.3f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1.2f, 0, 0, MoverFlags.None);
    }

    [Fact, Behaviour("transition.cliff.slides-along", "spec/03, 6.8 case 11b")]
    public void With_edge_slide_a_body_slides_along_a_cliff()
    {
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(60, rising: false)).Sweep(new(0.9f, 0, 0), new(0.3f, 0.1f, 0), Careful);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0.9f, 0.1f, 0, Standing);
        Assert.Equal(new Vector3(-1, 0, 0), t.Collision.SlidingNormal);
    }

    [Theory, Behaviour("transition.cliff.rising-slope", "spec/03, 6.8 cases 12, 12b")]
    [InlineData(false, 1.2f, 0.1f)]
    [InlineData(true, 0.9f, 0f)]
    public void A_steep_slope_ahead_is_entered_or_stops_the_sub_step(bool edgeSlide, float x, float y)
    {
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(60, rising: true)).Sweep(new(0.9f, 0, 0), new(0.3f, 0.1f, 0),
            edgeSlide ? Careful : Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, x, y, 0, edgeSlide ? Standing : MoverFlags.None);
        if (edgeSlide) Assert.Equal(new Vector3(-1, 0, 0), t.Collision.SlidingNormal);
    }

    [Theory, Behaviour("transition.stuck.makes-a-floor", "spec/03, 6.8 case 13")]
    [InlineData(0, 1, false)]
    [InlineData(1, 2, false)]
    [InlineData(2, 3, true)]
    [InlineData(3, 3, true)]
    public void A_body_wedged_in_the_air_gets_a_floor_at_the_third_failure(int before, int after, bool stands)
    {
        StubWorld world = new(_ => null) { Blocks = _ => true };
        Transition t = world.Sweep(new(0, 0, 5), new(0, 0, -0.1f), MoverFlags.None, stationary: before);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0, 5, stands ? Standing : MoverFlags.None);
        Assert.Equal(after, t.Collision.FramesStationaryFall);
        if (!stands) return;
        Assert.Equal(-5f, t.Collision.ContactPlane.D, 6);
        Assert.True(t.Collision.CollidedWithEnvironment);
    }

    /// <summary>0.15 mm on each axis is within the tolerance of the comparison but long enough for a sub-step.</summary>
    [Theory, Behaviour("transition.stuck.turning-is-moving", "spec/03, 4.1.4, Frame::is_equal @0x00424C30; spec/03, 5, frame equality")]
    [InlineData(0f, 1)]
    [InlineData(0.1f, 0)]
    public void A_body_that_turns_on_the_spot_is_not_stuck(float turn, int stationary)
    {
        Transition t = new StubWorld(_ => null).Sweep(new(0, 0, 5), new(0.00015f, 0.00015f, -0.00015f), MoverFlags.None);
        t.Path.EndPos.Frame.SetRotation(Quaternion.CreateFromAxisAngle(Vector3.UnitZ, turn));
        Assert.True(t.FindValidPosition());
        Assert.Equal(stationary, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("transition.stuck.not-on-the-ground", "spec/03, 6.8 case 14")]
    public void A_body_blocked_on_the_ground_is_not_counted_as_falling()
    {
        Transition t = new StubWorld(FlatGround) { Blocks = _ => true }.Sweep(Vector3.Zero, new(0.1f, 0, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0, 0, Standing);
        Assert.Equal(0, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("transition.slope.too-steep-slides-down", "spec/03, 6.8 case 15")]
    public void A_body_on_a_slope_beyond_the_limit_slides_down()
    {
        Vector3 start = new(2, 0, (float)Math.Tan(Math.PI / 3));
        Transition t = LedgeWorld(StubWorld.SlopeFromX1(60, rising: true)).Sweep(start, new(0, 0, -0.1f), MoverFlags.Contact);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 1.95669878f, 0, 1.65705073f, MoverFlags.Contact);
    }

    [Fact, Behaviour("transition.jump.takes-off", "spec/03, 6.8 case 16")]
    public void A_body_without_contact_rises()
    {
        Transition t = new StubWorld(FlatGround).Sweep(Vector3.Zero, new(0.1f, 0, 0.2f), MoverFlags.None);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0.1f, 0, 0.2f, MoverFlags.None);
    }

    [Fact, Behaviour("transition.wall.normal-outlives-the-wall", "spec/03, 6.8 case M")]
    public void The_collision_normal_goes_on_sliding_the_body_after_the_wall_has_ended()
    {
        Transition t = WallWorld(c => c.Y <= 0.75f).Sweep(Vector3.Zero, new(0.9f, 0.9f, 0), Standing);
        Assert.True(t.FindValidPosition());
        AssertEndsAt(t, 0, 0.9f, 0, Standing);
    }
}
