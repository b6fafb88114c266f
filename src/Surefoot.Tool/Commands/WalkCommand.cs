using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Physics.Motion;
using Surefoot.Tool.Output;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot walk</c>: a scripted walk, as a table, as JSON or as a picture.</summary>
internal static class WalkCommand
{
    private const int MaxSkill = 10_000;
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<string> at = new("--at")
        {
            Description = "Where to begin: a named place, or a cell id and metres: 0xA9B40001,12,12,0 (without the last, on the ground).",
            DefaultValueFactory = _ => "meadow",
        };
        Option<int> run = new("--run") { Description = "Run skill.", DefaultValueFactory = _ => 200 };
        Option<int> jump = new("--jump") { Description = "Jump skill.", DefaultValueFactory = _ => 200 };
        Option<int> burden = new("--burden")
        {
            Description = "What is carried, in burden units (strength 100 carries 15000 at full speed).",
            DefaultValueFactory = _ => 0,
        };
        Option<double> latency = new("--latency") { Description = "Milliseconds until the server answers.", DefaultValueFactory = _ => 0 };
        Option<double?> quantum = new("--quantum")
        {
            Description =
                "Milliseconds of a quantum: all are of this length, and keys act in the one that their moment falls into, as with the " +
                "page's commands. Without it, frames of 60 a second.",
        };
        Option<string?> script = new("--script")
        {
            Description = "Keys and seconds: W A S D Q E Shift Space Auto Wait, joined by + and separated by ;",
        };
        Option<FileInfo?> times = new("--times")
        {
            Description =
                "Walk again what 'surefoot connect --times' kept of a walk on a server, and say whether all places are the same bits.",
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Option<bool> csv = new("--csv") { Description = "Print every quantum as comma-separated values." };
        Option<FileInfo?> html = new("--html") { Description = "Write a self-contained picture of the path from above and in profile." };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Command command = new(
            "walk",
            "Walks a script and prints where the body was.\n\nExample:\n" +
            $"  surefoot walk --at meadow --run 300 --jump 250 --script \"{WalkScript.Example}\" --html walk.html")
        {
            at, run, jump, burden, latency, quantum, script, times, json, csv, html, dats,
        };
        command.SetAction(parsed =>
        {
            CharacterStats stats = new(
                InRange(parsed, run), InRange(parsed, jump), Burden: InRange(parsed, burden, 1_000_000));
            string? text = parsed.GetValue(script);
            FileInfo? timesFile = parsed.GetValue(times);
            if (text is null == timesFile is null)
                throw new UsageException($"give --script, for example --script \"{WalkScript.Example}\", or --times with a file.");
            IReadOnlyList<WalkLeg> legs = text is null ? [] : ParseScript(text);
            double seconds = parsed.GetRequiredValue(latency) / 1000;
            if (parsed.GetValue(json) && parsed.GetValue(csv))
                throw new UsageException("--json and --csv are two forms of the same: give one of them.");
            if (!(seconds is >= 0 and <= 60))
                throw new UsageException("--latency is between 0 and 60000 milliseconds, for example --latency 120.");
            double? quantumSeconds = parsed.GetValue(quantum) / 1000;
            if (quantumSeconds is not (null or (>= 1.0 / 30 and <= 0.2)))
                throw new UsageException("--quantum is between 33.34 and 200 milliseconds, for example --quantum 40.");
            using WalkScene scene = WalkScene.Open(parsed.GetValue(dats));
            int? different = null;
            WalkTimes? recorded = timesFile is null ? null : WalkTimes.Read(timesFile.FullName);
            WalkResult walk = recorded is not null ? WalkRunner.Replay(scene, recorded, out different) : WalkRunner.Run(
                scene, scene.FindPlace(parsed.GetRequiredValue(at)), stats, legs, text!, seconds, quantumSeconds);
            CommonOptions.SayLeftOut(scene.Simulation.World.LeftOut);
            if (parsed.GetValue(html) is { } file)
            {
                File.WriteAllText(file.FullName, WalkPicture.Render(walk, scene.GroundHeight));
                if (!parsed.GetValue(json) && !parsed.GetValue(csv)) Console.Out.WriteLine($"Picture written to {file.FullName}");
            }

            if (parsed.GetValue(json)) Console.Out.WriteLine(JsonSerializer.Serialize(ToJson(walk), Json));
            else if (parsed.GetValue(csv)) PrintCsv(walk);
            else PrintTable(walk);
            return recorded is null ? ExitCode.Done : TellSame(recorded, different);
        });
        return command;
    }

    /// <summary>Says whether the walk ended at the same bits as on the server.</summary>
    private static int TellSame(WalkTimes recorded, int? different)
    {
        CommonOptions.Say(different is { } frame
            ? string.Create(
                CultureInfo.InvariantCulture,
                $"other than on the server from frame {frame} of {recorded.Frames.Count} on: {recorded.Frames[frame].Position} there")
            : string.Create(
                CultureInfo.InvariantCulture, $"{recorded.Frames.Count} frames, every position the same bits as on the server"));
        return different is null ? ExitCode.Done : ExitCode.Failed;
    }

    private static int InRange(ParseResult parsed, Option<int> option, int max = MaxSkill)
    {
        int value = parsed.GetRequiredValue(option);
        return value >= 0 && value <= max
            ? value
            : throw new UsageException($"{option.Name} {value} is out of range: it is between 0 and {max}, for example {option.Name} 300.");
    }

    internal static IReadOnlyList<WalkLeg> ParseScript(string text)
    {
        try
        {
            return WalkScript.Parse(text);
        }
        catch (WalkScriptException e)
        {
            throw new UsageException(
                $"--script, character {e.Position + 1}: {e.Message}\n  {text}\n  {new string(' ', e.Position)}^\n" +
                $"Example: --script \"{WalkScript.Example}\"");
        }
    }

    private static void PrintTable(WalkResult walk)
    {
        Table table = new() { Border = TableBorder.Simple };
        foreach (string heading in (string[])["time", "cell", "x", "y", "z", "heading", "speed", ""])
            table.AddColumn(
                new TableColumn(heading) { Alignment = heading.Length == 0 || heading == "cell" ? Justify.Left : Justify.Right });
        double next = 0;
        foreach (WalkSample s in walk.Samples)
        {
            bool last = ReferenceEquals(s, walk.Samples[^1]);
            if (s.Time < next - 1e-6 && !last) continue;
            next = s.Time + 0.25;
            table.AddRow(
                Text(s.Time, "0.00"), $"{s.CellId:X8}", Text(s.Local.X, "0.000"), Text(s.Local.Y, "0.000"), Text(s.Local.Z, "0.000"),
                Text(s.Heading, "0.0"), Text(s.Speed, "0.00"), Footing(s));
        }

        Terminal.Write(table);
        foreach (WalkEvent e in walk.Events) Console.Out.WriteLine($"{Text(e.Time, "0.000"),8} s  {e.What}");
        Console.Out.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{walk.Distance:0.00} m over ground in {walk.Samples[^1].Time:0.00} s, mean speed {walk.MeanSpeed:0.00} m/s, " +
            $"top speed {walk.TopSpeed:0.00} m/s"));
    }

    /// <summary>
    /// Every quantum, metres in the landblock, m/s over ground, degrees; numbers that give the same single-precision value again.
    /// </summary>
    private static void PrintCsv(WalkResult walk)
    {
        Console.Out.WriteLine("time,cell,x,y,z,heading,speed,footing,charge");
        foreach (WalkSample s in walk.Samples)
            Console.Out.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{s.Time:0.####},{s.CellId:X8},{s.Local.X:R},{s.Local.Y:R},{s.Local.Z:R},{s.Heading:0.####},{s.Speed:0.#####}," +
                $"{Footing(s)},{s.Charge:0.####}"));
    }

    private static string Footing(WalkSample s) => s.OnWalkable ? "ground" : s.HasContact ? "slope" : "air";

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

    private static object ToJson(WalkResult walk) => new
    {
        walk.Place,
        walk.Script,
        walk.RunSkill,
        walk.JumpSkill,
        walk.Distance,
        walk.MeanSpeed,
        walk.TopSpeed,
        Samples = walk.Samples.Select(s => new
        {
            s.Time,
            Cell = $"{s.CellId:X8}",
            Position = (float[])[s.Local.X, s.Local.Y, s.Local.Z],
            s.Heading,
            s.Speed,
            s.OnWalkable,
            s.HasContact,
            s.Charge,
        }),
        walk.Events,
    };
}
