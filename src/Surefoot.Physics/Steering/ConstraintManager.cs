using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>A leash: a body of which a server tells nothing more is braked and then held. It measures path, not distance.</summary>
/// <remarks>Retail: ConstraintManager; specification 09, 3.4.</remarks>
internal sealed class ConstraintManager(SteeredBody body)
{
    private const double NearlyAll = 0.9;

    private float start;
    private float max;

    /// <summary>The leash is tied.</summary>
    internal bool IsConstrained { get; private set; }

    /// <summary>Path since it was tied, metres; it goes on counting what it does not brake.</summary>
    internal float PathLength { get; private set; }

    /// <summary>More than nine tenths of it are used. The end of the leash does not change the answer.</summary>
    /// <remarks>Retail: ConstraintManager::IsFullyConstrained @0x005560D0.</remarks>
    internal bool IsFullyConstrained => max * NearlyAll < PathLength;

    /// <summary>Ties the leash: where the body is away from <paramref name="place"/> counts as path.</summary>
    /// <remarks>Retail: ConstraintManager::ConstrainTo @0x00556240.</remarks>
    internal void ConstrainTo(in Position place, float startDistance, float maxDistance)
    {
        IsConstrained = true;
        PathLength = (float)place.DistanceTo(body.Position);
        start = startDistance;
        max = maxDistance;
    }

    /// <remarks>Retail: ConstraintManager::UnConstrain @0x005560C0.</remarks>
    internal void Unconstrain() => IsConstrained = false;

    /// <summary>Brakes the motion of a quantum.</summary>
    /// <remarks>Retail: ConstraintManager::adjust_offset @0x00556180.</remarks>
    internal void AdjustOffset(ref Frame offset)
    {
        if (!IsConstrained) return;
        if (body.HasContact)
        {
            float left = (float)(((double)max - PathLength) / ((double)max - start));
            if (PathLength >= max) offset.Origin = Vector3.Zero;
            else if (PathLength > start) offset.Origin = RetailMath.Scale(offset.Origin, left);
        }

        PathLength = (float)(RetailMath.Length(offset.Origin) + PathLength);
    }

    internal void AddTo(ref StateHash hash)
    {
        hash.Add(IsConstrained ? 1UL : 0UL);
        hash.Add(start);
        hash.Add(max);
        hash.Add(PathLength);
    }
}
