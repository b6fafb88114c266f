using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>The three small managers that bend the motion a body proposes, each made when it is first needed.</summary>
/// <remarks>
/// Retail: PositionManager; specification 09, 3.1. The order of the three is load-bearing: each works on what the one before it left.
/// </remarks>
internal sealed class PositionManager(SteeredBody body)
{
    /// <summary>Follows a server's positions; null until the first.</summary>
    internal InterpolationManager? Interpolation { get; private set; }

    /// <summary>Stays next to an object; null until the first.</summary>
    internal StickyManager? Sticky { get; private set; }

    /// <summary>The leash; null until the first.</summary>
    internal ConstraintManager? Constraint { get; private set; }

    internal bool IsInterpolating => Interpolation is { IsInterpolating: true };

    internal bool IsFullyConstrained => Constraint is { IsFullyConstrained: true };

    internal uint StickyObjectId => Sticky?.TargetId ?? 0;

    /// <remarks>Retail: PositionManager::adjust_offset @0x00555190.</remarks>
    internal void AdjustOffset(ref Frame offset, float quantum)
    {
        Interpolation?.AdjustOffset(ref offset, quantum);
        Sticky?.AdjustOffset(ref offset, quantum);
        Constraint?.AdjustOffset(ref offset);
    }

    /// <remarks>Retail: PositionManager::UseTime @0x00555160.</remarks>
    internal void UseTime()
    {
        Interpolation?.UseTime();
        Sticky?.UseTime();
    }

    internal void InterpolateTo(in Position place, bool keepHeading) =>
        (Interpolation ??= new InterpolationManager(body)).InterpolateTo(place, keepHeading);

    internal void StopInterpolating() => Interpolation?.StopInterpolating();

    internal void StickTo(uint id, float radius) => (Sticky ??= new StickyManager(body)).StickTo(id, radius);

    internal void Unstick() => Sticky?.Unstick();

    internal void ConstrainTo(in Position place, float start, float max) =>
        (Constraint ??= new ConstraintManager(body)).ConstrainTo(place, start, max);

    internal void Unconstrain() => Constraint?.Unconstrain();

    /// <remarks>Retail: PositionManager::HandleUpdateTarget @0x005553D0.</remarks>
    internal void HandleUpdateTarget(in TargetInfo info) => Sticky?.HandleUpdateTarget(info);

    internal void AddTo(ref StateHash hash)
    {
        Interpolation?.AddTo(ref hash);
        Sticky?.AddTo(ref hash);
        Constraint?.AddTo(ref hash);
    }
}
