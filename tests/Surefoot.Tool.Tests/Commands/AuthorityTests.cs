using System.Globalization;
using System.Text.Json;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>An hour's worth of <c>surefoot authority</c>, in five parts of other seeds.</summary>
public class AuthorityTests
{
    /// <summary>A fifth of an hour over all places, and each cheat once.</summary>
    private const string Hours = "0.2";

    private const int MostOfAnIncident = 3;

    private static readonly string[] Cheats =
    [
        "speed x 1.2 (clock)", "speed x 1.2 (legs)", "through a wall", "clipping a corner", "flying", "super jump", "gliding",
        "position rewind", "step height x 2",
    ];

    [Theory]
    [Behaviour("authority.honest", "design, server operator: who is 200 +- 100 ms away and loses one message in twenty is never refused")]
    [Behaviour("authority.cheats", "design, server operator: each cheat is caught by the second place told, a fifth of speed within 15 s")]
    [InlineData(1001)]
    [InlineData(1002)]
    [InlineData(1003)]
    [InlineData(1004)]
    public async Task No_honest_player_is_refused_and_every_cheat_is_caught_for_what_it_is(int seed) =>
        await PlayAsync(seed, mostRefused: 0);

    /// <summary>In fifty-one hours two honest jumps were objected to, in four claims (docs/authority.md): one may be met.</summary>
    [Fact]
    [Behaviour("authority.honest.any-seed", "docs/authority.md: whatever the seed, one incident at most in a fifth of an hour")]
    public async Task A_seed_drawn_at_random_meets_one_incident_at_most_and_catches_every_cheat() =>
        await PlayAsync(Random.Shared.Next(2000, int.MaxValue), MostOfAnIncident);

    private static async Task PlayAsync(int seed, int mostRefused)
    {
        string name = seed.ToString(CultureInfo.InvariantCulture);
        CommandLine.Outcome run = await CommandLine.RunAsync("authority", "--hours", Hours, "--seed", name, "--json");
        using JsonDocument document = JsonDocument.Parse(run.Output);
        JsonElement result = document.RootElement;
        int refused = result.GetProperty("falseRefusals").GetInt32();
        Assert.Equal($"seed {name}: missed []", $"seed {name}: missed {ListOf("missed")}");
        Assert.True(refused <= mostRefused, $"seed {name}: refused {ListOf("refusals")}");
        Assert.Equal((refused == 0 ? 0 : 1, 0), (run.ExitCode, result.GetProperty("missedCheats").GetInt32()));
        Assert.True(result.GetProperty("claims").GetInt32() > 1000);
        JsonElement[] tried = [.. result.GetProperty("cheats").EnumerateArray()];
        string[] names = [.. tried.Select(one => one.GetProperty("cheat").GetString()!)];
        Assert.All(Cheats, cheat => Assert.Contains(names, one => one.StartsWith(cheat, StringComparison.Ordinal)));
        Assert.Equal(Cheats.Length, tried.Sum(one => one.GetProperty("tried").GetInt32()));
        Assert.All(tried, one => Assert.InRange(one.GetProperty("longestSeconds").GetDouble(), 0.02, 15));

        string ListOf(string property) => result.GetProperty(property).GetRawText().Replace(" ", "", StringComparison.Ordinal);
    }
}
