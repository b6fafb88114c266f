using System.Globalization;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Grounds for tests.</summary>
internal static class Ground
{
    internal static TerrainSurface Of(uint block, Func<int, int, float> height, Func<int, int, int>? word = null)
    {
        float[] heights = new float[TerrainSurface.VertexCount];
        ushort[] words = new ushort[TerrainSurface.VertexCount];
        for (int i = 0; i < 9; i++)
        {
            for (int j = 0; j < 9; j++)
            {
                heights[(9 * i) + j] = height(i, j);
                words[(9 * i) + j] = (ushort)(word?.Invoke(i, j) ?? 0);
            }
        }

        return new TerrainSurface(block, heights, words);
    }

    internal static TerrainSurface Flat(uint block, float height = 0, int type = 0) => Of(block, (_, _) => height, (_, _) => type << 2);

    /// <summary>Flat but for one cell with the corner heights SW, SE, NW, NE.</summary>
    internal static TerrainSurface WithCell(uint block, int i, int j, float[] corners) => Of(
        block, (x, y) => x - i is 0 or 1 && y - j is 0 or 1 ? corners[(x - i) + (2 * (y - j))] : 0);

    /// <summary>The waters of specification 05, 6.8.</summary>
    internal static TerrainSurface Pond() => Of(0xA9B40000, (_, _) => 0, (i, j) => ((i, j) switch
    {
        (0 or 1, 0 or 1) => 16,
        (2, 2) => 20,
        (3, 2) => 21,
        (2, 3) => 15,
        _ => 0,
    }) << 2);

    internal static float[] Numbers(string list) =>
        Array.ConvertAll(list.Split(','), text => float.Parse(text, CultureInfo.InvariantCulture));
}
