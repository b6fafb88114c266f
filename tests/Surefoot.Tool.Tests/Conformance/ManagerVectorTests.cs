using Surefoot.Tool.Conformance;

namespace Surefoot.Tool.Tests.Conformance;

/// <summary>Replays recorded runs of the managers that move other bodies.</summary>
public class ManagerVectorTests
{
    [Theory, Behaviour("conformance.managers", "recorded runs of the managers, equal to the tolerances of their recording")]
    [InlineData("interpolation")]
    [InlineData("sticky")]
    [InlineData("constraint")]
    [InlineData("move-to")]
    [InlineData("target")]
    [InlineData("timestamps")]
    public void Recorded_runs_of_the_managers_come_out_the_same(string family)
    {
        ConformanceReport report = Replay(family);
        ManagerScore score = report.Managers[family];
        Assert.True(score.CasesEqual == score.Cases, $"{score.CasesEqual} of {score.Cases} runs equal:\n{Differences(report)}");
        Assert.True(score.Cases > 100);
    }

    /// <summary>These demand the exact arithmetic; whoever rounds elsewhere fails them.</summary>
    [Theory, Behaviour("conformance.managers-to-the-last-bit", "recorded runs of the managers that hang on the last bit of a float")]
    [InlineData("sticky", 5)]
    [InlineData("move-to", 24)]
    [InlineData("target", 1)]
    public void Recorded_runs_that_hang_on_a_last_bit_come_out_the_same(string family, int cases)
    {
        ConformanceReport report = Replay(family);
        ManagerScore score = report.Managers[family];
        Assert.Equal(cases, score.TightCases);
        Assert.True(score.TightCasesEqual == cases, Differences(report));
    }

    private static ConformanceReport Replay(string family)
    {
        using ConformanceRun run = new(null, new SceneFilter(null));
        run.Add(Repository.PathOf("tests", "data", "remote-vectors", $"{family}-1.jsonl.gz"), static (_, _) => { });
        return run.Report;
    }

    private static string Differences(ConformanceReport report) =>
        string.Join('\n', report.Divergences.Select(d => $"{d.CaseId} {d.Scene} #{d.Index}: {d.Detail}"));
}
