using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Tool.Network;
using Surefoot.Tool.Output;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot network</c>: how near to a runner others draw it who hear of it over a bad network.</summary>
internal static class NetworkCommand
{
    private const string DefaultWay = "gaps;long-stair;platform";
    private const int MaxSkill = 10_000, MostMinutes = 100_000, MostMilliseconds = (int)(NetworkQuality.MostDelay * 1000);
    private const double LeastPace = 0.1, MostPace = 10;
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<string> way = new("--way")
        {
            Description = "Places to run to and fro between in straight lines, within sight of each other, joined by ';': named places, " +
                "or cell ids and metres.",
            DefaultValueFactory = _ => DefaultWay,
        };
        Option<double> minutes = new("--minutes") { Description = "How long it runs.", DefaultValueFactory = _ => 10 };
        Option<int> seed = new("--seed") { Description = "Seed of the network and of the runner's whims.", DefaultValueFactory = _ => 1 };
        Option<double> delay = new("--delay") { Description = "Milliseconds of delay, each way.", DefaultValueFactory = _ => 200 };
        Option<double> jitter = new("--jitter")
        {
            Description = "Milliseconds by which the delay varies both ways.",
            DefaultValueFactory = _ => 100,
        };
        Option<double> loss = new("--loss") { Description = "Datagrams lost, percent.", DefaultValueFactory = _ => 5 };
        Option<double> duplicates = new("--duplicates")
        {
            Description = "Datagrams that come twice, percent.",
            DefaultValueFactory = _ => 2,
        };
        Option<int> run = new("--run") { Description = "Run skill.", DefaultValueFactory = _ => 200 };
        Option<int> jump = new("--jump") { Description = "Jump skill.", DefaultValueFactory = _ => 200 };
        Option<bool> live = new("--live")
        {
            Description = "The server tells others of the runner no more than live servers do: a place with a motion once a second at " +
                "most, a jumper as standing until its keys change.",
        };
        Option<double> pace = new("--pace")
        {
            Description = "How many times as often the hands change their mind: with 1 every 0.3 to 8 seconds, and they jump every 40.",
            DefaultValueFactory = _ => 1,
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Command command = new(
            "network",
            "Lets a player run, turn, jump, stop and climb stairs, draws it as another client does that hears of it over a bad network, " +
            "and prints how near the two are. Exit code 1 when it is ever inside a solid by the test that puts bodies somewhere; when it " +
            "is more than 5 cm from its last report two seconds after that arrived, but for three times or 2 % of the last reports, " +
            "whichever is more, in which it stands on the step of a stair where a placement at the reported place puts it, or within " +
            "20 cm of it and a sweep from there to it leads no nearer; or when it is 1 m or more off its path of the last second in over " +
            "a twentieth of the frames.\n\n" +
            "Example:\n" +
            "  surefoot network --minutes 10 --seed 7 --delay 200 --jitter 100 --loss 5 --duplicates 2\n" +
            "  surefoot network --way \"house-stairs;house-upstairs\" --loss 20 --json")
        {
            way, minutes, seed, delay, jitter, loss, duplicates, run, jump, pace, live, json, dats,
        };
        command.SetAction(parsed =>
        {
            bool quiet = parsed.GetValue(json);
            double length = Between(parsed, minutes, 0.1, MostMinutes, "--minutes 10");
            NetworkQuality quality = new(
                Between(parsed, delay, 0, MostMilliseconds, "--delay 200") / 1000,
                Between(parsed, jitter, 0, MostMilliseconds, "--jitter 100") / 1000,
                Between(parsed, loss, 0, 100, "--loss 5") / 100,
                Between(parsed, duplicates, 0, 100, "--duplicates 2") / 100);
            CharacterStats stats = new(
                (int)Between(parsed, run, 0, MaxSkill, "--run 300"), (int)Between(parsed, jump, 0, MaxSkill, "--jump 300"));
            using WalkScene scene = WalkScene.Open(parsed.GetValue(dats));
            string[] names = parsed.GetRequiredValue(way).Split(';', StringSplitOptions.TrimEntries);
            List<ScenePlace> places = [.. names.Select(name => scene.FindPlace(name, "--way"))];
            if (places.Count < 2)
                throw new UsageException("--way takes two places or more, for example --way \"long-stair;platform\".");
            NetworkTrial trial = new(places, stats, quality, parsed.GetValue(seed), length * 60)
            {
                Pace = Between(parsed, pace, LeastPace, MostPace, "--pace 2"),
                Detail = parsed.GetValue(live) ? BroadcastDetail.Live : BroadcastDetail.Full,
            };
            NetworkFigures figures = ProgressBar.Run("seconds", quiet, report => Try(scene, trial, report));
            CommonOptions.SayLeftOut(scene.Simulation.World.LeftOut);
            if (quiet) Console.Out.WriteLine(JsonSerializer.Serialize(ToJson(trial, figures), Json));
            else Print(figures);
            return figures.IsGood ? ExitCode.Done : ExitCode.Failed;
        });
        return command;
    }

    private static NetworkFigures Try(WalkScene scene, NetworkTrial trial, Action<int, int> report)
    {
        try
        {
            return NetworkRun.Run(scene, trial, report);
        }
        catch (PlaceException e)
        {
            throw new UsageException($"--way {e.Message}");
        }
    }

    private static double Between<T>(ParseResult parsed, Option<T> option, double least, double most, string example)
        where T : IConvertible
    {
        double value = parsed.GetRequiredValue(option).ToDouble(CultureInfo.InvariantCulture);
        return value >= least && value <= most
            ? value
            : throw new UsageException(string.Create(
                CultureInfo.InvariantCulture,
                $"{option.Name} {value} is out of range: it is between {least} and {most}, for example {example}."));
    }

    private static void Print(NetworkFigures figures)
    {
        Table table = new() { Border = TableBorder.Simple };
        table.AddColumn("");
        table.AddColumn(new TableColumn("") { Alignment = Justify.Right });
        table.AddColumn("");
        table.HideHeaders();
        Row("runner", Text(figures.Seconds / 60, "0.0 min"),
            $"{figures.PlacesReached} places reached, {figures.Jumps} jumps, {Text(figures.Climbed, "0 m")} climbed");
        Row("network", Text(figures.Messages, "0"), $"messages; {figures.Resent} packets sent again");
        Row("at rest, worst", Text(figures.WorstAtRest * 100, "0.00 cm"),
            $"of {figures.AtRest.Count} last reports, 2 s after arrival; at most {Text(NetworkFigures.RestLimit * 100, "0 cm")}; " +
            $"{figures.StepsApart} more on the step where a placement at that report puts it, {figures.Blocked} within 20 cm where a " +
            $"sweep leads no nearer, together at most {figures.MostExcused}");
        Row("inside a solid", Text(figures.InSolid.Count, "0"),
            $"of {figures.Judged} frames, by the test that puts bodies somewhere; never. {figures.Swept} more where a sweep led, " +
            "touching no face");
        Row("off the path, mean", Text(figures.MeanOffPath, "0.000 m"), "from the nearest point of the last second");
        Row("off the path, p95", Text(figures.P95OffPath, "0.000 m"), $"under {Text(NetworkFigures.PathLimit, "0 m")}");
        Row("off the path, max", Text(figures.MaxOffPath, "0.000 m"), "");
        Row("blips", Text(figures.BlipsAnHour, "0.0"), $"an hour; {figures.Blips} in all");
        Terminal.Write(table);
        foreach (string where in figures.InSolid.Take(5)) Console.Out.WriteLine($"inside a solid: {where}");

        void Row(string name, string value, string rest) => table.AddRow(name, value, rest);
    }

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

    private static object ToJson(NetworkTrial trial, NetworkFigures figures) => new
    {
        Way = trial.Way.Select(place => place.Name),
        trial.Seed,
        trial.Pace,
        figures.Seconds,
        Network = new { trial.Quality.Delay, trial.Quality.Jitter, trial.Quality.Loss, trial.Quality.Duplication },
        figures.PlacesReached,
        figures.Jumps,
        figures.Climbed,
        figures.Messages,
        figures.Resent,
        AtRest = new
        {
            Count = figures.AtRest.Count,
            Worst = figures.WorstAtRest,
            figures.StepsApart,
            figures.Blocked,
            figures.MostExcused,
        },
        InSolid = new { figures.Judged, Count = figures.InSolid.Count, figures.Swept, Places = figures.InSolid.Take(100) },
        OffPath = new { Mean = figures.MeanOffPath, P95 = figures.P95OffPath, Max = figures.MaxOffPath },
        figures.Blips,
        figures.BlipsAnHour,
        Good = figures.IsGood,
    };
}
