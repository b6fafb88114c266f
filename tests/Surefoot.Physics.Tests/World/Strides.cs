using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.World;

/// <summary>A movement side that moves its body by a given displacement, in the body's frame, each quantum.</summary>
internal sealed class Strides : IBodyMovement
{
    internal Vector3 Next { get; set; }

    /// <summary>Moves a body that stands, by one quantum.</summary>
    internal static void Walk(PhysicsBody body, Vector3 by)
    {
        if (SteeredPhysicsBody.Of(body).Movement is not Strides) SteeredPhysicsBody.Of(body).Attach(new Strides());
        ((Strides)SteeredPhysicsBody.Of(body).Movement!).Next = by;
        body.SetActive(true);
        body.AdvanceQuantum(1f / 30);
    }

    public void AccumulateRootMotion(float quantum, ref Frame offset) => offset.Origin = Next;

    public void HitGround()
    {
    }

    public void LeaveGround()
    {
    }

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
