using System.Numerics;

namespace Surefoot.Physics.World;

/// <summary>How much water a cell or block has.</summary>
public enum WaterType : byte
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>At some corners.</summary>
    Partly = 1,

    /// <summary>At all corners.</summary>
    Entirely = 2,
}

/// <content>What the ground is made of: terrain types, water, roads.</content>
public sealed partial class TerrainSurface
{
    private const float ShoreDepth = 0.1f;
    private const float WaterDepthAtCorner = 0.45f;
    private const float OpenWaterDepth = 0.9f;
    private const double RoadHalfWidth = 5;

    private readonly WaterType[] water = new WaterType[CellCount];

    /// <summary>Water of the whole block: entirely only when every cell is.</summary>
    public WaterType BlockWaterType { get; }

    /// <summary>The terrain word of a vertex.</summary>
    internal ushort WordOf(int column, int row) => words[(VerticesPerSide * column) + row];

    /// <summary>Terrain type of a word, 0 to 31.</summary>
    internal static int TypeOf(ushort word) => (word >> 2) & 31;

    /// <summary>Scenery type of a word, 0 to 31.</summary>
    internal static int SceneryOf(ushort word) => word >> 11;

    /// <summary>Road of a word; 0 is none.</summary>
    internal static int RoadOf(ushort word) => word & 3;

    /// <summary>Terrain types 16 to 20 are water, from running water to deep sea.</summary>
    internal static bool IsWaterType(int type) => type is >= 16 and <= 20;

    /// <summary>Water of a cell.</summary>
    /// <param name="cell">Index of the cell, 0 to 63.</param>
    public WaterType WaterTypeOf(int cell) => water[cell];

    /// <summary>How deep a body sinks in at a point of a cell, metres.</summary>
    /// <param name="cell">Index of the cell, 0 to 63.</param>
    /// <param name="point">The point; only x and y count.</param>
    /// <remarks>Retail: CObjCell::get_water_depth @0x0052B8A0, CLandBlockStruct::calc_water_depth @0x005315F0.</remarks>
    internal float WaterDepth(int cell, in Vector3 point) => water[cell] switch
    {
        WaterType.None => 0f,
        WaterType.Entirely => OpenWaterDepth,
        _ => IsWaterType(TypeOf(words[NearestCorner(cell, point)])) ? WaterDepthAtCorner : ShoreDepth,
    };

    /// <summary>Is a point of the block on a road? Roads keep scenery away and nothing else.</summary>
    /// <remarks>Retail: CLandBlock::on_road @0x0052FFF0.</remarks>
    internal bool IsOnRoad(in Vector3 point)
    {
        double column = Math.Floor(point.X / (double)CellIds.CellSize), row = Math.Floor(point.Y / (double)CellIds.CellSize);
        if (!(column is >= 0 and < CellsPerSide && row is >= 0 and < CellsPerSide)) return false;
        double x = point.X - (column * CellIds.CellSize);
        float y = (float)(point.Y - (row * CellIds.CellSize));
        const double side = CellIds.CellSize, far = side - RoadHalfWidth;
        int southWest = (VerticesPerSide * (int)column) + (int)row;
        bool west = x < RoadHalfWidth, south = y < RoadHalfWidth, east = x > far, north = y > far;
        int southEast = southWest + VerticesPerSide;
        return (Road(southWest) << 3 | Road(southWest + 1) << 2 | Road(southEast) << 1 | Road(southEast + 1)) switch
        {
            0b0000 => false,
            0b1111 => true,
            0b1110 => west || south,
            0b1101 => west || north,
            0b1100 => west,
            0b1011 => east || south,
            0b1010 => south,
            0b1001 => Math.Abs(x - y) < RoadHalfWidth,
            0b1000 => x + y < RoadHalfWidth,
            0b0111 => east || north,
            0b0110 => Math.Abs(x + y - side) < RoadHalfWidth,
            0b0101 => north,
            0b0100 => side + x - y < RoadHalfWidth,
            0b0011 => east,
            0b0010 => side - x + y < RoadHalfWidth,
            _ => (2 * side) - x - y < RoadHalfWidth,
        };
    }

    private int Road(int vertex) => RoadOf(words[vertex]) != 0 ? 1 : 0;

    /// <summary>A point strictly beyond the cell's centre line takes the far corner, even where it lies in another cell.</summary>
    private static int NearestCorner(int cell, in Vector3 point)
    {
        int i = cell >> 3, j = cell & 7;
        int column = point.X > (CellIds.CellSize / 2) * ((2 * i) + 1) ? i + 1 : i;
        int row = point.Y > (CellIds.CellSize / 2) * ((2 * j) + 1) ? j + 1 : j;
        return (VerticesPerSide * column) + row;
    }

    /// <remarks>Retail: CLandBlockStruct::CalcCellWater @0x00531550, CalcWater @0x005327E0.</remarks>
    private WaterType FindWater()
    {
        bool any = false, all = true;
        for (int cell = 0; cell < CellCount; cell++)
        {
            int southWest = (VerticesPerSide * (cell >> 3)) + (cell & 7);
            int corners =
                Water(southWest) + Water(southWest + 1) + Water(southWest + VerticesPerSide) + Water(southWest + VerticesPerSide + 1);
            water[cell] = corners switch { 0 => WaterType.None, 4 => WaterType.Entirely, _ => WaterType.Partly };
            any |= corners > 0;
            all &= corners == 4;
        }

        return !any ? WaterType.None : all ? WaterType.Entirely : WaterType.Partly;

        int Water(int vertex) => IsWaterType(TypeOf(words[vertex])) ? 1 : 0;
    }
}
