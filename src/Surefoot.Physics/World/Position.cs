using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// A place in the world: a cell id and a frame whose origin is in metres from the south-west corner of the landblock
/// named by the id's high word.
/// </summary>
public struct Position : IEquatable<Position>
{
    /// <summary>A place in <paramref name="cellId"/>'s landblock.</summary>
    public Position(uint cellId, in Frame frame)
    {
        CellId = cellId;
        Frame = frame;
    }

    /// <summary>A place facing north.</summary>
    public Position(uint cellId, Vector3 origin)
        : this(cellId, new Frame(origin, Quaternion.Identity))
    {
    }

    /// <summary>Nowhere: id 0 at the origin.</summary>
    public static Position Nowhere => new(0, Frame.Identity);

    /// <summary>Cell id; 0 is nowhere.</summary>
    public uint CellId;

    /// <summary>Origin in the landblock's coordinates, and orientation.</summary>
    public Frame Frame;

    /// <summary>Displacement from this origin to another one, metres, in the world's axes.</summary>
    /// <remarks>Retail: Position::get_offset @0x00509F60.</remarks>
    public readonly Vector3 OffsetTo(in Position other)
    {
        Vector3 block = CellIds.BlockOffset(CellId, other.CellId);
        return new Vector3(
            (float)((double)block.X + other.Frame.Origin.X - Frame.Origin.X),
            (float)((double)(float)((double)block.Y + other.Frame.Origin.Y) - Frame.Origin.Y),
            (float)((double)other.Frame.Origin.Z - Frame.Origin.Z));
    }

    /// <summary>Distance between two origins, metres.</summary>
    public readonly double DistanceTo(in Position other) => RetailMath.Length(OffsetTo(other));

    /// <summary>A point of <paramref name="other"/>'s local frame in this position's block coordinates.</summary>
    /// <remarks>Retail: Position::localtoglobal @0x00456180.</remarks>
    public readonly Vector3 LocalToGlobal(in Position other, in Vector3 point) =>
        other.Frame.LocalToGlobal(point) + CellIds.BlockOffset(CellId, other.CellId);

    /// <summary>A point of <paramref name="other"/>'s local frame in this position's local frame.</summary>
    /// <remarks>Retail: Position::localtolocal @0x004527F0.</remarks>
    public readonly Vector3 LocalToLocal(in Position other, in Vector3 point) => Frame.GlobalToLocal(LocalToGlobal(other, point));

    /// <summary>A plane of <paramref name="other"/>'s local frame in this position's block coordinates.</summary>
    /// <remarks>Retail: Plane::localtoglobal @0x005AA0A0; the constant of a scaled obstacle is multiplied by the caller.</remarks>
    public readonly Plane LocalToGlobal(in Position other, in Plane plane)
    {
        Vector3 normal = other.Frame.LocalToGlobalVector(plane.Normal);
        Vector3 point = LocalToGlobal(other, RetailMath.Scale(plane.Normal, -plane.D));
        return RetailMath.PlaneThrough(normal, point);
    }

    /// <summary>Re-derives the outdoor cell from the coordinates; false, with id 0, outside the map.</summary>
    /// <remarks>Retail: Position::adjust_to_outside @0x00504A40.</remarks>
    public bool AdjustToOutside() => CellIds.AdjustToOutside(ref CellId, ref Frame.Origin);

    /// <inheritdoc/>
    public readonly bool Equals(Position other) => CellId == other.CellId && Frame == other.Frame;

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is Position other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode() => HashCode.Combine(CellId, Frame);

    /// <summary>Same cell and same frame, bit for bit.</summary>
    public static bool operator ==(Position left, Position right) => left.Equals(right);

    /// <summary>Another cell or another frame.</summary>
    public static bool operator !=(Position left, Position right) => !left.Equals(right);

    /// <inheritdoc/>
    public override readonly string ToString() =>
        FormattableString.Invariant($"0x{CellId:X8} [{Frame.Origin.X:0.###} {Frame.Origin.Y:0.###} {Frame.Origin.Z:0.###}]");
}
