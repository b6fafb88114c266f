using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Motion;

/// <summary>Plays the default animation of one static object: its parts move, and what they stop moves with them.</summary>
internal sealed class AnimatedStatic : IHookTarget
{
    /// <summary>Frames a second of every default animation.</summary>
    private const float Framerate = 30f;

    private readonly StaticObject item;
    private readonly ICellWorld cells;
    private readonly MotionSequence sequence = new();
    private readonly ScaleTweens tweens = new();
    private Vector3 omega;
    private double updateTime;

    /// <summary>Begins at the first frame.</summary>
    /// <param name="item">A static with an animation, as it was made.</param>
    /// <param name="cells">The cells it stands in.</param>
    /// <param name="now">Seconds.</param>
    internal AnimatedStatic(StaticObject item, ICellWorld cells, double now)
    {
        this.item = item;
        this.cells = cells;
        updateTime = now;
        sequence.Append(new AnimationSpan(item.Animation!, 0, -1, Framerate), 1f);
    }

    /// <summary>The landblock it stands in, 0xXXYY0000.</summary>
    internal uint BlockId => CellIds.BlockOf(item.Position.CellId);

    /// <summary>Its place among all statics.</summary>
    internal ulong Order => item.Order;

    /// <summary>Brings the parts to <paramref name="now"/>. Less than 1/30 s waits for the next call, more than 2 s are lost.</summary>
    /// <remarks>
    /// Retail: CPhysicsObj::animate_static_object @0x00513DF0. The object turns by omega itself, not by omega times the time.
    /// </remarks>
    internal void Animate(double now)
    {
        double elapsed = now - updateTime;
        if (elapsed > RetailMath.Epsilon && elapsed < PhysicsBody.MinQuantum) return;
        updateTime = now;
        if (!(elapsed > RetailMath.Epsilon) || elapsed > PhysicsBody.HugeQuantum) return;
        Frame unused = Frame.Identity;
        sequence.Update((float)elapsed, ref unused);
        item.Turn(omega);
        item.Pose(sequence.PartFrames);
        item.Scale = tweens.Advance(item.Scale, now);
        while (sequence.Hooks.Count > 0) sequence.Hooks.Dequeue().ActOn(this);
    }

    /// <summary>Adds what is state to a hash.</summary>
    internal void AddTo(ref StateHash hash)
    {
        hash.Add(Order);
        hash.Add(BitConverter.DoubleToUInt64Bits(updateTime));
        hash.Add(BitConverter.DoubleToUInt64Bits(sequence.FrameNumber));
        hash.Add((ulong)item.State);
        hash.Add(item.Scale);
        hash.Add(omega);
        hash.Add(item.Position.Frame.Rotation);
        for (int i = 0; i < item.PlacedPartCount; i++) hash.Add(item.PartFrame(i));
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CPhysicsObj::set_ethereal @0x00511C40. A static has no quantum in which it would try again.</remarks>
    public bool SetEthereal(bool on)
    {
        item.State &= ~PhysicsState.Ethereal;
        if (!on && !cells.AnyOverlaps(item)) return true;
        item.State |= PhysicsState.Ethereal;
        return on;
    }

    /// <inheritdoc/>
    public void SetOmega(Vector3 value) => omega = value;

    /// <inheritdoc/>
    public void SetScale(float value, float seconds) => item.Scale = tweens.Set(item.Scale, value, seconds, updateTime);
}
