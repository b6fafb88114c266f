using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Surefoot.DemoWorld;
using Surefoot.Tool.Tests.Commands;

namespace Surefoot.Tool.Tests.Samples;

/// <summary>The programs of <c>samples/</c>, run on the demo world.</summary>
public partial class SampleTests
{
    private const double RunSpeed = 10.6;

    [Theory, Behaviour("samples.small", "a sample is read in one sitting: under 120 lines")]
    [InlineData("Walker")]
    [InlineData("ClaimServer")]
    [InlineData("Surveyor")]
    public void A_sample_has_less_than_120_lines(string name)
    {
        string[] sources = Directory.GetFiles(Repository.PathOf("samples", name), "*.cs");
        Assert.InRange(sources.Sum(path => File.ReadAllLines(path).Length), 20, 119);
    }

    [Theory, Behaviour("samples.usage", "design.md, decision 7")]
    [InlineData("Walker")]
    [InlineData("ClaimServer")]
    [InlineData("Surveyor")]
    public async Task A_sample_without_a_world_says_how_it_is_called_or_what_is_missing(string name)
    {
        CommandLine.Outcome usage = await Sample.RunAsync(name, null);
        Assert.NotEqual(0, usage.ExitCode);
        Assert.NotEmpty(usage.Error);
        CommandLine.Outcome missing = await Sample.RunAsync(name, null, Path.Combine(Sample.World, "nowhere"));
        Assert.Equal(1, missing.ExitCode);
        Assert.Contains("There is no folder", missing.Error, StringComparison.Ordinal);
    }

    [Fact, Behaviour("samples.walker", "spec/01, 4.1: 10.6 m/s at a run skill of 300")]
    public async Task The_walker_runs_and_jumps_where_the_keys_say()
    {
        CommandLine.Outcome run = await Sample.RunAsync("Walker", "wwwwww w xw", Sample.World, "0xA9B50032,156,24");
        Assert.Equal(("", 0), (run.Error, run.ExitCode));
        string[] lines = run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal(1 + "wwwwww w ".Length, lines.Length);
        Assert.InRange(NorthOf(lines[6]) - NorthOf(lines[2]), RunSpeed * 0.95, RunSpeed * 1.05);
        Assert.Contains("in the air", lines[8], StringComparison.Ordinal);
    }

    [Fact, Behaviour("samples.surveyor.land", "a foot of radius 0.48 m at 0.475 m rests 0.005 m above level ground")]
    public async Task The_surveyor_says_where_a_human_lands()
    {
        NamedPlace meadow = Sample.PlaceOf("meadow");
        CommandLine.Outcome land = await Sample.RunAsync("Surveyor", null, Sample.World, "land", meadow.Words(up: 40));
        Assert.Equal(("", 0), (land.Error, land.ExitCode));
        Assert.StartsWith("lands 39.995 m below", land.Output, StringComparison.Ordinal);
        Assert.Contains($"on Ground of 0x{meadow.CellId:X8}, 0.0°", land.Output, StringComparison.Ordinal);
    }

    [Theory, Behaviour("samples.surveyor.block", "docs/demo-world.md: the yards of steps and slopes")]
    [InlineData("steps-50", 9, 0, "^walks all 9 m, to 0x")]
    [InlineData("steps-50", 10, 1, "^blocked after 9.[0-9] of 10 m, at 0x.*, by the edge of Object 0x")]
    [InlineData("steps-70", 10, 1, "^blocked after [0-9.]+ of 10 m, at 0x.*, by Object 0x[0-9A-F]{8}, 90.0°")]
    [InlineData("slope-48-3", 10, 0, "^walks all 10 m, to 0x")]
    [InlineData("slope-50", 10, 1, "^blocked after [0-9.]+ of 10 m, at 0x.*, by Ground of 0x[0-9A-F]{8}, 50.0° .too steep.")]
    public async Task The_surveyor_says_what_blocks_the_way(string name, int metres, int code, string said)
    {
        NamedPlace place = Sample.PlaceOf(name);
        CommandLine.Outcome way = await Sample.RunAsync(
            "Surveyor", null, Sample.World, "block", place.Words(), place.Heading.ToString(CultureInfo.InvariantCulture), $"{metres}");
        Assert.Equal(("", code), (way.Error, way.ExitCode));
        Assert.Matches(said, way.Output);
    }

    [Theory, Behaviour("samples.surveyor.map", "the runway's block is level meadow; the sea is the end of the world")]
    [InlineData("0xA8B4", 95, 100)]
    [InlineData("0xA5B4", 0, 0)]
    public async Task The_surveyor_draws_the_walkable_ground_of_a_landblock(string block, double least, double most)
    {
        string file = Path.GetTempFileName();
        try
        {
            CommandLine.Outcome map = await Sample.RunAsync("Surveyor", null, Sample.World, "map", block, file);
            Assert.Equal(("", 0), (map.Error, map.ExitCode));
            double share = double.Parse(map.Output.Split(' ')[0], CultureInfo.InvariantCulture);
            Assert.InRange(share, least, most);

            // The drawing covers the whole block, and as much of it is green.
            XElement[] areas = [.. XDocument.Load(file).Root!.Elements().Where(e => e.Name.LocalName == "rect")];
            int Area(IEnumerable<XElement> some) => some.Sum(e => int.Parse(e.Attribute("width")!.Value, CultureInfo.InvariantCulture));
            Assert.Equal(96 * 96, Area(areas));
            Assert.Equal(share, 100.0 * Area(areas.Where(e => e.Attribute("fill")!.Value == "#8fbf6a")) / (96 * 96), 0.05);
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Fact, Behaviour("samples.claim-server", "what a client walks is accepted; too fast and through walls is not")]
    public async Task The_server_accepts_what_a_client_tells_and_refuses_what_cannot_be()
    {
        using Process server = Process.Start(WithOutput(Sample.Start("ClaimServer", Sample.World)))!;
        try
        {
            string? listening = await server.StandardOutput.ReadLineAsync(TestContext.Current.CancellationToken);
            using TcpClient client = new();
            await client.ConnectAsync(IPEndPoint.Parse(listening!["listening on ".Length..]), TestContext.Current.CancellationToken);
            using StreamReader reader = new(client.GetStream());
            await using StreamWriter writer = new(client.GetStream()) { AutoFlush = true };
            async Task<string> SayAsync(string line)
            {
                await writer.WriteLineAsync(line);
                return (await reader.ReadLineAsync())!;
            }

            const string keys = "keys 0 45000005,0,0,2,1";
            Assert.Equal("error: enter first", await SayAsync("claim 1 - 0xA9B50032,156,25"));
            NamedPlace corner = Sample.PlaceOf("corners");
            Assert.StartsWith($"at 0x{corner.CellId:X8},", await SayAsync($"enter 300 250 {corner.Words()}"), StringComparison.Ordinal);
            ClaimLines told = ClaimLines.OfAWalk(corner);
            Assert.True(told.Lines.Count > 5);
            foreach (string line in told.Lines) Assert.StartsWith("accepted ", await SayAsync(line), StringComparison.Ordinal);

            Assert.StartsWith("at 0x", await SayAsync($"enter 300 250 {corner.Words()}"), StringComparison.Ordinal);
            Assert.StartsWith("accepted ", await SayAsync($"{keys} {corner.Words()},0"), StringComparison.Ordinal);
            string behind = (corner with { Origin = corner.Origin + new System.Numerics.Vector3(0, 15, 0) }).Words();
            Assert.Matches("^refused 0x.*: ThroughWall$", await SayAsync($"claim 2 - {behind},0"));

            NamedPlace runway = Sample.PlaceOf("runway");
            Assert.StartsWith("at 0x", await SayAsync($"enter 300 250 {runway.Words()}"), StringComparison.Ordinal);
            Assert.StartsWith("accepted ", await SayAsync($"{keys} {runway.Words()},0"), StringComparison.Ordinal);
            string far = (runway with { Origin = runway.Origin + new System.Numerics.Vector3(0, 35, 0) }).Words();
            Assert.Matches("^refused 0x.*: TooFast$", await SayAsync($"claim 0.1 - {far},0"));
            Assert.StartsWith("error: ", await SayAsync("claim NaN - 0xA9B50032,156,25"), StringComparison.Ordinal);
            Assert.StartsWith("error: ", await SayAsync("claim 1 - 0xFFFF0001,NaN,0"), StringComparison.Ordinal);
            Assert.StartsWith("error: ", await SayAsync("keys 1 2 0xA9B50032,156,25"), StringComparison.Ordinal);
            Assert.StartsWith("error: ", await SayAsync("give me gold"), StringComparison.Ordinal);
        }
        finally
        {
            server.Kill();
        }
    }

    private static ProcessStartInfo WithOutput(ProcessStartInfo start)
    {
        start.RedirectStandardOutput = true;
        return start;
    }

    private static double NorthOf(string line) => double.Parse(North().Match(line).Groups[1].Value, CultureInfo.InvariantCulture);

    [GeneratedRegex(@"\[\S+ (\S+) \S+\]")]
    private static partial Regex North();
}
