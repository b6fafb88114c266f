using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>
/// Whole sweeps against one obstacle: specification 04, 6.17; exact floats. The names of the cases are the specification's.
/// </summary>
public class ObstacleSweepTests
{
    private const MoverFlags Air = MoverFlags.None;
    private const MoverFlags Stand = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags Careful = Stand | MoverFlags.EdgeSlide;
    private const MoverFlags Missile = MoverFlags.PathClipped;
    private const MoverFlags Camera = (MoverFlags)0x5C;

    private static readonly Vector3 PrintsNoNormal = new(float.NaN);

    private static readonly Sphere[] Body = [new(new Vector3(0, 0, 0.48f), 0.48f), new(new Vector3(0, 0, 1.35f), 0.48f)];

    /// <summary>A tree that answers as a room does.</summary>
    private static Func<Transition, TransitionState> Box(Vector3 min, Vector3 max)
    {
        PhysicsBsp tree = Trees.Box(min, max);
        return t =>
        {
            t.Path.ObstructionEthereal = false;
            t.Path.CacheLocalSpaceSpheres(new Position(StubWorld.CellId, Frame.Identity), 1);
            TransitionState state = tree.FindCollisions(t, 1);
            if (state != TransitionState.OK && !t.Object.Has(MoverFlags.Contact)) t.Collision.CollidedWithEnvironment = true;
            return state;
        };
    }

    private static Func<Transition, TransitionState> Ball(Vector3 center, bool creature = false) =>
        t => BallObstacle.IntersectsSphere(t, new Sphere(center, 0.5f), creature);

    private static Func<Transition, TransitionState> Pillar(float height, Quaternion? turn = null) =>
        t => CylinderObstacle.IntersectsSphere(
        t, new Position(StubWorld.CellId, new Frame(new(1.2f, 0, 0), turn ?? Quaternion.Identity)), 1,
        new CylSphere(Vector3.Zero, 0.5f, height));

    private static Transition Run(
        Func<Transition, TransitionState> obstacle, Vector3 start, Vector3 way, MoverFlags flags, float? small = null, bool ground = true,
        float floor = 0)
    {
        StubWorld world = new(_ => ground ? StubWorld.Flat(0) : null);
        world.Cell.Obstacle = obstacle;
        Transition t = new(world);
        t.Reset();
        Sphere[] spheres = small is { } radius ? [new Sphere(Vector3.Zero, radius)] : Body;
        PhysicsBody body = world.Walker();
        t.Object.Init(body, flags);
        t.Path.InitSpheres(spheres, 1);
        if ((flags & MoverFlags.Contact) != 0) t.InitContactPlane(StubWorld.CellId, StubWorld.Flat(floor), false);
        t.Path.InitPath(world.Cell, true, new Position(StubWorld.CellId, start), new Position(StubWorld.CellId, start + way));
        t.FindValidPosition();
        return t;
    }

    private static void AssertEnds(Transition t, float x, float y, float z, MoverFlags flags, Vector3? normal = null)
    {
        Assert.Equal(new Vector3(x, y, z), t.Path.CurrPos.Frame.Origin);
        Assert.Equal(flags & Careful, t.Object.Flags & Careful);
        if (normal is not { } n) Assert.False(t.Collision.CollisionNormalValid);
        else if (!float.IsNaN(n.X)) Assert.Equal(n, t.Collision.CollisionNormal);
    }

    private static Func<Transition, TransitionState> BoxOf(float height) => Box(new(1, -5, 0), new(5, 5, height));

    [Theory, Behaviour("obstacle.box.step-up", "spec/04, 6.17 B1, B2, B2j, B2h and 4.13: meshes are stepped onto further than terrain")]
    [InlineData(0.5, 0.700000048, 0.5)]
    [InlineData(0.8, 0.700000048, 0.799999952)]
    [InlineData(0.9, 0.400000006, 0)]
    [InlineData(1.0, 0.400000006, 0)]
    public void A_walker_steps_onto_a_box_while_the_foot_overlaps_its_edge(float height, float x, float z)
    {
        Transition t = Run(BoxOf(height), new(0.4f, 0, 0), new(0.3f, 0, 0), Stand);
        AssertEnds(t, x, 0, z, Stand, z == 0 ? new Vector3(-1, 0, 0) : null);
        if (height == 0.5f) Assert.Equal(-0.5f, t.Collision.ContactPlane.D);
    }

    [Fact, Behaviour("obstacle.box.along", "spec/04, 6.17 B3")]
    public void A_walker_slides_along_a_box_too_high_to_climb()
    {
        Transition t = Run(BoxOf(1), new(0.4f, 0, 0), new(0.3f, 0.3f, 0), Stand);
        AssertEnds(t, 0.400000006f, 0.300000012f, 0, Stand, PrintsNoNormal);
        Assert.Equal((true, new Vector3(-1, 0, 0)), (t.Collision.SlidingNormalValid, t.Collision.SlidingNormal));
    }

    [Fact, Behaviour("obstacle.box.landing", "spec/04, 6.17 B4")]
    public void A_falling_body_lands_on_a_box()
    {
        Transition t = Run(BoxOf(0.5f), new(2, 0, 0.6f), new(0.1f, 0, -0.2f), Air);
        AssertEnds(t, 2.04999995f, 0, 0.50000006f, Stand);
        Assert.Equal((-0.5f, true), (t.Collision.ContactPlane.D, t.Collision.CollidedWithEnvironment));
    }

    [Fact, Behaviour("obstacle.box.airborne-wall", "spec/04, 6.17 B5")]
    public void A_jump_against_a_wall_ends_there()
    {
        Transition t = Run(Box(new(1, -5, 0), new(2, 5, 3)), new(0.4f, 0, 2), new(0.3f, 0, -0.2f), Air);
        AssertEnds(t, 0.400000006f, 0, 2, Air, new(-1, 0, 0));
        Assert.Equal(1, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("obstacle.box.overhang", "spec/04, 6.17 B6, B6e")]
    public void A_walker_stands_beyond_an_edge_as_far_as_the_foot_overlaps_it()
    {
        Transition over = Run(BoxOf(1), new(1.2f, 0, 1), new(-0.5f, 0, 0), Stand, floor: 1);
        AssertEnds(over, 0.700000048f, 0, 1, Stand, PrintsNoNormal);
        Transition off = Run(BoxOf(1), new(0.7f, 0, 1), new(-0.3f, 0, 0), Stand, floor: 1);
        AssertEnds(off, 0.399999976f, 0, 1, Air, PrintsNoNormal);
    }

    [Fact, Behaviour("obstacle.box.precipice", "spec/04, 6.17 B6d")]
    public void A_careful_walker_slides_along_the_edge()
    {
        Transition t = Run(BoxOf(1), new(0.9f, 0, 1), new(-0.4f, 0.2f, 0), Careful, floor: 1);
        AssertEnds(t, 0.899999976f, 0.200000003f, 1, Careful, new(1, 0, 0));
    }

    [Fact, Behaviour("obstacle.box.ceiling", "spec/04, 6.17 B7")]
    public void A_jump_against_a_ceiling_ends_there()
    {
        Transition t = Run(Box(new(-2, -2, 2), new(2, 2, 3)), Vector3.Zero, new(0.3f, 0, 0.4f), Air);
        AssertEnds(t, 0, 0, 0, Air, new(0, 0, -1));
        Assert.Equal(1, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("obstacle.box.missile", "spec/04, 6.17 B8")]
    public void A_missile_ends_with_the_sub_step_that_hit_and_not_at_the_wall() =>
        AssertEnds(
            Run(Box(new(1, -5, 0), new(2, 5, 3)), new(-0.5f, 0, 1), new(1.4f, 0, 0), Missile, 0.2f, ground: false),
            0.699999988f, 0, 1, Air, new(-1, 0, 0));

    [Fact, Behaviour("obstacle.box.camera", "spec/04, 6.17 B9")]
    public void The_camera_ends_at_the_wall() =>
        AssertEnds(
            Run(Box(new(1, -5, 0), new(2, 5, 3)), new(-0.5f, 0, 1.5f), new(3, 0, 0), Camera, 0.3f),
            0.700000048f, 0, 1.5f, Air, new(-1, 0, 0));

    [Fact, Behaviour("obstacle.ball.step-up", "spec/04, 6.17 S1")]
    public void A_walker_steps_onto_a_ball()
    {
        Transition t = Run(Ball(new(1, 0, 0)), Vector3.Zero, new(0.3f, 0, 0), Stand);
        AssertEnds(t, 0.300000012f, 0, 0.205857113f, Stand, PrintsNoNormal);
        Assert.Equal(new Plane(-0.714285731f, 0, 0.699854195f, 0.214285731f), t.Collision.ContactPlane);
        Assert.True(t.Collision.ContactPlaneIsWater);
    }

    [Fact, Behaviour("obstacle.ball.creature-is-no-step", "spec/04, 6.17 S1b")]
    public void A_walker_does_not_step_onto_a_creature()
    {
        Transition t = Run(Ball(new(1, 0, 0), creature: true), Vector3.Zero, new(0.3f, 0, 0), Stand);
        AssertEnds(t, 0, 0, 0, Stand, new(-0.901523054f, 0, 0.432731062f));
        Assert.Equal(new Vector3(-1, 0, 0), t.Collision.SlidingNormal);
    }

    [Fact, Behaviour("obstacle.ball.slide", "spec/04, 6.17 S2")]
    public void A_walker_slides_past_a_ball() =>
        AssertEnds(Run(Ball(new(1.2f, 0, 0.48f)), Vector3.Zero, new(0.3f, 0.3f, 0), Stand), 0, 0.300000012f, 0, Stand, new(-1, 0, 0));

    [Fact, Behaviour("obstacle.ball.landing", "spec/04, 6.17 S3")]
    public void A_falling_body_lands_on_a_ball()
    {
        Transition t = Run(Ball(new(0, 0, 0.4f)), new(0, 0, 1), new(0.05f, 0, -0.2f), Air);
        AssertEnds(t, 0.0250802599f, 0, 0.899679005f, Stand, PrintsNoNormal);
        Assert.Equal(new Plane(0.0255921036f, 0, 0.999672472f, -0.800860345f), t.Collision.ContactPlane);
        Assert.True(t.Collision.ContactPlaneIsWater);
    }

    [Fact, Behaviour("obstacle.ball.creature-is-no-floor", "spec/04, 6.17 S3b")]
    public void A_falling_body_does_not_land_on_a_creature()
    {
        Transition t = Run(Ball(new(0, 0, 0.4f), creature: true), new(0, 0, 1), new(0.05f, 0, -0.2f), Air);
        AssertEnds(t, 0, 0, 1, Air, new(0, 0, 1));
        Assert.Equal(1, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("obstacle.ball.missile", "spec/04, 6.17 S4")]
    public void A_missile_ends_before_the_ball() =>
        AssertEnds(
            Run(Ball(new(1.5f, 0.2f, 0.5f)), new(0, 0, 0.5f), new(1, 0, 0), Missile, 0.1f, ground: false),
            0.900000095f, 0, 0.5f, Air, new(-0.948683262f, -0.316227823f, 0));

    [Fact, Behaviour("obstacle.ball.camera", "spec/04, 6.17 S5")]
    public void The_camera_ends_at_the_ball() =>
        AssertEnds(
            Run(Ball(new(1.2f, 0.1f, 0.5f)), new(0, 0, 0.5f), new(1, 0, 0), Camera, 0.3f, ground: false),
            0.406274647f, 0, 0.5f, Air, new(-0.992156744f, -0.125f, 0));

    [Fact, Behaviour("obstacle.cylinder.slide", "spec/04, 6.17 C1, C1b")]
    public void A_walker_slides_past_a_cylinder_and_is_stopped_head_on()
    {
        AssertEnds(Run(Pillar(2), Vector3.Zero, new(0.3f, 0.3f, 0), Stand), 0, 0.300000012f, 0, Stand, new(-1, 0, 0));
        AssertEnds(Run(Pillar(2), Vector3.Zero, new(0.3f, 0, 0), Stand), 0, 0, 0, Stand, PrintsNoNormal);
    }

    [Theory, Behaviour("obstacle.cylinder.step-up", "spec/04, 6.17 C2, C2b, C2c")]
    [InlineData(0.5, 0.300000012, 0.5)]
    [InlineData(0.6, 0.300000012, 0.600000024)]
    [InlineData(0.61, 0, 0)]
    public void A_walker_steps_onto_a_cylinder_up_to_the_step_height(float height, float x, float z) =>
        AssertEnds(Run(Pillar(height), Vector3.Zero, new(0.3f, 0, 0), Stand), x, 0, z, Stand, PrintsNoNormal);

    [Fact, Behaviour("obstacle.cylinder.landing", "spec/04, 6.17 C3")]
    public void A_falling_body_lands_on_a_cylinder()
    {
        Transition t = Run(Pillar(0.5f), new(1.2f, 0, 0.7f), new(0.02f, 0, -0.3f), Air);
        AssertEnds(t, 1.21333337f, 0, 0.5f, Stand, PrintsNoNormal);
        Assert.Equal((-0.5f, true), (t.Collision.ContactPlane.D, t.Collision.ContactPlaneIsWater));
    }

    [Fact, Behaviour("obstacle.cylinder.airborne-side", "spec/04, 6.17 C4")]
    public void A_jump_against_a_cylinder_ends_there()
    {
        Transition t = Run(Pillar(3), new(0, 0, 0.7f), new(0.3f, 0.1f, -0.1f), Air);
        AssertEnds(t, 0, 0, 0.699999988f, Air, new(-1, 0, 0));
        Assert.Equal(1, t.Collision.FramesStationaryFall);
    }

    [Fact, Behaviour("obstacle.cylinder.camera", "spec/04, 6.17 C6")]
    public void The_camera_ends_at_the_cylinder() =>
        AssertEnds(
            Run(Pillar(3), new(0, 0, 1), new(1, 0.1f, 0), Camera, 0.3f, ground: false),
            0.401005745f, 0.0401005745f, 1, Air, new(-0.998742938f, 0.0501257218f, 0));

    [Fact, Behaviour("obstacle.cylinder.rim", "spec/04, 6.17 C8b")]
    public void A_walker_stays_on_the_rim() =>
        AssertEnds(Run(Pillar(0.5f), new(1.6f, 0, 0.5f), new(0.3f, 0, 0), Stand, floor: 0.5f), 1.9000001f, 0, 0.49999997f, Stand,
            PrintsNoNormal);

    [Fact, Behaviour("obstacle.cylinder.refused-step-up", "spec/04, 6.17 C9, C9b")]
    public void A_refused_step_up_slides_with_a_normal_that_turns_with_the_object()
    {
        const float Root = 0.707106769f;
        Func<Transition, TransitionState> ceiling = Box(new(-3, -3, 1.9f), new(3, 3, 2.5f));

        Func<Transition, TransitionState> Under(Func<Transition, TransitionState> pillar) => t =>
        {
            TransitionState state = ceiling(t);
            return state != TransitionState.OK ? state : pillar(t);
        };

        Transition straight = Run(Under(Pillar(0.5f)), Vector3.Zero, new(0.3f, 0.1f, 0), Stand);
        AssertEnds(straight, 0, 0.100000001f, 0, Stand, PrintsNoNormal);
        Transition turned = Run(Under(Pillar(0.5f, new Quaternion(0, 0, Root, Root))), Vector3.Zero, new(0.3f, 0.1f, 0), Stand);
        AssertEnds(turned, 0, 0, 0, Stand, new(-3.42285453e-08f, -1, 0));
    }
}
