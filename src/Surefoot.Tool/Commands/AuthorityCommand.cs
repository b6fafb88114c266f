using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.DemoWorld;
using Surefoot.Tool.Authority;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot authority</c>: whether a server that judges movement lets the honest through and catches the others.</summary>
internal static class AuthorityCommand
{
    private const double MostHours = 1000;
    private const int MostSaid = 10;
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<double> hours = new("--hours")
        {
            Description = "Hours of honest play, spread over every place of the demo world; parts of an hour are shorter visits.",
            DefaultValueFactory = _ => 1,
        };
        Option<ulong> seed = new("--seed")
        {
            Description = "Seed of keys, numbers and network; each hour has the next.",
            DefaultValueFactory = _ => 1,
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Command command = new(
            "authority",
            "Plays honest players and cheaters over a bad network (200 ± 100 ms, 5 % lost) against a server that judges each message, " +
            "and counts honest players refused and cheats missed. Exit code 1 when there are any.\n\nExample:\n" +
            "  surefoot authority --hours 2 --seed 1")
        {
            hours, seed, json,
        };
        command.SetAction(parsed =>
        {
            double length = parsed.GetRequiredValue(hours);
            if (!(length is > 0 and <= MostHours))
            {
                throw new UsageException(
                    FormattableString.Invariant($"--hours is more than 0 and at most {MostHours}, for example --hours 2."));
            }

            bool quiet = parsed.GetValue(json);
            using AuthorityWorld world = new(DemoWorldCache.GetOrCreate(notice: CommonOptions.Say));
            AuthorityRun run = new(world);
            ProgressBar.Run("visits", quiet, progress => run.Play(length, parsed.GetRequiredValue(seed), progress));
            if (quiet) Console.Out.WriteLine(JsonSerializer.Serialize(ToJson(run), Json));
            else Print(run);
            return run.IsGood ? ExitCode.Done : ExitCode.Failed;
        });
        return command;
    }

    private static void Print(AuthorityRun run)
    {
        Table table = new() { Border = TableBorder.Simple };
        table.AddColumn(new TableColumn("cheat"));
        foreach (string heading in (string[])["tried", "missed", "mean s", "longest s"])
            table.AddColumn(new TableColumn(heading) { Alignment = Justify.Right });
        table.AddColumn(new TableColumn("caught as"));
        foreach (CheatSummary one in Summaries(run))
            table.AddRow(
                one.Cheat.EscapeMarkup(), $"{one.Tried}", $"{one.Missed}", Text(one.MeanSeconds), Text(one.LongestSeconds),
                string.Join(", ", one.Reasons));
        Terminal.Write(table);
        Console.Out.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{run.Hours:0.##} hours of honest play, {run.Claims} claims, " +
            $"{run.Courses / (double)Math.Max(1, run.Claims):0.0} courses a claim: " +
            $"{run.FalseRefusals.Count} refused; {run.MissedCheats} of {run.Caught.Count} cheats missed"));
        foreach (string line in run.FalseRefusals.Take(MostSaid)) CommonOptions.Say(line);
        foreach (CheatResult one in run.Caught.Where(one => !one.IsCaught).Take(MostSaid))
            CommonOptions.Say("missed: " + MissOf(one));
    }

    private static string MissOf(CheatResult one) => string.Create(
        CultureInfo.InvariantCulture,
        $"{one.Cheat}, seed {one.Seed}, at {one.Place}, frames of {one.Frame:0.000} s: {one.Reason} after {one.Seconds:0.0} s");

    private static string Text(double value) => value.ToString("0.0", CultureInfo.InvariantCulture);

    private static IEnumerable<CheatSummary> Summaries(AuthorityRun run) => run.Caught.GroupBy(one => one.Cheat).Select(group =>
    {
        double[] seconds = [.. group.Where(one => one.IsCaught).Select(one => one.Seconds).DefaultIfEmpty(0)];
        return new CheatSummary(
            group.Key, group.Count(), group.Count(one => !one.IsCaught), seconds.Average(), seconds.Max(),
            [.. group.Select(one => one.Reason.ToString()).Distinct().Order(StringComparer.Ordinal)]);
    });

    private static object ToJson(AuthorityRun run) => new
    {
        run.Hours,
        run.Claims,
        run.Courses,
        FalseRefusals = run.FalseRefusals.Count,
        run.MissedCheats,
        Cheats = Summaries(run),
        Refusals = run.FalseRefusals,
        Missed = run.Caught.Where(one => !one.IsCaught).Select(MissOf),
    };

    private sealed record CheatSummary(
        string Cheat, int Tried, int Missed, double MeanSeconds, double LongestSeconds, IReadOnlyList<string> Reasons);
}
