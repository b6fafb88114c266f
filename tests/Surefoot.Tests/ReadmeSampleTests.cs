using Surefoot.Client;
using Surefoot.Physics.Motion;

namespace Surefoot.Tests;

/// <summary>The sample of the README is here; it compiles, and it runs.</summary>
public sealed class ReadmeSampleTests(DemoFolder demo) : IClassFixture<DemoFolder>
{
    private const string Mark = "// sample";

    [Fact]
    [Behaviour("docs.readme.sample-runs", "README, Embed it")]
    public void The_sample_of_the_readme_runs_and_is_what_the_readme_shows()
    {
        string[] args = [demo.Path];
        // sample
        using var world = Simulation.Open(args[0]);         // a folder with client_portal.dat and client_cell_1.dat
        var player = world.SpawnPlayer(Place.Parse("0xA9B50032,156,24"), new CharacterStats(RunSkill: 300, JumpSkill: 250));
        for (double now = 0; now < 3; now += 1.0 / 60)      // your loop, and your clock in seconds
            player.Update(MovementKeys.Forward, now);       // the keys held now; then draw the player
        Console.WriteLine($"{player.Position}, {player.Body.AchievedVelocity.Length():0.0} m/s");

        // sample
        Assert.InRange(player.Position.Frame.Origin.Y, 24 + 25, 24 + 32);

        string[] source = File.ReadAllLines(Repository.PathOf("tests", "Surefoot.Tests", "ReadmeSampleTests.cs"));
        int first = Array.FindIndex(source, line => line.Trim() == Mark), last = Array.FindLastIndex(source, line => line.Trim() == Mark);

        // This file's own namespace stands for the first using.
        IEnumerable<string> usings = source.TakeWhile(line => line.StartsWith("using ",
            StringComparison.Ordinal)).Prepend("using Surefoot;");
        string[] sample = [.. usings.Concat(source[(first + 1)..last]).Select(line => line.Trim()).Where(line => line.Length > 0)];

        string[] readme = File.ReadAllLines(Repository.PathOf("README.md"));
        int begin = Array.IndexOf(readme, "```csharp", Array.IndexOf(readme, "## Embed it")) + 1;
        string[] shown = [.. readme[begin..Array.IndexOf(readme, "```", begin)].Select(line => line.Trim()).Where(line => line.Length > 0)];
        Assert.Equal(sample, shown);
    }
}
