using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>Where the specification itself lets a body end inside something; see <see cref="Stand"/>.</summary>
public sealed class ExceptionTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint HumanSetup = 0x02000001;
    private const float Quantum = 1f / 30;
    private const PhysicsState Plain = PhysicsState.Gravity | PhysicsState.ReportCollisions;
    private const WeenieTraits Beast = WeenieTraits.Present | WeenieTraits.Creature;

    private static readonly SetupAsset Ball =
        new() { Id = 0x02FF0001, Spheres = [new Sphere(Vector3.Zero, 0.25f)], StepUpHeight = 0.3f, StepDownHeight = 0.3f };

    [Fact]
    [Behaviour("properties.exception.steep-ground-walked-into", "spec/03, 4.4 (end) and 4.7 edge_slide case A")]
    public void A_walker_that_does_not_edge_slide_enters_steep_ground_and_is_lifted_out_later()
    {
        // The slope rises at 60 degrees from the northern border of its block's neighbour; before it the ground is level.
        (PhysicsWorld world, PhysicsEngine engine, Position foot) = At("slope-60", default);
        foot.Frame.Origin.Y = 191.9f;
        foot.CellId = (foot.CellId & 0xFFFF0000) | 0x20;
        Assert.True(foot.AdjustToOutside());
        PhysicsBody careless = Enter(engine, foot, Plain),
            careful = Enter(engine, foot with { Frame = Moved(foot.Frame, new Vector3(3, 0, 0)) }, PhysicsState.Default);
        SolidTest test = new(world);

        float level = careless.Position.Frame.Origin.Z;
        Strides.Walk(careless, new Vector3(0, 0.4f, 0));
        Assert.Equal(Stand.SteepGroundWalkedInto, test.Judge(careless));
        Assert.Equal(level, careless.Position.Frame.Origin.Z, 1e-4f);
        Assert.False(careless.HasContact);

        // The next quantum only gains velocity (specification 02, 4.6); the one after it meets the ground, 0.3 m past the border.
        for (int i = 0; i < 3; i++) Strides.Walk(careless, default);
        Assert.Equal(Stand.Free, test.Judge(careless));
        Assert.True(careless.Position.Frame.Origin.Z > level + (0.25f * MathF.Tan(MathF.PI / 3)));

        Strides.Walk(careful, new Vector3(0, 0.4f, 0));
        Assert.Equal(Stand.Free, test.Judge(careful));
    }

    [Fact]
    [Behaviour("properties.exception.passed-by-one-sphere", "spec/04, 4.6 row 5 and 4.13, last point")]
    public void One_sphere_passes_a_face_that_it_does_not_run_against_and_two_do_not()
    {
        // The stair is 3 m wide and begins 5 m north of the place. The ball's way west overlaps its front by 6 mm, and its end face not at
        // all in either quantum.
        (PhysicsWorld world, PhysicsEngine engine, Position place) = At("steps-80", default);
        SolidTest test = new(world);
        PhysicsBody ball = Enter(engine, Off(place, new Vector3(1.626f, 5 - 0.244f, 0.25f)), Plain, Ball);
        PhysicsBody human = Enter(engine, Off(place, new Vector3(1.626f, 5 - 0.474f, 0.005f)), Plain);
        Assert.True(ball.OnWalkable && human.OnWalkable);
        Assert.Equal(Stand.Free, test.Judge(ball));
        float begin = ball.Position.Frame.Origin.X;
        Strides.Walk(ball, new Vector3(-0.47f, 0, 0));
        Assert.Equal(begin - 0.47f, ball.Position.Frame.Origin.X, 1e-3f);
        Assert.Equal(Stand.PassedByOneSphere, test.Judge(ball));

        Strides.Walk(human, new Vector3(-0.47f, 0, 0));
        Assert.Equal(Stand.Free, test.Judge(human));
    }

    [Fact]
    [Behaviour("properties.exception.solid-without-faces", "spec/04, 3 CELL_FUDGE, 4.5, 4.6 rows 1 and 7")]
    public void The_mark_of_a_solid_leaf_stops_nobody_whose_spheres_touch_no_face()
    {
        // Above the hall's ceiling, in the hollow of the house: the ground's cell, as long as no room is reached.
        (PhysicsWorld world, PhysicsEngine engine, Position hall) = At("house-hall", default);
        float floor = hall.Frame.Origin.Z - 0.005f, ceiling = floor + 3;
        Position touching = new(hall.CellId, hall.Frame);
        Assert.True(touching.AdjustToOutside());
        touching.Frame.Origin.Z = ceiling + 0.48f - 0.475f;
        Position above = Off(touching, new Vector3(0, 0, 0.05f));
        SolidTest test = new(world);
        PhysicsBody body = engine.CreateBody(1, files.Cache.GetSetup(HumanSetup));
        Assert.Equal(Stand.Free, test.Judge(body, above, false));
        // A room is reached one centimetre before the sphere touches it.
        Assert.Equal(Stand.Free, test.Judge(body, Off(touching, new Vector3(0, 0, 0.012f)), false));
        Assert.Equal(Stand.SolidWithoutFaces, test.Judge(body, Off(touching, new Vector3(0, 0, 0.008f)), false));
        Assert.Equal(Stand.Inside, test.Judge(body, Off(touching, new Vector3(0, 0, -0.01f)), false));

        body.Seat(new BodySeat(above, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
        SweepResult fall = engine.CreateQuery().Sweep(body, Off(touching, new Vector3(0, 0, 0.005f)));
        Assert.True(fall.Found);
        Assert.Equal(touching.Frame.Origin.Z + 0.005f, fall.Position.Frame.Origin.Z, 1e-4f);
        Assert.Equal(Stand.SolidWithoutFaces, test.Judge(body, fall.Position, fall.Contact is not null));
    }

    [Fact]
    [Behaviour("properties.exception.turned-into", "spec/02, 4.4: a quantum that only turns runs no transition")]
    public void A_body_turns_its_off_centre_spheres_into_a_wall()
    {
        // The wall is 4 m east of the middle of the hall; the head reaches 0.9 m ahead of the axis.
        (PhysicsWorld world, PhysicsEngine engine, Position hall) = At("house-hall", new Vector3(3.4f, 0, 0));
        SetupAsset bent = new()
        {
            Id = 0x02FF0003,
            Spheres = [new Sphere(new Vector3(0, 0, 0.475f), 0.48f), new Sphere(new Vector3(0, 0.6f, 1.35f), 0.3f)],
            StepUpHeight = 0.6f,
            StepDownHeight = 1.5f,
        };
        SolidTest test = new(world);
        PhysicsBody body = Enter(engine, hall, PhysicsState.Default, bent);
        Assert.Equal(Stand.Free, test.Judge(body));
        Position before = body.Position;
        SteeredPhysicsBody.Of(body).Attach(new Turn());
        body.AdvanceQuantum(Quantum);
        Assert.Equal(before.Frame.Origin, body.Position.Frame.Origin);
        Assert.Equal(Stand.Inside, test.Judge(body));
    }

    [Fact]
    [Behaviour("properties.exception.others-walk-into-it",
        "spec/06, 4 and spec/02, 4.21 step 7: a mover is its spheres, an obstacle its cylinders")]
    public void Whoever_stands_still_may_find_itself_inside_another_that_came()
    {
        (PhysicsWorld world, PhysicsEngine engine, Position place) = At("gaps", default);
        SetupAsset fat = new()
        {
            Id = 0x02FF0004,
            Spheres = [new Sphere(new Vector3(0, 0, 0.3f), 0.3f)],
            Cylinders = [new CylSphere(Vector3.Zero, 0.6f, 1.8f)],
            StepUpHeight = 0.4f,
            StepDownHeight = 0.6f,
        };
        SolidTest test = new(world);
        PhysicsBody human = Enter(engine, place, PhysicsState.Default),
            other = Enter(engine, Off(place, new Vector3(0, -3, 0)), PhysicsState.Default, fat);
        Assert.Equal(Stand.Free, test.Judge(human));
        for (int i = 0; i < 60; i++) Strides.Walk(other, new Vector3(0, 0.1f, 0));
        float gap = other.Position.OffsetTo(human.Position).Y;
        // The spheres touch at 0.78 m on the level, less what the human's lower sphere leaves free under its middle.
        Assert.InRange(gap, 0.7f, 0.95f);
        Assert.NotEqual(Stand.Inside, test.Judge(other));
        Assert.Equal(Stand.Inside, test.Judge(human));

        for (int i = 0; i < 10; i++) Strides.Walk(human, new Vector3(0, 0.4f, 0));
        Assert.Equal(Stand.Free, test.Judge(human));
    }

    [Fact]
    [Behaviour("properties.exception.none-for-the-ethereal", "spec/02, 4.21: an ethereal obstacle is no obstacle to the test either")]
    public void An_open_door_is_free_and_a_closed_one_is_not()
    {
        (PhysicsWorld world, PhysicsEngine engine, Position place) = At("gaps", default);
        DemoSpawn spawn = DemoSpawns.All.First(s => s.Kind == DemoSpawnKind.Door);
        PhysicsBody door = engine.CreateBody(2, files.Cache.GetSetup(spawn.SetupId), PhysicsState.ReportCollisions, WeenieTraits.Present);
        Assert.True(door.EnterWorld(place));
        SolidTest test = new(world);
        PhysicsBody human = engine.CreateBody(1, files.Cache.GetSetup(HumanSetup), weenie: Beast);
        Position inside = Off(place, new Vector3(0, 0.2f, 0.005f));
        Assert.Equal(Stand.Inside, test.Judge(human, inside, true));
        Assert.True(door.SetEthereal(true));
        Assert.Equal(Stand.Free, test.Judge(human, inside, true));

        // It stays open as long as somebody stands in it.
        Assert.True(human.EnterWorld(inside));
        Assert.False(door.SetEthereal(false));
        Assert.Equal(Stand.Free, test.Judge(human));
    }

    private (PhysicsWorld World, PhysicsEngine Engine, Position Place) At(string name, Vector3 offset)
    {
        Assert.True(DemoPlaces.TryFind(name, out NamedPlace named));
        PhysicsEngine engine = files.CreateEngine();
        Position place = new(named.CellId, named.Origin + offset);
        engine.World.EnsureLoadedAround(place, 1);
        return (engine.World, engine, place);
    }

    /// <summary>Puts a body somewhere and lets it come to rest.</summary>
    private PhysicsBody Enter(PhysicsEngine engine, in Position place, PhysicsState state, SetupAsset? setup = null)
    {
        PhysicsBody body = engine.CreateBody((uint)engine.Bodies.Count() + 1, setup ?? files.Cache.GetSetup(HumanSetup), state, Beast);
        Assert.True(body.EnterWorld(place));
        for (int i = 0; i < 30; i++) Strides.Walk(body, default);
        return body;
    }

    private static Position Off(in Position place, Vector3 way) => place with { Frame = Moved(place.Frame, way) };

    private static Frame Moved(Frame frame, Vector3 way)
    {
        frame.Origin += way;
        return frame;
    }

    /// <summary>Turns by a quarter to the right in one quantum.</summary>
    private sealed class Turn : IBodyMovement
    {
        public void AccumulateRootMotion(float quantum, ref Frame offset) => offset.SetHeading(90);

        public void HitGround()
        {
        }

        public void LeaveGround()
        {
        }

        public void UseTime()
        {
        }

        public void HandleEnterWorld()
        {
        }

        public void HandleExitWorld()
        {
        }
    }
}
