using System.IO.Compression;
using System.Reflection.PortableExecutable;
using System.Xml.Linq;
using Surefoot.DemoWorld;

namespace Surefoot.Tool.Tests.Packages;

/// <summary>The packages, as somebody takes them who has no checkout.</summary>
public sealed class PackageTests(PackedFeed feed) : IClassFixture<PackedFeed>
{
    private static readonly string[] Libraries =
    [
        "Surefoot", "Surefoot.Client", "Surefoot.Dats", "Surefoot.DemoWorld", "Surefoot.Physics", "Surefoot.Protocol", "Surefoot.Server",
        "Surefoot.Workbench",
    ];

    private static readonly string[] All = [.. Libraries, "Surefoot.Tool"];

    [Fact, Behaviour("packages.embed", "README, Embed it")]
    public async Task The_sample_of_the_readme_compiles_and_runs_in_a_fresh_project_from_the_packages_alone()
    {
        string project = Directory.CreateDirectory(Path.Combine(feed.Root, "walk")).FullName, world = Path.Combine(feed.Root, "world");
        await File.WriteAllTextAsync(Path.Combine(project, "walk.csproj"), $"""
            <Project Sdk="Microsoft.NET.Sdk">
              <PropertyGroup>
                <OutputType>Exe</OutputType>
                <TargetFramework>net10.0</TargetFramework>
                <ImplicitUsings>enable</ImplicitUsings>
                <Nullable>enable</Nullable>
              </PropertyGroup>
              <ItemGroup>
                <PackageReference Include="Surefoot" Version="{VersionOf("Surefoot")}" />
              </ItemGroup>
            </Project>
            """, TestContext.Current.CancellationToken);
        string program = Path.Combine(project, "Program.cs");
        await File.WriteAllTextAsync(program, ReadmeText.Block("csharp"), TestContext.Current.CancellationToken);
        DemoWorldBuilder.Write(world);

        // Three seconds at 10.6 m/s, the formula's speed for a run skill of 300, less what it takes to begin.
        string printed = await feed.DotnetAsync(project, "run", "--", world);
        Assert.Matches(@"^0xA9B5003[34] \[156 (4[89]|5\d)\.\d+ \d+\.\d+\], 10\.\d m/s$", printed.Trim());
    }

    [Fact, Behaviour("packages.tool", "README, Install")]
    public async Task The_tool_installs_from_the_packages_and_is_the_command_surefoot()
    {
        string tools = Path.Combine(feed.Root, "tools");
        await feed.DotnetAsync(feed.Root, "tool", "install", "Surefoot.Tool", "--add-source", "artifacts", "--tool-path", tools);
        string command = Path.Combine(tools, OperatingSystem.IsWindows() ? "surefoot.exe" : "surefoot");
        Assert.Contains("surefoot [command] [options]", await feed.RunAsync(feed.Root, command, "--help"), StringComparison.Ordinal);
        string walk = await feed.RunAsync(feed.Root, command, "walk", "--script", "W 1");
        Assert.Contains("top speed", walk, StringComparison.OrdinalIgnoreCase);
    }

    [Fact, Behaviour("packages.metadata", "README, Install")]
    public void Every_package_has_its_licence_its_readme_its_tags_and_its_symbols()
    {
        IEnumerable<string> packed = Directory.GetFiles(feed.Feed, "*.nupkg").Select(IdOf);
        Assert.Equal(All.Order(StringComparer.Ordinal), packed.Order(StringComparer.Ordinal));
        foreach (string id in All)
        {
            using ZipArchive package = Open(id, "nupkg"), symbols = Open(id, "snupkg");
            using Stream spec = package.GetEntry($"{id}.nuspec")!.Open();
            XElement metadata = XDocument.Load(spec).Root!.Elements().First();
            string? Value(string name) => metadata.Elements().FirstOrDefault(e => e.Name.LocalName == name)?.Value;
            Assert.Equal(("MIT", "README.md"), (Value("license"), Value("readme")));
            Assert.NotNull(package.GetEntry("README.md"));
            Assert.Contains("asherons-call", Value("tags"), StringComparison.Ordinal);
            Assert.True(Value("description")?.Length > 10, id);
            Assert.Null(Value("repository"));
            string folder = id == "Surefoot.Tool" ? "tools/net10.0/any" : "lib/net10.0";
            Assert.NotNull(symbols.GetEntry($"{folder}/{id}.pdb"));
            if (id != "Surefoot.Tool") Assert.NotNull(package.GetEntry($"{folder}/{id}.xml"));
        }
    }

    [Fact, Behaviour("packages.deterministic", "the compiler's own mark of a build that can be repeated")]
    public void Every_assembly_is_built_so_that_it_can_be_repeated()
    {
        foreach (string id in All)
        {
            using ZipArchive package = Open(id, "nupkg");
            ZipArchiveEntry[] assemblies = [.. package.Entries.Where(entry => IsOurAssembly(entry.Name))];
            Assert.NotEmpty(assemblies);
            foreach (ZipArchiveEntry assembly in assemblies)
            {
                using MemoryStream bytes = new();
                using (Stream entry = assembly.Open()) entry.CopyTo(bytes);
                bytes.Position = 0;
                using PEReader image = new(bytes);
                Assert.Contains(image.ReadDebugDirectory(), entry => entry.Type == DebugDirectoryEntryType.Reproducible);
            }
        }
    }

    [Fact, Behaviour("packages.same-bytes", "same sources, same bytes")]
    public async Task The_same_sources_in_two_places_make_the_same_bytes()
    {
        byte[][] first = await BuildAsync("here"), second = await BuildAsync("somewhere/else");
        Assert.Equal(first, second);
    }

    /// <summary>Builds a library as <c>./pack</c> does, from a copy of its sources.</summary>
    private async Task<byte[][]> BuildAsync(string place)
    {
        const string Library = "Surefoot.Protocol";
        string root = Path.Combine(feed.Root, place), project = Path.Combine(root, "src", Library);
        Directory.CreateDirectory(project);
        foreach (string file in (string[])["Directory.Build.props", "Directory.Packages.props", ".editorconfig", "README.md"])
            File.Copy(Repository.PathOf(file), Path.Combine(root, file));
        string sources = Repository.PathOf("src", Library);
        foreach (string file in Directory.EnumerateFiles(sources, "*", SearchOption.AllDirectories))
        {
            string name = Path.GetRelativePath(sources, file);
            if (name.Split(Path.DirectorySeparatorChar)[0] is "bin" or "obj") continue;
            string copy = Path.Combine(project, name);
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        await feed.DotnetAsync(project, "build", "-c", "Release", "-p:ContinuousIntegrationBuild=true", "-p:RunAnalyzers=false");
        string built = Path.Combine(project, "bin", "Release", "net10.0", Library);
        return [.. ((string[])[".dll", ".pdb", ".xml"]).Select(kind => File.ReadAllBytes(built + kind))];
    }

    private static bool IsOurAssembly(string name) =>
        name.StartsWith("Surefoot", StringComparison.Ordinal) && name.EndsWith(".dll", StringComparison.Ordinal);

    private string VersionOf(string id) => Path.GetFileNameWithoutExtension(PathOf(id, "nupkg"))[(id.Length + 1)..];

    private string PathOf(string id, string kind) =>
        Assert.Single(Directory.GetFiles(feed.Feed, $"{id}.*.{kind}"), path => IdOf(path) == id);

    /// <summary>A package's file is named after its id and its version, which begins with a digit.</summary>
    private static string IdOf(string path) =>
        string.Join('.', Path.GetFileName(path).Split('.').TakeWhile(part => !char.IsAsciiDigit(part[0])));

    private ZipArchive Open(string id, string kind) => ZipFile.OpenRead(PathOf(id, kind));
}
