using System.Numerics;
using Surefoot.DemoWorld.Placement;

namespace Surefoot.DemoWorld.Land;

/// <summary>
/// The land of the demo world as its records hold it: height bytes and terrain words of all blocks, and the ground between.
/// </summary>
/// <remarks>
/// Eight by eight blocks of land with a ring of sea blocks around, which retail's water rule makes impassable. Immutable.
/// Grid columns and rows are cells of 24 m from the south-west corner of the land, -8 to 72 with the sea.
/// </remarks>
public sealed class DemoTerrain
{
    /// <summary>Block index (west to east) of the westernmost land block.</summary>
    public const int FirstBlockX = 0xA6;

    /// <summary>Block index (south to north) of the southernmost land block.</summary>
    public const int FirstBlockY = 0xB1;

    /// <summary>Land blocks a side.</summary>
    public const int LandBlocks = 8;

    /// <summary>Rows of sea blocks around the land.</summary>
    public const int SeaBlocks = 1;

    /// <summary>Side of a block (m).</summary>
    public const float BlockSide = 192f;

    /// <summary>Side of a cell (m).</summary>
    public const float CellSide = 24f;

    private const int CellsPerBlock = 8;
    private const int Margin = SeaBlocks * CellsPerBlock;
    private const int GridSide = ((LandBlocks + (2 * SeaBlocks)) * CellsPerBlock) + 1;

    private readonly byte[] heights = new byte[GridSide * GridSide];
    private readonly ushort[] words = new ushort[GridSide * GridSide];

    internal DemoTerrain(uint seed)
    {
        Seed = seed;
        var form = new Landform(seed);
        for (int column = -Margin; column <= LandBlocks * CellsPerBlock + Margin; column++)
        {
            for (int row = -Margin; row <= LandBlocks * CellsPerBlock + Margin; row++)
            {
                var (height, kind) = form.At(column, row);
                heights[Index(column, row)] = DemoHeightTable.Nearest(height);
                words[Index(column, row)] = (ushort)(((int)kind << 2) | (form.SceneryAt(column, row, kind) << 11));
            }
        }

        foreach (var (column, row) in Roads.Vertices())
        {
            ref ushort word = ref words[Index(column, row)];
            if (!TerrainKinds.IsWater(KindOf(word)))
                word |= 1;
        }
    }

    /// <summary>The number that the landscape was made from.</summary>
    public uint Seed { get; }

    /// <summary>All block indices of the world, land and sea, west to east and south to north within.</summary>
    public static IEnumerable<(int X, int Y)> Blocks
    {
        get
        {
            for (int x = FirstBlockX - SeaBlocks; x < FirstBlockX + LandBlocks + SeaBlocks; x++)
            {
                for (int y = FirstBlockY - SeaBlocks; y < FirstBlockY + LandBlocks + SeaBlocks; y++)
                    yield return (x, y);
            }
        }
    }

    /// <summary>Computes the land of a seed (some milliseconds).</summary>
    public static DemoTerrain Create(uint seed = DemoWorldBuilder.DefaultSeed) => WorldPlan.Create(seed).Terrain;

    /// <summary>True for a block that the world has.</summary>
    public static bool HasBlock(int x, int y)
        => x >= FirstBlockX - SeaBlocks && x < FirstBlockX + LandBlocks + SeaBlocks
        && y >= FirstBlockY - SeaBlocks && y < FirstBlockY + LandBlocks + SeaBlocks;

    /// <summary>The height byte of a vertex.</summary>
    public byte HeightIndex(int column, int row) => heights[Index(column, row)];

    /// <summary>The terrain word of a vertex: road, type, scenery.</summary>
    public ushort Word(int column, int row) => words[Index(column, row)];

    /// <summary>Height of a vertex (m).</summary>
    public float Height(int column, int row) => DemoHeightTable.Heights[HeightIndex(column, row)];

    /// <summary>Terrain type of a vertex.</summary>
    public TerrainKind Kind(int column, int row) => KindOf(Word(column, row));

    /// <summary>Whether a vertex carries a road.</summary>
    public bool IsRoad(int column, int row) => (Word(column, row) & 3) != 0;

    /// <summary>Grid column and row of a block's south-west vertex.</summary>
    public static (int Column, int Row) OriginOf(int blockX, int blockY)
        => ((blockX - FirstBlockX) * CellsPerBlock, (blockY - FirstBlockY) * CellsPerBlock);

    /// <summary>The ground at a point of the land, given in metres from its south-west corner (x east, y north).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The point is not in the world.</exception>
    public GroundPoint GroundAt(double x, double y)
    {
        int column = (int)Math.Floor(x / CellSide), row = (int)Math.Floor(y / CellSide);
        int blockX = FirstBlockX + (int)Math.Floor(x / BlockSide), blockY = FirstBlockY + (int)Math.Floor(y / BlockSide);
        if (!HasBlock(blockX, blockY))
            throw new ArgumentOutOfRangeException(nameof(x), $"({x}, {y}) is outside the demo world");
        var (originColumn, originRow) = OriginOf(blockX, blockY);
        int i = column - originColumn, j = row - originRow;
        float localX = (float)(x - (originColumn * CellSide)), localY = (float)(y - (originRow * CellSide));
        var triangle = TerrainTriangle.Under(this, blockX, blockY, i, j, localX, localY);
        return new(
            ((uint)blockX << 24) | ((uint)blockY << 16) | (uint)((8 * i) + j + 1),
            new Vector3(localX, localY, triangle.HeightAt(localX, localY)),
            triangle.Normal,
            WaterDepth(column, row, localX > 12 * ((2 * i) + 1), localY > 12 * ((2 * j) + 1)));
    }

    /// <summary>The ground at a point of an outdoor cell's block, given in metres from the block's south-west corner.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The point is not in the world.</exception>
    public GroundPoint GroundAt(uint cellId, float x, float y)
    {
        var (column, row) = OriginOf((int)(cellId >> 24), (int)((cellId >> 16) & 0xFF));
        return GroundAt((column * (double)CellSide) + x, (row * (double)CellSide) + y);
    }

    /// <summary>Takes scenery away where it could be thrown onto a place. For the planning of a world only.</summary>
    internal void ClearSceneryAround(NamedPlace place)
    {
        // Scenery strays from its vertex by up to 22 m on both axes, and trees and places have a width.
        const double reach = 34.0;
        var (column, row) = OriginOf((int)(place.CellId >> 24), (int)((place.CellId >> 16) & 0xFF));
        if (!HasBlock((int)(place.CellId >> 24), (int)((place.CellId >> 16) & 0xFF)))
            return;
        double x = (column * CellSide) + place.Origin.X, y = (row * CellSide) + place.Origin.Y;
        for (int i = (int)Math.Ceiling((x - reach) / CellSide); i * CellSide <= x + reach; i++)
        {
            for (int j = (int)Math.Ceiling((y - reach) / CellSide); j * CellSide <= y + reach; j++)
                words[Index(i, j)] &= 0x07FF;
        }
    }

    // Spec 05, 4.5: by the four corners of the cell, and in a mixed cell by the corner nearest to the point.
    private float WaterDepth(int column, int row, bool east, bool north)
    {
        int wet = 0;
        for (int corner = 0; corner < 4; corner++)
            wet += TerrainKinds.IsWater(Kind(column + (corner & 1), row + (corner >> 1))) ? 1 : 0;
        return wet switch
        {
            0 => 0f,
            4 => 0.9f,
            _ => TerrainKinds.IsWater(Kind(column + (east ? 1 : 0), row + (north ? 1 : 0))) ? 0.45f : 0.1f,
        };
    }

    private static TerrainKind KindOf(ushort word) => (TerrainKind)((word >> 2) & 31);

    private static int Index(int column, int row) => ((column + Margin) * GridSide) + row + Margin;
}

/// <summary>A point on the ground.</summary>
/// <param name="CellId">Outdoor cell under the point.</param>
/// <param name="Position">The point, in metres from the south-west corner of the cell's block, on the triangle.</param>
/// <param name="Normal">Upward normal of the triangle, of length 1.</param>
/// <param name="WaterDepth">How far feet sink below the triangle, measured along the normal (m); 0 on dry land.</param>
public readonly record struct GroundPoint(uint CellId, Vector3 Position, Vector3 Normal, float WaterDepth)
{
    /// <summary>Height (m) at which feet come to rest: the triangle's, lowered by the water.</summary>
    public float RestHeight => (float)(Position.Z - ((double)WaterDepth / Normal.Z));
}
