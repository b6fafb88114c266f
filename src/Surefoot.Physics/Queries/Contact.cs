using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>The plane that a mover touches: what it stands on, or the slope that it slides down.</summary>
/// <param name="Plane">
/// The plane, its normal of unit length and in world axes; the constant, metres, is in the block frame of <paramref name="CellId"/>.
/// </param>
/// <param name="CellId">
/// Cell whose block frame the plane is in; 0 when retail no longer knows it, as after a step that was undone (specification 02, 4.11).
/// </param>
/// <param name="IsWater">It is water, in which a mover stands lower than its plane.</param>
public readonly record struct Contact(Plane Plane, uint CellId, bool IsWater = false)
{
    /// <summary>The plane can be walked on: it is at most 48.38° steep.</summary>
    public bool IsWalkable => ObjectInfo.IsValidWalkable(Plane.Normal);

    internal static Contact? Of(CollisionInfo met) =>
        met.ContactPlaneValid ? new Contact(met.ContactPlane, met.ContactPlaneCellId, met.ContactPlaneIsWater) : null;

    internal void ThrowIfBad(string name)
    {
        BodySeat.ThrowIfNoFooting(Plane, CellId, name);
        if (CellId != 0) ThrowIfOffMap(CellId, name);
    }

    internal static void ThrowIfOffMap(uint cellId, string name)
    {
        if (!CellIds.IsValid(cellId)) throw new ArgumentException($"0x{cellId:X8}, the contact plane's, is not on the map.", name);
    }
}
