using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Transitions;

/// <summary>How a sweep is cut into sub-steps.</summary>
/// <param name="Count">How many.</param>
/// <param name="PerSubStep">Each how far, metres.</param>
/// <param name="Offset">The whole way, metres.</param>
/// <param name="Distance">Its length, metres.</param>
internal readonly record struct SubStepPlan(int Count, Vector3 PerSubStep, Vector3 Offset, double Distance)
{
    /// <summary>Sub-steps of at most one radius of sphere 0; the camera's are exactly one radius.</summary>
    /// <param name="path">The way, and the spheres that go it.</param>
    /// <param name="isViewer">The camera goes it.</param>
    /// <remarks>Retail: CTransition::calc_num_steps @0x0050A0B0.</remarks>
    internal static SubStepPlan Of(SpherePath path, bool isViewer)
    {
        if (!path.HasBegin) return new SubStepPlan(1, Vector3.Zero, Vector3.Zero, 0);

        Vector3 offset = path.BeginPos.OffsetTo(path.EndPos);
        double distance = RetailMath.Length(offset), quotient = distance / path.LocalSpheres[0].Radius;
        if (isViewer)
        {
            return distance <= RetailMath.Epsilon
                ? new SubStepPlan(0, Vector3.Zero, offset, distance)
                : new SubStepPlan((int)Math.Floor(quotient) + 1, RetailMath.Scale(offset, 1.0 / quotient), offset, distance);
        }

        if (quotient > 1)
        {
            double count = Math.Ceiling(quotient);
            return new SubStepPlan((int)count, RetailMath.Scale(offset, 1.0 / count), offset, distance);
        }

        return offset == Vector3.Zero
            ? new SubStepPlan(0, Vector3.Zero, offset, distance)
            : new SubStepPlan(1, offset, offset, distance);
    }
}
