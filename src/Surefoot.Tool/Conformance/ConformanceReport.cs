using Surefoot.Tool.Conformance.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>How much of a scene came out the same.</summary>
internal sealed class SceneScore
{
    /// <summary>Walks replayed.</summary>
    public int Cases { get; private set; }

    /// <summary>Walks equal from start to end.</summary>
    public int CasesEqual { get; private set; }

    /// <summary>Steps replayed.</summary>
    public int Steps { get; private set; }

    /// <summary>Steps equal.</summary>
    public int StepsEqual { get; private set; }

    internal void Add(int steps, int equal, bool whole)
    {
        Cases++;
        Steps += steps;
        StepsEqual += equal;
        if (whole) CasesEqual++;
    }
}

/// <summary>The scores of a set of walks, scene by scene.</summary>
internal sealed class ConformanceReport
{
    private readonly SortedDictionary<string, (SceneScore Reseated, SceneScore Free)> scenes = new(StringComparer.Ordinal);

    internal SceneScore Reseated { get; } = new();

    internal SceneScore FreeRunning { get; } = new();

    /// <summary>First divergence of each walk that diverges when re-seated, then of those that diverge only free-running.</summary>
    internal List<Divergence> Divergences { get; } = [];

    internal IEnumerable<(string Name, SceneScore Reseated, SceneScore Free)> Scenes => scenes.Select(s => (s.Key, s.Value.Reseated, s.Value.Free));

    internal void Add(WalkCase walk, WalkReplay replay)
    {
        if (!scenes.TryGetValue(walk.Scene, out var scene)) scenes[walk.Scene] = scene = (new SceneScore(), new SceneScore());
        var reseated = replay.Run(walk, reseat: true);
        var free = replay.Run(walk, reseat: false);
        scene.Reseated.Add(reseated.Steps, reseated.Equal, reseated.First is null);
        Reseated.Add(reseated.Steps, reseated.Equal, reseated.First is null);
        scene.Free.Add(free.Steps, free.Equal, free.First is null);
        FreeRunning.Add(free.Steps, free.Equal, free.First is null);
        if ((reseated.First ?? free.First) is { } divergence) Divergences.Add(divergence);
    }

    /// <summary>Results of a peer as it is, by family; those listed as changed by known departures are counted apart.</summary>
    internal SortedDictionary<string, OracleScore> Oracle { get; } = new(StringComparer.Ordinal);

    internal void Add(OracleReplay.Result result, bool listed)
    {
        if (!Oracle.TryGetValue(result.Family, out OracleScore? score)) Oracle[result.Family] = score = new OracleScore();
        score.Add(listed, result.Difference is null);
        if (listed || result.Difference is not { } difference) return;
        if (result.Departure is { } departure) score.Count(departure);
        Divergences.Add(new Divergence(
            result.Id, $"{result.Family} {result.Tag}", result.Step, StepDifference.Result, result.Departure is null ? difference : $"{difference} ({result.Departure})"));
    }

    /// <summary>Runs of the managers that move other bodies, by family.</summary>
    internal SortedDictionary<string, ManagerScore> Managers { get; } = new(StringComparer.Ordinal);

    internal void Add(ManagerResult result)
    {
        if (!Managers.TryGetValue(result.Family, out ManagerScore? score)) Managers[result.Family] = score = new ManagerScore();
        score.Add(result);
        if (result.Difference is not { } difference) return;
        string tight = result.IsTight ? " (hangs on a last bit)" : "";
        Divergences.Add(new Divergence(result.Id, $"{result.Family} {result.Tag}", result.Equal, StepDifference.Result, difference + tight));
    }

    internal object ToJson() => new
    {
        FreeRunning = Score(FreeRunning, s => s.Free),
        Reseated = Score(Reseated, s => s.Reseated),
        Oracle,
        Managers,
    };

    private object Score(SceneScore all, Func<(SceneScore Reseated, SceneScore Free), SceneScore> pick) => new
    {
        all.Cases,
        all.CasesEqual,
        all.Steps,
        all.StepsEqual,
        Scenes = scenes.ToDictionary(s => s.Key, s => pick(s.Value)),
    };
}

/// <summary>How many runs of a family of managers came out the same; those that hang on the last bit of a float are counted apart.</summary>
internal sealed class ManagerScore
{
    /// <summary>Runs replayed.</summary>
    public int Cases { get; private set; }

    /// <summary>Of those, equal to the end.</summary>
    public int CasesEqual { get; private set; }

    /// <summary>Their steps.</summary>
    public int Steps { get; private set; }

    /// <summary>Steps before the first that differs.</summary>
    public int StepsEqual { get; private set; }

    /// <summary>Runs that hang on a last bit.</summary>
    public int TightCases { get; private set; }

    /// <summary>Of those, equal to the end.</summary>
    public int TightCasesEqual { get; private set; }

    internal void Add(ManagerResult result)
    {
        int equal = result.Difference is null ? 1 : 0;
        if (result.IsTight)
        {
            TightCases++;
            TightCasesEqual += equal;
            return;
        }

        Cases++;
        CasesEqual += equal;
        Steps += result.Steps;
        StepsEqual += result.Equal;
    }
}

/// <summary>How many results of a family came out the same.</summary>
internal sealed class OracleScore
{
    /// <summary>Results that no known departure changes.</summary>
    public int Results { get; private set; }

    /// <summary>Of those, equal.</summary>
    public int ResultsEqual { get; private set; }

    /// <summary>Results that known departures of the peer change.</summary>
    public int Listed { get; private set; }

    /// <summary>Of those, differing as foreseen.</summary>
    public int ListedDiffering { get; private set; }

    /// <summary>Of the unlisted results that differ, those for which the mover's state says why, by reason.</summary>
    public SortedDictionary<string, int> Explained { get; } = new(StringComparer.Ordinal);

    internal void Count(string departure) => Explained[departure] = Explained.GetValueOrDefault(departure) + 1;

    internal void Add(bool listed, bool equal)
    {
        if (listed)
        {
            Listed++;
            if (!equal) ListedDiffering++;
        }
        else
        {
            Results++;
            if (equal) ResultsEqual++;
        }
    }
}
