using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>A way to be gone in one quantum: <c>transition</c> of retail's bodies.</summary>
/// <param name="Mover">Who goes.</param>
/// <param name="From">Where it begins; the cell is put right as for a body that is placed.</param>
/// <param name="To">Where it wants to go.</param>
public readonly record struct SweepInput(Mover Mover, Position From, Position To)
{
    /// <summary>
    /// What it touches where it begins; null for a mover in the air, which may land on its way. The result of a sweep has it for the next
    /// one.
    /// </summary>
    public Contact? Contact { get; init; }

    /// <summary>
    /// Unit normal of the wall it slides along, or null; the result of a sweep has it for the next one. Zero for a wall that has ended.
    /// </summary>
    public Vector3? SlidingNormal { get; init; }

    internal static void ThrowIfNoWall(Vector3 normal, string name)
    {
        if (!RetailMath.IsFinite(normal)) throw new ArgumentException("The sliding normal is not finite.", name);
        if (normal != Vector3.Zero && Math.Abs(RetailMath.LengthSquared(normal) - 1.0) > 1e-3)
            throw new ArgumentException("The sliding normal is neither of unit length nor zero.", name);
    }

    internal BodySeat Begin(in Position from)
    {
        TransientState state = TransientState.None;
        if (Contact is { } contact)
        {
            state |= TransientState.Contact;
            if (contact.IsWalkable) state |= TransientState.OnWalkable;
            if (contact.IsWater) state |= TransientState.WaterContact;
        }

        if (SlidingNormal is not null) state |= TransientState.Sliding;
        return new BodySeat(from, Vector3.Zero, state, Contact?.Plane ?? default, Contact?.CellId ?? 0, SlidingNormal ?? Vector3.Zero);
    }
}
