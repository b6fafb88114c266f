using System.CommandLine;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool;

/// <summary>The <c>surefoot</c> command. Exit codes: 0 done, 1 the thing asked for failed, 2 wrong usage.</summary>
internal static class Program
{
    private static Task<int> Main(string[] args) => RunAsync(args);

    /// <summary>Runs a command line.</summary>
    internal static async Task<int> RunAsync(string[] args)
    {
        RootCommand root = new("Moves bodies through an Asheron's Call world exactly as the retail client did.\n\nExample:\n  surefoot play")
        {
            PlayCommand.Create(), WalkCommand.Create(), DatsCommand.Create(), DemoCommand.Create(), ConformCommand.Create(),
        };
        ParseResult parsed = root.Parse(args);
        if (parsed.Errors.Count > 0 && parsed.Action is ParseErrorAction)
        {
            foreach (var error in parsed.Errors) await Console.Error.WriteLineAsync($"surefoot: {error.Message}").ConfigureAwait(false);
            await Console.Error.WriteLineAsync($"See: surefoot {CommandPath(parsed.CommandResult)}--help").ConfigureAwait(false);
            return ExitCode.Usage;
        }

        try
        {
            return await parsed.InvokeAsync(new InvocationConfiguration { EnableDefaultExceptionHandler = false }).ConfigureAwait(false);
        }
        catch (UsageException e)
        {
            await Console.Error.WriteLineAsync($"surefoot: {e.Message}").ConfigureAwait(false);
            return ExitCode.Usage;
        }
        catch (Exception e) when (e is IOException or InvalidDataException or UnauthorizedAccessException or FormatException)
        {
            await Console.Error.WriteLineAsync($"surefoot: {e.Message}").ConfigureAwait(false);
            return ExitCode.Failed;
        }
    }

    private static string CommandPath(CommandResult result)
    {
        string path = "";
        for (CommandResult? r = result; r is { Parent: CommandResult parent }; r = parent) path = $"{r.Command.Name} {path}";
        return path;
    }
}
