using System.Diagnostics;
using System.Reflection;

namespace Surefoot.Workbench.Tests;

public sealed class PageUnitTests
{
    [Fact]
    [Behaviour("workbench.page.unit-tests-pass", "design.md")]
    public async Task The_pages_own_tests_pass()
    {
        string folder = typeof(PageUnitTests).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>().Single(one => one.Key == "PageFolder").Value!;
        string runner = Path.Combine(folder, "node_modules", "vitest", "vitest.mjs");
        Assert.SkipUnless(File.Exists(runner), $"The page's sources are not where this was built: {folder}");
        ProcessStartInfo start = new("node", [runner, "run", "--no-color"]) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        using Process process = Process.Start(start)!;
        Task<string> errors = process.StandardError.ReadToEndAsync();
        string output = await process.StandardOutput.ReadToEndAsync();
        await process.WaitForExitAsync();
        Assert.True(process.ExitCode == 0, output + await errors);
    }
}
