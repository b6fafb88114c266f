using Surefoot.Tool.Conformance.Captures;
using Surefoot.Tool.Conformance.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>The scores of a set of recordings, family by family.</summary>
internal sealed class ConformanceReport
{
    private readonly SortedDictionary<string, (SceneScore Reseated, SceneScore Free)> scenes = new(StringComparer.Ordinal);

    internal SceneScore Reseated { get; } = new();

    internal SceneScore FreeRunning { get; } = new();

    /// <summary>First divergence of each walk that diverges, each other result that differs.</summary>
    internal List<Divergence> Divergences { get; } = [];

    internal IEnumerable<(string Name, SceneScore Reseated, SceneScore Free)> Scenes =>
        scenes.Select(s => (s.Key, s.Value.Reseated, s.Value.Free));

    /// <summary>Results of a peer as it is, by family; those listed as changed by known departures are counted apart.</summary>
    internal SortedDictionary<string, OracleScore> Oracle { get; } = new(StringComparer.Ordinal);

    /// <summary>Runs of the managers that move other bodies, by family.</summary>
    internal SortedDictionary<string, ManagerScore> Managers { get; } = new(StringComparer.Ordinal);

    /// <summary>Recorded sessions.</summary>
    internal CaptureScore Captures { get; } = new();

    /// <summary>A walk that only diverges when it runs freely hangs on a last bit: from each recorded state its quantum is equal.</summary>
    internal void Add(WalkCase walk, in WalkOutcome reseated, in WalkOutcome free)
    {
        if (!scenes.TryGetValue(walk.Scene, out var scene)) scenes[walk.Scene] = scene = (new SceneScore(), new SceneScore());
        bool quantaHold = reseated.Equal + reseated.LastBit == reseated.Quanta && reseated.First is not { Index: < 0 };
        foreach (SceneScore score in (SceneScore[])[scene.Reseated, Reseated]) score.Add(reseated, quantaHold);
        foreach (SceneScore score in (SceneScore[])[scene.Free, FreeRunning]) score.Add(free, quantaHold);
        if ((reseated.First ?? free.First) is not { } divergence) return;
        Divergences.Add(reseated.First is null ? divergence with { Reason = Divergence.LastBit } : divergence);
    }

    internal void Add(OracleResult result, bool listed)
    {
        if (!Oracle.TryGetValue(result.Family, out OracleScore? score)) Oracle[result.Family] = score = new OracleScore();
        score.Add(result, listed);
        if (listed || result.Difference is not { } difference) return;
        string? reason = result.Departure ?? (result.HangsOnLastBit ? Divergence.LastBit : null);
        string scene = $"{result.Family} {result.Tag}";
        Divergences.Add(new Divergence(result.Id, scene, result.Quantum ?? -1, StateDifference.Result, difference, reason));
    }

    internal void Add(ManagerResult result)
    {
        if (!Managers.TryGetValue(result.Family, out ManagerScore? score)) Managers[result.Family] = score = new ManagerScore();
        score.Add(result);
        if (result.Difference is not { } difference) return;
        string? reason = result.IsTight ? Divergence.LastBit : null;
        string scene = $"{result.Family} {result.Tag}";
        Divergences.Add(new Divergence(result.Id, scene, result.Equal, StateDifference.Result, difference, reason));
    }

    internal void Add(IReadOnlyCollection<CaptureResult> session)
    {
        Captures.Add(session);
        foreach (CaptureResult finding in session)
        {
            if (finding.Difference is not { } difference) continue;
            Divergences.Add(new Divergence(finding.Session, finding.What, finding.Number, StateDifference.Result, difference.TrimStart()));
        }
    }

    /// <summary>Each family against what is required of it.</summary>
    /// <param name="required">Percent required of all; null for what each family has by default.</param>
    internal List<Verdict> Judge(double? required)
    {
        List<Verdict> verdicts = [];
        if (Reseated.Cases > 0)
        {
            (int hangingQuanta, int hangingWalks) = (Reseated.QuantaLastBit, FreeRunning.CasesLastBit);
            verdicts.Add(new Verdict("walks", "re-seated quanta", Reseated.Quanta - hangingQuanta, Reseated.QuantaEqual)
            {
                Required = required ?? Verdict.Walks,
                Apart = Hanging(hangingQuanta),
            });
            verdicts.Add(new Verdict("walks", "free-running walks", FreeRunning.Cases - hangingWalks, FreeRunning.CasesEqual)
            {
                Required = required ?? Verdict.Walks,
                Apart = Hanging(hangingWalks),
            });
        }

        foreach ((string family, OracleScore score) in Oracle)
        {
            int apart = score.ResultsLastBit + score.Explained.Values.Sum();
            verdicts.Add(new Verdict($"peer's {family}", "results", score.Results - apart, score.ResultsEqual)
            {
                Required = required ?? Verdict.Oracle,
                Apart = ApartOf(score),
            });
        }

        foreach ((string family, ManagerScore score) in Managers)
        {
            string apart = score.TightCases == 0 ? "" : $"{Hanging(score.TightCases)} ({score.TightCasesEqual} of them equal)";
            verdicts.Add(new Verdict(family, "runs", score.Cases, score.CasesEqual)
            {
                Required = required ?? Verdict.Exact,
                Apart = apart,
            });
        }

        if (Captures.Sessions > 0)
        {
            verdicts.Add(new Verdict("sessions", "datagrams, verdicts, messages", Captures.Findings, Captures.FindingsEqual)
            {
                Required = required ?? Verdict.Exact,
            });
        }

        return verdicts;
    }

    /// <summary>What a program reads.</summary>
    internal object ToJson(double? required) => new
    {
        FreeRunning = Score(FreeRunning, s => s.Free),
        Reseated = Score(Reseated, s => s.Reseated),
        Oracle,
        Managers,
        Captures,
        Families = Judge(required),
        IsMet = Judge(required).TrueForAll(verdict => verdict.IsMet),
    };

    private static string Hanging(int count) => count == 0 ? "" : $"{count} {(count == 1 ? "hangs" : "hang")} on a last bit";

    private static string ApartOf(OracleScore score) => string.Join(", ", new[]
    {
        Hanging(score.ResultsLastBit),
        score.Listed == 0 ? "" : $"{score.Listed} listed as departures ({score.ListedDiffering} of them differ)",
    }.Concat(score.Explained.Select(reason => $"{reason.Key} {reason.Value}")).Where(words => words.Length > 0));

    private object Score(SceneScore all, Func<(SceneScore Reseated, SceneScore Free), SceneScore> pick) => new
    {
        all.Cases,
        all.CasesEqual,
        all.CasesLastBit,
        all.Quanta,
        all.QuantaEqual,
        all.QuantaLastBit,
        Scenes = scenes.ToDictionary(s => s.Key, s => pick(s.Value)),
    };
}
