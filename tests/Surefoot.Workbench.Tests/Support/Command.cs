using System.CommandLine.Parsing;
using System.Text.Json;

namespace Surefoot.Workbench.Tests.Support;

/// <summary>Runs command lines in this process.</summary>
internal static class Command
{
    private static readonly SemaphoreSlim Alone = new(1, 1);

    /// <summary>What a command says with <c>--json</c>.</summary>
    public static async Task<JsonElement> JsonAsync(string command)
    {
        string[] words = [.. CommandLineParser.SplitCommandLine(command + " --json")];
        Assert.Equal("surefoot", words[0]);
        await Alone.WaitAsync();
        TextWriter before = Console.Out;
        using StringWriter said = new();
        Console.SetOut(said);
        try
        {
            int code = await Surefoot.Tool.Program.RunAsync(words[1..], TestContext.Current.CancellationToken);
            Assert.True(code == 0, command);
        }
        finally
        {
            Console.SetOut(before);
            Alone.Release();
        }

        return JsonDocument.Parse(said.ToString()).RootElement;
    }
}
