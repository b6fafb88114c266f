using System.Text.Json;
using System.Text.Json.Nodes;
using Surefoot.Tool.Conformance;

namespace Surefoot.Tool.Tests.Commands;

/// <summary><c>surefoot conform</c>, run as a process.</summary>
public sealed class ConformTests : IDisposable
{
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-conform");

    private static string World => Repository.PathOf("tests", "data", "worlds", "first");

    public void Dispose() => folder.Delete(recursive: true);

    [Fact, Behaviour("tool.conform.departures-beside-cases", "design.md, The tool")]
    public async Task A_list_of_departures_among_the_vectors_is_read_beside_its_cases()
    {
        string vectors = Repository.PathOf("tests", "data", "oracle-vectors");
        CommandLine.Outcome run = await CommandLine.RunAsync(
            "conform", "--json", "--dats", Repository.PathOf("tests", "data", "worlds", "oracle"),
            Path.Combine(vectors, "departures-201.jsonl.gz"), Path.Combine(vectors, "placement-201.jsonl.gz"));
        Assert.Equal((0, ""), (run.ExitCode, run.Error));
        using JsonDocument report = JsonDocument.Parse(run.Output);
        Assert.Equal(0, report.RootElement.GetProperty("reseated").GetProperty("cases").GetInt32());
        Assert.Equal(55, report.RootElement.GetProperty("oracle").GetProperty("placement").GetProperty("listed").GetInt32());
    }

    [Fact, Behaviour("tool.conform.families", "design.md, The tool")]
    public async Task Families_are_told_apart_by_the_files_themselves_and_a_folder_stands_for_its_files()
    {
        Copy("constraint-1.jsonl.gz", "remote-vectors");
        Copy("timestamps-1.jsonl.gz", "remote-vectors");
        Copy("wrong-password.jsonl.gz", "wire-captures");
        Copy("wrong-password.expected.json.gz", "wire-captures");
        CommandLine.Outcome run = await CommandLine.RunAsync("conform", "--json", folder.FullName);
        Assert.Equal((0, ""), (run.ExitCode, run.Error));
        using JsonDocument report = JsonDocument.Parse(run.Output);
        JsonElement[] families = [.. report.RootElement.GetProperty("families").EnumerateArray()];
        Assert.Equal(["constraint", "timestamps", "sessions"], families.Select(f => f.GetProperty("family").GetString()));
        Assert.All(families, family => Assert.Equal(family.GetProperty("compared").GetInt32(), family.GetProperty("equal").GetInt32()));
        Assert.All(families, family => Assert.Equal(100, family.GetProperty("required").GetDouble()));
        Assert.Equal(168, families[0].GetProperty("compared").GetInt32());
    }

    [Fact, Behaviour("tool.conform.threshold", "less than what is required exits with 1")]
    public async Task A_share_below_what_is_required_exits_with_one_and_says_which_family()
    {
        JsonNode walk = FirstCase("vectors", "walk-11.jsonl.gz");
        JsonArray quanta = walk["steps"]!.AsArray();
        quanta[^1]!["pos"]!.AsArray()[0] = quanta[^1]!["pos"]![0]!.GetValue<float>() + 1;
        string file = Write("walk.jsonl", walk);
        CommandLine.Outcome below = await CommandLine.RunAsync("conform", "--dats", World, file);
        Assert.Equal(1, below.ExitCode);
        double share = Math.Floor(10_000.0 * (quanta.Count - 1) / quanta.Count) / 100;
        string[] expected =
        [
            $"surefoot: walks: {share:0.00} % of re-seated quanta equal, 99.9 % required",
            "surefoot: walks: 0.00 % of free-running walks equal, 99.9 % required",
        ];
        Assert.Equal(expected, below.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains($"#{quanta.Count - 1} Position", below.Output, StringComparison.Ordinal);
        Assert.Equal(0, (await CommandLine.RunAsync("conform", "--dats", World, file, "--require", "0")).ExitCode);
        Assert.Equal(1, (await CommandLine.RunAsync("conform", "--dats", World, file, "--require", "0.1")).ExitCode);
    }

    [Fact, Behaviour("tool.conform.last-bit-apart", "data/remote-vectors, Comparing: runs with tight are reported apart")]
    public async Task Runs_that_hang_on_a_last_bit_are_counted_apart()
    {
        IEnumerable<string> recorded = Lines("remote-vectors", "target-1.jsonl.gz");
        JsonNode run = JsonNode.Parse(recorded.First(line => line.Contains("\"tight\":1", StringComparison.Ordinal)))!;
        JsonNode state = run["steps"]![0]!["out"]!["s"]!.AsObject().First().Value!;
        state["pos"]!.AsArray()[0] = state["pos"]![0]!.GetValue<float>() + 1;
        CommandLine.Outcome apart = await CommandLine.RunAsync("conform", "--json", Write("target.jsonl", run));
        Assert.Equal(0, apart.ExitCode);
        using JsonDocument report = JsonDocument.Parse(apart.Output);
        JsonElement score = report.RootElement.GetProperty("managers").GetProperty("target");
        int[] counts = [.. ((string[])["cases", "tightCases", "tightCasesEqual"]).Select(name => score.GetProperty(name).GetInt32())];
        Assert.Equal([0, 1, 0], counts);

        run["tight"] = 0;
        CommandLine.Outcome counted = await CommandLine.RunAsync("conform", Write("target.jsonl", run));
        Assert.Equal((1, "surefoot: target: 0.00 % of runs equal, 100 % required"), (counted.ExitCode, counted.Error.Trim()));
    }

    [Fact, Behaviour("tool.conform.sessions", "data/wire-captures")]
    public async Task A_session_in_which_a_byte_is_another_is_not_what_a_decoder_has_to_find()
    {
        string[] lines = [.. Lines("wire-captures", "wrong-password.jsonl.gz")];
        JsonNode first = JsonNode.Parse(lines[0])!;
        string hex = first["hex"]!.GetValue<string>();
        first["hex"] = hex[..^2] + (hex.EndsWith("00", StringComparison.Ordinal) ? "01" : "00");
        string file = Path.Combine(folder.FullName, "wrong-password.jsonl");
        await File.WriteAllLinesAsync(file, [first.ToJsonString(), .. lines[1..]], TestContext.Current.CancellationToken);
        CommandLine.Outcome alone = await CommandLine.RunAsync("conform", file);
        Assert.Equal(1, alone.ExitCode);
        Assert.Contains("wrong-password.expected.json", alone.Error, StringComparison.Ordinal);

        Copy("wrong-password.expected.json.gz", "wire-captures");
        CommandLine.Outcome run = await CommandLine.RunAsync("conform", file);
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("surefoot: sessions:", run.Error, StringComparison.Ordinal);
        Assert.Contains("wrong-password datagram #0 Result: .payloadHash", run.Output, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.conform.scene", "a scene that matches nothing is wrong usage")]
    public async Task A_scene_that_matches_nothing_is_told_with_the_scenes_that_there_are()
    {
        string file = Repository.PathOf("tests", "data", "remote-vectors", "constraint-1.jsonl.gz");
        CommandLine.Outcome none = await CommandLine.RunAsync("conform", file, "--scene", "nowhere");
        Assert.Equal(2, none.ExitCode);
        string tag = FirstCase("remote-vectors", "constraint-1.jsonl.gz")["tag"]!.GetValue<string>();
        Assert.Contains("'nowhere'", none.Error, StringComparison.Ordinal);
        Assert.Contains(tag, none.Error, StringComparison.Ordinal);
        Assert.Equal(0, (await CommandLine.RunAsync("conform", file, "--scene", tag)).ExitCode);
    }

    [Theory, Behaviour("tool.conform.usage", "design.md, The tool")]
    [InlineData("--require", "101", "0 to 100")]
    [InlineData("--require", "-1", "0 to 100")]
    [InlineData("--require", "many", "0 to 100")]
    [InlineData("--worst", "many", "many")]
    public async Task Options_that_make_no_sense_are_wrong_usage(string option, string value, string hint)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("conform", folder.FullName, option, value);
        Assert.Equal(2, run.ExitCode);
        Assert.Contains(hint, run.Error, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.conform.empty-folder", "design.md, The tool")]
    public async Task A_folder_without_recordings_says_what_it_looked_for()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("conform", folder.FullName);
        Assert.Equal(2, run.ExitCode);
        Assert.Contains("*.jsonl.gz", run.Error, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.conform.reads-once", "each file is opened once")]
    public async Task Recordings_are_read_once_so_that_a_pipe_will_do()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "there is no /dev/stdin on Windows");
        string[] cases = [.. Lines("remote-vectors", "constraint-1.jsonl.gz").Take(3)];
        CommandLine.Outcome run = await CommandLine.RunWithInputAsync(string.Join('\n', cases), "conform", "--json", "/dev/stdin");
        Assert.Equal((0, ""), (run.ExitCode, run.Error));
        using JsonDocument report = JsonDocument.Parse(run.Output);
        Assert.Equal(3, report.RootElement.GetProperty("managers").GetProperty("constraint").GetProperty("cases").GetInt32());
    }

    [Theory, Behaviour("tool.conform.damaged-vectors", "design.md, decision 7")]
    [InlineData("", "empty")]
    [InlineData("{", "line 1")]
    [InlineData("[]", "line 1")]
    [InlineData("{}", "not a recorded walk")]
    [InlineData("""{"family":"sticky"}""", "not a recorded run")]
    [InlineData("""{"family":"swimming"}""", "swimming")]
    [InlineData("""{"family":"walk"}""", "not a recorded result")]
    [InlineData(
        """{"id":"","scene":"","setup":"0200000100","placed":"","place":{"cell":"A9B40001","pos":[1,2,3],"yaw":0}}""", "eight digits")]
    [InlineData("""{"id":"","scene":"","setup":"0200FFFF","placed":"","place":{"cell":"A9B40001","pos":[1,2,3],"yaw":0}}""", "0200FFFF")]
    [InlineData("""{"id":"","scene":"","setup":"02000001","placed":"","place":{"cell":"A9B40001","pos":[1,2],"yaw":0}}""", "3 numbers")]
    public async Task Vectors_that_cannot_be_read_are_one_line_that_names_the_file_and_the_line(string content, string hint)
    {
        string file = Path.Combine(folder.FullName, "walk.jsonl");
        await File.WriteAllTextAsync(file, content, TestContext.Current.CancellationToken);
        CommandLine.Outcome run = await CommandLine.RunAsync("conform", "--dats", World, file);
        Assert.Equal(1, run.ExitCode);
        Assert.Single(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains("walk.jsonl", run.Error, StringComparison.Ordinal);
        Assert.Contains(hint, run.Error, StringComparison.Ordinal);
    }

    private static IEnumerable<string> Lines(string set, string name)
    {
        using VectorFile file = VectorFile.Open(Repository.PathOf("tests", "data", set, name));
        return [.. file.Read(line => line)];
    }

    private static JsonNode FirstCase(string set, string name) => JsonNode.Parse(Lines(set, name).First())!;

    private string Write(string name, JsonNode one)
    {
        string path = Path.Combine(folder.FullName, name);
        File.WriteAllText(path, one.ToJsonString());
        return path;
    }

    private void Copy(string name, string set) =>
        File.Copy(Repository.PathOf("tests", "data", set, name), Path.Combine(folder.FullName, name));
}
