using System.Numerics;
using System.Runtime.CompilerServices;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// Arithmetic of cell ids 0xXXYYCCCC: XX the landblock's column (east), YY its row (north), CCCC the cell inside the block.
/// </summary>
public static class CellIds
{
    /// <summary>Side of a landblock, metres.</summary>
    public const float BlockSize = 192f;

    /// <summary>Side of a land cell, metres.</summary>
    public const float CellSize = 24f;

    /// <summary>Land cells along a side of the map.</summary>
    public const int MapCells = 2040;

    /// <summary>Lowest index of an environment cell.</summary>
    public const uint FirstIndoor = 0x100;

    /// <summary>True for ids whose low word is below 0x100.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsOutdoor(uint cellId) => (cellId & 0xFFFF) < FirstIndoor;

    /// <summary>The landblock part of an id, 0xXXYY0000.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint BlockOf(uint cellId) => cellId & 0xFFFF0000;

    /// <summary>True when the index inside the block can name a cell.</summary>
    public static bool HasValidIndex(uint cellId)
    {
        uint c = cellId & 0xFFFF;
        return c is (>= 1 and <= 0x40) or (>= 0x100 and <= 0xFFFD) or 0xFFFF;
    }

    /// <summary>Id of the land cell at global cell coordinates, 0 outside the map.</summary>
    /// <remarks>Retail: LandDefs::lcoord_to_gid @0x004A19A0.</remarks>
    public static uint FromLandCoordinates(int x, int y) => x is >= 0 and < MapCells && y is >= 0 and < MapCells
        ? ((uint)(x >> 3) << 24) | ((uint)(y >> 3) << 16) | (uint)((8 * (x & 7)) + (y & 7) + 1)
        : 0;

    /// <summary>
    /// What must be added to a point in the block frame of <paramref name="to"/> to express it in that of <paramref name="from"/>, metres.
    /// </summary>
    /// <remarks>Retail: LandDefs::get_block_offset @0x0043E630; an id of 0 counts as the block (0, 0).</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 BlockOffset(uint from, uint to)
    {
        if (((from ^ to) & 0xFFFF0000) == 0) return Vector3.Zero;
        return new Vector3(
            BlockSize * ((int)(to >> 24) - (int)(from >> 24)),
            BlockSize * ((int)((to >> 16) & 0xFF) - (int)((from >> 16) & 0xFF)),
            0f);
    }

    /// <summary>
    /// Re-derives the outdoor cell under a point and moves the point into that cell's block frame; id 0 and false outside the map.
    /// </summary>
    /// <remarks>Retail: LandDefs::adjust_to_outside @0x005A9BC0.</remarks>
    public static bool AdjustToOutside(ref uint cellId, ref Vector3 point)
    {
        if (HasValidIndex(cellId))
        {
            if (Math.Abs(point.X) < RetailMath.Epsilon) point.X = 0;
            if (Math.Abs(point.Y) < RetailMath.Epsilon) point.Y = 0;
            double column = Math.Floor(point.X / (double)CellSize), row = Math.Floor(point.Y / (double)CellSize);
            // Far outside the map the sum would leave the integers; NaN fails both tests as well.
            if (Math.Abs(column) < 1e6 && Math.Abs(row) < 1e6)
            {
                uint id = FromLandCoordinates((int)((cellId >> 21) & 0x7F8) + (int)column, (int)((cellId >> 13) & 0x7F8) + (int)row);
                if (id != 0)
                {
                    cellId = id;
                    point.X = (float)(point.X - (BlockSize * Math.Floor(point.X / (double)BlockSize)));
                    point.Y = (float)(point.Y - (BlockSize * Math.Floor(point.Y / (double)BlockSize)));
                    return true;
                }
            }
        }

        cellId = 0;
        return false;
    }
}
