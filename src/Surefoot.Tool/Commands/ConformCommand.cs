using System.CommandLine;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Tool.Conformance;
using Surefoot.Tool.Conformance.Steering;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot conform</c>: replays recordings and says how much comes out the same; each file tells by itself what it is.</summary>
internal static class ConformCommand
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create()
    {
        Option<DirectoryInfo?> dats = new("--dats")
        {
            Description = "Folder with the dat files of the world that walks, sweeps and placements were recorded in; others need none.",
        };
        Argument<FileInfo[]> vectors = new("VECTORS")
        {
            Description = "Files of recorded walks, sweeps, placements and runs of managers, one JSON object a line, gzipped or not.",
            Arity = ArgumentArity.OneOrMore,
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Option<int> worst = new("--worst") { Description = "How many first divergences to print.", DefaultValueFactory = _ => 5 };
        Option<string?> scene = new("--scene") { Description = "Only the scenes whose name begins like this." };
        Command command = new(
            "conform",
            "Replays recordings and prints how much comes out the same: walks free-running and re-seated before each step, runs of the " +
            "managers that move other bodies from their start.\n\nExample:\n" +
            "  surefoot conform --dats tests/data/worlds/first tests/data/vectors/walk-11.jsonl.gz --worst 10\n" +
            "  surefoot conform tests/data/remote-vectors/move-to-1.jsonl.gz")
        {
            dats, vectors, json, worst, scene,
        };
        command.SetAction(parsed =>
        {
            List<WalkCase> cases = [];
            List<string> oracles = [];
            ConformanceReport report = new();
            foreach (FileInfo file in parsed.GetRequiredValue(vectors))
            {
                if (OracleReplay.IsDepartureList(file.FullName)) continue;
                if (ManagerVectors.Reads(file.FullName)) AddManagers(file.FullName, report, parsed.GetValue(json));
                else if (OracleReplay.Reads(file.FullName)) oracles.Add(file.FullName);
                else cases.AddRange(WalkCase.ReadAll(file.FullName));
            }

            if (parsed.GetValue(scene) is { } prefix) cases.RemoveAll(c => !c.Scene.StartsWith(prefix, StringComparison.OrdinalIgnoreCase));
            if (cases.Count > 0 || oracles.Count > 0)
            {
                DirectoryInfo folder = parsed.GetValue(dats) ??
                    throw new UsageException("Walks, sweeps and placements need the world they were recorded in: --dats DIR");
                using WholeWorld world = WholeWorld.Open(folder);
                CommonOptions.SayLeftOut(world.World.LeftOut);
                AddWalks(world, cases, report, parsed.GetValue(json));
                if (oracles.Count > 0)
                {
                    OracleReplay oracle = OracleReplay.Over(world.Cache.Source, world.World.Landblocks.Select(block => block.Id));
                    foreach (string path in oracles) oracle.Score(path, report);
                }
            }

            if (parsed.GetValue(json)) Console.Out.WriteLine(JsonSerializer.Serialize(report.ToJson(), Json));
            else Print(report, parsed.GetRequiredValue(worst));
            return ExitCode.Done;
        });
        return command;
    }

    private static void AddManagers(string path, ConformanceReport report, bool quiet)
    {
        int cases = VectorFile.Read(path, static line => line.Length).Count();
        ProgressBar.Run(Path.GetFileName(path), quiet, progress =>
        {
            int done = 0;
            foreach (ManagerResult result in ManagerVectors.Run(path))
            {
                report.Add(result);
                progress(++done, cases);
            }
        });
    }

    private static void AddWalks(WholeWorld world, List<WalkCase> cases, ConformanceReport report, bool quiet)
    {
        WalkReplay replay = new(world.World, world.Cache.GetSetup);
        ProgressBar.Run("walks", quiet, progress =>
        {
            for (int i = 0; i < cases.Count; i++)
            {
                report.Add(cases[i], replay);
                progress(i + 1, cases.Count);
            }
        });
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
        foreach ((string family, ManagerScore score) in report.Managers)
        {
            Console.Out.WriteLine(
                $"{family}: {score.CasesEqual} of {score.Cases} runs equal ({Share(score.StepsEqual, score.Steps)} of {score.Steps} steps); " +
                $"of {score.TightCases} that hang on a last bit {score.TightCasesEqual} equal");
        }

        foreach (Divergence d in report.Divergences.Take(worst)) Console.Out.WriteLine($"{d.CaseId} {d.Scene} step {d.Step}: {d.Difference}: {d.Detail}");
    }

    private static string Reasons(OracleScore score) =>
        score.Explained.Count == 0 ? "" : $"; differing for a known reason: {string.Join(", ", score.Explained.Select(e => $"{e.Key} {e.Value}"))}";

    private static string Share(int part, int whole) => whole == 0 ? "-" : FormattableString.Invariant($"{100.0 * part / whole:0.00} %");
}
