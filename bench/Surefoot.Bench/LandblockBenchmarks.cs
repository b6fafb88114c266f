using BenchmarkDotNet.Attributes;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Bench;

/// <summary>Loading one landblock of the demo world from its file.</summary>
[MemoryDiagnoser]
public class LandblockBenchmarks
{
    private DatSet dats = null!;
    private PhysicsWorld world = null!;
    private uint block;

    /// <summary>Opens the files.</summary>
    [GlobalSetup]
    public void Setup()
    {
        dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        world = new PhysicsEngine(new PhysicsDataCache(dats)).World;
        block = DemoPlaces.All[0].CellId;
    }

    /// <summary>Closes them.</summary>
    [GlobalCleanup]
    public void Cleanup() => dats.Dispose();

    /// <summary>Loads a block and unloads it again.</summary>
    [Benchmark]
    public void LoadAndUnload()
    {
        world.LoadLandblock(block);
        world.UnloadLandblock(block);
    }
}
