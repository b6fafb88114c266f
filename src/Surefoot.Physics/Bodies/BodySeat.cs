using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>The state of a body between two quanta.</summary>
/// <param name="Position">Cell and frame.</param>
/// <param name="Velocity">m/s, world axes.</param>
/// <param name="Transient">Changing bits.</param>
/// <param name="ContactPlane">The plane touched.</param>
/// <param name="ContactPlaneCellId">Cell whose block frame the plane is in.</param>
/// <param name="SlidingNormal">Normal of the wall slid along.</param>
/// <param name="TouchesEnvironment">A collision with the environment was reported and has not ended.</param>
public readonly record struct BodySeat(
    Position Position, Vector3 Velocity, TransientState Transient, Plane ContactPlane, uint ContactPlaneCellId, Vector3 SlidingNormal,
    bool TouchesEnvironment = false)
{
    internal void ThrowIfBad(string name)
    {
        PhysicsBody.ThrowIfBad(Position, name);
        if (!RetailMath.IsFinite(Velocity)) throw new ArgumentException("The velocity is not finite.", name);
        if (!RetailMath.IsFinite(ContactPlane.Normal) || !float.IsFinite(ContactPlane.D))
            throw new ArgumentException("The contact plane is not finite.", name);
        if (!RetailMath.IsFinite(SlidingNormal)) throw new ArgumentException("The sliding normal is not finite.", name);
    }
}
