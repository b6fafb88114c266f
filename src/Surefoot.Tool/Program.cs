using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using System.CommandLine.Parsing;
using Surefoot.Dats;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool;

/// <summary>The <c>surefoot</c> command. Exit codes: 0 done, 1 the thing asked for failed, 2 wrong usage.</summary>
internal static class Program
{
    /// <summary>Environment variable that lets a mistake of ours end with its stack.</summary>
    private const string DebugVariable = "SUREFOOT_DEBUG";

    /// <summary>How a mistake of ours begins.</summary>
    internal const string Unexpected = "a mistake in the program";

    private static bool Debugging => Environment.GetEnvironmentVariable(DebugVariable) == "1";

    private static Task<int> Main(string[] args) => RunAsync(args, CancellationToken.None);

    /// <summary>Runs a command line.</summary>
    /// <param name="args">The words behind the command's name.</param>
    /// <param name="cancellation">Ends a command that would go on.</param>
    internal static async Task<int> RunAsync(string[] args, CancellationToken cancellation)
    {
        // A RootCommand would take its name from the assembly.
        Command root = new("surefoot",
            "Moves bodies through an Asheron's Call world exactly as the retail client did.\n\nExample:\n  surefoot play")
        {
            new HelpOption(), new VersionOption(),
            PlayCommand.Create(), WalkCommand.Create(), DatsCommand.Create(), DemoCommand.Create(), ConformCommand.Create(),
            NetworkCommand.Create(), AuthorityCommand.Create(), ServeCommand.Create(), ConnectCommand.Create(), SniffCommand.Create(),
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
            return await parsed.InvokeAsync(new InvocationConfiguration { EnableDefaultExceptionHandler = false },
                cancellation).ConfigureAwait(false);
        }
        catch (UsageException e)
        {
            await Console.Error.WriteLineAsync($"surefoot: {e.Message}").ConfigureAwait(false);
            return ExitCode.Usage;
        }
        catch (Exception e) when (
            e is IOException or InvalidDataException or UnauthorizedAccessException or DatFormatException or DatRecordMissingException)
        {
            await Console.Error.WriteLineAsync($"surefoot: {e.Message}").ConfigureAwait(false);
            return ExitCode.Failed;
        }
        catch (Exception e) when (!Debugging && e is not OperationCanceledException)
        {
            await Console.Error.WriteLineAsync(
                $"surefoot: {Unexpected}: {e.GetType().Name}: {e.Message} Please report it; {DebugVariable}=1 shows where it happened.")
                .ConfigureAwait(false);
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
