using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Tool.Conformance;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Commands;

/// <summary>
/// <c>surefoot conform</c>: replays recordings and says how much comes out the same; each file tells by itself what it is.
/// </summary>
internal static class ConformCommand
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<DirectoryInfo?> dats = new("--dats")
        {
            Description = "Folder with the dat files of the world that walks, sweeps and placements were recorded in. " +
                "Runs of managers and sessions need none.",
        };
        Argument<string[]> vectors = new("RECORDINGS")
        {
            Description = "Files of recordings, one JSON object a line, gzipped or not, or folders of them (*.jsonl, *.jsonl.gz). " +
                "What a file records it tells by itself.",
            Arity = ArgumentArity.OneOrMore,
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Option<int> worst = new("--worst")
        {
            Description = "How many divergences to print, those that count first.",
            DefaultValueFactory = _ => 5,
        };
        Option<string?> scene = new("--scene") { Description = "Only the cases whose scene, tag or session begins like this." };
        Option<double?> require = new("--require")
        {
            HelpName = "PERCENT",
            Description = "How much of each family has to come out the same, 0 to 100; less is exit code 1. " +
                $"By default {Verdict.Defaults}.",
        };
        require.Validators.Add(result =>
        {
            if (!result.Tokens.All(static word => IsPercentage(word.Value)))
                result.AddError("--require takes a percentage from 0 to 100, as in --require 99.5");
        });
        Command command = new(
            "conform",
            "Replays recordings and prints how much comes out the same: walks free-running and re-seated before each quantum, sweeps, " +
            "placements and walks of a peer, runs of the managers that move other bodies, and sessions between a client and a server. " +
            "What hangs on the last bit of a float, or differs for a known reason, is counted apart.\n\nExample:\n" +
            "  surefoot conform --dats tests/data/worlds/first tests/data/vectors --worst 10\n" +
            "  surefoot conform tests/data/remote-vectors tests/data/wire-captures --require 100")
        {
            dats, vectors, json, worst, scene, require,
        };
        command.SetAction(parsed =>
        {
            bool quiet = parsed.GetValue(json);
            SceneFilter scenes = new(parsed.GetValue(scene));
            using ConformanceRun run = new(parsed.GetValue(dats), scenes);
            foreach (string path in ConformanceRun.Files(parsed.GetRequiredValue(vectors)))
                ProgressBar.Run(Path.GetFileName(path), quiet, progress => run.Add(path, progress));
            scenes.RequireAny();

            double? required = parsed.GetValue(require);
            if (quiet) Console.Out.WriteLine(JsonSerializer.Serialize(run.Report.ToJson(required), Json));
            else Print(run.Report, required, parsed.GetRequiredValue(worst));
            List<Verdict> below = run.Report.Judge(required).FindAll(verdict => !verdict.IsMet);
            foreach (Verdict verdict in below) CommonOptions.Say(verdict.ToString());
            return below.Count == 0 ? ExitCode.Done : ExitCode.Failed;
        });
        return command;
    }

    private static bool IsPercentage(string word) =>
        double.TryParse(word, CultureInfo.InvariantCulture, out double percent) && percent is >= 0 and <= 100;

    private static void Print(ConformanceReport report, double? required, int worst)
    {
        if (report.Reseated.Cases > 0) PrintScenes(report);
        Table table = NewTable(["family", "counted", "apart"], "equal", "of", "share", "required");
        foreach (Verdict verdict in report.Judge(required))
        {
            table.AddRow(
                verdict.Family.EscapeMarkup(), verdict.Measure, verdict.Apart.EscapeMarkup(), $"{verdict.Equal}", $"{verdict.Compared}",
                verdict.Share, FormattableString.Invariant($"{verdict.Required} %"));
        }

        Terminal.Write(table);
        foreach (Divergence divergence in report.Divergences.OrderBy(one => one.Reason is not null).Take(worst))
            Console.Out.WriteLine(divergence);
        if (report.Divergences.Count > worst) Console.Out.WriteLine($"... {report.Divergences.Count - worst} more; --worst N prints N");
    }

    private static void PrintScenes(ConformanceReport report)
    {
        Table table = NewTable(["scene"], "walks", "quanta", "re-seated quanta equal", "free-running walks equal");
        foreach ((string name, SceneScore reseated, SceneScore free) in report.Scenes)
            table.AddRow(name.EscapeMarkup(), $"{reseated.Cases}", $"{reseated.Quanta}", $"{reseated.QuantaEqual}", $"{free.CasesEqual}");
        Terminal.Write(table);
    }

    private static Table NewTable(string[] words, params string[] numbers)
    {
        Table table = new() { Border = TableBorder.Simple };
        foreach (string heading in words) table.AddColumn(new TableColumn(heading));
        foreach (string heading in numbers) table.AddColumn(new TableColumn(heading) { Alignment = Justify.Right });
        return table;
    }
}
