using System.CommandLine;
using System.Text.Json;
using Surefoot.DemoWorld;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot demo</c>: the demo world as dat files, and as a map.</summary>
internal static class DemoCommand
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create() =>
        new("demo", "Makes the demo world.\n\nExample:\n  surefoot demo write ./demo-world")
        {
            CreateWrite(), CreateMap(), CreatePlaces(), CreateRows(), DemoArrowsCommand.Create(Json),
        };

    private static Option<uint> SeedOption() =>
        new("--seed") { Description = "Chooses the landscape.", DefaultValueFactory = _ => DemoWorldBuilder.DefaultSeed };

    private static Command CreateWrite()
    {
        Argument<DirectoryInfo> folder = new("DIR") { Description = "Where the dat files go; made when it is not there." };
        Option<uint> seed = SeedOption();
        Command command = new("write",
            "Writes the demo world as real dat files.\n\nExample:\n  surefoot demo write ./demo-world --seed 7") { folder, seed };
        command.SetAction(parsed =>
        {
            string path = parsed.GetRequiredValue(folder).FullName;
            ProgressBar.Run("demo world", quiet: false, report =>
                DemoWorldBuilder.Write(path, parsed.GetRequiredValue(seed), new Reporter(p => report((int)(p.Share * 100), 100))));
            Console.Out.WriteLine($"Demo world written to {path}\nPlay in it: surefoot play --dats {path}");
            return ExitCode.Done;
        });
        return command;
    }

    private static Command CreateMap()
    {
        Argument<FileInfo> file = new("FILE") { Description = "SVG file to write." };
        Option<uint> seed = SeedOption();
        Command command = new("map", "Draws a map of the demo world.\n\nExample:\n  surefoot demo map demo-world.svg") { file, seed };
        command.SetAction(parsed =>
        {
            string path = parsed.GetRequiredValue(file).FullName;
            File.WriteAllText(path, DemoMap.ToSvg(parsed.GetRequiredValue(seed)));
            Console.Out.WriteLine($"Map written to {path}");
            return ExitCode.Done;
        });
        return command;
    }

    private static Command CreateRows()
    {
        Argument<FileInfo> file = new("FILE") { Description = "SQL file to write." };
        Option<uint> seed = SeedOption();
        Command command = new("rows",
            "Writes the demo world's inhabitants as rows of an ACE server's world database.\n\nExample:\n" +
            "  surefoot demo rows demo-world.sql")
            { file, seed };
        command.SetAction(parsed =>
        {
            string path = parsed.GetRequiredValue(file).FullName;
            File.WriteAllText(path, DemoServerRows.ToSql(parsed.GetRequiredValue(seed)));
            Console.Out.WriteLine($"Rows written to {path}\nLoad them: mariadb ace_world < {path}");
            return ExitCode.Done;
        });
        return command;
    }

    private static Command CreatePlaces()
    {
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Command command = new("places", "Lists the named places of the demo world.\n\nExample:\n  surefoot demo places --json") { json };
        command.SetAction(parsed =>
        {
            if (parsed.GetValue(json))
            {
                Console.Out.WriteLine(JsonSerializer.Serialize(new { Places = DemoPlaces.All.Select(ToJson) }, Json));
                return ExitCode.Done;
            }

            foreach (NamedPlace place in DemoPlaces.All) Console.Out.WriteLine($"{place.Name,-24} 0x{place.CellId:X8}  {place.WhatToTry}");
            return ExitCode.Done;
        });
        return command;
    }

    private static object ToJson(NamedPlace place) => new
    {
        place.Name,
        place.Title,
        Cell = $"{place.CellId:X8}",
        Position = (float[])[place.Origin.X, place.Origin.Y, place.Origin.Z],
        place.Heading,
        place.WhatToTry,
    };

    /// <summary>Reports on the caller's thread.</summary>
    private sealed class Reporter(Action<DemoWorldProgress> report) : IProgress<DemoWorldProgress>
    {
        public void Report(DemoWorldProgress value) => report(value);
    }
}
