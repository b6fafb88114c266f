using System.Diagnostics;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>Runs the command as a process of its own, as a person does.</summary>
internal static class CommandLine
{
    /// <summary>What a run left behind.</summary>
    internal sealed record Outcome(int ExitCode, string Output, string Error);

    internal static async Task<Outcome> RunAsync(params string[] arguments)
    {
        ProcessStartInfo start = new("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add("exec");
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "surefoot.dll"));
        foreach (string argument in arguments) start.ArgumentList.Add(argument);
        start.Environment["COLUMNS"] = "160";
        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(), error = process.StandardError.ReadToEndAsync();
        await process.WaitForExitAsync();
        return new Outcome(process.ExitCode, await output, await error);
    }
}
