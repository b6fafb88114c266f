namespace Surefoot.Client.Tests.Peer;

/// <summary>The client on a server, over real sockets and in real time.</summary>
public abstract class ServerSuite(IGameServer server)
{
    /// <summary>Metres between what the server says and where the player is.</summary>
    private const float Same = 0.05f;

    [Theory]
    [Behaviour("client.server.walks", "08, 5 and 9; 09b, 9.8")]
    [InlineData("W 2")]
    [InlineData("Shift+W 2")]
    [InlineData("Q 1; E 1")]
    [InlineData("A 1; D 0.5; W 1")]
    [InlineData("S 1")]
    [InlineData("Space 0.5; Wait 1")]
    [InlineData("W 1; W+Space 0.5; W 1")]
    public void What_a_new_character_does_ends_where_the_server_says(string script)
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        var start = player.Position;
        party.Walk(player, script);
        party.Settle(player);
        TestContext.Current.TestOutputHelper!.WriteLine($"{start} -> {player.Position}, told {player.LastPlaceOf(player.Id)}");
        Assert.InRange(player.Disagreement, 0, Same);
    }
}

/// <summary>The client on a real server of the field.</summary>
public sealed class AceSuite(AceGameServer server) : ServerSuite(server), IClassFixture<AceGameServer>;
