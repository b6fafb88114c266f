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

    /// <summary>Id of the block's terrain record, 0xXXYYFFFF.</summary>
    internal static uint LandblockRecord(uint cellId) => cellId | 0xFFFF;

    /// <summary>Id of the block's record of buildings and objects, 0xXXYYFFFE.</summary>
    internal static uint LandblockInfoRecord(uint cellId) => BlockOf(cellId) | 0xFFFE;

    /// <summary>True for global cell coordinates on the map.</summary>
    /// <remarks>Retail: LandDefs::in_bounds @0x0043D650.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static bool IsOnMap(int x, int y) => (uint)x < MapCells && (uint)y < MapCells;

    /// <summary>Global cell coordinates of the south-west land cell of an id's block; false for the id 0 and outside the map.</summary>
    /// <remarks>Retail: LandDefs::blockid_to_lcoord @0x0043D680.</remarks>
    internal static bool TryBlockCorner(uint cellId, out int x, out int y)
    {
        x = (int)((cellId >> 21) & 0x7F8);
        y = (int)((cellId >> 13) & 0x7F8);
        return cellId != 0 && IsOnMap(x, y);
    }

    /// <summary>True when the index can name a cell and the block is on the map.</summary>
    /// <remarks>Retail: LandDefs::inbound_valid_cellid @0x004979A0.</remarks>
    public static bool IsValid(uint cellId) => HasValidIndex(cellId) && TryBlockCorner(cellId, out _, out _);

    /// <summary>Global cell coordinates of a land cell; false for anything else.</summary>
    /// <remarks>Retail: LandDefs::gid_to_lcoord @0x00497A90.</remarks>
    public static bool TryLandCoordinates(uint cellId, out int x, out int y)
    {
        if (!IsValid(cellId) || !IsOutdoor(cellId))
        {
            x = y = 0;
            return false;
        }

        int index = LandIndex(cellId);
        x = (int)((cellId >> 21) & 0x7F8) + (index >> 3);
        y = (int)((cellId >> 13) & 0x7F8) + (index & 7);
        return true;
    }

    /// <summary>Index of a land cell inside its block, 0..63: eight times the column plus the row.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static int LandIndex(uint cellId) => (int)(cellId & 0xFFFF) - 1;

    /// <summary>Is a sphere over the block that its coordinates belong to?</summary>
    /// <param name="point">Centre, block coordinates, metres.</param>
    /// <param name="radius">Radius, metres.</param>
    /// <remarks>Retail: LandDefs::within_block @0x0050E800.</remarks>
    internal static bool IsWithinBlock(in Vector3 point, float radius) =>
        point.X >= radius && point.Y >= radius && point.X < (double)BlockSize - radius && point.Y < (double)BlockSize - radius;

    /// <summary>Id of the land cell at global cell coordinates, 0 outside the map.</summary>
    /// <remarks>Retail: LandDefs::lcoord_to_gid @0x004A19A0.</remarks>
    public static uint FromLandCoordinates(int x, int y) => IsOnMap(x, y)
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
