using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Bodies;

/// <content>Where the parts of the body are, and how large it is.</content>
public sealed partial class PhysicsBody
{
    /// <summary>Frames of the parts in the body's frame; only bodies whose parts stop others have them.</summary>
    private readonly Frame[] partPose;
    private int posedParts;
    private List<ScaleTween>? tweens;

    /// <summary>Simulated time of the quantum whose hooks are being done.</summary>
    private double? quantumTime;

    private readonly record struct ScaleTween(double Created, double Duration, float Start, float End);

    /// <inheritdoc/>
    /// <remarks>A part that no frame was ever given for is nowhere.</remarks>
    internal override ReadOnlySpan<Frame> PartPose => partPose.Length == 0 ? base.PartPose : partPose.AsSpan(0, posedParts);

    /// <summary>Scales the body, its shapes and its steps.</summary>
    /// <param name="value">Uniform scale, more than 0.</param>
    /// <param name="seconds">How long it takes to get there, in the body's simulated time; less than 0.0002 is at once.</param>
    /// <exception cref="ArgumentException">The scale is not a positive number, or the time is none.</exception>
    /// <remarks>Retail: CPhysicsObj::SetScale, SetScaleStatic, FPHook::Execute @0x0051BAA0. The cells the body is listed in follow when it moves.</remarks>
    public void SetScale(float value, float seconds = 0f)
    {
        if (!(value > 0) || !float.IsFinite(value)) throw new ArgumentException("The scale is not a positive number.", nameof(value));
        if (!float.IsFinite(seconds)) throw new ArgumentException("The time is not finite.", nameof(seconds));
        if (seconds < RetailMath.Epsilon) Scale = value;
        else (tweens ??= []).Add(new ScaleTween(quantumTime ?? updateTime, seconds, Scale, value));
    }

    /// <summary>The parts follow the animation; those that it has no frame for stay. Emitters of particles leave theirs alone.</summary>
    /// <remarks>Retail: CPartArray::UpdateParts; specification 06, 3, and 02, 4.17 set_frame.</remarks>
    private void UpdateParts()
    {
        if (partPose.Length == 0 || State.Has(PhysicsState.ParticleEmitter)) return;
        ReadOnlySpan<Frame> pose = Movement is null ? [] : Movement.PartFrames;
        if (pose.IsEmpty) pose = Setup!.Placement(0);
        int count = Math.Min(pose.Length, partPose.Length);
        pose[..count].CopyTo(partPose);
        posedParts = Math.Max(posedParts, count);
    }

    /// <summary>Carries on what takes time, the newest first, then does what the animations passed.</summary>
    /// <remarks>Retail: CPhysicsObj::process_hooks @0x00511550.</remarks>
    private void ProcessHooks(double simulatedTime)
    {
        quantumTime = simulatedTime;
        for (int i = (tweens?.Count ?? 0) - 1; i >= 0; i--)
        {
            ScaleTween tween = tweens![i];
            double t = simulatedTime - tween.Created, u = t <= 0 ? 0 : t < tween.Duration ? t / tween.Duration : 1;
            Scale = (float)(tween.Start + (((double)tween.End - tween.Start) * u));
            if (u >= 1) tweens.RemoveAt(i);
        }

        Movement?.ProcessHooks(this);
        quantumTime = null;
    }
}
