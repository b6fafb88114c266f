using System.Text.Json;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>An hour's worth of <c>surefoot authority</c>.</summary>
public class AuthorityTests
{
    private static readonly string[] Cheats =
    [
        "speed x 1.2 (clock)", "speed x 1.2 (legs)", "through a wall", "clipping a corner", "flying", "gliding", "position rewind",
        "step height x 2",
    ];

    [Fact]
    // An hour that is clean: it guards what is reached, and does not show that no honest player is ever refused (docs/authority.md).
    [Behaviour("authority.honest", "design, server operator: who is 200 +- 100 ms away and loses one message in twenty")]
    [Behaviour("authority.cheats", "design, server operator: each cheat is caught by the second place told, a fifth of speed within 15 s")]
    public async Task An_hour_of_honest_play_over_all_places_has_no_refusal_and_every_cheat_is_caught()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("authority", "--hours", "1", "--seed", "7", "--json");
        using JsonDocument document = JsonDocument.Parse(run.Output);
        JsonElement result = document.RootElement;
        Assert.Equal("[]", result.GetProperty("refusals").GetRawText().Replace(" ", "", StringComparison.Ordinal));
        Assert.Equal((0, 0, 0),
            (run.ExitCode, result.GetProperty("falseRefusals").GetInt32(), result.GetProperty("missedCheats").GetInt32()));
        Assert.True(result.GetProperty("claims").GetInt32() > 5000);
        Dictionary<string, int> tried = result.GetProperty("cheats").EnumerateArray()
            .ToDictionary(one => one.GetProperty("cheat").GetString()!, one => one.GetProperty("tried").GetInt32());
        Assert.All(Cheats, cheat => Assert.True(tried[cheat] >= 3));
        Assert.Contains(tried.Keys, cheat => cheat.StartsWith("super jump", StringComparison.Ordinal));
        Assert.All(
            result.GetProperty("cheats").EnumerateArray(), one => Assert.InRange(one.GetProperty("longestSeconds").GetDouble(), 0.05, 15));
    }
}
