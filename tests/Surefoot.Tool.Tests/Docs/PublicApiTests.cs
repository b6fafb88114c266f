using System.Reflection;
using PublicApiGenerator;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>Pins what the libraries offer to those who embed them, as <c>docs/api/*.txt</c>: a change of it is seen in review.</summary>
public class PublicApiTests
{
    public static TheoryData<string> Libraries =>
        ["Surefoot.Dats", "Surefoot.Physics", "Surefoot.Protocol", "Surefoot.Client", "Surefoot.Server", "Surefoot.DemoWorld", "Surefoot"];

    [Theory, MemberData(nameof(Libraries)), Behaviour("docs.public-api.pinned", "style.md, House rules")]
    public void The_public_surface_is_the_one_on_record(string library)
    {
        string surface = LibraryOf(library).GeneratePublicApi(new ApiGeneratorOptions { IncludeAssemblyAttributes = false });
        surface = surface.ReplaceLineEndings("\n").TrimEnd() + "\n";
        string path = Repository.PathOf("docs", "api", $"{library}.txt");
        if (Environment.GetEnvironmentVariable("SUREFOOT_UPDATE_DOCS") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(path)!);
            File.WriteAllText(path, surface);
        }

        string committed = File.Exists(path) ? File.ReadAllText(path).ReplaceLineEndings("\n") : "";
        Assert.True(surface == committed,
            $"docs/api/{library}.txt is stale: run the tests once with SUREFOOT_UPDATE_DOCS=1 and look at what changed for users.");
    }

    private static Assembly LibraryOf(string name) => name switch
    {
        "Surefoot.Dats" => typeof(DatSet).Assembly,
        "Surefoot.Physics" => typeof(PhysicsEngine).Assembly,
        "Surefoot.Protocol" => typeof(WireMessage).Assembly,
        "Surefoot.Client" => typeof(LocalPlayer).Assembly,
        "Surefoot.Server" => typeof(LoopbackServer).Assembly,
        "Surefoot.DemoWorld" => typeof(DemoPlaces).Assembly,
        _ => typeof(Simulation).Assembly,
    };
}
