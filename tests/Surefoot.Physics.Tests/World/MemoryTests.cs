using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Runs alone: it looks at the whole heap.</summary>
[CollectionDefinition(nameof(MemoryTests), DisableParallelization = true)]
[Collection(nameof(MemoryTests))]
public sealed class MemoryTests(FirstWorld files) : IClassFixture<FirstWorld>
{
    [Fact]
    [Behaviour("world.loading.memory", "design: a loaded landblock retains under 64 KiB without its shared assets")]
    public void A_loaded_block_retains_less_than_64_KiB()
    {
        files.Load(FirstWorld.Blocks);
        PhysicsWorld world = files.Empty();
        foreach (uint id in FirstWorld.Blocks)
        {
            long before = GC.GetTotalMemory(true);
            world.LoadLandblock(id);
            long retained = GC.GetTotalMemory(true) - before;
            Assert.True(retained < 64 * 1024,
                $"block {id:X8} with {world.FindLandblock(id)!.StaticObjects.Count} objects retains {retained} bytes");
        }
    }
}
