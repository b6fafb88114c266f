using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>What stands near the body.</content>
public sealed partial class PhysicsBody
{
    /// <summary>Places that differ by less count as the same, metres.</summary>
    private const double SurroundingsGrain = 0.1;

    /// <summary>
    /// A fingerprint of the body's place and of what is near it in the cells that it reaches: which objects, where, in which state. While
    /// it stays the same, whatever stopped the body stops it still; to compare it costs no sweep.
    /// </summary>
    /// <param name="radius">How far around counts, metres from surface to surface, 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative or not finite.</exception>
    public ulong HashSurroundings(float radius)
    {
        if (!(radius >= 0) || !float.IsFinite(radius))
            throw new ArgumentOutOfRangeException(nameof(radius), radius, "A radius is a number of metres, 0 or more.");
        ulong sum = Fingerprint(this);
        for (int i = 0; i < ShadowCount; i++)
        {
            if (Shadows[i].Cell is not { } cell) continue;
            for (int k = 0; k < cell.ShadowCount; k++)
            {
                WorldObject other = cell.ShadowAt(k);
                if (ReferenceEquals(other, this) || other.Parent is not null) continue;
                double gap = PositionField.DistanceTo(other.Position) - ((double)Radius + other.Radius);
                // The order in a cell's list is no matter: who leaves disturbs it.
                if (gap <= radius) unchecked { sum += Fingerprint(other); }
            }
        }

        return sum;
    }

    private static ulong Fingerprint(WorldObject item)
    {
        StateHash hash = new();
        hash.Add(item.Id);
        hash.Add((ulong)item.State);
        hash.Add(CellIds.BlockOf(item.Position.CellId));
        hash.Add(Grains(item.Position.Frame.Origin.X));
        hash.Add(Grains(item.Position.Frame.Origin.Y));
        hash.Add(Grains(item.Position.Frame.Origin.Z));
        return hash.Value;
    }

    private static ulong Grains(float metres) => (ulong)(long)Math.Round(metres / SurroundingsGrain);
}
