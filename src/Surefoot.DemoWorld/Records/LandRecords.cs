using System.Collections.Immutable;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Records;

/// <summary>The land block records of a terrain.</summary>
internal static class LandRecords
{
    /// <summary>One record a block, land and sea.</summary>
    public static IEnumerable<DatRecord> All(DemoTerrain terrain) => DemoTerrain.Blocks.Select(block => Block(terrain, block.X, block.Y));

    private static LandBlock Block(DemoTerrain terrain, int x, int y)
    {
        var (column, row) = DemoTerrain.OriginOf(x, y);
        var words = ImmutableArray.CreateBuilder<ushort>(LandBlock.VertexCount);
        var heights = ImmutableArray.CreateBuilder<byte>(LandBlock.VertexCount);
        for (int i = 0; i < LandBlock.Side; i++)
        {
            for (int j = 0; j < LandBlock.Side; j++)
            {
                words.Add(terrain.Word(column + i, row + j));
                heights.Add(terrain.HeightIndex(column + i, row + j));
            }
        }

        return new() { Id = DatIds.LandBlock(x, y), Terrain = words.MoveToImmutable(), Heights = heights.MoveToImmutable() };
    }
}
