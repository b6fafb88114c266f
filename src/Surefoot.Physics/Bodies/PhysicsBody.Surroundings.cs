using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>What stands near the body.</content>
public sealed partial class PhysicsBody
{
    /// <summary>Places that differ by less count as the same, metres.</summary>
    private const double SurroundingsGrain = 0.1;

    private CellArray? reached;

    /// <summary>
    /// A fingerprint of the body's place and of what is near it, in every cell that lies so near: which objects, where, in which state.
    /// While it stays the same, whatever stopped the body stops it still; to compare it costs no sweep.
    /// </summary>
    /// <param name="radius">How far around counts, metres from surface to surface, 0 or more.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative or not finite.</exception>
    public ulong HashSurroundings(float radius)
    {
        if (!(radius >= 0) || !float.IsFinite(radius))
            throw new ArgumentOutOfRangeException(nameof(radius), radius, "A radius is a number of metres, 0 or more.");
        ulong sum = Fingerprint(this);
        if (Cell is null) return sum;
        // What stands just across a cell's border is in no list of the cells that the body itself is in.
        double reach = (double)Radius + radius;
        Sphere around = new(Position.Frame.Origin + new Vector3(0, 0, Radius), (float)reach);
        ObjCell? home = null;
        reached ??= new CellArray();
        population.Cells.FindCellList(reached, Position, new ReadOnlySpan<Sphere>(in around), wantHome: false, ref home);
        for (int i = 0; i < reached.Count; i++)
        {
            if (reached[i].Cell is not { } cell) continue;
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
