using System.Numerics;
using CsCheck;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>What animations pass is told once and in order: specification 01b, 1, and 02, 4.18.</summary>
public class HookOrderTests
{
    private const MotionCommand Style = MotionCommand.NonCombat;

    [Fact]
    [Behaviour("motion.hooks.once-and-in-order", "spec/01b, 1, step 3: hooks of each whole frame passed; the last of a round is not")]
    public void Whatever_the_quanta_each_frame_s_hook_is_passed_once_a_round_and_in_order()
    {
        Gen.Select(Gen.Int[3, 9], Gen.Int[1, 4], Gen.Float[0.004f, 0.2f].List[1, 40]).Sample(
            (frames, speed, quanta) =>
            {
                MotionSequence sequence = Playing(Numbered(1, frames), speed);
                foreach (float quantum in quanta) Advance(sequence, quantum);
                int[] passed = [.. Drain(sequence).Select(hook => hook.Frame)];
                for (int i = 0; i < passed.Length; i++) Assert.Equal(i % (frames - 1), passed[i]);
                // A round is as many frames long as there are frames, and the last one's hook is not passed.
                double crossed = quanta.Sum(quantum => quantum * 30.0 * speed), rounds = Math.Floor(crossed / frames);
                Assert.InRange(passed.Length, (rounds * (frames - 1)) + Math.Min(crossed % frames, frames - 1) - 1.01,
                    (rounds * (frames - 1)) + (crossed % frames) + 0.01);
            },
            iter: 500);
    }

    [Fact]
    [Behaviour("motion.hooks.backwards", "spec/01b, 1, step 4: the mirror image")]
    public void Backwards_hooks_are_passed_from_the_last_to_the_first_but_one()
    {
        MotionSequence sequence = Playing(Numbered(1, 5), -1);
        for (int i = 0; i < 10; i++) Advance(sequence, 1f / 30);
        Assert.Equal([4, 3, 2, 1, 4, 3, 2, 1], Drain(sequence).Select(hook => hook.Frame).Take(8));
    }

    [Fact]
    [Behaviour("motion.hooks.direction", "spec/01b, 1, steps 3 and 4: direction forward, backward; 07, 7.8")]
    public void A_hook_of_one_direction_is_passed_in_that_direction_only()
    {
        AnimationAsset animation = new(1, 3)
        {
            Hooks =
            [
                Hook(0, 0), new MotionHook(MotionHookKind.Other, 1, 1, default) { Index = 1 },
                new MotionHook(MotionHookKind.Other, 1, -1, default) { Index = 2 }, Hook(1, 3),
            ],
        };
        MotionSequence forward = Playing(animation, 1), backward = Playing(animation, -1);
        Advance(forward, 2.5f / 30);
        Advance(backward, 2.5f / 30);
        Assert.Equal([0, 1, 3], Drain(forward).Select(hook => hook.Index));
        Assert.Equal([2, 3], Drain(backward).Select(hook => hook.Index));
    }

    [Fact]
    [Behaviour("motion.hooks.end-of-a-link-in-its-place", "spec/01b, 1, step 5: an end is queued after the hooks passed before it")]
    public void The_end_of_a_link_comes_between_its_own_hooks_and_those_of_the_cycle()
    {
        MotionSequence sequence = Playing(Numbered(1, 3), 1);
        sequence.Append(new AnimationSpan(Numbered(2, 4), 0, -1, 30f), 1);
        Advance(sequence, 5.5f / 30);
        Assert.Equal(
            [(1u, 0), (1u, 1), (0u, 0), (2u, 0), (2u, 1)],
            Drain(sequence).Select(hook => (hook.AnimationId, hook.Frame)));
    }

    [Fact]
    [Behaviour("body.hooks.told", "spec/01b, 1; spec/02, 4.18: in order, then the list is cleared")]
    public void A_body_tells_each_hook_once_and_what_it_does_is_done_by_then()
    {
        AnimationAsset animation = new(0x03000007, 6)
        {
            Hooks =
            [
                Hook(0, 0), new MotionHook(MotionHookKind.Scale, 1, 0, new Vector3(2, 0, 0)) { AnimationId = 0x03000007 }, Hook(1, 1),
                Hook(3, 0),
            ],
        };
        PhysicsEngine engine = new(new StubWorld(_ => null));
        PhysicsBody body = engine.CreateBody(1, StubWorld.Setup(new Sphere(Vector3.Zero, 0.5f)), PhysicsState.ReportCollisions);
        body.Seat(
            new BodySeat(
                new Position(StubWorld.CellId, new Vector3(12, 12, 5)), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
        MotionTableAsset table = new MotionTableBuilder(1).Style(Style, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, new MotionAsset([new AnimationSpan(animation, 0, -1, 30f)])).Build();
        SteeredPhysicsBody.Of(body).Attach(new MovementManager(body, table, weenie: null));
        Witness witness = new();
        body.HookListener = witness;
        body.AdvanceQuantum(4.5f / 30);
        Assert.Equal([(0, 0, 1f), (1, 0, 2f), (1, 1, 2f), (3, 0, 2f)], witness.Told);
        body.AdvanceQuantum(0.1f / 30);
        Assert.Equal(4, witness.Told.Count);

        // Nobody who is hidden passes anything.
        body.SetState(body.State | PhysicsState.Hidden);
        body.AdvanceQuantum(BodyFixture.Tick * 3);
        Assert.Equal(4, witness.Told.Count);
    }

    private static AnimationAsset Numbered(uint id, int frames) => new(id, frames)
    {
        Hooks = [.. Enumerable.Range(0, frames).Select(frame => Hook(frame, 0) with { AnimationId = id })],
    };

    private static MotionHook Hook(int frame, int index) =>
        new(MotionHookKind.Other, frame, 0, default) { AnimationId = 0x03000007, Index = index };

    private static MotionSequence Playing(AnimationAsset animation, float speed)
    {
        MotionSequence sequence = new();
        sequence.Append(new AnimationSpan(animation, 0, -1, 30f), speed);
        return sequence;
    }

    private static void Advance(MotionSequence sequence, float quantum)
    {
        Frame frame = Frame.Identity;
        sequence.Update(quantum, ref frame);
    }

    private static List<MotionHook> Drain(MotionSequence sequence)
    {
        List<MotionHook> all = [];
        while (sequence.Hooks.Count > 0) all.Add(sequence.Hooks.Dequeue());
        return all;
    }

    private sealed class Witness : IHookListener
    {
        public List<(int Frame, int Index, float Scale)> Told { get; } = [];

        public void OnHook(PhysicsBody body, in PassedHook hook)
        {
            Assert.Equal(0x03000007u, hook.AnimationId);
            Told.Add((hook.Frame, hook.Index, body.Scale));
        }
    }
}
