using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests.Peer;

/// <summary>The demo world is a world for a real server.</summary>
public sealed class AceOnDemoWorldTests(AceOnDemoWorld server) : IClassFixture<AceOnDemoWorld>
{
    /// <summary>An object without a motion table: rows that name none, not a table that the files lack.</summary>
    private const string Nothing = "00000000";

    private const uint Run = 24, JackOfAllTrades = 326;
    private const int JackOfAllTradesBonus = 5;
    private const ushort RunForward = 7;
    private const double Quickness = 60, RunSpeed = 4;

    [Fact]
    [Behaviour("demo-world.servers.ace", "08, 7.2 and 8.5; 07, 7.17; 01, 4.1")]
    public void Ace_starts_without_an_absent_table_and_a_character_runs_in_the_town_at_the_rate_of_its_skill()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        NamedPlace town = DemoPlaces.All.Single(place => place.Name == "town");
        Assert.True(new Position(town.CellId, town.Origin).DistanceTo(player.Position) < 1, $"{player.Position}");

        // By the files' table a run skill is quickness, and what its record and the augmentation for all skills add.
        PlayerDescription told = player.Heard<PlayerDescription>().First();
        SkillRecord record = told.Skills!.Value.Single(one => one.Id == Run).Value;
        double skill = Quickness + record.Initial + record.Ranks
            + (JackOfAllTradesBonus * told.Ints!.Value.Where(one => one.Id == JackOfAllTrades).Sum(one => one.Value));
        double rate = (((skill / (skill + 200)) * 11) + 4) / 4;
        Position from = player.Position;
        party.Walk(player, "W 3");
        party.Settle(player);
        Assert.InRange(from.DistanceTo(player.Position), RunSpeed * rate * 2.5, RunSpeed * rate * 3.2);
        Assert.True(player.Player.Weenie.InqRunRate(out float own));
        Assert.Equal(rate, own, 1e-4);

        // The server says the same to everybody: it has the same table.
        UpdateMotion seen = player.Heard<UpdateMotion>()
            .First(motion => motion.Guid == player.Id && motion.Movement.State.ForwardCommand == RunForward);
        Assert.Equal(rate, seen.Movement.State.ForwardSpeed, 1e-4);
        Assert.DoesNotContain(server.AbsentRecords(), line => !line.Contains(Nothing, StringComparison.Ordinal));
    }
}
