using System.CommandLine;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Tool.Conformance;
using Surefoot.Tool.Output;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot conform</c>: replays recorded walks and says how many steps come out the same.</summary>
internal static class ConformCommand
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        dats.Required = true;
        Argument<FileInfo[]> vectors = new("VECTORS") { Description = "Files of recorded walks, one JSON object a line, gzipped or not.", Arity = ArgumentArity.OneOrMore };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Option<int> worst = new("--worst") { Description = "How many first divergences to print.", DefaultValueFactory = _ => 5 };
        Option<string?> scene = new("--scene") { Description = "Only the scenes whose name begins like this." };
        Command command = new(
            "conform",
            "Replays recorded walks, free-running and re-seated before each step, and prints how many steps come out the same.\n\nExample:\n  surefoot conform --dats tests/data/worlds/first tests/data/vectors/walk-11.jsonl.gz --worst 10")
        {
            dats, vectors, json, worst, scene,
        };
        command.SetAction(parsed =>
        {
            List<WalkCase> cases = [];
            List<string> oracles = [];
            foreach (FileInfo file in parsed.GetRequiredValue(vectors))
            {
                if (OracleReplay.IsDepartureList(file.FullName)) continue;
                if (OracleReplay.Reads(file.FullName)) oracles.Add(file.FullName);
                else cases.AddRange(WalkCase.ReadAll(file.FullName));
            }

            if (parsed.GetValue(scene) is { } prefix) cases.RemoveAll(c => !c.Scene.StartsWith(prefix, StringComparison.OrdinalIgnoreCase));
            using WalkScene world = WalkScene.OpenWhole(parsed.GetRequiredValue(dats)!);
            ConformanceReport report = Replay(world, cases, parsed.GetValue(json));
            if (oracles.Count > 0)
            {
                OracleReplay oracle = OracleReplay.Over(world.Cache.Source, world.World.Landblocks.Select(block => block.Id));
                foreach (string path in oracles) oracle.Score(path, report);
            }

            if (parsed.GetValue(json)) Console.Out.WriteLine(JsonSerializer.Serialize(report.ToJson(), Json));
            else Print(report, parsed.GetRequiredValue(worst));
            return ExitCode.Done;
        });
        return command;
    }

    private static ConformanceReport Replay(WalkScene world, List<WalkCase> cases, bool quiet)
    {
        WalkReplay replay = new(world.World, world.Cache.GetSetup);
        ConformanceReport report = new();
        ProgressBar.Run("walks", quiet, progress =>
        {
            for (int i = 0; i < cases.Count; i++)
            {
                report.Add(cases[i], replay);
                progress(i + 1, cases.Count);
            }
        });
        return report;
    }

    private static void Print(ConformanceReport report, int worst)
    {
        Table table = new() { Border = TableBorder.Simple };
        foreach (string heading in (string[])["scene", "cases", "steps", "re-seated equal", "free-running cases equal"])
            table.AddColumn(new TableColumn(heading) { Alignment = heading == "scene" ? Justify.Left : Justify.Right });
        foreach ((string name, SceneScore reseated, SceneScore free) in report.Scenes)
            table.AddRow(name.EscapeMarkup(), $"{reseated.Cases}", $"{reseated.Steps}", Share(reseated.StepsEqual, reseated.Steps), Share(free.CasesEqual, free.Cases));
        table.AddRow("all", $"{report.Reseated.Cases}", $"{report.Reseated.Steps}", Share(report.Reseated.StepsEqual, report.Reseated.Steps), Share(report.FreeRunning.CasesEqual, report.FreeRunning.Cases));
        if (report.Reseated.Cases > 0) Terminal.Write(table);
        foreach ((string family, OracleScore score) in report.Oracle)
            Console.Out.WriteLine($"{family}: {score.ResultsEqual} of {score.Results} results equal ({Share(score.ResultsEqual, score.Results)}); of {score.Listed} listed as departures {score.ListedDiffering} differ{Reasons(score)}");
        foreach (Divergence d in report.Divergences.Take(worst)) Console.Out.WriteLine($"{d.CaseId} {d.Scene} step {d.Step}: {d.Difference}: {d.Detail}");
    }

    private static string Reasons(OracleScore score) =>
        score.Explained.Count == 0 ? "" : $"; differing for a known reason: {string.Join(", ", score.Explained.Select(e => $"{e.Key} {e.Value}"))}";

    private static string Share(int part, int whole) => whole == 0 ? "-" : FormattableString.Invariant($"{100.0 * part / whole:0.00} %");
}
