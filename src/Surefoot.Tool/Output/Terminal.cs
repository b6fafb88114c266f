using System.Globalization;
using Spectre.Console;

namespace Surefoot.Tool.Output;

/// <summary>Where tables are printed: as wide as a terminal is, and on one line a row where a file or a program reads.</summary>
internal static class Terminal
{
    /// <summary>Wider than any row.</summary>
    private const int Unbounded = 1000;

    /// <summary>Prints a table. Without a terminal nothing is wrapped, unless the environment variable COLUMNS asks for a width.</summary>
    internal static void Write(Table table)
    {
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) });
        if (Console.IsOutputRedirected) console.Profile.Width = Columns ?? Unbounded;
        console.Write(table);
    }

    private static int? Columns =>
        int.TryParse(Environment.GetEnvironmentVariable("COLUMNS"), NumberStyles.None, CultureInfo.InvariantCulture, out int columns) &&
        columns > 0 ? columns : null;
}
