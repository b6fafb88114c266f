using System.Text.RegularExpressions;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>What holds for every page of documentation.</summary>
public partial class PagesTests
{
    private static readonly string[] Kinds = [".cs", ".ts", ".mjs", ".json", ".txt", ".md", ".props", ".csproj", ".slnx"];
    private static readonly string[] Folders = ["src/", "tests/", "bench/", "samples/", "docs/", "eng/"];

    [Fact, Behaviour("docs.pages.files-exist", "CONTRIBUTING.md: the pages tell where to look")]
    public void Files_and_folders_that_a_page_names_exist()
    {
        string[] files = [.. FilesBelow(Repository.Root)];
        string[] missing =
        [
            .. from page in Pages()
               from name in NamedIn(page)
               where !Exists(name, files)
               select $"{Path.GetRelativePath(Repository.Root, page)} names {name}",
        ];
        Assert.True(missing.Length == 0, string.Join('\n', missing));
    }

    [Fact, Behaviour("docs.pages.links-lead-somewhere", "CONTRIBUTING.md: the pages tell where to look")]
    public void Links_between_pages_lead_somewhere()
    {
        (string Page, string Target)[] links =
        [
            .. from page in Pages()
               from Match link in Link().Matches(File.ReadAllText(page))
               select (Page: page, Target: link.Groups[1].Value),
        ];
        Assert.InRange(links.Length, 20, 5000);
        string[] dead =
        [
            .. from link in links
               where !Path.Exists(Path.Combine(Path.GetDirectoryName(link.Page)!, link.Target))
               select $"{Path.GetRelativePath(Repository.Root, link.Page)} links to {link.Target}",
        ];
        Assert.True(dead.Length == 0, string.Join('\n', dead));
    }

    [Fact, Behaviour("docs.pages.names-are-found", "CONTRIBUTING.md: the pages tell where to look")]
    public void Names_of_files_are_found_in_pages_and_missing_ones_are_missed()
    {
        string[] named = [.. Pages().SelectMany(NamedIn)];
        Assert.Contains("Transitions/Transition.Stairs.cs", named);
        Assert.Contains("src/Surefoot.Physics/Transitions", named);
        string[] files = [.. FilesBelow(Repository.Root)];
        string[] there = ["Transition.Stairs.cs", "Transitions/Transition.Stairs.cs", "src/Surefoot.Physics"];
        Assert.All(there, name => Assert.True(Exists(name, files), name));
        string[] gone = ["Stairs.cs", "Motion/Transition.Stairs.cs", "src/Surefoot.Steps"];
        Assert.All(gone, name => Assert.False(Exists(name, files), name));
    }

    private static IEnumerable<string> Pages() =>
        Directory.EnumerateFiles(Repository.Root, "*.md")
            .Concat(Directory.EnumerateFiles(Repository.PathOf("docs"), "*.md", SearchOption.AllDirectories))
            .Concat(Directory.EnumerateFiles(Repository.PathOf("samples"), "*.md"));

    private static IEnumerable<string> NamedIn(string page) =>
        from Match span in Code().Matches(File.ReadAllText(page))
        let name = span.Groups[1].Value
        where Kinds.Contains(Path.GetExtension(name)) || Folders.Any(folder => name.StartsWith(folder, StringComparison.Ordinal))
        select name.TrimEnd('/');

    private static bool Exists(string name, string[] files) =>
        Path.Exists(Repository.PathOf(name)) || files.Any(file => file.EndsWith($"/{name}", StringComparison.Ordinal));

    private static IEnumerable<string> FilesBelow(string root) =>
        from folder in Folders
        from file in Directory.EnumerateFiles(Path.Combine(root, folder), "*", new EnumerationOptions { RecurseSubdirectories = true })
        let path = file.Replace('\\', '/')
        where !path.Contains("/node_modules/", StringComparison.Ordinal)
        where !path.Contains("/obj/", StringComparison.Ordinal) && !path.Contains("/bin/", StringComparison.Ordinal)
        select path;

    /// <summary>Code between single backticks that could be the path of a file.</summary>
    [GeneratedRegex("(?<!`)`([A-Za-z0-9_.-]+(?:/[A-Za-z0-9_.-]+)*/?)`(?!`)")]
    private static partial Regex Code();

    /// <summary>The target of a link to a file, without the place in it.</summary>
    [GeneratedRegex(@"\]\((?![a-z]+:|#)([^)#\s]+)(?:#[^)]*)?\)")]
    private static partial Regex Link();
}
