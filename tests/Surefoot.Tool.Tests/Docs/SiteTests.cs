using System.Diagnostics;
using System.Text.RegularExpressions;
using Surefoot.Tool.Tests.Commands;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>The documentation as a site.</summary>
public partial class SiteTests
{
    [Fact, Behaviour("docs.site.no-broken-link", "style.md, Jolt")]
    public async Task The_documentation_builds_as_a_site_whose_own_links_all_lead_somewhere()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "docs-site is a shell script.");
        ProcessStartInfo start = new("bash", ["docs-site", "--no-build"]) { WorkingDirectory = Repository.Root };
        CommandLine.Outcome run = await CommandLine.RunAsync(start);
        Assert.True(run.ExitCode == 0, $"{run.Output}\n{run.Error}");

        string site = Repository.PathOf("artifacts", "site");
        string[] pages = Directory.GetFiles(site, "*.html", SearchOption.AllDirectories);
        Assert.Contains(Path.Combine(site, "index.html"), pages);
        Assert.Contains(Path.Combine(site, "docs", "architecture.html"), pages);
        Assert.Contains(pages, page => page.EndsWith("PhysicsEngine.html", StringComparison.Ordinal));
        List<string> broken = [];
        foreach (string page in pages)
        {
            foreach (Match link in LocalLink().Matches(await File.ReadAllTextAsync(page, TestContext.Current.CancellationToken)))
            {
                string target = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(page)!, Uri.UnescapeDataString(link.Groups[1].Value)));
                if (!File.Exists(target)) broken.Add($"{Path.GetRelativePath(site, page)}: {link.Groups[1].Value}");
            }
        }

        Assert.Empty(broken.Distinct());
    }

    [GeneratedRegex("""(?:href|src)="(?!https?:|mailto:|#|data:)([^"#?]+)""")]
    private static partial Regex LocalLink();
}
