using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>A movement side that only counts quanta and changes of ground.</summary>
internal sealed class QuantumCounter : IBodyMovement
{
    internal int Count { get; private set; }

    internal int Hits { get; private set; }

    internal int Leaves { get; private set; }

    public void HitGround() => Hits++;

    public void LeaveGround() => Leaves++;

    public void AccumulateRootMotion(float quantum, ref Frame offset) => Count++;

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
