using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>The state of a body between two quanta.</summary>
/// <param name="Position">Cell and frame.</param>
/// <param name="Velocity">m/s, world axes.</param>
/// <param name="Transient">Changing bits.</param>
/// <param name="ContactPlane">The plane touched; zero for none.</param>
/// <param name="ContactPlaneCellId">
/// Cell whose block frame the plane is in; 0 when that is not known, as after a step that was undone (specification 02, 4.11).
/// </param>
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
        ThrowIfNotFinite(ContactPlane, name);
        if (!RetailMath.IsFinite(SlidingNormal)) throw new ArgumentException("The sliding normal is not finite.", name);
        // A missile that has hit a creature is in contact with no plane.
        bool stands = (Transient & TransientState.OnWalkable) != 0;
        if (stands || (ContactPlaneCellId != 0 && ContactPlane.Normal != Vector3.Zero))
            ThrowIfNoFooting(ContactPlane, ContactPlaneCellId, name);
        if (stands && (Transient & TransientState.Contact) == 0)
            throw new ArgumentException("What touches nothing stands on nothing: OnWalkable is set without Contact.", name);
    }

    /// <summary>A plane that is touched is finite, has a unit normal, and is in the frame of a block or of an unknown one.</summary>
    internal static void ThrowIfNoFooting(in Plane plane, uint cellId, string name)
    {
        ThrowIfNotFinite(plane, name);
        if (Math.Abs(RetailMath.LengthSquared(plane.Normal) - 1.0) > 1e-3)
            throw new ArgumentException("The normal of the contact plane is not of unit length.", name);
        if (cellId != 0 && !CellIds.HasValidIndex(cellId))
            throw new ArgumentException($"0x{cellId:X8}, the contact plane's, cannot name a cell.", name);
    }

    private static void ThrowIfNotFinite(in Plane plane, string name)
    {
        if (!RetailMath.IsFinite(plane.Normal) || !float.IsFinite(plane.D))
            throw new ArgumentException("The contact plane is not finite.", name);
    }
}
