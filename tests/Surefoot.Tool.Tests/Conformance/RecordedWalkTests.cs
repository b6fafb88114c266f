using Surefoot.Tool.Conformance;

namespace Surefoot.Tool.Tests.Conformance;

/// <summary>Replays the recorded walks of <c>tests/data/vectors</c> in the world they were recorded in.</summary>
public class RecordedWalkTests
{
    private static readonly string[] Files = ["walk-11.jsonl.gz", "walk-12.jsonl.gz", "walk-13.jsonl.gz"];

    [Theory, Behaviour("conformance.walks", "recorded walks, corrected to the retail rules")]
    [InlineData("outdoor")]
    [InlineData("border")]
    [InlineData("scenery")]
    [InlineData("statics")]
    [InlineData("house")]
    [InlineData("dungeon")]
    public void Recorded_walks_come_out_the_same(string scenes)
    {
        using ConformanceRun run = new(new DirectoryInfo(Repository.PathOf("tests", "data", "worlds", "first")), new SceneFilter(scenes));
        foreach (string file in Files.Take(Fuzz.Cases(1)))
            run.Add(Repository.PathOf("tests", "data", "vectors", file), static (_, _) => { });
        ConformanceReport report = run.Report;
        Assert.NotEmpty(report.Scenes);
        foreach ((string name, SceneScore reseated, SceneScore free) in report.Scenes)
        {
            Assert.True(reseated.QuantaEqual >= 0.997 * reseated.Quanta,
                $"{name}: {reseated.QuantaEqual} of {reseated.Quanta} quanta equal re-seated");
            Assert.True(free.CasesEqual >= 0.98 * free.Cases, $"{name}: {free.CasesEqual} of {free.Cases} cases equal free-running");
        }
    }
}
