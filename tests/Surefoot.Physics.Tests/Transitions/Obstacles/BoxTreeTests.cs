using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>The box 2 × 2 × 2 of specification 04, 6.16: exact floats.</summary>
public class BoxTreeTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags Camera = (MoverFlags)0x5C;
    private const int MinusX = 3;

    private static readonly Vector3 Head = new(0, 0, 0.87f);
    private static readonly PhysicsBsp Box = Trees.Box(Vector3.Zero, new(2));

    [Fact, Behaviour("bsp.landing.on-box", "spec/04, 6.16")]
    public void A_falling_body_lands_on_the_box()
    {
        Mover air = new(MoverFlags.None, new(1, 1, 2.6f), new(1, 1, 2.3f), 0.48f);
        Assert.Equal(TransitionState.Adjusted, air.Ask(Box));
        Assert.Equal((true, Vector3.UnitZ), (air.Path.Collide, air.Path.StepUpNormal));

        Mover landing = new Mover(MoverFlags.None, new(1, 1, 2.6f), new(1, 1, 2.3f), 0.48f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, landing.Ask(Box));
        Assert.Equal(new Vector3(0, 0, 0.180000067f), landing.Moved);
        Assert.Equal((-2f, 0.399999768f), (landing.Collision.ContactPlane.D, landing.Path.WalkInterp));
        Assert.Equal(new Sphere(new(1, 1, 2.48000002f), 0.48f), landing.Path.WalkableCheckPos);

        Mover slanted = new Mover(MoverFlags.None, new(0.8f, 1, 2.6f), new(1, 1, 2.3f), 0.48f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, slanted.Ask(Box));
        Assert.Equal((new Vector3(-0.120000064f, 0, 0.180000067f), 0.399999768f), (slanted.Moved, slanted.Path.WalkInterp));
    }

    [Fact, Behaviour("bsp.airborne.leaving", "spec/04, 6.16")]
    public void A_body_in_the_air_that_leaves_a_wall_is_asked_to_land_on_it()
    {
        Mover mover = new(MoverFlags.None, new(-0.4f, 1, 1), new(-0.45f, 1, 1), 0.48f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Box));
        Assert.Equal((true, new Vector3(-1, 0, 0)), (mover.Path.Collide, mover.Path.StepUpNormal));
    }

    [Fact, Behaviour("bsp.airborne.head-stops", "spec/04, 6.16")]
    public void A_head_in_the_air_is_stopped_by_the_ceiling()
    {
        Mover mover = new(MoverFlags.None, new(1, 1, -1.5f), new(1, 1, -1.3f), 0.48f, Head);
        Assert.Equal(TransitionState.Collided, mover.Ask(Box));
        Assert.Equal(new Vector3(0, 0, -1), mover.Collision.CollisionNormal);
        Assert.False(mover.Path.Collide);
    }

    [Fact, Behaviour("bsp.grounded.one-sphere-back-face", "spec/04, 6.16")]
    public void A_body_of_one_sphere_walks_along_a_wall_it_overlaps()
    {
        Mover mover = new(Standing, new(-0.4f, 0.9f, 1), new(-0.4f, 1, 1), 0.48f);
        Assert.Equal((TransitionState.OK, false), (mover.Ask(Box), mover.Path.NegPolyHit));
    }

    [Theory, Behaviour("bsp.grounded.two-spheres-back-face", "spec/04, 6.16")]
    [InlineData(1.9, true)]
    [InlineData(0.5, false)]
    [InlineData(-1, false)]
    public void A_body_of_two_spheres_defers_the_wall_it_overlaps(float z, bool stepUp)
    {
        Mover mover = new(Standing, new(-0.4f, 0.9f, z), new(-0.4f, 1, z), 0.48f, Head);
        Assert.Equal(TransitionState.OK, mover.Ask(Box));
        Assert.Equal((true, stepUp, new Vector3(1, 0, 0)), (mover.Path.NegPolyHit, mover.Path.NegStepUp, mover.Path.NegCollisionNormal));
    }

    [Fact, Behaviour("bsp.grounded.head-slides-foot", "spec/04, 6.16, BSPTREE::slide_sphere @0x00539E50")]
    public void A_head_into_a_wall_slides_the_body()
    {
        Mover along = new Mover(Standing, new(-0.6f, 0.9f, -1), new(-0.4f, 1, -1), 0.48f, Head).LastStoodOn(Vector3.UnitZ);
        Assert.Equal(TransitionState.Slid, along.Ask(Box));
        Assert.Equal(new Vector3(-0.200000018f, 0, 0), along.Moved);

        Mover straight = new Mover(Standing, new(-0.6f, 1, -1), new(-0.4f, 1, -1), 0.48f, Head).LastStoodOn(Vector3.UnitZ);
        Assert.Equal(TransitionState.Collided, straight.Ask(Box));
        Assert.Equal(new Vector3(-1, 0, 0), straight.Collision.CollisionNormal);
    }

    [Fact, Behaviour("bsp.missile.stops", "spec/04, 6.16, BSPTREE::collide_with_pt @0x0053A090")]
    public void A_missile_stops_with_the_polygon_s_normal()
    {
        Mover mover = new(MoverFlags.PathClipped, new(-0.6f, 1, 1), new(-0.4f, 1, 1), 0.48f);
        Assert.Equal(TransitionState.Collided, mover.Ask(Box));
        Assert.Equal((new Vector3(-1, 0, 0), Vector3.Zero), (mover.Collision.CollisionNormal, mover.Moved));
    }

    [Fact, Behaviour("bsp.missile.head-passes", "spec/04, 4.6 row 6: sphere 1 is not tested")]
    public void The_second_sphere_of_a_missile_is_not_tested()
    {
        Mover mover = new(MoverFlags.PathClipped, new(1, 1, -1.5f), new(1, 1, -1.3f), 0.48f, Head);
        Assert.Equal(TransitionState.OK, mover.Ask(Box));
    }

    [Theory, Behaviour("bsp.step-down.box", "spec/04, 6.16")]
    [InlineData(-0.3, 1, 0.699999928)]
    [InlineData(1, 0.4, 0.0999999493)]
    public void A_probe_stands_on_the_box_and_on_its_edge(float x, float interp, float after)
    {
        Mover mover = new Mover(Standing, new(x, 1, 2.3f), new(x, 1, 2.3f), 0.48f)
            .With(p => (p.SteppingDown, p.StepDownAmount, p.WalkInterp) = (true, 0.6f, interp));
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Box));
        Assert.Equal((new Vector3(0, 0, 0.180000067f), after), (mover.Moved, mover.Path.WalkInterp));
    }

    [Theory, Behaviour("bsp.footing.half-radius", "spec/04, 6.16")]
    [InlineData(1, TransitionState.Collided)]
    [InlineData(-0.2, TransitionState.Collided)]
    [InlineData(-0.3, TransitionState.OK)]
    public void Footing_ends_half_a_radius_beyond_the_edge(float x, TransitionState answer) =>
        Assert.Equal(answer, new Mover(Standing, new(x, 1, 2.3f), new(x, 1, 2.3f), 0.48f).With(p => p.CheckingWalkable = true).Ask(Box));

    [Theory, Behaviour("bsp.placement.box", "spec/04, 6.16")]
    [InlineData(1.7, 1, false, 0.779999971, 0)]
    [InlineData(2.3, 1, false, 0.180000067, 0)]
    [InlineData(1.7, 1.8, false, 0, 0.680000067)]
    [InlineData(1.7, 1.2, true, 0.779999971, 0)]
    [InlineData(1, 1, false, 0, 0)]
    public void A_placed_body_is_pushed_out_of_the_box(float x, float z, bool two, float outX, float outZ)
    {
        Mover mover = new Mover(Standing, new(x, 1, z), new(x, 1, z), 0.48f,
            two ? Head : null).With(p => p.InsertType = InsertType.InitialPlacement);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Box));
        Assert.Equal(new Vector3(outX, 0, outZ), mover.Moved);
    }

    [Fact, Behaviour("bsp.placement.hopeless", "spec/04, 6.16: the six polygons in every leaf")]
    public void A_body_deep_in_matter_is_refused_when_every_leaf_has_polygons()
    {
        Trees.Face[] order =
            [Trees.Face.PlusZ, Trees.Face.MinusZ, Trees.Face.PlusX, Trees.Face.MinusX, Trees.Face.PlusY, Trees.Face.MinusY];
        Vector3[][] faces = [.. order
            .Select(f => Trees.Corners(f, Vector3.Zero, new(2)))];
        Sphere bounds = new(new(1), 1.7320508f);
        PolygonSet polygons = Trees.Polygons(faces);
        PhysicsBspBuilder builder = new(polygons);
        int[] all = [0, 1, 2, 3, 4, 5];
        int below = builder.AddLeaf(bounds, true, all);
        for (int i = 5; i >= 0; i--)
        {
            int node = builder.AddNode(polygons.PlaneOf(i), bounds);
            builder.SetNegative(node, below);
            builder.SetPositive(node, builder.AddLeaf(bounds, false, all));
            below = node;
        }

        Mover mover = new Mover(Standing, new(1), new(1), 0.48f).With(p => p.InsertType = InsertType.InitialPlacement);
        Assert.Equal(TransitionState.Collided, mover.Ask(builder.Build(below, bounds)));
        Assert.Equal(Vector3.Zero, mover.Moved);
    }

    [Fact, Behaviour("bsp.camera.stops-at-wall", "spec/04, 6.16")]
    public void The_camera_stops_at_the_wall()
    {
        Mover mover = new(Camera, new(-1, 1, 1), new(-0.1f, 1, 1), 0.3f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Box));
        Assert.Equal((new Vector3(-0.200000018f, 0, 0), new Vector3(-1, 0, 0)), (mover.Moved, mover.Collision.CollisionNormal));
    }

    [Theory, Behaviour("bsp.adjust-to-plane.halving", "spec/04, 6.16, BSPTREE::adjust_to_plane @0x00539BF0")]
    [InlineData(-0.2, -1, -0.2, 1, -0.200000003, -0.25)]
    [InlineData(-1, -1, 0.5, 0.5, -0.225000024, -0.225000024)]
    public void The_last_free_place_is_found_by_halving(float currX, float currY, float x, float y, float endX, float endY)
    {
        Sphere sphere = new(new(x, y, 1), 0.3f);
        Assert.True(Box.AdjustToPlane(ref sphere, new(currX, currY, 1), new PolygonContact { Polygon = MinusX }));
        Assert.Equal(new Vector3(endX, endY, 1), sphere.Center);
    }

    [Fact, Behaviour("bsp.scale.turned-part", "spec/04, 6.16: scale 2 at (10,20,0), turned 90° about z")]
    public void A_scaled_and_turned_part_answers_in_the_world()
    {
        const float Root = 0.707106769f;
        Frame frame = new(new(10, 20, 0), new Quaternion(0, 0, Root, Root));
        Mover landing = new Mover(MoverFlags.None, new(8, 22, 4.6f), new(8, 22, 4.3f), 0.48f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, landing.Ask(Box, frame, 2));
        Assert.Equal(new Sphere(new(0.999999881f, 1, 2.1500001f), 0.239999995f), landing.Path.LocalSpaceSpheres[0]);
        Assert.Equal((new Vector3(0, 0, 0.179999828f), 0.400000095f), (landing.Moved, landing.Path.WalkInterp));
        Assert.Equal(new Plane(0, 0, 1, -4), landing.Collision.ContactPlane);

        Mover side = new(MoverFlags.None, new(8, 19.3f, 2), new(8, 19.7f, 2), 0.48f);
        Assert.Equal(TransitionState.Adjusted, side.Ask(Box, frame, 2));
        Assert.Equal(new Vector3(-3.42285418e-08f, -0.99999994f, 0), side.Path.StepUpNormal);
    }

    [Theory, Behaviour("bsp.scale.offset-stored-twice", "spec/04, 4.6 row 4: stored after turning and again after scaling")]
    [InlineData(3.3, 11.4, 19.3, 10.6, 19.6, 11.0799999, 19.4200001, 0.479999989)] // stored once: x = 11.0800009
    [InlineData(0.7, 11.6, 19.3, 10.8, 20, 11.2800007, 19.5799999, 0.480000019)] // stored once: x = 11.2799997
    public void A_move_out_of_a_scaled_part_is_stored_after_turning_and_after_scaling(
        float scale, float currX, float currY, float x, float y, float endX, float endY, float endZ)
    {
        PhysicsBsp floor = Trees.OneFace(new(-5, -5, 0), new(5, -5, 0), new(5, 5, 0), new(-5, 5, 0));
        Mover landing = new Mover(MoverFlags.None, new(currX, currY, 0.6f), new(x, y, 0.3f), 0.48f).With(p => p.Collide = true);
        Assert.Equal(TransitionState.Adjusted, landing.Ask(floor, new Frame(new(10, 20, 0), new Quaternion(0, 0, 0.6f, 0.8f)), scale));
        Assert.Equal((new Vector3(endX, endY, endZ), 0.400000095f), (landing.At, landing.Path.WalkInterp));
    }
}
