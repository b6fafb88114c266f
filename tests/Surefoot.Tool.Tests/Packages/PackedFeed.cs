using System.Diagnostics;
using Surefoot.Tool.Tests.Commands;

namespace Surefoot.Tool.Tests.Packages;

/// <summary>
/// Every package, packed from what these tests were built from, in a folder outside of the checkout. Nothing but that folder is a source
/// there, and nothing is cached: what restores there restores without a network.
/// </summary>
public sealed class PackedFeed : IAsyncLifetime
{
    /// <summary>Folder in which the feed is the only source.</summary>
    internal string Root { get; } = Directory.CreateTempSubdirectory("surefoot-packages-").FullName;

    /// <summary>The packages.</summary>
    internal string Feed => Path.Combine(Root, "artifacts");

    private static string Configuration =>
        AppContext.BaseDirectory.Split(Path.DirectorySeparatorChar).Contains("Debug") ? "Debug" : "Release";

    /// <inheritdoc/>
    public async ValueTask InitializeAsync()
    {
        await DotnetAsync(Repository.Root, "pack", "Surefoot.slnx", "-c", Configuration, "--no-build", "-o", Feed);
        string sources = ReadmeText.Block("xml").Replace(ReadmeText.FeedExample, Feed, StringComparison.Ordinal);
        await File.WriteAllTextAsync(Path.Combine(Root, "nuget.config"), sources);
    }

    /// <inheritdoc/>
    public ValueTask DisposeAsync()
    {
        Directory.Delete(Root, recursive: true);
        return ValueTask.CompletedTask;
    }

    /// <summary>Runs the SDK, which has to succeed, and returns what it printed.</summary>
    internal Task<string> DotnetAsync(string folder, params string[] arguments) => RunAsync(folder, "dotnet", arguments);

    /// <summary>Runs a program, which has to succeed, and returns what it printed.</summary>
    internal async Task<string> RunAsync(string folder, string program, params string[] arguments)
    {
        ProcessStartInfo start = new(program, arguments) { WorkingDirectory = folder };

        // What the SDK told the tests about itself is not for a project elsewhere.
        string[] told = [.. start.Environment.Keys.Where(name => name.StartsWith("MSBUILD", StringComparison.OrdinalIgnoreCase))];
        foreach (string name in told) start.Environment.Remove(name);
        start.Environment["NUGET_PACKAGES"] = Path.Combine(Root, "packages");

        // Servers that go on would keep the output open.
        start.Environment["MSBUILDDISABLENODEREUSE"] = "1";
        start.Environment["UseSharedCompilation"] = "false";
        CommandLine.Outcome run = await CommandLine.RunAsync(start);
        Assert.True(run.ExitCode == 0, $"{program} {string.Join(' ', arguments)}\n{run.Output}\n{run.Error}");
        return run.Output;
    }
}
