using BenchmarkDotNet.Attributes;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>One quantum of 1/30 s of a running player with skill 300.</summary>
[MemoryDiagnoser]
[StateHashes]
public class QuantumBenchmarks
{
    private DatSet dats = null!;
    private SceneRun run = null!;

    /// <summary>The scenes.</summary>
    public static IEnumerable<string> Names => Scenes.Scene.Players.Select(scene => scene.Name);

    /// <summary>What the player does.</summary>
    [ParamsSource(nameof(Names))]
    public string Scene { get; set; } = "flat";

    /// <summary>Puts the player in its place.</summary>
    [GlobalSetup]
    public void Setup()
    {
        dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        run = Scenes.Scene.Find(Scene).Begin(dats);
    }

    /// <summary>Closes the files.</summary>
    [GlobalCleanup]
    public void Cleanup() => dats.Dispose();

    /// <summary>One quantum.</summary>
    [Benchmark]
    public void Advance() => run.AdvanceQuantum();
}
