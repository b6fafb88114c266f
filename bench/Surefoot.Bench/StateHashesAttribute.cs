using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Reports;
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
    public IConfig Config { get; } = ManualConfig.CreateEmpty().AddColumn(new Column());

    private sealed class Column : IColumn
    {
        public string Id => nameof(StateHashesAttribute);

        public string ColumnName => "State hash";

        public string Legend => "Hash of the states after every quantum of the scene; tests/data/state-hashes.txt has those on record";

        public bool AlwaysShow => true;

        public ColumnCategory Category => ColumnCategory.Custom;

        public int PriorityInCategory => 0;

        public bool IsNumeric => false;

        public UnitType UnitType => UnitType.Dimensionless;

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase)
        {
            using DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
            return $"{Scene.Find((string)benchmarkCase.Parameters[nameof(QuantumBenchmarks.Scene)]).Hash(dats):x16}";
        }

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase, SummaryStyle style) => GetValue(summary, benchmarkCase);

        public bool IsAvailable(Summary summary) => true;

        public bool IsDefault(Summary summary, BenchmarkCase benchmarkCase) => false;
    }
}
