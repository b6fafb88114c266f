using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Landblock A9B4 as records, flat at height 0 with nothing on it until a test adds to it. Height index k is k metres.</summary>
internal sealed class WorldRecords
{
    internal const uint Block = 0xA9B4FFFF, Info = 0xA9B4FFFE, Scene = 0x12000001;

    /// <summary>Terrain word of ground on which <see cref="Scene"/> grows: type 1, scenery 2.</summary>
    internal const ushort Wooded = (1 << 2) | (2 << 11);

    private readonly MemorySource source = new();

    /// <summary>Ids of the scenes that may grow on wooded ground.</summary>
    internal uint[] Scenes { get; set; } = [Scene];

    /// <summary>The ground.</summary>
    /// <param name="word">Terrain word of a vertex.</param>
    /// <param name="height">Height index of a vertex.</param>
    /// <param name="info">There is an info record.</param>
    internal WorldRecords Ground(Func<int, int, int>? word = null, Func<int, int, int>? height = null, bool info = false)
    {
        ushort[] words = new ushort[81];
        byte[] heights = new byte[81];
        for (int k = 0; k < 81; k++)
        {
            words[k] = (ushort)(word?.Invoke(k / 9, k % 9) ?? 0);
            heights[k] = (byte)(height?.Invoke(k / 9, k % 9) ?? 0);
        }

        return Add(new LandBlock { Id = Block, InfoFlag = info ? 1u : 0, Terrain = [.. words], Heights = [.. heights] });
    }

    internal WorldRecords Add(params DatRecord[] records)
    {
        source.Add(records);
        return this;
    }

    internal WorldRecords Add(uint id, params byte[] bytes)
    {
        source.Add(id, bytes);
        return this;
    }

    /// <summary>The block, loaded.</summary>
    internal Landblock Load() => World().FindLandblock(Block)!;

    /// <summary>A world with the block.</summary>
    internal PhysicsWorld World()
    {
        Region region = new()
        {
            Id = 0x13000000,
            HeightTable = [.. Enumerable.Range(0, 256).Select(k => (float)k)],
            SceneTypes = [new SceneType(SceneType.NoSound, [.. Scenes])],
            TerrainTypes = [new TerrainType("bare", default, []), new TerrainType("wood", default, [0xFFFFFFFF, 7, 0])],
        };
        PhysicsWorld world = new(new PhysicsDataCache(source), new RegionAsset(region, source));
        Assert.True(world.LoadLandblock(Block));
        return world;
    }

    internal static DatFrame At(float x, float y, float z = 0) => new(new Vector3(x, y, z), Quaternion.Identity);
}
