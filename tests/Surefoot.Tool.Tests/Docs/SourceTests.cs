using System.Globalization;
using System.Text.RegularExpressions;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>What holds for every source file.</summary>
public partial class SourceTests
{
    private static readonly string[] Folders = ["src", "tests", "bench", "samples", "eng"];
    private static readonly string[] Kinds = [".cs", ".ts", ".css", ".mjs"];
    private static readonly string[] Made = ["bin", "obj", "node_modules", "dist", "wwwroot"];

    [Fact, Behaviour("docs.sources.line-length", ".editorconfig; style.md, What a review of this house found")]
    public void No_line_is_longer_than_the_editor_is_told()
    {
        string settings = File.ReadAllText(Repository.PathOf(".editorconfig"));
        int limit = int.Parse(Limit().Match(settings).Groups[1].Value, CultureInfo.InvariantCulture);
        string[] tooLong =
        [
            .. Sources().SelectMany(file => File.ReadLines(file).Index()
                .Where(line => line.Item.Length > limit)
                .Select(line => $"{Path.GetRelativePath(Repository.Root, file)}:{line.Index + 1} has {line.Item.Length} columns")),
        ];
        Assert.True(tooLong.Length == 0, $"Lines of more than {limit} columns:\n{string.Join('\n', tooLong)}");
    }

    [Fact, Behaviour("docs.sources.parts-carry-the-name", "style.md, What a review of this house found")]
    public void The_parts_of_a_type_carry_its_name()
    {
        var parts = from file in Sources()
                    where Path.GetExtension(file) == ".cs"
                    from Match part in Partial().Matches(File.ReadAllText(file))
                    group file by (Project: ProjectOf(file), Type: part.Groups[1].Value);
        // One part alone is completed by the compiler's generators.
        string[] strangers =
        [
            .. from type in parts
               from file in type
               where type.Count() > 1 && Path.GetFileName(file).Split('.')[0] != type.Key.Type
               select $"{Path.GetRelativePath(Repository.Root, file)}: {type.Key.Type}",
        ];
        Assert.True(strangers.Length == 0,
            $"Files that do not begin with the name of the type they are part of:\n{string.Join('\n', strangers)}");
    }

    [Fact, Behaviour("docs.sources.all-are-read", "style.md, House rules")]
    public void Sources_of_every_kind_are_found()
    {
        string[] sources = [.. Sources()];
        Assert.All(Kinds, kind => Assert.Contains(sources, file => file.EndsWith(kind, StringComparison.Ordinal)));
        Assert.Contains(Repository.PathOf("tests", "Surefoot.Tool.Tests", "Docs", "SourceTests.cs"), sources);
        Assert.InRange(sources.Length, 500, 5000);
    }

    private static IEnumerable<string> Sources() =>
        from folder in Folders
        from file in Directory.EnumerateFiles(Repository.PathOf(folder), "*", SearchOption.AllDirectories)
        where Kinds.Contains(Path.GetExtension(file))
        where !Path.GetRelativePath(Repository.Root, file).Split(Path.DirectorySeparatorChar).Intersect(Made).Any()
        select file;

    private static string ProjectOf(string file) =>
        string.Join('/', Path.GetRelativePath(Repository.Root, file).Split(Path.DirectorySeparatorChar)[..2]);

    [GeneratedRegex("""^max_line_length = (\d+)$""", RegexOptions.Multiline)]
    private static partial Regex Limit();

    [GeneratedRegex("""^(?:public|internal) [\w ]*\bpartial (?:class|struct|interface|record(?: struct)?) (\w+)""", RegexOptions.Multiline)]
    private static partial Regex Partial();
}
