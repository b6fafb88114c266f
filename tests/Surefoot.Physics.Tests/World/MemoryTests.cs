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
            // Other tests allocate meanwhile: the least of some tries is the block's own.
            long retained = long.MaxValue;
            for (int attempt = 0; attempt < 5 && retained >= 64 * 1024; attempt++)
            {
                world.UnloadLandblock(id);
                long before = GC.GetTotalMemory(true);
                world.LoadLandblock(id);
                retained = GC.GetTotalMemory(true) - before;
            }

            Assert.True(retained < 64 * 1024,
                $"block {id:X8} with {world.FindLandblock(id)!.StaticObjects.Count} objects retains {retained} bytes");
        }
    }
}
