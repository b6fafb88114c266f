using System.Globalization;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>
/// Two threads that sweep in the same block of one world, against each alone. A turn is three windows of half a millisecond: one thread
/// alone, the other alone, both at once. The columns have what counts, the rates: of each kind the best window of all turns, so that what
/// else the machine does counts for little, and of the turns one by one the median ratio.
/// </summary>
[InProcess]
[WarmupCount(2)]
[IterationCount(20)]
[InvocationCount(200)]
[SweepRates]
public class TwoThreadBenchmarks
{
    private readonly SweepRates rates = new();
    private DatSet dats = null!;
    private SweepWorkers workers = null!;

    /// <summary>Where they run side by side, 4 m apart: each is in the list of the cells that the other's sweeps test.</summary>
    [Params("runway", "forest")]
    public string Place { get; set; } = "";

    /// <summary>Lets two players run, and starts the threads.</summary>
    [GlobalSetup]
    public void Setup()
    {
        dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        workers = new SweepWorkers(new ProbeRun(dats, Place, 2, 4f));
        for (int i = 0; i < 200; i++) workers.Measure(0, 1);
        SweepRates.Of[Place] = rates;
    }

    /// <summary>Ends the threads and closes the files.</summary>
    [GlobalCleanup]
    public void Cleanup()
    {
        workers.Dispose();
        dats.Dispose();
    }

    /// <summary>One turn.</summary>
    [Benchmark]
    public void Turn() => rates.Add(workers.Measure(0), workers.Measure(1), workers.Measure(0, 1));
}

/// <summary>What the turns of one place measured, sweeps in a millisecond.</summary>
internal sealed class SweepRates
{
    private readonly List<double> ratios = [];

    /// <summary>Turns in which both threads swept at the same time.</summary>
    internal int Turns => ratios.Count;

    /// <summary>By place. The benchmark runs in the process that prints the table.</summary>
    internal static Dictionary<string, SweepRates> Of { get; } = [];

    internal double One { get; private set; }

    internal double Other { get; private set; }

    internal double Both { get; private set; }

    /// <summary>The middle one of the ratios of the turns.</summary>
    internal double MedianRatio => ratios.Count == 0 ? double.NaN : ratios.Order().ElementAt(ratios.Count / 2);

    internal void Add(double one, double other, double both)
    {
        if (double.IsNaN(both)) return;
        One = Math.Max(One, one);
        Other = Math.Max(Other, other);
        Both = Math.Max(Both, both);
        ratios.Add(both / (one + other));
    }
}

/// <summary>Prints the rates.</summary>
[AttributeUsage(AttributeTargets.Class)]
internal sealed class SweepRatesAttribute : Attribute, IConfigSource
{
    /// <inheritdoc/>
    public IConfig Config { get; } = ManualConfig.CreateEmpty().AddColumn(
        Rates("One alone /ms", rates => rates.One, "0"), Rates("Other alone /ms", rates => rates.Other, "0"),
        Rates("Both /ms", rates => rates.Both, "0"), Rates("Both / sum", rates => rates.Both / (rates.One + rates.Other), "0.00"),
        Rates("Median of turns", rates => rates.MedianRatio, "0.00"), Rates("Turns", rates => rates.Turns, "0"));

    private static CaseColumn Rates(string name, Func<SweepRates, double> value, string format) => new(
        name,
        "Sweeps, best of all windows; ratios of rates",
        isNumeric: true,
        one => SweepRates.Of.TryGetValue((string)one.Parameters[nameof(TwoThreadBenchmarks.Place)], out SweepRates? rates)
            ? value(rates).ToString(format, CultureInfo.InvariantCulture)
            : "-");
}
