using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Decisions;

/// <summary>What a sweep tells of the objects in its way.</summary>
public class ObjectTraceTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const uint Box = 0x01000077, Crate = 0x02000077, Post = 0x02000078, Ball = 0x02000079, ObjectId = 0x70000001;
    private const int MinusX = 3;

    [Fact, Behaviour("trace.hit.names-polygon-and-part", "design.md, decision 6")]
    public void A_hit_names_object_setup_part_polygon_sphere_plane_and_gap()
    {
        // The second part, a box from x = 1 on, is met by a foot of 0.48 m whose middle would come to 0.7.
        TraceEntry[] told = Tell(CrateOf(5), new(0.4f, 0, 0), new(0.3f, 0, 0));
        TraceEntry hit = told.First(e => e.Kind == TraceKind.Hit && e.Subject.Kind == TraceSubjectKind.Body);
        Assert.Equal(new TraceSubject(TraceSubjectKind.Body, StubWorld.CellId, ObjectId, Crate, 1, MinusX, 0), hit.Subject);
        Assert.Equal((TraceReason.RunInto, new Vector3(-1, 0, 0)), (hit.Reason, hit.Plane.Normal));
        Assert.Equal(1, hit.Plane.D, 1e-6f);
        Assert.Equal(-0.18f, hit.Gap, 1e-6f);

        TraceEntry slide = told.Last(e => e.Response == TransitionResponse.Slide);
        Assert.Equal(hit.Subject, slide.Subject);
        TraceEntry answer = told.First(e => e.Kind == TraceKind.ObjectAnswered && e.Question == SweepQuestion.Move);
        Assert.Equal((ObjectId, TransitionState.Collided), (answer.Subject.ObjectId, answer.Answer));
    }

    [Fact, Behaviour("trace.step-up.accepted", "design.md, decision 6; spec/04, 6.17 B1")]
    public void A_step_onto_an_object_is_told_and_the_body_then_rests_on_its_part_and_polygon()
    {
        TraceEntry[] told = Tell(CrateOf(0.5f), new(0.4f, 0, 0), new(0.3f, 0, 0));
        Assert.True(told.Single(e => e is { Kind: TraceKind.Responded, Response: TransitionResponse.StepUp }).Succeeded);
        TraceSubject under = told[^1].Subject;
        Assert.Equal((TraceSubjectKind.Body, Crate, (short)1, 0), (under.Kind, under.SetupId, under.Part, under.Polygon));
        Assert.Equal(Vector3.UnitZ, told[^1].Plane.Normal);
    }

    [Fact, Behaviour("trace.step-up.too-high", "design.md, decision 6; spec/04, 4.8 and 4.9")]
    public void A_post_and_a_ball_that_are_too_high_say_so_before_they_are_slid_along()
    {
        foreach (SetupAsset setup in (SetupAsset[])
        [
            new SetupAsset { Id = Post, Cylinders = [new CylSphere(new(1.2f, 0, 0), 0.5f, 5)] },
            new SetupAsset { Id = Ball, Spheres = [new Sphere(new(1.2f, 0, 0.6f), 0.6f)] },
        ])
        {
            TraceEntry[] told = Tell(setup, new(0.2f, 0.1f, 0), new(0.3f, 0, 0));
            int refused = Array.FindIndex(told, e => e is { Kind: TraceKind.Responded, Response: TransitionResponse.StepUp });
            Assert.Equal((false, TraceReason.TooHigh, setup.Id),
                (told[refused].Succeeded, told[refused].Reason, told[refused].Subject.SetupId));
            Assert.Contains(told[refused..], e => e.Response == TransitionResponse.Slide && e.Subject.SetupId == setup.Id);
            Assert.Equal(0, told.First(e => e.Kind == TraceKind.Hit && e.Subject.SetupId == setup.Id).Subject.Sphere);
        }
    }

    [Fact, Behaviour("trace.deferred-hit", "design.md, decision 6; spec/04, 4.6 row 5")]
    public void A_polygon_that_is_overlapped_but_not_run_into_is_told_as_deferred_and_the_answer_is_about_it()
    {
        // Along the face of the box, 0.1 m inside it: the movement does not run against it.
        TraceEntry[] told = Tell(CrateOf(5), new(0.62f, -1, 0), new(0, 0.2f, 0));
        TraceEntry hit = told.First(e => e is { Kind: TraceKind.Hit, Reason: TraceReason.Deferred });
        Assert.Equal(MinusX, hit.Subject.Polygon);
        TraceEntry slide = told.First(e => e.Response == TransitionResponse.Slide);
        Assert.Equal(hit.Subject, slide.Subject);
    }

    [Theory, Behaviour("trace.object.passed", "design.md, decision 6; spec/02, 4.21")]
    [InlineData(WeenieTraits.Present, PhysicsState.Ethereal | PhysicsState.IgnoreCollisions, MoverFlags.None,
        TraceReason.IgnoresCollisions)]
    [InlineData(WeenieTraits.Present, PhysicsState.Ethereal, MoverFlags.None, TraceReason.Ethereal)]
    [InlineData(WeenieTraits.Creature, PhysicsState.None, MoverFlags.IsViewer, TraceReason.IgnoredCreature)]
    [InlineData(WeenieTraits.Creature, PhysicsState.None, MoverFlags.IgnoreCreatures, TraceReason.IgnoredCreature)]
    [InlineData(WeenieTraits.Player, PhysicsState.None, MoverFlags.IsPlayer, TraceReason.PassedPlayer)]
    [InlineData(WeenieTraits.Present, PhysicsState.Missile, MoverFlags.None, TraceReason.PassedByMissile)]
    public void An_object_that_is_passed_says_why(WeenieTraits weenie, PhysicsState state, object flags, TraceReason reason)
    {
        WorldObject target = new(ObjectId, new SetupAsset { Id = Ball, Spheres = [new Sphere(new(1.2f, 0, 0.6f), 0.6f)] },
            state)
        { Weenie = weenie };
        TraceEntry[] told = Tell(target, new(0.2f, 0.1f, 0), new(0.3f, 0, 0), Standing | (MoverFlags)flags);
        Assert.Contains(
            told, e => e.Kind is TraceKind.Skipped or TraceKind.ObjectAnswered && e.Subject.ObjectId == ObjectId && e.Reason == reason);
    }

    [Fact, Behaviour("trace.object.too-far", "design.md, decision 6")]
    public void What_is_too_far_away_to_be_met_is_told_as_left_out()
    {
        TraceEntry[] ball = Tell(new SetupAsset { Id = Ball, Spheres = [new Sphere(Vector3.Zero, 0.6f)] }, new(-9, 0, 0), new(0.3f, 0, 0));
        Assert.Contains(ball, e => e is { Kind: TraceKind.Skipped, Reason: TraceReason.TooFar, Subject.SetupId: Ball });
        TraceEntry[] crate = Tell(CrateOf(5), new(-30, 0, 0), new(0.3f, 0, 0));
        Assert.Contains(crate, e => e is { Kind: TraceKind.Skipped, Reason: TraceReason.TooFar, Subject: { SetupId: Crate, Part: 1 } });
    }

    /// <summary>Two parts: one that stops nothing, and a box from x = 1 to 5.</summary>
    private static SetupAsset CrateOf(float height) => new SetupAsset
    {
        Id = Crate,
        Parts =
        [
            new SetupPart(new GfxObjAsset { Id = 0x01000076 }, Vector3.One),
            new SetupPart(new GfxObjAsset { Id = Box, Physics = Trees.Box(new(1, -5, 0), new(5, 5, height)) }, Vector3.One),
        ],
    }.With(0, [Frame.Identity, Frame.Identity]);

    private static TraceEntry[] Tell(SetupAsset setup, Vector3 start, Vector3 way) =>
        Tell(new WorldObject(ObjectId, setup, setup.HasPhysicsBsp ? PhysicsState.HasPhysicsBsp : PhysicsState.None), start, way, Standing);

    private static TraceEntry[] Tell(WorldObject target, Vector3 start, Vector3 way, MoverFlags flags)
    {
        StubWorld world = new(_ => StubWorld.Flat(0));
        target.SeatAt(new Position(StubWorld.CellId, Vector3.Zero), world.Cell);
        world.Cell.Obstacle = t => target.FindObjCollisions(t);
        Transition sweep = world.Sweep(start, way, flags);
        TraceBuffer trace = sweep.Trace = new TraceBuffer();
        sweep.FindValidPosition();
        return trace.Entries.ToArray();
    }
}
