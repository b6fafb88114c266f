using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>A cylinder as an obstacle: specification 04, 6.13 and the end of 6.16; exact floats.</summary>
public class CylinderObstacleTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags PerfectMissile = MoverFlags.PathClipped | MoverFlags.PerfectClip;

    private static readonly CylSphere Cylinder = new(Vector3.Zero, 0.5f, 1);

    private static Mover Walker(Vector3 curr, Vector3 check) => new Mover(Standing, curr, check, 0.48f).Standing(Vector3.UnitZ);

    private static Mover Falling(Vector3 curr, Vector3 check) => new Mover(MoverFlags.None, curr, check, 0.48f)
        .With(p => (p.Collide, p.WalkableAllowance) = (true, RetailMath.LandingZ));

    [Fact, Behaviour("cylinder.slide", "spec/04, 6.13, CCylSphere::slide_sphere @0x0053B2A0")]
    public void A_walker_slides_around_a_cylinder_too_tall_to_climb()
    {
        Mover mover = Walker(new(-1.2f, 0, 0.48f), new(-0.9f, 0.3f, 0.48f));
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Slid, mover.Ask(Cylinder));
        Assert.Equal((before + new Vector3(-0.300000072f, 0, 0), new Vector3(-1, 0, 0)), (mover.At, mover.Collision.CollisionNormal));

        Mover headOn = Walker(new(-1.2f, 0, 0.48f), new(-0.9f, 0, 0.48f));
        Assert.Equal(TransitionState.Collided, headOn.Ask(Cylinder));
        Assert.Equal(new Vector3(-1, 0, 0), headOn.Collision.CollisionNormal);
    }

    [Fact, Behaviour("cylinder.step-up.refused", "spec/04, 6.13, CCylSphere::step_sphere_up @0x0053B310")]
    public void A_refused_step_up_onto_a_low_cylinder_slides()
    {
        Mover mover = Walker(new(-1.2f, 0, 0.9f), new(-0.9f, 0.2f, 0.9f)).LastStoodOn(Vector3.UnitZ);
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Slid, mover.Ask(Cylinder));
        Assert.Equal(before + new Vector3(-0.300000072f, 0, 0), mover.At);
        Assert.Equal((new Vector3(-1, 0, 0), false), (mover.Path.StepUpNormal, mover.Collision.ContactPlaneValid));
    }

    [Fact, Behaviour("cylinder.step-up.turned-twice", "spec/04, 4.9: the normal is turned with the object although it is global")]
    public void The_normal_of_a_step_up_turns_with_the_object()
    {
        const float Root = 0.707106769f;
        Mover mover = Walker(new(-1.2f, 0, 0.9f), new(-0.9f, 0.2f, 0.9f)).LastStoodOn(Vector3.UnitZ);
        mover.Ask(Cylinder, new Frame(Vector3.Zero, new Quaternion(0, 0, Root, Root)));
        Assert.Equal(new Vector3(-3.42285453e-08f, -1, 0), Vector3.Normalize(mover.Path.StepUpNormal), Near);
    }

    private static bool Near(Vector3 a, Vector3 b) => (a - b).Length() < 2e-7f;

    [Fact, Behaviour("cylinder.rim", "spec/04, 6.13")]
    public void Above_the_rim_by_less_than_the_tolerance_collides()
    {
        Assert.Equal(TransitionState.OK, Walker(new(-1.2f, 0, 1.48f), new(-0.3f, 0, 1.48f)).Ask(Cylinder));
        Assert.NotEqual(TransitionState.OK, Walker(new(-1.2f, 0, 1.4797f), new(-0.3f, 0, 1.4797f)).Ask(Cylinder));
    }

    [Theory, Behaviour("cylinder.step-down", "spec/04, 6.13, CCylSphere::step_sphere_down @0x0053A9B0")]
    [InlineData(0.6, 0.699999928)]
    [InlineData(0.165, -0.0909092724)]
    public void A_probe_is_lifted_onto_the_top_and_the_top_counts_as_water(float amount, float interp)
    {
        Mover mover = Walker(new(-0.2f, 0, 1.3f), new(-0.2f, 0, 1.3f)).With(p => (p.SteppingDown, p.StepDownAmount) = (true, amount));
        float before = mover.At.Z;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cylinder));
        Assert.Equal((before + 0.180000037f, interp), (mover.At.Z, mover.Path.WalkInterp));
        Assert.Equal((new Plane(0, 0, 1, -1), true), (mover.Collision.ContactPlane, mover.Collision.ContactPlaneIsWater));
        Assert.Equal(Mover.CellId, mover.Collision.ContactPlaneCellId);
    }

    [Fact, Behaviour("cylinder.step-down.refused", "spec/04, 6.13")]
    public void A_probe_too_short_is_refused()
    {
        Mover mover = Walker(new(-0.2f, 0, 1.3f), new(-0.2f, 0, 1.3f)).With(p => (p.SteppingDown, p.StepDownAmount) = (true, 0.15f));
        Assert.Equal((TransitionState.Collided, Vector3.Zero), (mover.Ask(Cylinder), mover.Moved));
    }

    [Theory, Behaviour("cylinder.airborne.landing-asked", "spec/04, 6.13, CCylSphere::land_on_cylinder @0x0053B3D0")]
    [InlineData(-0.2, 2, -0.2, 1.4, 0, 0, 1)]
    [InlineData(-1.3, 0.8, -0.9, 0.7, -1, 0, 0)]
    [InlineData(-0.2, -0.6, -0.2, -0.3, 0, 0, -1)]
    public void A_body_in_the_air_asks_to_land_on_what_it_came_to(float currX, float currZ, float x, float z, float nx, float ny, float nz)
    {
        Mover mover = new(MoverFlags.None, new(currX, 0, currZ), new(x, 0, z), 0.48f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cylinder));
        Assert.Equal((true, new Vector3(nx, ny, nz)), (mover.Path.Collide, mover.Path.StepUpNormal));
    }

    [Theory, Behaviour("cylinder.landing", "spec/04, 6.13 and 6.16")]
    [InlineData(-0.2, 2, -0.2, 1.4, 0, 0.0800000131, 0.866666675)]
    [InlineData(0, 1.7, 0.1, 1.3, -0.0449999981, 0.180000067, 0.550000012)]
    public void A_landing_body_rests_on_the_top(float currX, float currZ, float x, float z, float outX, float outZ, float interp)
    {
        Mover mover = Falling(new(currX, 0, currZ), new(x, 0, z));
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cylinder));
        Assert.Equal(outX, mover.Moved.X);
        Assert.Equal(outZ, mover.Moved.Z, 6);
        Assert.Equal((interp, -1f, true), (mover.Path.WalkInterp, mover.Collision.ContactPlane.D, mover.Collision.ContactPlaneIsWater));
    }

    [Theory, Behaviour("cylinder.landing.side", "spec/04, 6.13 and 6.16")]
    [InlineData(-1.3, 0.7, -0.9, 0.7, TransitionState.Collided)]
    [InlineData(-1.3, 0.8, -0.9, 0.7, TransitionState.OK)]
    [InlineData(1.6, 1.6, 0.9, 1.3, TransitionState.OK)]
    public void A_landing_beside_the_cylinder_is_none(float currX, float currZ, float x, float z, TransitionState answer)
    {
        Mover mover = Falling(new(currX, 0, currZ), new(x, 0, z));
        Assert.Equal((answer, Vector3.Zero, false), (mover.Ask(Cylinder), mover.Moved, mover.Collision.ContactPlaneValid));
    }

    [Theory, Behaviour("cylinder.perfect-clip", "spec/04, 6.13, CCylSphere::collide_with_point @0x0053ACB0")]
    [InlineData(-2, 0, 0.5, -0.5, 0, 0.5, -0.100000024, 0, 0, -1, 0, 0)]
    [InlineData(-2, 0.3, 0.5, -0.3, 0.3, 0.6, -0.219615161, 0, -0.0129185319, -0.866025388, 0.50000006, 0)]
    [InlineData(0.1, 0, 2, 0.2, 0, 1.05, -0.00526316464, 0, 0.0499999523, 0, 0, 1)]
    [InlineData(0.1, 0, -1, 0.2, 0, -0.05, -0.00526316464, 0, -0.0499999635, 0, 0, -1)]
    [InlineData(-1, 0, 1.6, 0, 0, 0.9, -0.285714328, 0, 0.200000048, 0, 0, 1)]
    [InlineData(-1, 0, 1.3, -0.3, 0, 0.6, -0.299999893, 0, 0.299999952, -1, 0, 0)]
    [InlineData(-1, 0, -0.6, -0.1, 0, 0.2, -0.337500006, 0, -0.300000012, 0, 0, -1)]
    public void A_perfectly_clipped_mover_ends_at_the_side_or_an_end(
        float currX, float currY, float currZ, float x, float y, float z, float outX, float outY, float outZ, float nx, float ny, float nz)
    {
        Mover mover = new(PerfectMissile, new(currX, currY, currZ), new(x, y, z), 0.1f);
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cylinder));
        Assert.Equal(before + new Vector3(outX, outY, outZ), mover.At);
        // The recorded normal is made unit once more, which may cost the last digit of the printed one.
        Assert.Equal(new Vector3(nx, ny, nz), mover.Collision.CollisionNormal, Near);
    }

    [Fact, Behaviour("cylinder.perfect-clip.starts-inside", "spec/04, 6.13")]
    public void A_perfectly_clipped_mover_that_starts_inside_the_radius_is_stopped_without_a_normal()
    {
        Mover mover = new(PerfectMissile, new(-0.55f, 0, 0.5f), new(-0.3f, 0, 0.6f), 0.1f);
        Assert.Equal((TransitionState.Collided, false), (mover.Ask(Cylinder), mover.Collision.CollisionNormalValid));
    }

    [Theory, Behaviour("cylinder.normal", "spec/04, 6.16, CCylSphere::normal_of_collision @0x0053AB50")]
    [InlineData(-1.1, 0, 1.7, -0.9, 0, 1.3, -1.10000002, 0, 0, false)]
    [InlineData(-1.1, 0, 1.7, -0.9, 0, 1.69995, -1.10000002, 0, 0, true)]
    [InlineData(0.5, 0, 0.5, 0.4, 0, 0.5, 0, 0, 1, true)]
    public void The_normal_is_radial_from_outside_and_upright_from_above(
        float currX, float currY, float currZ, float x, float y, float z, float nx, float ny, float nz, bool definite)
    {
        Mover mover = Walker(new(currX, currY, currZ), new(x, y, z));
        float radiusSum = (float)(0.5f - (double)RetailMath.Epsilon + 0.48f);
        Assert.Equal(definite, CylinderObstacle.NormalOfCollision(mover.Path, Cylinder, new(x, y, z), radiusSum, 0, out Vector3 normal));
        Assert.Equal(new Vector3(nx, ny, nz), normal);
    }

    [Fact, Behaviour("cylinder.placement", "spec/04, 4.9 rows 1 and 3")]
    public void Placement_and_footing_take_any_touch()
    {
        Assert.Equal(
            TransitionState.Collided,
            Walker(new(0.9f, 0, 0.5f), new(0.9f, 0, 0.5f)).With(p => p.InsertType = InsertType.Placement).Ask(Cylinder));
        Assert.Equal(
            TransitionState.Collided, Walker(new(0.9f, 0, 0.5f), new(0.9f, 0, 0.5f)).With(p => p.CheckingWalkable = true).Ask(Cylinder));
        Assert.Equal(
            TransitionState.OK, Walker(new(1, 0, 0.5f), new(1, 0, 0.5f)).With(p => p.InsertType = InsertType.Placement).Ask(Cylinder));
    }
}
