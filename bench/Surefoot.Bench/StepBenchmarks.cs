using BenchmarkDotNet.Attributes;
using Surefoot.Client;

namespace Surefoot.Bench;

/// <summary>One quantum of 1/30 s of a running player with skill 300.</summary>
[MemoryDiagnoser]
public class StepBenchmarks
{
    private DemoScene scene = null!;

    /// <summary>What the player does.</summary>
    [Params("flat", "hills", "unwalkable slope", "falling")]
    public string Scene { get; set; } = "flat";

    /// <summary>Puts the player in its place.</summary>
    [GlobalSetup]
    public void Setup() => scene = Scene switch
    {
        "flat" => new DemoScene("runway", MovementKeys.Forward),
        "hills" => new DemoScene("hills", MovementKeys.Forward),
        "unwalkable slope" => new DemoScene("slope-50", MovementKeys.Forward),
        _ => new DemoScene("meadow", MovementKeys.None, height: 30),
    };

    /// <summary>Takes it out again.</summary>
    [GlobalCleanup]
    public void Cleanup() => scene.Dispose();

    /// <summary>One quantum.</summary>
    [Benchmark]
    public void Step() => scene.Step();
}
