using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Whole ways of a real body on flat ground, thirty quanta a second: specification 09b, 14.7.</summary>
public class WholeMoveTests
{
    private const uint TargetId = 2;

    [Fact]
    [Behaviour("steering.move-to.to-a-place", "spec/09b, 14.7 M1")]
    public void A_body_turns_to_a_place_and_walks_there()
    {
        Fixture f = new(heading: 270);
        f.Movement.MoveToPosition(
            new Position(StubWorld.CellId, new Vector3(0, 10, 0)),
            new MovementParameters { Flags = MovementFlags.Default & ~MovementFlags.UseSpheres });
        Assert.Equal(32, f.CountQuanta(MotionCommand.TurnRight, out float before));
        Assert.Equal(270 + (31 * 2.86478898f), before, 1e-3f);
        Assert.Equal(0, f.Body.Position.Frame.Heading);
        Assert.Equal(91, f.CountQuanta(MotionCommand.WalkForward, out _));
        Assert.Equal(0, f.Origin.X, 1e-5f);
        Assert.Equal(9.464f, f.Origin.Y, 1e-4f);
        f.AssertStands();
    }

    [Theory]
    [Behaviour("steering.move-to.to-an-object", "spec/09b, 14.7 M2, M3 and M4")]
    [InlineData(MovementFlags.None, 0f)]
    [InlineData(MovementFlags.UseFinalHeading, 300f)]
    [InlineData(MovementFlags.Sticky, 0f)]
    public void A_body_runs_to_a_far_object_to_the_end(MovementFlags more, float desired)
    {
        Fixture f = new(heading: 0);
        PhysicsBody target = f.Spawn(TargetId, new Vector3(20, 0, 0));
        f.Movement.ApplyMoveToObject(
            MotionCommand.NonCombat, TargetId, target.Position,
            new MovementParameters { Flags = MovementFlags.Default | more, DesiredHeading = desired }, runRate: 2, autonomous: false);
        Assert.Equal(32, f.CountQuanta(MotionCommand.TurnRight, out _));
        Assert.Equal(90, f.Body.Position.Frame.Heading, 1e-4);
        Assert.Equal(71, f.CountQuanta(MotionCommand.WalkForward, out _));
        Assert.Equal(18.9333f, f.Origin.X, 1e-4f);
        if (more == MovementFlags.UseFinalHeading)
        {
            Assert.Equal(30f, f.Movement.MoveTo!.NodeAt(0).Heading);
            f.CountQuanta(MotionCommand.TurnLeft, out _);
            Assert.Equal(30, f.Body.Position.Frame.Heading, 1e-4);
        }

        f.AssertStands();
        Assert.Equal(more == MovementFlags.Sticky ? TargetId : 0, f.Body.StickyObjectId);
        if (more != MovementFlags.Sticky) return;

        // It closes up to 0.3 m between the two radii of 0.3 m.
        f.Tick(10);
        Assert.Equal(19.1f, f.Origin.X, 1e-4f);
    }

    /// <summary>A creature of radius 0.3 m and height 1.8 m whose motions are velocities.</summary>
    private sealed class Fixture
    {
        private const double FrameTime = (1.0 / 30) + 1e-9;

        private static readonly SetupAsset Shape = new()
        {
            Id = 0x02000001,
            Spheres = [new Sphere(new Vector3(0, 0, 0.3f), 0.3f)],
            Height = 1.8f,
            Radius = 0.3f,
            StepUpHeight = 0.6f,
            StepDownHeight = 0.6f,
        };

        private readonly PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
        private int frames;

        internal Fixture(float heading)
        {
            Body = Spawn(1, Vector3.Zero);
            Body.SetHeading(heading);
            Movement = new MovementManager(Body, HumanoidTable.Create(smooth: true), new OtherWeenie());
            SteeredPhysicsBody.Of(Body).Attach(Movement);
            Tick(30);
            Assert.False(Movement.MotionsPending);
        }

        internal PhysicsBody Body { get; }

        internal MovementManager Movement { get; }

        internal Vector3 Origin => Body.Position.Frame.Origin;

        internal PhysicsBody Spawn(uint id, Vector3 origin)
        {
            PhysicsBody body = engine.CreateBody(id, Shape, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature);
            Assert.True(body.EnterWorld(new Position(StubWorld.CellId, origin)));
            return body;
        }

        /// <summary>Quanta from the one after a motion was begun to the one that ends it, both counted.</summary>
        internal int CountQuanta(MotionCommand command, out float headingBefore)
        {
            for (int i = 0; i < 60 && Movement.MoveTo!.CurrentCommand != command; i++) Tick(1);
            int count = 0;
            headingBefore = 0;
            while (Movement.MoveTo!.CurrentCommand == command)
            {
                headingBefore = (float)Body.Position.Frame.Heading;
                Tick(1);
                count++;
            }

            return count;
        }

        internal void AssertStands()
        {
            Assert.False(Movement.IsMovingTo);
            Assert.Equal(MotionError.None, Movement.LastMoveToError);
            Assert.Equal(
                (MotionCommand.Ready, MotionCommand.None),
                (Movement.Interpreter.Interpreted.ForwardCommand, Movement.Interpreter.Interpreted.TurnCommand));
            Vector3 place = Origin;
            Tick(1);
            Assert.Equal(place.Y, Origin.Y, 1e-6f);
        }

        internal void Tick(int count)
        {
            for (int i = 0; i < count; i++) engine.Tick(++frames * FrameTime);
        }
    }
}
