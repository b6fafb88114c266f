using System.Text;

namespace Surefoot.DemoWorld.Tests;

/// <summary>What docs/demo-world.md shows is made from the world. SUREFOOT_UPDATE=1 writes it anew.</summary>
public sealed class DocsTests
{
    private const string PlacesStart = "<!-- places: written by the tests with SUREFOOT_UPDATE=1 -->\n";
    private const string PlacesEnd = "<!-- end of places -->";

    private static readonly string Docs = Path.Combine(Root(), "docs");

    [Fact, Behaviour("demo-world.docs.map-is-current", "design.md, Two commands")]
    public void The_maps_in_the_docs_show_the_world_as_it_is()
    {
        AssertCurrent(Path.Combine(Docs, "images", "demo-world.svg"), DemoMap.ToSvg());
        AssertCurrent(Path.Combine(Docs, "images", "demo-town.svg"), DemoMap.TownToSvg());
        AssertCurrent(Path.Combine(Docs, "images", "demo-park.svg"), DemoMap.ParkToSvg());
    }

    [Fact, Behaviour("demo-world.docs.places-are-current", "design.md, Two commands")]
    public void The_docs_list_every_place()
    {
        string path = Path.Combine(Docs, "demo-world.md");
        string page = File.ReadAllText(path).ReplaceLineEndings("\n");
        int start = page.IndexOf(PlacesStart, StringComparison.Ordinal) + PlacesStart.Length,
            end = page.IndexOf(PlacesEnd, StringComparison.Ordinal);
        var table = new StringBuilder("| name | cell | what to try |\n| --- | --- | --- |\n");
        foreach (var place in DemoPlaces.All)
            table.Append($"| `{place.Name}` | {place.CellId:X8} | {place.WhatToTry} |\n");
        AssertCurrent(path, page[..start] + table + page[end..]);
    }

    private static void AssertCurrent(string path, string expected)
    {
        if (Environment.GetEnvironmentVariable("SUREFOOT_UPDATE") == "1")
            File.WriteAllText(path, expected);
        Assert.Equal(expected, File.ReadAllText(path).ReplaceLineEndings("\n"));
    }

    private static string Root()
    {
        string? folder = AppContext.BaseDirectory;
        while (folder is not null && !File.Exists(Path.Combine(folder, "Surefoot.slnx")))
            folder = Path.GetDirectoryName(folder);
        return folder ?? throw new InvalidOperationException("The tests do not run inside the repository.");
    }
}
