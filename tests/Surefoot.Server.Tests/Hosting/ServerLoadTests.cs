using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>Two hundred clients that play at once. How long steps take is for <c>surefoot serve --load 200 --stats --json</c> to
/// say.</summary>
public sealed class ServerLoadTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const int Clients = 200;

    /// <summary>Ten minutes with SUREFOOT_FUZZ=10.</summary>
    private static readonly int Seconds = Fuzz.Cases(60);

    [Fact]
    [Behaviour("server.load", "spec/08, 8.1 and 8.7")]
    public void Two_hundred_clients_lose_nothing_and_the_memory_stays()
    {
        List<(double At, object Message)> course = CourseReplay.Record(ground);
        SimulatedHost host = new(ground, options => options with { Slots = Clients, LoginsPerSecond = 1000 });
        List<TestClient> clients = [];
        for (int i = 0; i < Clients; i++)
        {
            clients.Add(host.Connect($"load{i}", seed: (ulong)i));
            clients[i].IsForgetful = true;
        }

        for (int i = 0; i < Clients; i++) clients[i].EnterAs($"Load {(char)('A' + (i / 26))}{(char)('a' + (i % 26))}");
        CourseReplay[] players = [.. clients.Select((client, i) => new CourseReplay(client, course, host.Now + (i * 0.05)))];
        long settled = 0, grown = 0;
        for (int second = 0; second < Seconds; second++)
        {
            host.Run(1, () =>
            {
                foreach (CourseReplay player in players) player.Update(host.Now);
            });
            if (second == Math.Min(59, Seconds / 2)) settled = GC.GetTotalMemory(forceFullCollection: true);
        }

        grown = GC.GetTotalMemory(forceFullCollection: true) - settled;
        host.Run(3);
        ServerFigures figures = host.Server.Figures;
        Assert.Equal((Clients, 0L, 0L), (figures.Players, figures.Faults, figures.SlowClients));
        Assert.Equal(players.Sum(player => (long)player.Told), figures.Claims);
        Assert.All(Enum.GetValues<DropReason>(), reason => Assert.Equal(0, figures.Dropped(reason)));
        Assert.All(clients, client => Assert.Equal(SessionState.InWorld, client.Session.State));
        Assert.All(clients, client => Assert.True(clients.All(other => client.Objects.ContainsKey(other.Id))));
        Assert.Equal(0, figures.AllRefusedClaims);
        Assert.True(grown < 8 << 20, $"{grown / 1048576.0:0.0} MB");
    }
}
