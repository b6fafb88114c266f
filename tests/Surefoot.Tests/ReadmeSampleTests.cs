using Surefoot.Client;
using Surefoot.Physics.Motion;

namespace Surefoot.Tests;

/// <summary>The sample of the README is here; it compiles, and it runs.</summary>
public sealed class ReadmeSampleTests(DemoFolder demo) : IClassFixture<DemoFolder>
{
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
        Sample.AssertShown("README.md", "## Embed it", "ReadmeSampleTests.cs");
    }
}
