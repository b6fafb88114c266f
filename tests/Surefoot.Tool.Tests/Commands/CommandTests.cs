using System.Text.Json;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Motion;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>The command, run as a process.</summary>
public class CommandTests
{
    private static string InRepository(string argument) =>
        argument.StartsWith("tests/", StringComparison.Ordinal) ? Repository.PathOf(argument.Split('/')) : argument;

    private static string World => Repository.PathOf("tests", "data", "worlds", "first");

    [Theory, Behaviour("tool.help.has-an-example", "design.md, The tool")]
    [InlineData]
    [InlineData("play")]
    [InlineData("walk")]
    [InlineData("dats")]
    [InlineData("dats", "list")]
    [InlineData("dats", "show")]
    [InlineData("dats", "verify")]
    [InlineData("demo")]
    [InlineData("demo", "write")]
    [InlineData("demo", "map")]
    [InlineData("conform")]
    [InlineData("network")]
    [InlineData("authority")]
    [InlineData("sniff")]
    [InlineData("demo", "rows")]
    public async Task Every_command_explains_itself_with_an_example(params string[] command)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync([.. command, "--help"]);
        Assert.Equal(0, run.ExitCode);
        Assert.Contains("Example:", run.Output, StringComparison.Ordinal);
    }

    [Theory, Behaviour("tool.usage.exits-with-two", "design.md, The tool")]
    [InlineData("walk", "--script", "W 1; W+Jmp 2", "character 8")]
    [InlineData("walk", "--script", "W 1", "--at", "medow", "meadow")]
    [InlineData("walk", "--script", "W 1", "--run", "-5", "--run 300")]
    [InlineData("walk", "--script", "W 1", "--jump", "99999", "--jump 300")]
    [InlineData("walk", "--script", "W 1", "--at", "0xA9B4FFFF,12,12,0", "0xA9B40001")]
    [InlineData("walk", "--script", "W 1", "--at", "0xFEFE0001,999,12,0", "outside the map")]
    [InlineData("walk", "--script", "W 1", "--at", "0x01230001,12,12,0", "has no cell 0x01230001")]
    [InlineData("walk", "--script", "W 1", "--at", "0xA9B403FF,12,12,0", "has no cell 0xA9B403FF")]
    [InlineData("walk", "--script", "W 1", "--json", "--csv", "one of them")]
    [InlineData("walk", "--script", "W 1", "--quantum", "20", "--quantum 40")]
    [InlineData("walk", "--script", "W 1", "--quantum", "NaN", "--quantum 40")]
    [InlineData("dats", "list", ".", "--type", "Sandwich", "Setup")]
    [InlineData("walk", "script")]
    [InlineData("play", "--port", "99999", "65535")]
    [InlineData("play", "--server", "127.0.0.1:99999", "1 to 65534")]
    [InlineData("play", "--server", "127.0.0.1:9000", "--account", "", "--password-file",
        "tests/data/README.md", "1 to 50 printable")]
    [InlineData("connect", "--server", "127.0.0.1:9000", "--account", "a", "--character", "A", "--page", "--json", "--password-file",
        "tests/data/README.md", "--page goes with")]
    [InlineData("fly", "fly")]
    [InlineData("authority", "--hours", "0", "--hours 2")]
    [InlineData("authority", "--hours", "NaN", "--hours 2")]
    [InlineData("network", "--loss", "101", "--loss 5")]
    [InlineData("network", "--delay", "NaN", "--delay 200")]
    [InlineData("network", "--minutes", "0", "--minutes 10")]
    [InlineData("network", "--way", "long-stair", "two places or more")]
    [InlineData("network", "--way", "long-stair;platfrom", "platform")]
    [InlineData("sniff", "session.pcap", "--port", "70000", "65534")]
    [InlineData("serve", "--metrics", "-5", "--metrics 9100")]
    [InlineData("serve", "--json", "give both")]
    [InlineData("serve", "--stats", "--every", "-1", "--every 10")]
    [InlineData("serve", "--start", "0xA9B40001,12", "a cell and metres")]
    [InlineData("serve", "--start", "medow", "meadow")]
    [InlineData("conform", "tests/data/vectors/walk-11.jsonl.gz", "--dats")]
    public async Task Wrong_usage_says_what_is_right_and_exits_with_two(params string[] commandAndHint)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync([.. commandAndHint[..^1].Select(InRepository)]);
        Assert.Equal(2, run.ExitCode);
        Assert.Contains(commandAndHint[^1], run.Error, StringComparison.Ordinal);
    }

    [Theory, Behaviour("tool.dats.missing-folder-says-what-to-do", "design.md, decision 7")]
    [InlineData("walk", "--script", "W 1", "--dats")]
    [InlineData("play", "--no-browser", "--dats")]
    [InlineData("dats", "verify")]
    public async Task A_folder_without_dat_files_is_one_line_that_says_how_to_get_a_world(params string[] command)
    {
        DirectoryInfo empty = Directory.CreateTempSubdirectory("surefoot-empty");
        try
        {
            CommandLine.Outcome run = await CommandLine.RunAsync([.. command, empty.FullName]);
            Assert.Equal(1, run.ExitCode);
            Assert.Single(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
            Assert.Contains("client_portal.dat", run.Error, StringComparison.Ordinal);
            Assert.Contains("surefoot demo write", run.Error, StringComparison.Ordinal);
        }
        finally
        {
            empty.Delete(recursive: true);
        }
    }

    [Theory, Behaviour("tool.no-motion-table", "spec/07, 9.1")]
    [InlineData("walk", "--script", "W 1", "--at", "0xA9B40001,12,12,0", "--dats")]
    [InlineData("play", "--no-browser", "--port", "0", "--dats")]
    public async Task A_human_without_a_motion_table_is_one_sentence(params string[] command)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync([.. command, World]);
        Assert.Equal(1, run.ExitCode);
        Assert.Equal("surefoot: Setup 0x02000001 names no motion table, and such a body cannot walk by itself.", run.Error.Trim());
    }

    [Fact, Behaviour("tool.left-out.told-once", "spec/07, 9.1")]
    public async Task What_damaged_files_make_the_world_do_without_is_told_once_and_listed_by_verify()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-damaged");
        try
        {
            DemoWorldBuilder.Write(folder.FullName);
            DamageRooms(folder.FullName, 0xA8B50000);
            CommandLine.Outcome walk = await CommandLine.RunAsync(
                "walk", "--script", "W 1", "--at", "0xA8B50001,12,12,30", "--dats", folder.FullName);
            Assert.Equal(0, walk.ExitCode);
            string line = Assert.Single(walk.Error.Split('\n'), one => one.Contains("A8B50100", StringComparison.Ordinal));
            Assert.StartsWith("surefoot: left out: ", line, StringComparison.Ordinal);

            CommandLine.Outcome verify = await CommandLine.RunAsync("dats", "verify", folder.FullName, "--json");
            Assert.Equal(1, verify.ExitCode);
            using JsonDocument summary = JsonDocument.Parse(verify.Output);
            JsonElement item = summary.RootElement.GetProperty("leftOut").GetProperty("items")[0];
            Assert.Equal(("Room", "A8B50100"), (item.GetProperty("kind").GetString(), item.GetProperty("id").GetString()));
            Assert.Equal(("A8B5FFFE", DatSet.CellName), (item.GetProperty("firstIn").GetString(), item.GetProperty("file").GetString()));
            Assert.Equal(0, item.GetProperty("offset").GetInt32());
            Assert.Equal(1, summary.RootElement.GetProperty("leftOut").GetProperty("total").GetInt32());
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    /// <summary>The first room of a block becomes bytes that no room has.</summary>
    private static void DamageRooms(string folder, uint block)
    {
        using DatFileEditor editor = DatFileEditor.Open(Path.Combine(folder, DatSet.CellName));
        editor.Put(block | 0x100, [0xFF, 0xFF, 0xFF]);
        editor.Complete();
    }

    [Fact, Behaviour("tool.walk.runs-at-the-formulas-speed", "spec/01, 4.1 and 6")]
    public async Task A_scripted_run_covers_the_formulas_distance()
    {
        using JsonDocument walk = await WalkAsync("--at", "runway", "--run", "300", "--script", "W 3");
        JsonElement[] samples = [.. walk.RootElement.GetProperty("samples").EnumerateArray()];
        JsonElement first = samples.First(s => s.GetProperty("time").GetDouble() >= 1), last = samples[^1];
        double seconds = last.GetProperty("time").GetDouble() - first.GetProperty("time").GetDouble();
        double metres = samples.SkipWhile(s => s.GetProperty("time").GetDouble() <= first.GetProperty("time").GetDouble())
            .Sum(s => s.GetProperty("speed").GetDouble()) * seconds /
                        samples.Count(s => s.GetProperty("time").GetDouble() > first.GetProperty("time").GetDouble());
        Assert.InRange(metres / seconds, 10.6 * 0.98, 10.6 * 1.02);
    }

    [Fact, Behaviour("tool.walk.jumps", "spec/01, 4.12")]
    public async Task A_scripted_jump_is_told_with_its_extent_and_velocity()
    {
        using JsonDocument walk = await WalkAsync("--at", "meadow", "--jump", "300", "--script", "Space 1.2; Wait 3");
        string[] events = [.. walk.RootElement.GetProperty("events").EnumerateArray().Select(e => e.GetProperty("what").GetString()!)];
        Assert.Contains(events, e => e.StartsWith("sends Jump: extent 1.000, velocity (0.00, 0.00, 9.09)", StringComparison.Ordinal));
        Assert.Contains("leaves the ground", events);
    }

    [Fact, Behaviour("tool.walk.csv", "design.md, The tool")]
    public async Task Every_quantum_is_a_line_of_comma_separated_values()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("walk", "--at", "meadow", "--script", "W 1", "--csv");
        string[] lines = run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Equal("time,cell,x,y,z,heading,speed,footing,charge", lines[0]);
        Assert.All(lines, line => Assert.Equal(8, line.Count(c => c == ',')));
        Assert.InRange(lines.Length, 20, 32);
    }

    [Fact, Behaviour("tool.walk.tells-the-mean-speed", "design.md, The tool")]
    public async Task The_mean_speed_is_the_way_over_ground_divided_by_the_time()
    {
        using JsonDocument walk = await WalkAsync("--at", "runway", "--run", "300", "--script", "W 2; Wait 2");
        JsonElement root = walk.RootElement;
        double seconds = root.GetProperty("samples")[root.GetProperty("samples").GetArrayLength() - 1].GetProperty("time").GetDouble();
        Assert.Equal(root.GetProperty("distance").GetDouble() / seconds, root.GetProperty("meanSpeed").GetDouble(), 9);
        Assert.True(root.GetProperty("meanSpeed").GetDouble() < root.GetProperty("topSpeed").GetDouble());
    }

    [Fact, Behaviour("tool.output.fits-a-pipe", "design.md, The tool")]
    public async Task A_table_without_a_terminal_has_a_row_a_line_unless_a_width_is_asked_for()
    {
        CommandLine.Outcome piped = await CommandLine.RunAsync(columns: null, "walk", "--at", "meadow", "--script", "W 1");
        Assert.Contains(
            piped.Output.Split('\n'),
            line => line.Contains("ground", StringComparison.Ordinal) && line.Contains("A9B5", StringComparison.Ordinal));
        CommandLine.Outcome narrow = await CommandLine.RunAsync(columns: 40, "walk", "--at", "meadow", "--script", "W 1");
        string[] rows = narrow.Output.Split('\n')[..^6];
        Assert.All(rows.TakeWhile(line => !line.Contains(" s  ", StringComparison.Ordinal)), line => Assert.True(line.Length <= 40, line));
    }

    [Fact, Behaviour("tool.places.one-cell", "a place on a cell's edge has one cell id everywhere")]
    public async Task Whoever_stands_at_a_named_place_is_in_the_cell_that_the_list_names()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("demo", "places", "--json");
        using JsonDocument list = JsonDocument.Parse(run.Output);
        using WalkScene scene = WalkScene.Open(null);
        Assert.Equal(DemoPlaces.All.Length, list.RootElement.GetProperty("places").GetArrayLength());
        foreach (JsonElement place in list.RootElement.GetProperty("places").EnumerateArray())
        {
            string name = place.GetProperty("name").GetString()!, cell = place.GetProperty("cell").GetString()!;
            WalkResult stand = WalkRunner.Run(scene, scene.FindPlace(name), new CharacterStats(), WalkScript.Parse("Wait 0.1"), "Wait 0.1",
                0);
            Assert.Equal($"{name} {cell}", $"{name} {stand.Samples[0].CellId:X8}");
            Assert.Equal(scene.FindPlace(name).Place, scene.FindPlace(place.GetProperty("title").GetString()!).Place);
        }
    }

    [Fact, Behaviour("tool.demo.arrows", "spec/06, 7: what a missile hits; design.md, The tool")]
    public async Task The_butts_of_the_demo_world_shoot_and_every_hit_is_told_with_place_and_normal()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("demo", "arrows", "--seconds", "3", "--json");
        Assert.Equal(ExitCode.Done, run.ExitCode);
        using JsonDocument told = JsonDocument.Parse(run.Output);
        JsonElement[] hits = [.. told.RootElement.GetProperty("hits").EnumerateArray()];
        // Every 2 s and every 1.5 s, from the first frame on; the last ones arrive in time.
        Assert.Equal((4, 4), (told.RootElement.GetProperty("shots").GetInt32(), hits.Length));
        Assert.All(hits, hit => Assert.Equal([0.0, -1.0, 0.0], hit.GetProperty("normal").EnumerateArray().Select(one => one.GetDouble())));
        Assert.Equal(["bow", "spell-trap"], hits.Select(hit => hit.GetProperty("shooter").GetString()).Distinct().Order());

        foreach (string wrong in (string[])["0", "-1", "NaN", "1e9"])
            Assert.Equal(ExitCode.Usage, (await CommandLine.RunAsync("demo", "arrows", "--seconds", wrong)).ExitCode);
    }

    [Fact, Behaviour("tool.walk.draws-a-picture", "design.md, The tool")]
    public async Task A_walk_draws_a_self_contained_picture()
    {
        string file = Path.Combine(Directory.CreateTempSubdirectory("surefoot-picture").FullName, "walk.html");
        try
        {
            CommandLine.Outcome run = await CommandLine.RunAsync("walk", "--script", "W 2; W+Space 0.6; W 1", "--html", file);
            Assert.Equal(0, run.ExitCode);
            string html = await File.ReadAllTextAsync(file);
            Assert.Contains("path from above", html, StringComparison.Ordinal);
            Assert.Contains("path in profile", html, StringComparison.Ordinal);
            Assert.DoesNotContain("http", html, StringComparison.Ordinal);
        }
        finally
        {
            Directory.GetParent(file)!.Delete(recursive: true);
        }
    }

    [Fact, Behaviour("tool.dats.verifies-a-foreign-world", "spec/07")]
    public async Task Every_record_of_a_world_written_by_another_library_is_identical_after_encoding()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("dats", "verify", World, "--json");
        Assert.Equal(0, run.ExitCode);
        using JsonDocument summary = JsonDocument.Parse(run.Output);
        Assert.Equal(0, summary.RootElement.GetProperty("different").GetInt32());
        Assert.Equal(0, summary.RootElement.GetProperty("failed").GetInt32());
        Assert.True(summary.RootElement.GetProperty("identical").GetInt32() > 100);
    }

    [Fact, Behaviour("tool.dats.shows-a-record", "spec/07, 7.6")]
    public async Task A_record_is_shown_as_text_and_as_json()
    {
        CommandLine.Outcome text = await CommandLine.RunAsync("dats", "show", World, "02000001");
        Assert.Equal(0, text.ExitCode);
        Assert.Contains("0.48", text.Output, StringComparison.Ordinal);
        CommandLine.Outcome json = await CommandLine.RunAsync("dats", "show", World, "0x02000001", "--json");
        using JsonDocument record = JsonDocument.Parse(json.Output);
        Assert.Equal(JsonValueKind.Object, record.RootElement.ValueKind);
        Assert.Equal(1, (await CommandLine.RunAsync("dats", "show", World, "02FFFFFF")).ExitCode);
        Assert.Equal(2, (await CommandLine.RunAsync("dats", "show", World, "xyz")).ExitCode);
    }

    [Fact, Behaviour("tool.demo.writes-readable-files", "spec/07")]
    public async Task The_demo_world_is_written_as_files_that_verify()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-demo");
        try
        {
            Assert.Equal(0, (await CommandLine.RunAsync("demo", "write", folder.FullName)).ExitCode);
            Assert.Equal(0, (await CommandLine.RunAsync("dats", "verify", folder.FullName)).ExitCode);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static async Task<JsonDocument> WalkAsync(params string[] arguments)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync(["walk", "--json", .. arguments]);
        Assert.True(run.ExitCode == 0, run.Error);
        return JsonDocument.Parse(run.Output);
    }
}
