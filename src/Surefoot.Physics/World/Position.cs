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

    /// <summary>Horizontal distance between two origins, metres.</summary>
    /// <remarks>Retail: Position::xy_distance @0x005A94F0.</remarks>
    public readonly double HorizontalDistanceTo(in Position other)
    {
        Vector3 offset = OffsetTo(other);
        offset.Z = 0;
        return RetailMath.Length(offset);
    }

    /// <summary>Compass direction of another origin, degrees: 0 north, 90 east; 0 when it is straight above or below.</summary>
    /// <remarks>Retail: Position::heading @0x005A9520.</remarks>
    public readonly float HeadingTo(in Position other)
    {
        Vector3 offset = OffsetTo(other);
        offset.Z = 0;
        return RetailMath.NormalizeCheckSmall(ref offset) ? 0f : (float)Frame.HeadingOf(offset);
    }

    /// <summary>
    /// Gap between two upright cylinders that stand on positions, metres; negative when they overlap. Retail mixes the measures: the
    /// horizontal gap is taken from the distance in space.
    /// </summary>
    /// <param name="radius">Radius of the cylinder here.</param>
    /// <param name="height">Height of the cylinder here.</param>
    /// <param name="other">Where the other one stands.</param>
    /// <param name="otherRadius">Its radius.</param>
    /// <param name="otherHeight">Its height.</param>
    /// <remarks>Retail: Position::cylinder_distance @0x005A97F0.</remarks>
    internal readonly double CylinderDistance(float radius, float height, in Position other, float otherRadius, float otherHeight)
    {
        float reach = (float)CylinderDistanceIgnoringHeight(radius, other, otherRadius);
        double z = Frame.Origin.Z, otherZ = other.Frame.Origin.Z;
        double rise = z <= otherZ ? otherZ - (z + height) : z - (otherZ + otherHeight);
        double slant = Math.Sqrt((rise * rise) + ((double)reach * reach));
        if (rise <= 0) return reach <= 0 ? -slant : reach;
        return reach > 0 ? slant : rise;
    }

    /// <summary>Distance between origins less both radii, metres.</summary>
    /// <remarks>Retail: Position::cylinder_distance_no_z @0x005A98B0.</remarks>
    internal readonly double CylinderDistanceIgnoringHeight(float radius, in Position other, float otherRadius) =>
        DistanceTo(other) - ((double)radius + otherRadius);

    /// <summary>
    /// Where another origin lies seen from here, as bits: right 16 or left 8, front 32 or back 64, and the third of
    /// <paramref name="height"/>: low 4, middle 2, high 1.
    /// </summary>
    /// <remarks>Retail: Position::determine_quadrant @0x005A9580.</remarks>
    internal readonly int QuadrantOf(in Position other, float height)
    {
        Vector3 local = LocalToLocal(other, Vector3.Zero);
        int third = height * 0.333333333 <= local.Z ? height * 0.66666667 <= local.Z ? 1 : 2 : 4;
        return (local.X >= 0 ? 16 : 8) | (local.Y >= 0 ? 32 : 64) | third;
    }

    /// <summary>A cell id on the map and a frame without NaN whose quaternion is of unit length.</summary>
    /// <remarks>Retail: Position::IsValid @0x005A9480.</remarks>
    public readonly bool IsValid => CellIds.IsValid(CellId) && Frame.IsValid;

    /// <summary>A point of <paramref name="other"/>'s local frame in this position's block coordinates.</summary>
    /// <remarks>Retail: Position::localtoglobal @0x00456180.</remarks>
    public readonly Vector3 LocalToGlobal(in Position other, in Vector3 point) =>
        other.Frame.LocalToGlobal(point) + CellIds.BlockOffset(CellId, other.CellId);

    /// <summary>A point of <paramref name="other"/>'s local frame in this position's local frame.</summary>
    /// <remarks>Retail: Position::localtolocal @0x004527F0.</remarks>
    internal readonly Vector3 LocalToLocal(in Position other, in Vector3 point) => Frame.GlobalToLocal(LocalToGlobal(other, point));

    /// <summary>The frame of <paramref name="other"/> seen from inside this one: combined with this one it gives the other.</summary>
    /// <remarks>Retail: Position::subtract2 @0x00555A90.</remarks>
    internal readonly Frame RelativeFrame(in Position other)
    {
        Frame relative = new(LocalToLocal(other, Vector3.Zero), Quaternion.Identity);
        relative.SetRotation(Frame.RelativeRotation(other.Frame));
        return relative;
    }

    /// <summary>A plane of <paramref name="other"/>'s local frame in this position's block coordinates.</summary>
    /// <remarks>Retail: Plane::localtoglobal @0x005AA0A0; the constant of a scaled obstacle is multiplied by the caller.</remarks>
    internal readonly Plane LocalToGlobal(in Position other, in Plane plane)
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
