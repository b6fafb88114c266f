using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Running;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>Prints beside each timing the state hash of its scene: two tables with other hashes did not time the same thing.</summary>
[AttributeUsage(AttributeTargets.Class)]
internal sealed class StateHashesAttribute : Attribute, IConfigSource
{
    /// <inheritdoc/>
    public IConfig Config { get; } = ManualConfig.CreateEmpty().AddColumn(new CaseColumn(
        "State hash",
        "Hash of the states after every quantum of the scene; tests/data/state-hashes.txt has those on record",
        isNumeric: false,
        HashOf));

    private static string HashOf(BenchmarkCase one)
    {
        using DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        return $"{Scene.Find((string)one.Parameters[nameof(QuantumBenchmarks.Scene)]).Hash(dats):x16}";
    }
}
