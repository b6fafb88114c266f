using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>
/// Plays the animations of a body and hands out, each quantum, how it moved by itself. Velocity is handed out in whole animation frames:
/// 1/framerate seconds of it for each frame crossed.
/// </summary>
/// <remarks>Retail: CSequence and AnimSequenceNode; specification 01b, section 1.</remarks>
internal sealed class MotionSequence
{
    /// <summary>
    /// Most nodes entered in one update. Real tables enter a few; a framerate out of all proportion would otherwise keep an update busy for
    /// ever.
    /// </summary>
    private const int MaxAdvances = 4096;

    private Node[] nodes = new Node[8];
    private int firstCyclic = -1;
    private int current = -1;
    private Vector3 velocity;
    private Vector3 omega;

    /// <summary>Number of animations in the list.</summary>
    public int Count { get; private set; }

    /// <summary>There is an animation.</summary>
    public bool HasAnimations => Count > 0;

    /// <summary>m/s, body axes.</summary>
    public Vector3 Velocity => velocity;

    /// <summary>rad/s, body axes.</summary>
    public Vector3 Omega => omega;

    /// <summary>Place in the current animation, in frames.</summary>
    public double FrameNumber { get; private set; }

    /// <summary>The animation playing, or null.</summary>
    public AnimationAsset? CurrentAnimation => current < 0 ? null : nodes[current].Animation;

    /// <summary>Frames a second of the animation playing; 0 without one.</summary>
    public float CurrentFramerate => current < 0 ? 0f : nodes[current].Framerate;

    /// <summary>Animations that play once before the cycle.</summary>
    public int LinkCount => Math.Max(firstCyclic, 0);

    /// <summary>What was passed and not yet done, the oldest first.</summary>
    public RingQueue<MotionHook> Hooks { get; } = new();

    /// <summary>Where the animation playing has the parts now; empty without one.</summary>
    /// <remarks>Retail: CSequence::get_curr_animframe.</remarks>
    public ReadOnlySpan<Frame> PartFrames
    {
        get
        {
            if (current < 0) return [];
            AnimationAsset animation = nodes[current].Animation;
            return animation.PartFrames(Math.Clamp((int)Math.Floor(FrameNumber), 0, animation.FrameCount - 1));
        }
    }

    /// <summary>Sets both velocities to zero.</summary>
    public void ClearPhysics() => velocity = omega = Vector3.Zero;

    /// <summary>Replaces both velocities.</summary>
    public void SetPhysics(Vector3 velocity, Vector3 omega) => (this.velocity, this.omega) = (velocity, omega);

    /// <summary>Replaces both velocities by those of a motion at a speed.</summary>
    public void SetPhysics(MotionAsset data, float speed)
    {
        velocity = RetailMath.Scale(data.Velocity, speed);
        omega = RetailMath.Scale(data.Omega, speed);
    }

    /// <summary>Adds the velocities of a motion at a speed.</summary>
    public void CombinePhysics(MotionAsset data, float speed)
    {
        velocity += RetailMath.Scale(data.Velocity, speed);
        omega += RetailMath.Scale(data.Omega, speed);
    }

    /// <summary>Takes the velocities of a motion at a speed off again.</summary>
    public void SubtractPhysics(MotionAsset data, float speed)
    {
        velocity -= RetailMath.Scale(data.Velocity, speed);
        omega -= RetailMath.Scale(data.Omega, speed);
    }

    /// <summary>Appends an animation; it becomes the cycle, and what was the cycle before it a link.</summary>
    /// <remarks>Retail: CSequence::append_animation.</remarks>
    public void Append(in AnimationSpan animation, float speed)
    {
        if (Count == nodes.Length) Array.Resize(ref nodes, nodes.Length * 2);
        int last = animation.Animation.FrameCount - 1;
        int high = animation.HighFrame < 0 ? last : Math.Min(animation.HighFrame, last);
        int low = Math.Clamp(animation.LowFrame, 0, last);
        nodes[Count] = new Node(animation.Animation, low, Math.Max(low, high), (float)((double)animation.Framerate * speed));
        firstCyclic = Count++;
        if (current < 0) Enter(0, atEnd: false);
    }

    /// <summary>Becomes the same as another one.</summary>
    public void CopyFrom(MotionSequence other)
    {
        if (nodes.Length < other.Count) Array.Resize(ref nodes, other.nodes.Length);
        if (Count > other.Count) Array.Clear(nodes, other.Count, Count - other.Count);
        Array.Copy(other.nodes, nodes, other.Count);
        (Count, firstCyclic, current) = (other.Count, other.firstCyclic, other.current);
        (velocity, omega, FrameNumber) = (other.velocity, other.omega, other.FrameNumber);
        Hooks.CopyFrom(other.Hooks);
    }

    /// <summary>Removes everything.</summary>
    public void ClearAnimations()
    {
        Array.Clear(nodes, 0, Count);
        Count = 0;
        firstCyclic = current = -1;
        FrameNumber = 0;
    }

    /// <summary>Removes the part that repeats; when it was playing, the animation before it stands at its end.</summary>
    /// <remarks>Retail: CSequence::remove_cyclic_anims.</remarks>
    public void RemoveCyclic()
    {
        if (firstCyclic < 0) return;
        Array.Clear(nodes, firstCyclic, Count - firstCyclic);
        Count = firstCyclic;
        if (current >= Count)
        {
            if (Count > 0) Enter(Count - 1, atEnd: true);
            else (current, FrameNumber) = (-1, 0);
        }

        firstCyclic = Count - 1;
    }

    /// <summary>Drops up to <paramref name="count"/> animations before the cycle, the latest first.</summary>
    /// <remarks>Retail: CSequence::remove_link_animations.</remarks>
    public void RemoveLinks(int count)
    {
        for (; count > 0 && firstCyclic > 0; count--)
        {
            bool playing = current == firstCyclic - 1;
            RemoveAt(firstCyclic - 1);
            if (playing) Enter(firstCyclic, atEnd: false);
        }
    }

    /// <summary>Drops every animation before the cycle.</summary>
    /// <remarks>Retail: CSequence::remove_all_link_animations.</remarks>
    public void RemoveAllLinks() => RemoveLinks(int.MaxValue);

    /// <summary>Multiplies the framerate of the part that repeats.</summary>
    /// <remarks>Retail: CSequence::multiply_cyclic_animation_fr. A negative factor swaps the ends; no caller has one.</remarks>
    public void MultiplyCyclicFramerate(float factor)
    {
        for (int i = Math.Max(firstCyclic, 0); i < Count; i++)
        {
            ref Node node = ref nodes[i];
            if (factor < 0) (node.Low, node.High) = (node.High, node.Low);
            node.Framerate = (float)((double)node.Framerate * factor);
        }
    }

    /// <summary>Advances by a quantum and adds the motion to <paramref name="frame"/>.</summary>
    /// <param name="quantum">Seconds, 0 or more.</param>
    /// <param name="frame">Motion so far, body axes.</param>
    /// <remarks>Retail: CSequence::update.</remarks>
    public void Update(double quantum, ref Frame frame)
    {
        if (Count == 0)
        {
            ApplyPhysics(ref frame, quantum, quantum);
            return;
        }

        UpdateInternal(quantum, ref frame);
        while (current > 0 && firstCyclic > 0) RemoveAt(0);
    }

    private void UpdateInternal(double quantum, ref Frame frame)
    {
        for (int advances = 0; advances < MaxAdvances; advances++)
        {
            ref Node node = ref nodes[current];
            double rate = node.Framerate, frames = rate * quantum, timeLeft = 0;
            double last = Math.Floor(FrameNumber);
            FrameNumber += frames;
            if (frames == 0)
            {
                if (Math.Abs(quantum) > RetailMath.Epsilon) ApplyPhysics(ref frame, quantum, quantum);
                return;
            }

            bool advance = false, canTime = Math.Abs(rate) > RetailMath.Epsilon;
            if (frames > 0)
            {
                if (Math.Floor(FrameNumber) > node.High)
                {
                    double over = Math.Max(0, FrameNumber - node.High - 1);
                    timeLeft = canTime ? over / rate : 0;
                    FrameNumber = node.High;
                    advance = true;
                }

                for (; Math.Floor(FrameNumber) > last; last++)
                {
                    PassForward(node, (int)last, quantum, ref frame);
                    QueueHooks(node.Animation, (int)last, direction: 1);
                }
            }
            else
            {
                if (Math.Floor(FrameNumber) < node.Low)
                {
                    double over = Math.Min(0, FrameNumber - node.Low);
                    timeLeft = canTime ? over / rate : 0;
                    FrameNumber = node.Low;
                    advance = true;
                }

                for (; Math.Floor(FrameNumber) < last; last--)
                {
                    PassBackward(node, (int)last, quantum, ref frame);
                    QueueHooks(node.Animation, (int)last, direction: -1);
                }
            }

            if (!advance) return;
            if (firstCyclic != 0) Hooks.Enqueue(new MotionHook(MotionHookKind.AnimationDone, 0, 0, default));
            Advance(quantum, ref frame);
            quantum = timeLeft;
        }
    }

    /// <summary>Leaves the current animation for the next one, or for the beginning of the cycle.</summary>
    /// <remarks>Retail: CSequence::advance_to_next_animation. The first frame of the animation entered is handed out at once.</remarks>
    private void Advance(double quantum, ref Frame frame)
    {
        if (nodes[current].Framerate < 0) PassBackward(nodes[current], (int)FrameNumber, quantum, ref frame);
        Enter(current + 1 < Count ? current + 1 : firstCyclic, atEnd: false);
        if (nodes[current].Framerate > 0) PassForward(nodes[current], (int)FrameNumber, quantum, ref frame);
    }

    private void PassForward(in Node node, int index, double sign, ref Frame frame)
    {
        ReadOnlySpan<Frame> positions = node.Animation.PositionFrames;
        if ((uint)index < (uint)positions.Length) frame = Frame.Combine(frame, positions[index]);
        if (Math.Abs(node.Framerate) > RetailMath.Epsilon) ApplyPhysics(ref frame, 1.0 / node.Framerate, sign);
    }

    private void PassBackward(in Node node, int index, double sign, ref Frame frame)
    {
        ReadOnlySpan<Frame> positions = node.Animation.PositionFrames;
        if ((uint)index < (uint)positions.Length) frame = Frame.Subtract(frame, positions[index]);
        if (Math.Abs(node.Framerate) > RetailMath.Epsilon) ApplyPhysics(ref frame, 1.0 / node.Framerate, sign);
    }

    private void QueueHooks(AnimationAsset animation, int index, int direction)
    {
        foreach (ref readonly MotionHook hook in animation.Hooks)
        {
            if (hook.Frame == index && (hook.Direction == 0 || hook.Direction == direction)) Hooks.Enqueue(hook);
        }
    }

    /// <summary>Adds the velocities over a time. The origin moves in the axes the frame began with, not in its own.</summary>
    /// <remarks>Retail: CSequence::apply_physics.</remarks>
    private void ApplyPhysics(ref Frame frame, double time, double sign)
    {
        double t = sign >= 0 ? Math.Abs(time) : -Math.Abs(time);
        frame.Origin = RetailMath.AddScaled(frame.Origin, t, velocity);
        frame.RotateLocal(RetailMath.Scale(omega, t));
    }

    private void Enter(int index, bool atEnd)
    {
        current = index;
        ref Node node = ref nodes[index];
        bool high = node.Framerate >= 0 == atEnd;
        FrameNumber = high ? node.High + 1.0 - RetailMath.Epsilon : node.Low;
    }

    private void RemoveAt(int index)
    {
        Array.Copy(nodes, index + 1, nodes, index, Count - index - 1);
        nodes[--Count] = default;
        if (current > index) current--;
        if (firstCyclic > index) firstCyclic--;
    }

    private record struct Node(AnimationAsset Animation, int Low, int High, float Framerate);
}
