using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>One wall, one floor: specification 04, 6.8 to 6.10 and 6.15; exact floats.</summary>
public class WallTreeTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags PerfectMissile = MoverFlags.PathClipped | MoverFlags.PerfectClip;

    private static readonly Vector3 Head = new(0, 0, 0.87f);
    private static readonly PhysicsBsp Wall = Trees.OneFace(new(1, -5, -5), new(1, -5, 5), new(1, 5, 5), new(1, 5, -5));
    private static readonly PhysicsBsp Floor = Trees.OneFace(new(-5, -5, 0), new(5, -5, 0), new(5, 5, 0), new(-5, 5, 0));

    [Theory, Behaviour("bsp.perfect-clip", "spec/04, 6.8, BSPTREE::adjust_to_plane @0x00539BF0")]
    [InlineData(0, 0, 1, 0.95, 0, 1, 0.899999976, 0, 1)]
    [InlineData(0, 0, 1, 0.95, 0.4, 1.2, 0.899999976, 0.378947377, 1.18947375)]
    [InlineData(0.91, 0, 1, 0.95, 0.4, 1, 0.910000026, 0, 1)]
    public void A_perfectly_clipped_mover_ends_where_it_touches(
        float currX, float currY, float currZ, float x, float y, float z, float endX, float endY, float endZ)
    {
        Mover mover = new(PerfectMissile, new(currX, currY, currZ), new(x, y, z), 0.1f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Wall));
        Assert.Equal(new Vector3(endX, endY, endZ), mover.At);
        Assert.Equal(new Vector3(-1, 0, 0), mover.Collision.CollisionNormal);
    }

    [Fact, Behaviour("bsp.grounded.refused-step-up-slides", "spec/04, 6.8, SPHEREPATH::step_up_slide @0x0050C3B0")]
    public void A_walker_that_cannot_step_up_slides_along_the_wall()
    {
        Mover mover = new Mover(Standing, new(0.4f, 0, 0.48f), new(0.7f, 0.3f, 0.48f), 0.48f).LastStoodOn(Vector3.UnitZ);
        Assert.Equal(TransitionState.Slid, mover.Ask(Wall));
        Assert.Equal(new Vector3(0.400000006f, 0.300000012f, 0.479999989f), mover.At);
        Assert.Equal((new Vector3(-1, 0, 0), false), (mover.Collision.CollisionNormal, mover.Collision.ContactPlaneValid));
    }

    [Fact, Behaviour("bsp.grounded.straight-in-stops", "spec/04, 6.8")]
    public void A_walker_straight_into_the_wall_is_stopped_and_one_beside_it_is_free()
    {
        Assert.Equal(
            TransitionState.Collided,
            new Mover(Standing, new(0.4f, 0, 0.48f), new(0.7f, 0, 0.48f), 0.48f).LastStoodOn(Vector3.UnitZ).Ask(Wall));
        Assert.Equal(TransitionState.OK, new Mover(Standing, new(0.4f, 0, 0.48f), new(0.52f, 0.1f, 0.48f), 0.48f).Ask(Wall));
    }

    [Theory, Behaviour("slide.crease", "spec/04, 6.9, CSphere::slide_sphere @0x00537440")]
    [InlineData(0.3, 0.3, 0.48, -1, 0, 0, 0, 0, 1, TransitionState.Slid, -0.300000012, 0, 0)]
    [InlineData(0.3, 0.3, 0.48, -2, 0, 0, 0, 0, 1, TransitionState.Slid, -0.300000012, 0, 0)]
    [InlineData(0.3, 0.3, 0.48, -0.866025404, 0.5, 0, 0, 0, 1, TransitionState.Slid, -0.0950961933, 0.0549038053, 0)]
    [InlineData(0.3, 0.3, 0.48, -1, 0, 0, 0, -0.6, 0.8, TransitionState.Slid, -0.300000012, -0.107999995, 0.144000009)]
    [InlineData(0.3, 0, 0.48, -1, 0, 0, 0, 0, 1, TransitionState.Collided, 0, 0, 0)]
    [InlineData(0.3, 0.014, 0.48, -1, 0, 0, 0, 0, 1, TransitionState.Collided, 0, 0, 0)]
    [InlineData(0.3, 0.0142, 0.48, -1, 0, 0, 0, 0, 1, TransitionState.Slid, -0.300000012, 0, 0)]
    [InlineData(0.3, 0.1, 0.38, 0, 0, 1, 0, 0, 1, TransitionState.Slid, 0, 0, 0.099999994)]
    [InlineData(0.3, 0.1, 0.6, 0, 0, -1, 0, 0, 1, TransitionState.Collided, 0, 0, 0)]
    [InlineData(0.3, 0.1, 0.4, 0, 0, 0, 0, 0, 1, TransitionState.Adjusted, -0.150000006, -0.0500000007, 0.0399999917)]
    [InlineData(0.3, 0.3, 0.48, -1, 0, 0, 0, 0, 0, TransitionState.Slid, -0.300000012, 0, 0)]
    public void A_slide_leaves_what_runs_along_wall_and_floor(
        float x, float y, float z, float nx, float ny, float nz, float fx, float fy, float fz, TransitionState answer, float ox, float oy,
        float oz)
    {
        Vector3 curr = new(0, 0, 0.48f), normal = new(nx, ny, nz);
        Mover mover = new Mover(Standing, curr, new(x, y, z), 0.48f).Standing(new(fx, fy, fz));
        Vector3 before = mover.At;
        Assert.Equal(answer, mover.Transition.SlideSphere(0, ref normal, curr));
        Assert.Equal(before + new Vector3(ox, oy, oz), mover.At);
    }

    [Fact, Behaviour("slide.along-the-floor-itself.rounds-the-share", "spec/04, 4.7 slide B, step 5: q = F(n·g)")]
    public void A_slide_along_the_plane_stood_on_rounds_the_share_it_removes()
    {
        // g = (0.06, 0.1, -0.18), n·g = -0.18 to nine digits; unrounded it would leave x one unit in the last place further out.
        Vector3 curr = new(0, 0, 0.48f), slope = new(-0.6f, 0, 0.8f), normal = slope;
        Mover mover = new Mover(Standing, curr, new(0.06f, 0.1f, 0.3f), 0.48f).Standing(slope);
        Assert.Equal(TransitionState.Slid, mover.Transition.SlideSphere(0, ref normal, curr));
        Assert.Equal(new Vector3(-0.0479999892f, 0.100000001f, 0.444000006f), mover.At);
    }

    [Fact, Behaviour("slide.opposed", "spec/04, 6.9 G9")]
    public void Between_floor_and_ceiling_the_way_back_becomes_the_normal()
    {
        Vector3 curr = new(0, 0, 0.48f), normal = new(0, 0, -1);
        Mover mover = new Mover(Standing, curr, new(0.3f, 0.1f, 0.6f), 0.48f).Standing(Vector3.UnitZ);
        Assert.Equal(TransitionState.Collided, mover.Transition.SlideSphere(0, ref normal, curr));
        Vector3 back = new(-0.886968553f, -0.295656174f, -0.354787529f);
        Assert.Equal((back, back), (normal, mover.Collision.CollisionNormal));
    }

    [Fact, Behaviour("bsp.airborne.landing-asked", "spec/04, 6.10")]
    public void A_falling_body_asks_for_a_landing_and_stays_where_it_is()
    {
        Mover mover = new(MoverFlags.None, new(0, 0, 1), new(0.1f, 0, 0.3f), 0.48f, Head);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Floor));
        Assert.Equal(
            (true, Vector3.UnitZ, 0.0871556997f, Vector3.Zero),
            (mover.Path.Collide, mover.Path.StepUpNormal, mover.Path.WalkableAllowance, mover.Moved));
    }

    [Fact, Behaviour("bsp.landing.on-floor", "spec/04, 6.10")]
    public void A_landing_body_comes_to_rest_on_the_floor()
    {
        Mover mover = new Mover(MoverFlags.None, new(0, 0, 1), new(0.1f, 0, 0.3f), 0.48f, Head)
            .With(p => (p.Collide, p.WalkableAllowance) = (true, RetailMath.LandingZ));
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Floor));
        Assert.Equal(before + new Vector3(-0.0257142857f, 0, 0.179999977f), mover.At);
        Assert.Equal(0.742857158f, mover.Path.WalkInterp);
        Assert.Equal(new Plane(0, 0, 1, 0), mover.Collision.ContactPlane);
    }

    [Theory, Behaviour("bsp.step-down.reach", "spec/04, 6.10 and 4.13: one and a half times the probe")]
    [InlineData(0.28, 0.199999988, 0.666666687)]
    [InlineData(-0.12, 0.599999964, 6.20881693e-08)]
    [InlineData(-0.42, 0.899999976, -0.499999911)]
    public void A_probe_reaches_a_floor_half_its_length_above_where_it_began(float z, float lift, float interp)
    {
        Mover mover = new Mover(Standing, new(0, 0, 1), new(0.1f, 0, z), 0.48f, Head)
            .With(p => (p.SteppingDown, p.StepDownAmount) = (true, 0.6f));
        float before = mover.At.Z;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Floor));
        Assert.Equal((before + lift, interp), (mover.At.Z, mover.Path.WalkInterp));
    }

    [Fact, Behaviour("bsp.step-down.tangent", "spec/04, 6.10")]
    public void A_probe_that_is_exactly_tangent_finds_nothing()
    {
        Mover mover = new Mover(Standing, new(0, 0, 1), new(0.1f, 0, 0.48f), 0.48f,
            Head).With(p => (p.SteppingDown, p.StepDownAmount) = (true, 0.6f));
        Assert.Equal(TransitionState.OK, mover.Ask(Floor));
    }

    [Theory, Behaviour("bsp.scale.contact-plane", "spec/04, 6.15: retail scales the constant after moving it")]
    [InlineData(1, -5.5)]
    [InlineData(2, -11)]
    public void The_contact_plane_of_a_scaled_part_is_off_by_the_part_s_height(float scale, float d)
    {
        PhysicsBsp top = Trees.OneFace(new(-1, -1, 0.5f), new(1, -1, 0.5f), new(1, 1, 0.5f), new(-1, 1, 0.5f));
        float surface = 5 + (0.5f * scale);
        Mover mover = new Mover(MoverFlags.None, new(3, 4, surface + 0.6f), new(3, 4, surface + 0.3f), 0.48f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(top, new Frame(new(3, 4, 5), Quaternion.Identity), scale));
        Assert.Equal(surface + 0.48f, mover.At.Z, 4);
        Assert.Equal(d, mover.Collision.ContactPlane.D);
    }

    [Theory, Behaviour("bsp.scale.degenerate", "spec/04, 4.3: never let a NaN reach a position")]
    [InlineData(0f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_part_of_no_scale_stops_nobody_and_moves_nobody(float scale)
    {
        foreach (MoverFlags flags in (MoverFlags[])[Standing, MoverFlags.None, MoverFlags.PathClipped, PerfectMissile])
        {
            Action<SpherePath>[] modes = [_ => { }, p => p.SteppingDown = true, p => p.Collide = true, p => p.CheckingWalkable = true];
            foreach (Action<SpherePath> mode in modes)
            {
                Mover mover = new Mover(flags, new(0, 0, 1), new(0.1f, 0, 0.3f), 0.48f, Head).With(mode);
                mover.Path.StepDownAmount = 0.6f;
                mover.Ask(Floor, Frame.Identity, scale);
                Assert.True(RetailMath.IsFinite(mover.At), $"{flags} at {mover.At}");
            }
        }
    }
}
