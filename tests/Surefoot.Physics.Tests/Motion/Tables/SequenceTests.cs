using System.Numerics;
using CsCheck;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class SequenceTests
{
    private const float Tick = 1f / 30;
    private static readonly AnimationAsset TenFrames = new(1, 10);

    private static Frame Advance(MotionSequence sequence, double quantum)
    {
        Frame frame = Frame.Identity;
        sequence.Update(quantum, ref frame);
        return frame;
    }

    private static MotionSequence Cycle(Vector3 velocity, float speed, Vector3 omega = default, AnimationAsset? animation = null)
    {
        MotionSequence sequence = new();
        MotionAsset data = new([new AnimationSpan(animation ?? TenFrames, 0, -1, 30f)], velocity, omega);
        sequence.SetPhysics(data, speed);
        sequence.Append(data.Animations[0], speed);
        return sequence;
    }

    [Fact]
    [Behaviour("motion.sequence.velocity-in-whole-frames", "spec/01b, 1 and 4; CSequence::update_internal")]
    public void Walking_hands_out_a_tenth_of_a_metre_for_each_frame_crossed()
    {
        MotionSequence sequence = Cycle(new Vector3(0, 3.12f, 0), 1f);
        Assert.Equal(0f, Advance(sequence, 0.02).Origin.Y);
        Assert.Equal((float)(3.12f / 30.0), Advance(sequence, 0.02).Origin.Y);
        Assert.Equal(0f, Advance(sequence, 0.02).Origin.Y);
    }

    [Fact]
    [Behaviour("motion.sequence.runner-crosses-two-or-three-frames", "spec/01b, 4")]
    public void Running_crosses_two_or_three_frames_a_quantum()
    {
        MotionSequence sequence = Cycle(new Vector3(0, 4f, 0), 2.6500001f);
        float frame = 4f / 30;
        double total = 0;
        HashSet<int> counts = [];
        for (int i = 0; i < 300; i++)
        {
            float moved = Advance(sequence, Tick).Origin.Y;
            int frames = (int)MathF.Round(moved / frame);
            Assert.Equal(frames * frame, moved, 1e-6f);
            counts.Add(frames);
            total += moved;
        }

        Assert.Equal([2, 3], counts.Order());
        Assert.Equal(106.0, total, 0.15);
    }

    [Fact]
    [Behaviour("motion.sequence.backwards-frames", "spec/01b, 1.4 and 4")]
    public void Walking_backwards_hands_out_the_same_movement_backwards()
    {
        MotionSequence sequence = Cycle(new Vector3(0, 3.12f, 0), -0.649999976f);
        Assert.Equal(-19.5f, sequence.CurrentFramerate, 1e-5f);
        Assert.Equal(9.9998, sequence.FrameNumber, 1e-6);
        double total = 0;
        for (int i = 0; i < 300; i++)
        {
            float moved = Advance(sequence, Tick).Origin.Y;
            Assert.True(moved is 0f || Math.Abs(moved + 0.104f) < 1e-6f, $"{moved}");
            total += moved;
        }

        Assert.Equal(-20.28, total, 0.11);
    }

    [Fact]
    [Behaviour("motion.sequence.turn-in-whole-frames", "spec/01b, 4")]
    public void Turning_turns_by_a_twentieth_of_a_radian_a_frame()
    {
        MotionSequence sequence = Cycle(Vector3.Zero, 1.5f, new Vector3(0, 0, -1.5f));
        Frame frame = Advance(sequence, 1.01 / 45);
        Assert.Equal(-0.05, 2 * Math.Asin(frame.Rotation.Z), 1e-6);
        Assert.Equal(0f, Advance(sequence, 0.5 / 45).Rotation.Z);
    }

    [Fact]
    [Behaviour("motion.sequence.turning-does-not-bend-the-way", "spec/01b, 1, apply_physics: the frame's rotation is not applied to it")]
    public void Within_one_quantum_a_turn_does_not_bend_the_way()
    {
        MotionSequence sequence = Cycle(new Vector3(0, 3, 0), 1f, new Vector3(0, 0, -1.5f));
        Frame frame = Advance(sequence, 8.5 / 30);
        Assert.Equal((0f, 0f), (frame.Origin.X, frame.Origin.Z));
        Assert.Equal(0.8f, frame.Origin.Y, 1e-6f);
        Assert.Equal(-0.4, 2 * Math.Asin(frame.Rotation.Z), 1e-5);
    }

    [Fact]
    [Behaviour("motion.sequence.smooth-without-animations", "spec/01b, 1 and 4")]
    public void Without_animations_velocity_is_handed_out_continuously()
    {
        MotionSequence sequence = new();
        sequence.SetPhysics(new MotionAsset([], new Vector3(0, 4f, 0)), 2.5f);
        Assert.Equal((float)(Tick * 10.0), Advance(sequence, Tick).Origin.Y);
        Assert.Equal((float)(0.001f * 10.0), Advance(sequence, 0.001f).Origin.Y);
    }

    [Fact]
    [Behaviour("motion.sequence.framerate-zero-moves-by-time", "spec/01b, 1.2")]
    public void An_animation_that_stands_still_moves_by_time()
    {
        MotionSequence sequence = new();
        MotionAsset data = new([new AnimationSpan(TenFrames, 0, -1, 0f)], new Vector3(0, 2f, 0));
        sequence.SetPhysics(data, 1f);
        sequence.Append(data.Animations[0], 1f);
        Assert.Equal((float)(Tick * 2.0), Advance(sequence, Tick).Origin.Y);
        Assert.Equal(0f, Advance(sequence, 0.0001).Origin.Y);
    }

    private static int TakeHooks(MotionSequence sequence)
    {
        int count = sequence.Hooks.Count;
        sequence.Hooks.Clear();
        return count;
    }

    [Fact]
    [Behaviour("motion.sequence.links-once-then-cycle", "spec/01b, 1; CSequence::append_animation")]
    public void Links_play_once_and_the_last_animation_repeats()
    {
        MotionSequence sequence = new();
        AnimationAsset link = new(7, 3), cycle = new(8, 4);
        sequence.Append(new AnimationSpan(link, 0, -1, 10f), 1f);
        sequence.Append(new AnimationSpan(link, 0, -1, 10f), 1f);
        sequence.Append(new AnimationSpan(cycle, 0, -1, 10f), 1f);
        Assert.Equal(2, sequence.LinkCount);
        Assert.Same(link, sequence.CurrentAnimation);

        Advance(sequence, 0.35);
        Assert.Equal(1, TakeHooks(sequence));
        Assert.Equal(2, sequence.Count);
        Advance(sequence, 0.3);
        Assert.Equal(1, TakeHooks(sequence));
        Assert.Equal(1, sequence.Count);
        Assert.Same(cycle, sequence.CurrentAnimation);
        Advance(sequence, 5.0);
        Assert.Equal(0, TakeHooks(sequence));
        Assert.Same(cycle, sequence.CurrentAnimation);
    }

    [Fact]
    [Behaviour("motion.sequence.loop-hands-out-the-first-frame-at-once", "spec/01b, 1, advance_to_next_animation")]
    public void A_loop_hands_out_every_frame_once()
    {
        Vector3[] movements = [new(1, 0, 0), new(0, 2, 0), new(0, 0, 4)];
        AnimationAsset animation = new(5, 3, movements.Select(s => new Frame(s, Quaternion.Identity)).ToArray());
        MotionSequence sequence = Cycle(Vector3.Zero, 1f, animation: animation);

        // Two frames are passed in 2/30 s; the third is held until the loop, which hands out the first frame of the next round.
        Assert.Equal(new Vector3(1, 2, 0), Advance(sequence, 2.5 / 30).Origin);
        Assert.Equal(new Vector3(1, 0, 0), Advance(sequence, 1.0 / 30).Origin);
        Assert.Equal(new Vector3(1, 2, 0), Advance(sequence, 2.0 / 30).Origin);
    }

    [Fact]
    [Behaviour("motion.sequence.position-frames-and-velocity-together", "spec/01b, 1.3 and 5")]
    public void Position_frames_and_velocity_add()
    {
        Frame[] frames = [new(new Vector3(0, 1, 0), Quaternion.Identity), new(new Vector3(0, 1, 0), Quaternion.Identity)];
        MotionSequence sequence = Cycle(new Vector3(0, 3, 0), 1f, animation: new AnimationAsset(5, 2, frames));
        Assert.Equal(1.1f, Advance(sequence, 1.5 / 30).Origin.Y);
    }

    [Fact]
    [Behaviour("motion.sequence.frames-clamped-to-the-animation", "spec/01b, 1, node")]
    public void Frames_beyond_the_animation_are_clamped()
    {
        MotionSequence sequence = new();
        sequence.Append(new AnimationSpan(TenFrames, 20, 30, -30f), 1f);
        Assert.Equal(10.0 - RetailMath.Epsilon, sequence.FrameNumber, 1e-9);
        MotionSequence other = new();
        other.Append(new AnimationSpan(TenFrames, 5, 2, -30f), 1f);
        Assert.Equal(6.0 - RetailMath.Epsilon, other.FrameNumber, 1e-9);
    }

    [Fact]
    [Behaviour("motion.sequence.removing-the-cycle-stands-at-the-end-before-it", "spec/01b, 1, remove_cyclic_anims")]
    public void Removing_the_cycle_leaves_the_link_at_its_end()
    {
        MotionSequence sequence = new();
        sequence.Append(new AnimationSpan(TenFrames, 0, -1, 30f), 1f);
        sequence.Append(new AnimationSpan(TenFrames, 0, 4, 30f), 1f);
        sequence.RemoveCyclic();
        Assert.Equal(1, sequence.Count);
        Assert.Equal(0.0, sequence.FrameNumber);
        sequence.RemoveCyclic();
        Assert.Equal(0, sequence.Count);
        Assert.Null(sequence.CurrentAnimation);
    }

    [Fact]
    [Behaviour("motion.sequence.distance-is-velocity-times-time", "spec/01b, 1, consequence")]
    public void Over_time_the_distance_is_velocity_times_time() =>
        Gen.Select(Gen.Float[0.2f, 4.5f], Gen.Float[0.5f, 5f], Gen.Double[0.001, 0.2].List[50, 200],
            Gen.Int[1, 40]).Sample((speed, velocity, quanta, frames) =>
        {
            MotionSequence sequence = Cycle(new Vector3(0, velocity, 0), speed, animation: new AnimationAsset(1, frames));
            double total = 0, time = 0;
            foreach (double quantum in quanta)
            {
                total += Advance(sequence, quantum).Origin.Y;
                time += quantum;
            }

            // One frame may be outstanding, and the last frame of a round is held until the next begins.
            double frame = velocity / 30;
            return Math.Abs(total - (velocity * speed * time)) <= (2 * frame) + 1e-3;
        });

    [Fact]
    [Behaviour("motion.sequence.absurd-framerate-ends", "spec/01b, 1")]
    public void A_framerate_out_of_proportion_does_not_hang()
    {
        MotionSequence sequence = new();
        sequence.Append(new AnimationSpan(new AnimationAsset(1, 1), 0, -1, 1e30f), 1f);
        Advance(sequence, 0.2);
        Assert.True(sequence.HasAnimations);
    }
}
