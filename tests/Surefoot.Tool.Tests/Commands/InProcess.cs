using System.Text;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>Tests that take over the process's console: one at a time.</summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public sealed class ConsoleCollection
{
    /// <summary>Name of the collection.</summary>
    public const string Name = "console";
}

/// <summary>Runs the command inside this process, for tests of many inputs.</summary>
internal static class InProcess
{
    /// <summary>Runs a command line; one that serves is ended as soon as it says so.</summary>
    internal static async Task<CommandLine.Outcome> RunAsync(params string[] arguments)
    {
        TextWriter output = Console.Out, error = Console.Error;
        using CancellationTokenSource serving = new();
        using Watch said = new(["Surefoot workbench", "Surefoot server"], serving);
        using Watch failed = new(["Surefoot server"], serving);
        Console.SetOut(said);
        Console.SetError(failed);
        try
        {
            int code = await Program.RunAsync(arguments, serving.Token).ConfigureAwait(false);
            return new CommandLine.Outcome(code, said.ToString(), failed.ToString());
        }
        catch (OperationCanceledException) when (serving.IsCancellationRequested)
        {
            return new CommandLine.Outcome(ExitCode.Done, said.ToString(), failed.ToString());
        }
        finally
        {
            Console.SetOut(output);
            Console.SetError(error);
        }
    }

    private sealed class Watch(string[] words, CancellationTokenSource source) : StringWriter
    {
        public override Encoding Encoding => Encoding.UTF8;

        public override void WriteLine(string? value)
        {
            base.WriteLine(value);
            if (words.Any(word => value?.StartsWith(word, StringComparison.Ordinal) == true)) source.Cancel();
        }
    }
}
