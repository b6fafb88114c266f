using System.Collections.Immutable;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Records;

/// <summary>Land block records.</summary>
internal static class LandRecords
{
    /// <summary>The record of a block.</summary>
    public static LandBlock Block(DemoTerrain terrain, int x, int y, bool hasInfo)
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

        return new()
        {
            Id = DatIds.LandBlock(x, y),
            InfoFlag = hasInfo ? 1u : 0u,
            Terrain = words.MoveToImmutable(),
            Heights = heights.MoveToImmutable(),
        };
    }

    /// <summary>A block of open sea, around a dungeon.</summary>
    public static LandBlock Sea(uint id) => new()
    {
        Id = id,
        InfoFlag = 1,
        Terrain = [.. Enumerable.Repeat(LandBlock.TerrainWord(0, (int)TerrainKind.WaterDeepSea, 0), LandBlock.VertexCount)],
        Heights = [.. new byte[LandBlock.VertexCount]],
    };
}
