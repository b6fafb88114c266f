using BenchmarkDotNet.Attributes;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>A crowd of 200 humans in the meadow who run in circles and into each other: what a tick costs one of them.</summary>
[MemoryDiagnoser]
[StateHashes]
public class CrowdBenchmarks
{
    private DatSet dats = null!;
    private SceneRun run = null!;

    /// <summary>The scenes.</summary>
    public static IEnumerable<string> Names => Scenes.Scene.Crowds.Select(scene => scene.Name);

    /// <summary>How far they stand apart; a body is 0.96 m wide.</summary>
    [ParamsSource(nameof(Names))]
    public string Scene { get; set; } = "";

    /// <summary>Spawns them and lets them mix.</summary>
    [GlobalSetup]
    public void Setup()
    {
        dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        run = Scenes.Scene.Find(Scene).Begin(dats);
        for (int i = 0; i < 60; i++) run.AdvanceQuantum();
    }

    /// <summary>Closes the files.</summary>
    [GlobalCleanup]
    public void Cleanup() => dats.Dispose();

    /// <summary>One tick of all, divided by their number.</summary>
    [Benchmark(OperationsPerInvoke = Runners.CrowdSize)]
    public void Tick() => run.AdvanceQuantum();
}
