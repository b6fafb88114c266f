using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>A ball as an obstacle: specification 04, 6.12 and the end of 6.16; exact floats.</summary>
public class BallObstacleTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags Missile = MoverFlags.PathClipped;
    private const MoverFlags PerfectMissile = Missile | MoverFlags.PerfectClip;

    private static readonly Sphere Ball = new(new(0, 0, 0.5f), 0.5f);
    private static readonly Sphere Low = new(Vector3.Zero, 0.5f);

    private static Mover Walker(Vector3 curr, Vector3 check, float stepUp = 0.6f) =>
        new Mover(Standing, curr, check, 0.48f, stepUpHeight: stepUp).Standing(Vector3.UnitZ);

    private static Mover Falling(Vector3 curr, Vector3 check) => new Mover(MoverFlags.None, curr, check, 0.48f)
        .With(p => (p.Collide, p.WalkableAllowance) = (true, RetailMath.LandingZ));

    private static Mover Probe(Vector3 check, float amount) =>
        Walker(check, check).With(p => (p.SteppingDown, p.StepDownAmount) = (true, amount));

    [Fact, Behaviour("ball.touch", "spec/04, 6.12")]
    public void A_walker_that_only_touches_is_free()
    {
        Mover mover = Walker(new(-2, 0, 0.5f), new(-0.9799f, 0, 0.5f));
        Assert.Equal((TransitionState.OK, Vector3.Zero), (mover.Ask(Ball), mover.Moved));
    }

    [Fact, Behaviour("ball.slide-around", "spec/04, 6.12, CSphere::slide_sphere @0x00536F40")]
    public void A_walker_slides_around_a_ball_too_tall_to_climb()
    {
        Mover mover = Walker(new(-1.2f, 0, 0.48f), new(-0.9f, 0.2f, 0.48f), 0.3f);
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Slid, mover.Ask(Ball));
        Assert.Equal(before + new Vector3(-0.300000072f, 0, 0), mover.At);
        Assert.Equal(new Vector3(-0.999861121f, 0, -0.0166643597f), mover.Collision.CollisionNormal);

        Mover headOn = Walker(new(-1.2f, 0, 0.48f), new(-0.9f, 0, 0.48f), 0.3f);
        Assert.Equal(TransitionState.Collided, headOn.Ask(Ball));
        Assert.Equal(new Vector3(-0.999861121f, 0, -0.0166643597f), headOn.Collision.CollisionNormal);
    }

    [Fact, Behaviour("ball.slide-around.degenerate", "spec/04, 6.12")]
    public void Straight_above_the_way_down_is_removed_and_straight_below_the_way_up_is_refused()
    {
        Mover above = Walker(new(0, 0, 1.6f), new(0.05f, 0, 1.4f), 0.05f);
        Vector3 before = above.At;
        Assert.Equal(TransitionState.Slid, above.Ask(Ball));
        Assert.Equal(before + new Vector3(0, 0, 0.200000048f), above.At);

        Mover below = Walker(new(0, 0, -0.6f), new(0.05f, 0, -0.4f), 0.05f);
        Assert.Equal(TransitionState.Collided, below.Ask(Ball));
        Assert.Equal(new Vector3(0, 0, -1), below.Collision.CollisionNormal);
    }

    [Fact, Behaviour("ball.missile", "spec/04, 6.12, CSphere::collide_with_point @0x00537230")]
    public void A_missile_stops_with_the_radial_normal()
    {
        Mover mover = new(Missile, new(-2, 0, 0.5f), new(-0.5f, 0, 0.5f), 0.1f);
        Assert.Equal(TransitionState.Collided, mover.Ask(Ball));
        Assert.Equal((new Vector3(-1, 0, 0), Vector3.Zero), (mover.Collision.CollisionNormal, mover.Moved));
    }

    [Theory, Behaviour("ball.perfect-clip", "spec/04, 6.12")]
    [InlineData(-2, 0, -0.5, -0.0999999642, -1, 0)]
    [InlineData(-2, 0.3, -0.3, -0.219615236, -0.866025388, 0.5)]
    public void A_perfectly_clipped_mover_ends_where_it_touches_the_ball(float currX, float y, float x, float outX, float nx, float ny)
    {
        Mover mover = new(PerfectMissile, new(currX, y, 0.5f), new(x, y, 0.5f), 0.1f);
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Ball));
        Assert.Equal(before + new Vector3(outX, 0, 0), mover.At);
        Assert.Equal(new Vector3(nx, ny, 0), mover.Collision.CollisionNormal);
    }

    [Fact, Behaviour("ball.perfect-clip.starts-inside", "spec/04, 6.12")]
    public void A_perfectly_clipped_mover_that_starts_inside_is_stopped_without_a_normal()
    {
        Mover mover = new(PerfectMissile, new(-0.55f, 0, 0.5f), new(-0.3f, 0, 0.5f), 0.1f);
        Assert.Equal((TransitionState.Collided, false), (mover.Ask(Ball), mover.Collision.CollisionNormalValid));
    }

    [Fact, Behaviour("ball.airborne.landing-asked", "spec/04, 6.12, CSphere::land_on_sphere @0x005379A0")]
    public void A_falling_body_asks_to_land_on_the_ball()
    {
        Mover mover = new(MoverFlags.None, new(0.1f, 0, 2), new(0.1f, 0, 1.3f), 0.48f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Ball));
        Assert.Equal(
            (true, new Vector3(0.0665190145f, 0, 0.997785151f), RetailMath.LandingZ),
            (mover.Path.Collide, mover.Path.StepUpNormal, mover.Path.WalkableAllowance));
    }

    [Fact, Behaviour("ball.landing", "spec/04, 6.12: the plane is that of the centre before it moved")]
    public void A_landing_body_rests_on_the_ball_and_the_ball_counts_as_water()
    {
        Mover mover = Falling(new(0.1f, 0, 2), new(0.1f, 0, 1.3f));
        float before = mover.At.Z;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Ball));
        Assert.Equal((before + 0.174884617f, 0.750164866f), (mover.At.Z, mover.Path.WalkInterp));
        Assert.Equal(new Plane(0.10204082f, 0, 0.994780242f, -0.823418379f), mover.Collision.ContactPlane);
        Assert.Equal((true, Mover.CellId), (mover.Collision.ContactPlaneIsWater, mover.Collision.ContactPlaneCellId));
        Assert.True(mover.Path.Walkable.IsNone);
    }

    [Theory, Behaviour("ball.landing.more", "spec/04, 6.16")]
    [InlineData(0, 1.2, 0, 0.9, 0, 0.0799999833, -0.419999987, 0.733333468)]
    [InlineData(-0.3, 1.2, 0.1, 0.9, -0.106636658, 0.0799775124, -0.419302166, 0.733408332)]
    public void A_landing_body_is_pulled_back_along_its_way_onto_the_ball(
        float currX, float currZ, float x, float z, float outX, float outZ, float d, float interp)
    {
        Mover mover = Falling(new(currX, 0, currZ), new(x, 0, z));
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Low));
        Assert.Equal(new Vector3(outX, 0, outZ), mover.Moved);
        Assert.Equal((d, interp), (mover.Collision.ContactPlane.D, mover.Path.WalkInterp));
    }

    [Fact, Behaviour("ball.landing.refused", "spec/04, 6.16 and 4.8 rows 7 and 8")]
    public void Short_ways_creatures_and_distance_refuse_the_landing()
    {
        Assert.Equal(TransitionState.Collided, Falling(new(0, 0, 0.985f), new(0, 0, 0.975f)).Ask(Low));
        Assert.Equal(TransitionState.OK, Falling(new(0.1f, 0, 2), new(0.1f, 0, 1.3f)).Ask(Ball, creature: true));
        Assert.Equal(TransitionState.OK, Falling(new(0.1f, 0, 3), new(0.1f, 0, 2)).Ask(Ball));
    }

    [Fact, Behaviour("ball.landing.root-compared-too-early", "spec/04, 4.8: u is compared with 1 before it is divided by the squared way")]
    public void A_long_way_back_onto_a_ball_is_refused()
    {
        // By hand: B = 1.9, b = −1.9, a = 3.61, root 3.8, so u = 1.9 becomes 2b − u = −5.7; divided first it would have been 0.53.
        Mover mover = new Mover(MoverFlags.None, new(0, 0, 2.9f), new(0, 0, 1), 1.5f).With(p => p.Collide = true);
        Assert.Equal((TransitionState.Collided, Vector3.Zero), (mover.Ask(Low), mover.Moved));
        Mover shorter = new Mover(MoverFlags.None, new(0, 0, 2.5f), new(0, 0, 1.6f), 1.5f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, shorter.Ask(Low));
        Assert.Equal(2f, shorter.At.Z, 1e-5f);
    }

    [Fact, Behaviour("ball.step-down", "spec/04, 6.12, CSphere::step_sphere_down @0x00536D20")]
    public void A_probe_is_lifted_straight_onto_the_ball()
    {
        Mover mover = Probe(new(0.1f, 0, 1.3f), 0.6f);
        float before = mover.At.Z;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Ball));
        Assert.Equal((before + 0.174884632f, 0.708525658f), (mover.At.Z, mover.Path.WalkInterp));
        Assert.Equal(new Plane(0.10204082f, 0, 0.994780242f, -0.997390151f), mover.Collision.ContactPlane);
    }

    [Theory, Behaviour("ball.step-down.refused", "spec/04, 6.12")]
    [InlineData(0.1, 1.3, 0.1, false, TransitionState.Collided)]
    [InlineData(0.1, 1.3, 0.6, true, TransitionState.OK)]
    [InlineData(0.9, 0.6, 0.6, false, TransitionState.OK)]
    public void A_probe_finds_no_footing_out_of_reach_on_creatures_and_on_the_flank(
        float x, float z, float amount, bool creature, TransitionState answer)
    {
        Mover mover = Probe(new(x, 0, z), amount);
        Assert.Equal((answer, Vector3.Zero), (mover.Ask(Ball, creature), mover.Moved));
    }

    [Fact, Behaviour("ball.step-down.head-only", "spec/04, question 8: a negative radicand never reaches a position")]
    public void A_probe_whose_head_touches_a_ball_far_beside_the_foot_is_not_moved()
    {
        Mover mover = new Mover(Standing, new(2, 0, 0), new(2, 0, 0), 0.48f, new Vector3(-1.5f, 0, 0.9f));
        mover.Path.SteppingDown = true;
        mover.Path.StepDownAmount = 0.6f;
        Assert.Equal((TransitionState.Collided, Vector3.Zero), (mover.Ask(Ball), mover.Moved));
        Assert.False(mover.Collision.ContactPlaneValid);
    }

    [Fact, Behaviour("ball.airborne.head-stops", "spec/04, 6.16")]
    public void A_head_in_the_air_is_stopped_by_the_ball()
    {
        Mover mover = new(MoverFlags.None, new(-0.5f, 0, -1.8f), new(-0.4f, 0, -1.7f), 0.48f, new Vector3(0, 0, 0.87f));
        Assert.Equal(TransitionState.Collided, mover.Ask(Low));
        Assert.Equal(new Vector3(-0.473534971f, 0, -0.880775034f), mover.Collision.CollisionNormal);
    }

    [Fact, Behaviour("ball.footing", "spec/04, 6.16 and 4.8 row 3")]
    public void A_footing_query_takes_any_touch_creatures_too() =>
        Assert.Equal(
            TransitionState.Collided,
            Walker(new(0, 0, 0.9f), new(0, 0, 0.9f)).With(p => p.CheckingWalkable = true).Ask(Low, creature: true));

    [Fact, Behaviour("ball.placement", "spec/04, 4.8 row 1")]
    public void A_placed_body_must_not_touch_the_ball()
    {
        Assert.Equal(
            TransitionState.Collided, Walker(new(0, 0, 0.9f), new(0, 0, 0.9f)).With(p => p.InsertType = InsertType.Placement).Ask(Low));
        Assert.Equal(
            TransitionState.OK, Walker(new(0, 0, 0.98f), new(0, 0, 0.98f)).With(p => p.InsertType = InsertType.Placement).Ask(Low));
    }
}
