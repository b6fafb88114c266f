using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;

namespace Surefoot.Bench;

/// <summary>A column of the summary that says something of each case by itself.</summary>
/// <param name="name">Its heading.</param>
/// <param name="legend">What it says.</param>
/// <param name="isNumeric">It is set as numbers are.</param>
/// <param name="value">What it says of a case.</param>
internal sealed class CaseColumn(string name, string legend, bool isNumeric, Func<BenchmarkCase, string> value) : IColumn
{
    public string Id => name;

    public string ColumnName => name;

    public string Legend => legend;

    public bool AlwaysShow => true;

    public ColumnCategory Category => ColumnCategory.Custom;

    public int PriorityInCategory => 0;

    public bool IsNumeric => isNumeric;

    public UnitType UnitType => UnitType.Dimensionless;

    public string GetValue(Summary summary, BenchmarkCase benchmarkCase) => value(benchmarkCase);

    public string GetValue(Summary summary, BenchmarkCase benchmarkCase, SummaryStyle style) => value(benchmarkCase);

    public bool IsAvailable(Summary summary) => true;

    public bool IsDefault(Summary summary, BenchmarkCase benchmarkCase) => false;
}
