using System.Diagnostics;
using System.Globalization;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>Runs the command as a process of its own, as a person does.</summary>
internal static class CommandLine
{
    /// <summary>What a run left behind.</summary>
    internal sealed record Outcome(int ExitCode, string Output, string Error);

    internal static Task<Outcome> RunAsync(params string[] arguments) => RunAsync(columns: 160, arguments);

    /// <summary>Runs the command with the environment variable COLUMNS set, or not.</summary>
    internal static Task<Outcome> RunAsync(int? columns, params string[] arguments) => RunAsync(columns, null, arguments);

    /// <summary>Runs the command with something to read from its standard input.</summary>
    internal static Task<Outcome> RunWithInputAsync(string input, params string[] arguments) => RunAsync(columns: 160, input, arguments);

    private static async Task<Outcome> RunAsync(int? columns, string? input, string[] arguments)
    {
        ProcessStartInfo start = new("dotnet", ["exec", Path.Combine(AppContext.BaseDirectory, "Surefoot.Tool.dll"), .. arguments]);
        if (columns is { } width) start.Environment["COLUMNS"] = width.ToString(CultureInfo.InvariantCulture);
        else start.Environment.Remove("COLUMNS");
        return await RunAsync(start, input);
    }

    /// <summary>Runs any program to its end.</summary>
    /// <param name="start">The program.</param>
    /// <param name="input">What it reads from its standard input; null leaves that as it is.</param>
    internal static async Task<Outcome> RunAsync(ProcessStartInfo start, string? input = null)
    {
        (start.RedirectStandardOutput, start.RedirectStandardError, start.RedirectStandardInput) = (true, true, input is not null);
        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(), error = process.StandardError.ReadToEndAsync();
        if (input is not null)
        {
            await process.StandardInput.WriteAsync(input);
            process.StandardInput.Close();
        }

        await process.WaitForExitAsync();
        return new Outcome(process.ExitCode, await output, await error);
    }
}
