using System.Numerics;
using BenchmarkDotNet.Attributes;
using Surefoot.Client;

namespace Surefoot.Bench;

/// <summary>One quantum of 1/30 s of a running player with skill 300.</summary>
[MemoryDiagnoser]
public class StepBenchmarks
{
    private static readonly Dictionary<string, DemoAct> Acts = new()
    {
        ["flat"] = new("runway", MovementKeys.Forward),
        ["hills"] = new("hills", MovementKeys.Forward),
        ["unwalkable slope"] = new("slope-50", MovementKeys.Forward),
        ["falling"] = new("meadow", MovementKeys.None) { Offset = new(0, 30), Airborne = Vector3.Zero },
        ["forest"] = new("forest", MovementKeys.Forward),
        ["town"] = new("town", MovementKeys.Forward),
        ["stairs"] = new("long-stair", MovementKeys.Forward) { Steps = 45 },
        ["corridor"] = new("dungeon-corridor", MovementKeys.Forward) { Steps = 90 },
        ["jump through a doorway"] = new("house-door", MovementKeys.Forward) { Offset = new(2, 0.05f), Airborne = new(0, 9, 1.5f), Steps = 20 },
    };

    private DemoScene scene = null!;

    /// <summary>The scenes.</summary>
    public static IEnumerable<string> Scenes => Acts.Keys;

    /// <summary>What the player does.</summary>
    [ParamsSource(nameof(Scenes))]
    public string Scene { get; set; } = "flat";

    /// <summary>Puts the player in its place.</summary>
    [GlobalSetup]
    public void Setup() => scene = new DemoScene(Acts[Scene]);

    /// <summary>Takes it out again.</summary>
    [GlobalCleanup]
    public void Cleanup() => scene.Dispose();

    /// <summary>One quantum.</summary>
    [Benchmark]
    public void Step() => scene.Step();
}
