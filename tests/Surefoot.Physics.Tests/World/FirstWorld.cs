using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>
/// The test world of <c>tests/data/worlds/first</c>: 5 × 5 landblocks A7B2 to ABB6 with a ring of plain ones, two houses, a dungeon in
/// 0105.
/// </summary>
public sealed class FirstWorld : IDisposable
{
    public const uint SouthWest = 0xA7B20000;
    public const uint DungeonBlock = 0x01050000;

    private readonly DatSet dats = DatSet.Open(Repository.PathOf("tests", "data", "worlds", "first"));

    public FirstWorld()
    {
        Cache = new PhysicsDataCache(dats);
        Region = RegionAsset.Load(dats);
    }

    internal IDatSource Source => dats;

    internal PhysicsDataCache Cache { get; }

    internal RegionAsset Region { get; }

    /// <summary>Ids of the 5 × 5 blocks.</summary>
    internal static uint[] Blocks { get; } =
        [.. from x in Enumerable.Range(0, 5) from y in Enumerable.Range(0, 5) select SouthWest + ((uint)x << 24) + ((uint)y << 16)];

    internal PhysicsWorld Empty() => new(Cache, Region);

    internal PhysicsWorld Load(params IEnumerable<uint> blocks)
    {
        PhysicsWorld world = Empty();
        foreach (uint block in blocks) Assert.True(world.LoadLandblock(block));
        return world;
    }

    public void Dispose() => dats.Dispose();
}
