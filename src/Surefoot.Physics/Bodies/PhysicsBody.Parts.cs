using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Where the parts of the body are, and how large it is.</content>
public sealed partial class PhysicsBody
{
    private readonly ScaleTweens tweens = new();
    private uint placement = SetupAsset.Resting;

    /// <summary>Simulated time of the quantum whose hooks are being done.</summary>
    private double? quantumTime;

    /// <inheritdoc/>
    private protected override ReadOnlySpan<Frame> StillPose =>
        Setup is null ? default : placement == SetupAsset.Resting ? Setup.RestPose : Setup.Placement(placement);

    /// <summary>
    /// Puts the body's parts down in another way than <see cref="SetupAsset.Resting"/>, as a server's description of a body without
    /// movement tells. A way that its setup lacks is listed in <see cref="PhysicsWorld.LeftOut"/> and is the default way, 0; one that lacks
    /// that too leaves the parts where they are. An animation goes before it.
    /// </summary>
    /// <param name="value">Number of the placement: 0 by default, 0x67 on a hook and so on.</param>
    /// <remarks>Retail: CPhysicsObj::SetPlacementFrame, CPartArray::SetPlacementFrame; specification 06, 3.</remarks>
    public void SetPlacement(uint value)
    {
        // Told once: a server says the same way with each of its positions.
        if (value != placement && Setup is not null && !Setup.HasPlacement(value))
            population.Cells.LeftOut.Add(
                new LeftOutItem(LeftOutKind.Placement, Setup.Id, $"the setup has no placement 0x{value:X}") { FirstIn = Id });
        placement = value;
        UpdateParts();
    }

    /// <summary>
    /// Scales the body, its shapes and its steps. The places of its parts follow when its frame is set next, the cells it is listed in when
    /// it moves.
    /// </summary>
    /// <param name="value">Uniform scale, more than 0.</param>
    /// <param name="seconds">How long it takes to get there, in the body's simulated time; less than 0.0002 is at once.</param>
    /// <exception cref="ArgumentException">The scale is not a positive number, or the time is not finite.</exception>
    /// <remarks>Retail: CPhysicsObj::SetScale, SetScaleStatic.</remarks>
    public void SetScale(float value, float seconds = 0f)
    {
        if (!(value > 0) || !float.IsFinite(value)) throw new ArgumentException("The scale is not a positive number.", nameof(value));
        if (!float.IsFinite(seconds)) throw new ArgumentException("The time is not finite.", nameof(seconds));
        Scale = tweens.Set(Scale, value, seconds, quantumTime ?? updateTime);
    }

    /// <inheritdoc/>
    void IHookTarget.OnPassed(in PassedHook hook) => HookListener?.OnHook(this, hook);

    /// <summary>Somebody asks where the parts are: a tree of theirs, or what they hold.</summary>
    private bool KeepsParts => State.Has(PhysicsState.HasPhysicsBsp) || HeldCount > 0;

    /// <summary>The parts follow the animation, or lie as they were put down. Emitters of particles leave theirs alone.</summary>
    /// <remarks>Retail: specification 02, 4.17, set_frame.</remarks>
    private void UpdateParts()
    {
        if (Setup is null || !KeepsParts || State.Has(PhysicsState.ParticleEmitter)) return;
        ReadOnlySpan<Frame> pose = driver.PartFrames;
        PlaceParts(pose.IsEmpty ? StillPose : pose, Scale);
    }

    /// <summary>Carries on what takes time, then does what the animations passed.</summary>
    /// <remarks>Retail: CPhysicsObj::process_hooks @0x00511550.</remarks>
    private void ProcessHooks(double simulatedTime)
    {
        quantumTime = simulatedTime;
        Scale = tweens.Advance(Scale, simulatedTime);
        driver.ProcessHooks();
        quantumTime = null;
    }
}
