using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.Transitions.Obstacles;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>
/// A door whose leaf its motion table swings: specification 06, 3 (the pose is the sequence's frame), and 02, 4.17 (set_frame) and 4.18
/// (hooks).
/// </summary>
public class AnimatedPartTests
{
    private const MotionCommand On = (MotionCommand)0x4000000B;

    /// <summary>A cube as the one part: put down at the origin, animated from x = 2 to x = 3 and x = 4.</summary>
    private static readonly SetupAsset Leaf = new SetupAsset
    {
        Parts = [new SetupPart(new GfxObjAsset { Id = 0x01000001, Physics = Trees.UnitCube() }, Vector3.One)],
    }.With(0, [Frame.Identity]);

    private static readonly Vector3 Hinge = new(12, 12, 5);

    [Fact, Behaviour("object.parts.follow-the-animation", "spec/06, 3, CPartArray::UpdateParts; spec/02, 4.17 set_frame")]
    public void A_part_is_hit_where_the_animation_has_it_now()
    {
        (PhysicsBody door, MovementManager movement) = Door(withParts: true);
        Assert.Equal(0f, LeafAt(door));

        // Standing still it is in the frame of its only cycle, from the next quantum on.
        door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(2f, LeafAt(door));
        movement.Interpreter.DoInterpretedMotion(On, new MovementParameters());
        Assert.Equal(2f, LeafAt(door));

        // 30 frames a second: one frame each thirtieth, and the last one is held by a framerate of 0.
        door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(3f, LeafAt(door));
        for (int i = 0; i < 10; i++) door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(4f, LeafAt(door));
    }

    [Fact, Behaviour("object.parts.scaled-pose", "spec/06, 3 and 8: setting the scale moves no part; parts move when the frame is set")]
    public void The_pose_of_a_larger_object_is_larger_from_its_next_quantum_on()
    {
        (PhysicsBody door, _) = Door(withParts: true);
        door.AdvanceQuantum(BodyFixture.Tick);
        door.SetScale(2);
        // The leaf itself is twice as large at once, a metre to each side of x = 2.
        Assert.True(Hits(door, Hinge + new Vector3(2.95f, 0, 0)));
        Assert.False(Hits(door, Hinge + new Vector3(4, 0, 0)));

        door.AdvanceQuantum(BodyFixture.Tick);
        Assert.True(Hits(door, Hinge + new Vector3(4, 0, 0)));
        Assert.True(Hits(door, Hinge + new Vector3(4.95f, 0, 0)));
        Assert.False(Hits(door, Hinge + new Vector3(2, 0, 0)));
    }

    [Fact, Behaviour("object.parts.no-pose-loaded", "spec/06, 3")]
    public void Without_part_frames_the_parts_stay_where_they_were_put_down()
    {
        (PhysicsBody door, _) = Door(withParts: false);
        door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0f, LeafAt(door));
    }

    [Fact, Behaviour("object.parts.hidden-are-not-animated", "spec/02, 4.5, step 2")]
    public void A_hidden_door_does_not_swing()
    {
        AnimationAsset swing = new(2, 2, default, [At(2), At(3)]);
        PhysicsBody door = Body(Table(swing, swing), out _);
        door.SetHidden(true);
        for (int i = 0; i < 3; i++)
        {
            door.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(2f, LeafAt(door));
        }

        door.SetHidden(false);
        door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(3f, LeafAt(door));
    }

    [Fact, Behaviour("object.parts.quanta-without-allocation", "design, decision 4")]
    public void A_swinging_door_allocates_nothing()
    {
        (PhysicsBody door, _) = Door(withParts: true);
        for (int i = 0; i < 100; i++) door.AdvanceQuantum(BodyFixture.Tick);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++) door.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact, Behaviour("body.hooks.animation", "spec/02, 4.18 process_hooks; spec/01b, 1, step 3")]
    public void An_animation_makes_its_body_ethereal_spins_it_and_scales_it_as_it_passes_the_frame()
    {
        AnimationAsset animation = new(1, 4)
        {
            Hooks =
            [
                new MotionHook(MotionHookKind.Ethereal, 0, 1, Vector3.UnitX),
                new MotionHook(MotionHookKind.Omega, 1, 0, new Vector3(0, 0, 3)),
                new MotionHook(MotionHookKind.Scale, 1, -1, new Vector3(9, 0, 0)),
                new MotionHook(MotionHookKind.Scale, 2, 1, new Vector3(2, 0, 0)),
            ],
        };
        PhysicsBody body = Body(Table(animation, animation), out _);
        body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal((true, Vector3.Zero, 1f), (Ethereal(body), body.Omega, body.Scale));
        body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal((true, new Vector3(0, 0, 3), 1f), (Ethereal(body), body.Omega, body.Scale));
        body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal((true, new Vector3(0, 0, 3), 2f), (Ethereal(body), body.Omega, body.Scale));
    }

    [Fact, Behaviour("body.hooks.scale-takes-its-time", "spec/02, 4.18, tween")]
    public void A_scale_grows_by_the_body_s_own_time_and_ends_exactly()
    {
        BodyFixture f = new();
        f.Seat(new Vector3(12, 12, 100), Vector3.Zero, TransientState.None);
        f.Body.SetScale(3f, seconds: 0.5f);
        Assert.Equal(1f, f.Body.Scale);
        float[] expected = [1.5f, 2f, 2.5f, 3f, 3f];
        foreach (float scale in expected)
        {
            f.Body.AdvanceQuantum(0.125f);
            Assert.Equal(scale, f.Body.Scale);
        }

        f.Body.SetScale(0.5f, seconds: 0.0001f);
        Assert.Equal(0.5f, f.Body.Scale);
        Assert.Equal((0.3f, 0.3f), (f.Body.StepUpHeight, f.Body.StepDownHeight));
        Assert.Throws<ArgumentException>(() => f.Body.SetScale(0));
        Assert.Throws<ArgumentException>(() => f.Body.SetScale(float.NaN));
        Assert.Throws<ArgumentException>(() => f.Body.SetScale(1, float.NaN));
    }

    private static bool Ethereal(PhysicsBody body) => body.State.HasFlag(PhysicsState.Ethereal);

    private static Frame At(float x) => new(new Vector3(x, 0, 0), Quaternion.Identity);

    private static (PhysicsBody Door, MovementManager Movement) Door(bool withParts)
    {
        AnimationAsset shut = new(1, 1, default, withParts ? [At(2)] : []), swing = new(2, 2, default, withParts ? [At(2), At(3)] : []),
            open = new(3, 1, default, withParts ? [At(4)] : []);
        PhysicsBody door = Body(Table(shut, open, swing), out MovementManager movement);
        return (door, movement);
    }

    private static MotionTableAsset Table(AnimationAsset ready, AnimationAsset on, AnimationAsset? link = null)
    {
        MotionAsset Data(AnimationAsset animation) => new([new AnimationSpan(animation, 0, -1, animation.FrameCount > 1 ? 30f : 0f)]);
        MotionTableBuilder table = new MotionTableBuilder(1)
            .Style(MotionCommand.NonCombat, MotionCommand.Ready)
            .Cycle(MotionCommand.NonCombat, MotionCommand.Ready, Data(ready))
            .Cycle(MotionCommand.NonCombat, On, Data(on));
        return (link is null ? table : table.Link(MotionCommand.NonCombat, MotionCommand.Ready, On, Data(link))).Build();
    }

    private static PhysicsBody Body(MotionTableAsset table, out MovementManager movement)
    {
        PhysicsEngine engine = new(new StubWorld(_ => null));
        PhysicsBody body = engine.CreateBody(1, Leaf, PhysicsState.ReportCollisions, WeenieTraits.Present);
        body.Seat(new BodySeat(new Position(StubWorld.CellId, Hinge), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
        movement = new MovementManager(body, table, weenie: null);
        SteeredPhysicsBody.Of(body).Attach(movement);
        return body;
    }

    /// <summary>The whole number of metres along x at which the leaf stops a small ball.</summary>
    private static float LeafAt(PhysicsBody door)
    {
        float[] hits = [.. Enumerable.Range(0, 6).Select(x => (float)x).Where(x => Hits(door, Hinge + new Vector3(x, 0, 0)))];
        return Assert.Single(hits);
    }

    private static bool Hits(PhysicsBody door, Vector3 center)
    {
        Mover mover = new Mover(MoverFlags.None, center, center, 0.1f).With(p => p.InsertType = InsertType.Placement);
        return door.FindObjCollisions(mover.Transition) != TransitionState.OK;
    }
}
