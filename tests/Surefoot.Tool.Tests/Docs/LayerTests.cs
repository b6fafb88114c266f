using System.Reflection;
using System.Text.RegularExpressions;
using Surefoot.Physics;
using static Surefoot.Tool.Tests.Docs.LayerReader;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>
/// Who may use whom: between the assemblies, and between the folders of the physics. <c>docs/architecture.md</c> says the same in words.
/// </summary>
public partial class LayerTests
{
    private const string Root = "Surefoot.Physics";

    /// <summary>
    /// The folders of the physics, each of which uses only those before it. The namespace above them, where the engine is, uses all. A
    /// recording or a replay watches bodies and what drives them, so <c>Tracing</c> comes last; what a sweep tells is a value of
    /// <c>Decisions</c>.
    /// </summary>
    private static readonly string[] Layers = [
        "Geometry", "Assets", "Decisions", "World", "Transitions", "Bodies", "Motion", "Steering", "Queries", "Tracing"];

    /// <summary>
    /// The one pair that knows each other: a cell is asked by a transition, and hands the question to the obstacle that answers for it.
    /// </summary>
    private static readonly Use[] Pair =
    [
        new("World", "EnvCell", "Transitions", "RoomObstacle"),
        new("World", "EnvCell", "Transitions", "Transition"),
        new("World", "LandCell", "Transitions", "LandObstacle"),
        new("World", "LandCell", "Transitions", "Transition"),
        new("World", "ObjCell", "Transitions", "Transition"),
    ];

    /// <summary>The arrows between the assemblies.</summary>
    private static readonly Dictionary<string, string[]> Arrows = new()
    {
        ["Surefoot.Dats"] = [],
        ["Surefoot.Protocol"] = [],
        ["Surefoot.Physics"] = ["Surefoot.Dats"],
        ["Surefoot.DemoWorld"] = ["Surefoot.Dats"],
        ["Surefoot.Client"] = ["Surefoot.Physics", "Surefoot.Protocol"],
        ["Surefoot.Server"] = ["Surefoot.Physics", "Surefoot.Protocol"],
        ["Surefoot"] = ["Surefoot.Client", "Surefoot.Server"],
        ["Surefoot.Workbench"] = ["Surefoot.Client", "Surefoot.DemoWorld", "Surefoot.Server"],
        ["Surefoot.Tool"] = ["Surefoot", "Surefoot.Workbench"],
    };

    [Fact, Behaviour("docs.layers.physics", "design.md, Assemblies")]
    public void A_folder_of_the_physics_uses_only_those_before_it()
    {
        Assembly physics = typeof(PhysicsEngine).Assembly;
        Assert.Empty(LayerReader.Layers(physics, Root).Except([.. Layers, ""]));
        Use[] upward = [.. Read(physics, Root).Where(use => IndexOf(use.From) < IndexOf(use.To))];
        Assert.Equal(Pair.Select(use => use.ToString()), upward.Select(use => use.ToString()));
    }

    [Fact, Behaviour("docs.layers.page", "design.md, Assemblies")]
    public void The_architecture_page_lists_the_folders_in_the_order_that_holds()
    {
        string page = File.ReadAllText(Repository.PathOf("docs", "architecture.md"));
        string[] rows = [.. FolderRow().Matches(page).Select(row => row.Groups[1].Value)];
        Assert.Equal(Layers, rows);
        Assert.All(Pair, use => Assert.Contains($"`{use.Used}`", page, StringComparison.Ordinal));
    }

    [Fact, Behaviour("docs.layers.assemblies", "design.md, Assemblies")]
    public void An_assembly_uses_only_what_its_arrows_lead_to()
    {
        foreach (string project in Directory.EnumerateFiles(Repository.PathOf("src"), "*.csproj", SearchOption.AllDirectories))
        {
            string name = Path.GetFileNameWithoutExtension(project);
            Assert.True(Arrows.TryGetValue(name, out string[]? arrows), $"{name} has no place among the assemblies.");
            string[] references = [.. ProjectReference().Matches(File.ReadAllText(project)).Select(match => match.Groups[1].Value)];
            Assert.Equal(arrows.Order(), references.Order());

            Assembly built = Assembly.LoadFrom(Path.Combine(AppContext.BaseDirectory, $"{Path.GetFileName(name)}.dll"));
            string[] used = [
                .. built.GetReferencedAssemblies()
                    .Select(used => used.Name!)
                    .Where(used => used.StartsWith("Surefoot", StringComparison.Ordinal))];
            Assert.Empty(used.Except(Reach(name)));
        }
    }

    [Fact, Behaviour("docs.layers.reader-sees-every-use", "design.md, Assemblies")]
    public void A_use_is_seen_wherever_a_type_hides_it()
    {
        string[] hiding =
            [.. typeof(Planted.Below.Attribute).Assembly.GetTypes().Where(IsPlanted).Select(type => type.Name.Split('`')[0]).Order()];
        Assert.InRange(hiding.Length, 30, 100);
        Use[] seen = Read(typeof(LayerTests).Assembly, "Surefoot.Tool.Tests.Planted");
        Assert.Equal(hiding, seen.Select(use => use.User).Distinct().Order());
        Assert.All(seen, use => Assert.Equal(("Below", "Above"), (use.From, use.To)));
    }

    private static bool IsPlanted(Type type) => type is { Namespace: "Surefoot.Tool.Tests.Planted.Below", IsNested: false };

    private static HashSet<string> Reach(string assembly)
    {
        HashSet<string> reach = [.. Arrows[assembly]];
        foreach (string next in Arrows[assembly]) reach.UnionWith(Reach(next));
        return reach;
    }

    private static int IndexOf(string layer) => layer.Length == 0 ? Layers.Length : Array.IndexOf(Layers, layer);

    [GeneratedRegex("""^\| `([A-Z]\w+)` \| .*\|$""", RegexOptions.Multiline)]
    private static partial Regex FolderRow();

    [GeneratedRegex("""<ProjectReference Include="[^"]*?(Surefoot[.\w]*)\.csproj" />""")]
    private static partial Regex ProjectReference();
}
