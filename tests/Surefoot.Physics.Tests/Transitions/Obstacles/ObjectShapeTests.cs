using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>From an object to the shapes that stop a body: specification 06, sections 3, 4 and 8.</summary>
public class ObjectShapeTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const float Root = 0.707106769f;

    private static readonly GfxObjAsset Cube = new() { Id = 0x01000001, Physics = Trees.UnitCube() };

    private static WorldObject Object(SetupAsset setup, Vector3 at, float scale = 1, Quaternion? turn = null)
    {
        WorldObject target = new(2, setup, PhysicsState.Static) { Scale = scale };
        target.SeatAt(new Position(Mover.CellId, new Frame(at, turn ?? Quaternion.Identity)), null);
        return target;
    }

    private static TransitionState Touch(SetupAsset setup, Vector3 check, float scale = 1, bool creature = false)
    {
        Mover mover = new Mover(Standing, check, check, 0.1f).With(p => p.InsertType = InsertType.Placement);
        return setup.FindCollisions(mover.Transition, Object(setup, Vector3.Zero, scale), creature);
    }

    [Fact, Behaviour("object.part.placed", "spec/06, 8, CPartArray::UpdateParts")]
    public void A_part_is_placed_by_its_pose_the_object_s_scale_and_its_turn()
    {
        Frame part = SetupAsset.PlacePart(
            new Frame(new(10, 20, 30), new Quaternion(0, 0, Root, Root)), new Frame(new(1, 0, 0.5f), Quaternion.Identity), 2);
        Assert.Equal(new Vector3(10, 22, 31), part.Origin, (a, b) => (a - b).Length() < 2e-6f);
        Assert.Equal(new Quaternion(0, 0, Root, Root), part.Rotation);
    }

    [Fact, Behaviour("object.part.scale-z", "spec/06, 8: default scale (0.5,0.5,2) at scale 2 tests with 4")]
    public void Only_the_z_scale_of_a_part_counts()
    {
        SetupAsset setup = new SetupAsset { Parts = [new SetupPart(Cube, new(0.5f, 0.5f, 2))] }.With(0, [Frame.Identity]);
        Assert.Equal(TransitionState.Collided, Touch(setup, new(2.05f, 0, 0), 2));
        Assert.Equal(TransitionState.OK, Touch(setup, new(2.15f, 0, 0), 2));
    }

    [Fact, Behaviour("object.shapes.exactly-one-set", "spec/02, 4.21 step 7")]
    public void Trees_come_before_cylinders_and_cylinders_before_spheres()
    {
        Sphere[] spheres = [new(new(0, 0, 5), 0.5f)];
        CylSphere[] cylinders = [new(new(0, 0, 8), 0.5f, 1)];
        SetupAsset all = new SetupAsset { Parts = [new SetupPart(Cube, Vector3.One)], Cylinders = cylinders, Spheres = spheres }
            .With(0, [Frame.Identity]);
        SetupAsset two = new() { Cylinders = cylinders, Spheres = spheres };
        SetupAsset one = new() { Spheres = spheres };
        Assert.Equal(
            (TransitionState.Collided, TransitionState.OK, TransitionState.OK),
            (Touch(all, new(0, 0, 0.55f)), Touch(all, new(0, 0, 8.5f)), Touch(all, new(0, 0, 5))));
        Assert.Equal((TransitionState.Collided, TransitionState.OK), (Touch(two, new(0, 0, 8.5f)), Touch(two, new(0, 0, 5))));
        Assert.Equal(TransitionState.Collided, Touch(one, new(0, 0, 5)));
        Assert.Equal(TransitionState.OK, Touch(new SetupAsset(), Vector3.Zero));
    }

    [Fact, Behaviour("object.shapes.scaled", "spec/06, 3")]
    public void Cylinders_and_spheres_scale_with_the_object()
    {
        SetupAsset pillar = new() { Cylinders = [new CylSphere(new(0, 0, 1), 0.5f, 1)] };
        Assert.Equal((TransitionState.OK, TransitionState.Collided), (Touch(pillar, new(0, 0, 3.5f)), Touch(pillar, new(0, 0, 3.5f), 2)));
        SetupAsset ball = new() { Spheres = [new Sphere(new(1, 0, 0), 0.5f)] };
        Assert.Equal((TransitionState.OK, TransitionState.Collided), (Touch(ball, new(2.5f, 0, 0)), Touch(ball, new(2.5f, 0, 0), 2)));
    }

    [Theory, Behaviour("object.shapes.head-has-the-foot-s-radius", "spec/04, 4.8: the radius of sphere 0 is used for sphere 1 as well")]
    [InlineData(1.45f, TransitionState.Collided)]
    [InlineData(1.55f, TransitionState.OK)]
    public void A_small_head_meets_a_ball_as_far_away_as_the_foot_would(float distance, TransitionState expected)
    {
        // Radii .5 and 1 together: the head, of .1 m and 2 m above the foot, meets the ball above it within 1.5 m.
        SetupAsset ball = new() { Spheres = [new Sphere(Vector3.Zero, 0.5f)] };
        Vector3 foot = new(0, 0, -2 - distance);
        Mover mover = new Mover(Standing, foot, foot, 1).With(p =>
        {
            p.InitSpheres([new Sphere(Vector3.Zero, 1), new Sphere(new Vector3(0, 0, 2), 0.1f)], 1);
            p.CacheGlobalSpheres();
            p.InsertType = InsertType.Placement;
        });
        Assert.Equal(expected, ball.FindCollisions(mover.Transition, Object(ball, Vector3.Zero), creature: false));
    }

    [Fact, Behaviour("object.parts.without-pose", "spec/06, 3: absent placement")]
    public void Parts_without_a_frame_stop_nobody()
    {
        SetupAsset setup = new() { Parts = [new SetupPart(Cube, Vector3.One)] };
        Assert.Equal(TransitionState.OK, Touch(setup, Vector3.Zero));
        SetupAsset halfPosed = new SetupAsset { Parts = [new SetupPart(Cube, Vector3.One), new SetupPart(Cube, Vector3.One)] }
            .With(0, [Records.FrameAt(new(5, 0, 0))]);
        Assert.Equal((TransitionState.Collided, TransitionState.OK), (Touch(halfPosed, new(5, 0, 0)), Touch(halfPosed, Vector3.Zero)));
    }

    [Fact, Behaviour("object.parts.first-answer", "spec/06, 4")]
    public void The_first_part_that_answers_ends_the_object()
    {
        SetupAsset setup = new SetupAsset { Parts = [new SetupPart(Cube, Vector3.One), new SetupPart(Cube, Vector3.One)] }
            .With(0, [Records.FrameAt(new(0, 0, -0.02f)), Frame.Identity]);
        Mover mover = new(MoverFlags.None, new(0, 0, 1), new(0, 0, 0.55f), 0.1f);
        mover.Path.Collide = true;
        Assert.Equal(TransitionState.Adjusted, setup.FindCollisions(mover.Transition, Object(setup, Vector3.Zero), false));
        Assert.Equal(-0.48f, mover.Collision.ContactPlane.D, 6);
    }

    [Fact, Behaviour("object.part.culled", "spec/04, 4.3: the root's sphere must meet one of the body's")]
    public void A_part_is_tested_when_any_sphere_meets_its_bounds()
    {
        SetupAsset setup = new SetupAsset { Parts = [new SetupPart(Cube, Vector3.One)] }.With(0, [Frame.Identity]);
        Mover mover = new(Standing, new(0, 0, -3), new(0, 0, -3), 0.1f, new Vector3(0, 0, 2.45f));
        mover.Path.InsertType = InsertType.Placement;
        Assert.Equal(TransitionState.Collided, setup.FindCollisions(mover.Transition, Object(setup, Vector3.Zero), false));
    }

    [Fact, Behaviour("object.part.initial-placement", "spec/04, 4.3: insert type 2 pushes out")]
    public void A_body_first_put_into_a_part_is_pushed_out()
    {
        Mover mover = new(Standing, new(0, 0, 0.55f), new(0, 0, 0.55f), 0.1f);
        mover.Path.InsertType = InsertType.InitialPlacement;
        Assert.Equal(TransitionState.Adjusted, Cube.FindCollisions(mover.Transition, new Position(Mover.CellId, Vector3.Zero), 1));
        Assert.Equal(0.6f, mover.At.Z, 6);
    }
}
