using System.Text.Json;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Tool.Network;
using Surefoot.Tool.Tests.Commands;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Tests.Network;

/// <summary>A runner in one world, drawn in another that hears of it over a bad network.</summary>
public class NetworkRunTests
{
    private static readonly NetworkQuality Bad = new(delay: 0.2, jitter: 0.1, loss: 0.05, duplication: 0.02);

    private static NetworkFigures Run(int seed, double minutes, NetworkQuality? quality = null, double pace = 1)
    {
        using WalkScene scene = WalkScene.Open(null);
        List<ScenePlace> way = [scene.FindPlace("gaps"), scene.FindPlace("long-stair"), scene.FindPlace("platform")];
        return NetworkRun.Run(scene, new NetworkTrial(way, new CharacterStats(200, 200), quality ?? Bad, seed, minutes * 60)
        {
            Detail = BroadcastDetail.Full,
            Pace = pace,
        });
    }

    [Theory]
    [Behaviour("remote.followed-over-a-bad-network", "spec/09, 3.2 (5 cm) and 4.3; spec/08, 2.6; design, acceptance: dead reckoning")]
    [InlineData(1)]
    [InlineData(38)]
    [InlineData(75)]
    public void A_runner_is_drawn_near_its_path_rests_where_it_reported_and_is_never_in_a_solid(int seed)
    {
        NetworkFigures run = Run(seed, minutes: 10);
        Assert.True(run.Resent > 0 && run.Jumps > 0 && run.Climbed > 6 && run.PlacesReached > 3, $"{run.Jumps} jumps, {run.Climbed} m");
        Assert.InRange(run.AtRest.Count, 5, 1000);
        // On this way the placement test refuses it nowhere.
        Assert.Empty(run.InSolid);
        Assert.Equal((run.Frames, 0), (run.Judged, run.Swept));
        Assert.InRange(run.WorstAtRest, 0, 0.05);
        Assert.InRange(run.P95OffPath, 0, 1);
        Assert.True(run.IsGood);
    }

    [Fact]
    [Behaviour("remote.followed-restless-hands", "design, acceptance: dead reckoning; docs/testing.md")]
    public void A_runner_who_changes_its_mind_every_second_is_drawn_near_its_path()
    {
        NetworkFigures run = Run(2, minutes: 5, pace: 4);
        Assert.True(run.Jumps > 10, $"{run.Jumps} jumps");
        Assert.Empty(run.InSolid);
        Assert.InRange(run.P95OffPath, 0, 1);
    }

    [Fact]
    [Behaviour("remote.followed-same-seed", "design, decision 5")]
    public void The_same_seed_draws_the_same()
    {
        NetworkFigures one = Run(4, minutes: 0.5), same = Run(4, minutes: 0.5);
        Assert.Equal(one.OffPath, same.OffPath);
        Assert.Equal(one.Resent, same.Resent);
    }

    [Fact]
    [Behaviour("remote.followed-without-delay", "spec/09, 5.4: it does what the message says")]
    public void Over_a_perfect_network_a_runner_is_drawn_on_its_path()
    {
        NetworkFigures run = Run(5, minutes: 1, new NetworkQuality(0));
        Assert.Equal(0, run.Resent);
        // One frame late, a runner of 9.5 m/s starts and turns off the path by less than that frame's way.
        Assert.InRange(run.P95OffPath, 0, 9.5 / 30);
    }

    [Fact]
    [Behaviour("remote.figures", "the figures' own definitions")]
    public void Figures_are_those_of_their_numbers()
    {
        double[] off = [.. Enumerable.Range(1, 100).Select(i => i / 100.0)];
        RestDistance near = new(0.05, 0.3, 0), apart = new(0.25, 0.05, 0.25), blocked = new(0.19, 0.19, 0.051);
        RestDistance far = new(0.5, 0.051, 0.5), lazy = new(0.19, 0.19, 0.05);
        Assert.Equal([false, true, true, false, false], new[] { near, apart, blocked, far, lazy }.Select(one => one.IsExcused));
        RestDistance[] rests = [near, apart, apart, blocked, .. Enumerable.Repeat(near, 96)];
        NetworkFigures figures = new(100, rests, off, 100, [], 0, 3, 1, 1, 1, 1, 1, Seconds: 600);
        Assert.Equal((0.95, 1.0), (figures.P95OffPath, figures.MaxOffPath));
        Assert.Equal(0.505, figures.MeanOffPath, 9);
        Assert.Equal((0.05, 2, 1), (figures.WorstAtRest, figures.StepsApart, figures.Blocked));
        Assert.Equal(18, figures.BlipsAnHour);
        Assert.True(figures.IsGood);
        Assert.Equal(0.5, (figures with { AtRest = [near, far] }).WorstAtRest);
        Assert.False((figures with { AtRest = [far] }).IsGood);
        Assert.False((figures with { AtRest = [near, lazy] }).IsGood);
        Assert.False((figures with { AtRest = [.. figures.AtRest, apart] }).IsGood);
        Assert.False((figures with { AtRest = [.. figures.AtRest, blocked] }).IsGood);
        Assert.True((figures with { AtRest = [near, apart, apart, blocked] }).IsGood);
        RestDistance[] four = [apart, apart, apart, blocked];
        Assert.True((figures with { AtRest = [.. four, .. Enumerable.Repeat(near, 196)] }).IsGood);
        Assert.False((figures with { AtRest = [.. four, .. Enumerable.Repeat(near, 195)] }).IsGood);
        Assert.False((figures with { InSolid = ["there"] }).IsGood);
        Assert.False((figures with { OffPath = [1, 1] }).IsGood);
    }

    [Fact]
    [Behaviour("remote.figures-path", "the figures' own definitions")]
    public void The_path_is_that_of_the_last_second_and_goes_on_between_its_points()
    {
        RecentPath path = new();
        for (int i = 0; i <= 20; i++) path.Add(At(i, 0), now: i * 0.1);
        Assert.Equal(3, path.DistanceTo(At(15.5f, 3)), 5);
        Assert.Equal(5, path.DistanceTo(At(25, 0)), 5);
        Assert.Equal(10, path.DistanceTo(At(0, 0)), 5);

        static Position At(float x, float y) => new(0xA9B40001, new System.Numerics.Vector3(x, y, 0));
    }

    [Fact]
    [Behaviour("tool.network.as-json", "design.md, The tool")]
    public async Task The_command_prints_its_figures_as_one_object()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync(
            "network", "--minutes", "0.5", "--delay", "50", "--jitter", "0", "--loss", "0", "--duplicates", "1", "--json");
        Assert.Equal(0, run.ExitCode);
        using JsonDocument parsed = JsonDocument.Parse(run.Output);
        JsonElement root = parsed.RootElement;
        Assert.True(root.GetProperty("good").GetBoolean());
        Assert.Equal(0.05, root.GetProperty("network").GetProperty("delay").GetDouble());
        Assert.Equal(0.01, root.GetProperty("network").GetProperty("duplication").GetDouble());
        Assert.InRange(root.GetProperty("offPath").GetProperty("p95").GetDouble(), 0, 1);
        Assert.InRange(root.GetProperty("seconds").GetDouble(), 30, 30.1);
    }

    [Fact]
    [Behaviour("tool.network.table", "design.md, The tool")]
    public async Task The_command_prints_a_table_and_fails_where_a_figure_does()
    {
        // On so bad a network, of a server that tells little, nobody is drawn near its path.
        CommandLine.Outcome run = await CommandLine.RunAsync(
            "network", "--minutes", "1", "--delay", "900", "--jitter", "800", "--loss", "40", "--live");
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("off the path, p95", run.Output, StringComparison.Ordinal);
        Assert.Contains("blips", run.Output, StringComparison.Ordinal);
    }
}
