using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>The movement side of a replayed body: it only hands out the recorded root motion.</summary>
internal sealed class RecordedMotion : IBodyMovement
{
    /// <summary>Root motion of the next quanta, metres in the body's own frame.</summary>
    internal Vector3 Offset { get; set; }

    public void HitGround()
    {
    }

    public void LeaveGround()
    {
    }

    public void AccumulateRootMotion(float quantum, ref Frame offset) => offset.Origin = Offset;

    public void UseTime()
    {
    }

    public void HandleEnterWorld()
    {
    }

    public void HandleExitWorld()
    {
    }
}
