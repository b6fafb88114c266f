using System.Text;
using System.Text.RegularExpressions;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>Makes <c>docs/behaviours.md</c> from the attributes on the tests, and fails when the page in the checkout is stale.</summary>
public partial class BehavioursPageTests
{
    [Fact, Behaviour("docs.behaviours.up-to-date", "style.md, Behaviours and their tests")]
    public void The_page_lists_exactly_the_behaviours_that_tests_pin()
    {
        string page = Render();
        string path = Repository.PathOf("docs", "behaviours.md");
        if (Environment.GetEnvironmentVariable("SUREFOOT_UPDATE_DOCS") == "1") File.WriteAllText(path, page);
        string committed = File.Exists(path) ? File.ReadAllText(path) : "";
        Assert.True(page == committed, "docs/behaviours.md is stale: run the tests once with SUREFOOT_UPDATE_DOCS=1 and commit the page.");
    }

    [Fact, Behaviour("docs.behaviours.unique-names", "style.md, Behaviours and their tests")]
    public void No_two_tests_claim_the_same_behaviour()
    {
        string[] twice = [.. Scan().GroupBy(b => b.Name).Where(g => g.Count() > 1).Select(g => g.Key)];
        Assert.Empty(twice);
    }

    private static string Render()
    {
        StringBuilder page = new();
        page.Append("# Behaviours\n\nEvery observable behaviour that a test pins, with its source. Made from the tests; do not edit.\n");
        foreach (var area in Scan().GroupBy(b => b.Name.Split('.')[0]).OrderBy(g => g.Key, StringComparer.Ordinal))
        {
            page.Append($"\n## {area.Key}\n\n| behaviour | what holds | source |\n| --- | --- | --- |\n");
            foreach (Entry entry in area.OrderBy(b => b.Name, StringComparer.Ordinal))
                page.Append($"| `{entry.Name}` | {entry.Sentence} | {entry.Source} |\n");
        }

        return page.ToString();
    }

    private static List<Entry> Scan()
    {
        List<Entry> entries = [];
        IEnumerable<string> files = Directory.EnumerateFiles(Repository.PathOf("tests"), "*.cs", SearchOption.AllDirectories);
        foreach (string file in files.Order(StringComparer.Ordinal))
        {
            string relative = Path.GetRelativePath(Repository.Root, file).Replace('\\', '/');
            if (relative.Contains("/obj/", StringComparison.Ordinal) || relative.Contains("/bin/", StringComparison.Ordinal)) continue;
            string text = File.ReadAllText(file);
            foreach (Match match in BehaviourPattern().Matches(text))
            {
                Match method = MethodPattern().Match(text, match.Index);
                string sentence = method.Success ? method.Groups[1].Value.Replace('_', ' ') : "";
                entries.Add(new Entry(match.Groups[1].Value, sentence, match.Groups[2].Value));
            }
        }

        return entries;
    }

    [GeneratedRegex("""\bBehaviour\(\s*"([^"]+)",\s*"([^"]+)"\s*\)""")]
    private static partial Regex BehaviourPattern();

    [GeneratedRegex("""public (?:async )?(?:static )?[\w<>\[\]?]+ (\w+)\(""")]
    private static partial Regex MethodPattern();

    private sealed record Entry(string Name, string Sentence, string Source);
}
