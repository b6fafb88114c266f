using Surefoot.Client;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

public sealed class ServedNetworkTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private static readonly NetworkQuality Bad = new(delay: 0.2, jitter: 0.1, loss: 0.1, duplication: 0.05);

    /// <summary>An hour of the simulated clock.</summary>
    private static readonly double Minutes = Fuzz.Cases(60);

    [Fact]
    [Behaviour("server.network.bad", "spec/08, 2.6: 200 ± 100 ms, 10 % loss, 5 % duplication and reordering")]
    public void Over_a_bad_network_nothing_is_lost_or_applied_twice_and_both_ends_agree_when_the_player_stands()
    {
        SimulatedHost host = new(ground, options => options with { Spawns = [] });
        TestClient walker = host.Enter("Walker", quality: Bad, seed: 5);
        using PlayedPlayer player = new(ground, walker);
        MovementKeys[] course =
        [
            MovementKeys.Forward, MovementKeys.Forward | MovementKeys.TurnRight, MovementKeys.Forward | MovementKeys.Jump,
            MovementKeys.TurnLeft,
            MovementKeys.Forward | MovementKeys.SidestepLeft, MovementKeys.Back, MovementKeys.None,
        ];
        int said = 0;
        for (int i = 0; i * 2.0 / 60 < Minutes; i++)
        {
            player.Hold(course[i % course.Length]);
            walker.Session.Send(new Talk($"{said++}"));
            host.Run(2, () => player.Frame(host.Now));
        }

        player.Hold(MovementKeys.None);
        host.Run(20, () => player.Frame(host.Now));
        Position truth = player.Body.Position, believed = host.Server.FindPlayer("Walker")!.Value;
        Assert.True(truth.DistanceTo(believed) < 0.01, $"{truth} {believed}");

        // A client hears in the order of arrival (08, 2.6); each thing once.
        int[] heard = [.. walker.Texts.Where(text => int.TryParse(text, out _)).Select(int.Parse).Order()];
        Assert.Equal(Enumerable.Range(0, said), heard);
        Assert.Equal(player.Told, host.Server.Figures.Claims);
        Assert.True(host.Server.Figures.Network.Resent > 10);
    }

    [Fact]
    [Behaviour("server.network.very-bad", "spec/08, 2.7: 40 % loss")]
    public void Over_a_very_bad_network_a_client_is_in_or_says_that_it_is_not_within_half_a_minute()
    {
        int isIn = 0;
        for (ulong seed = 1; seed <= 20; seed++)
        {
            SimulatedHost host = new(ground, options => options with { Spawns = [] });
            TestClient client = host.Connect("walker", quality: new NetworkQuality(0.2, 0.1, 0.4, 0.05), seed: seed);
            Assert.True(
                host.RunUntil(() => client.Session.State is SessionState.CharacterSelect or SessionState.Failed, 30.5), $"seed {seed}");
            if (client.Session.State == SessionState.CharacterSelect) isIn++;
            else Assert.NotEmpty(client.Session.Failure!.Sentence);
        }

        Assert.True(isIn >= 15, $"{isIn} of 20");
    }

    [Fact]
    [Behaviour("server.network.restart", "spec/08, 8.1: unknown sessions are not answered")]
    public void When_the_server_is_killed_and_restarted_the_client_says_so_within_ten_seconds_and_can_come_back()
    {
        SimulatedHost host = new(ground);
        TestClient client = host.Connect("walker", change: options => options with { SilenceTimeout = 8 });
        client.EnterAs("Walker");
        host.Run(3);
        host.Restart(ground);
        Assert.True(host.RunUntil(() => client.Session.State == SessionState.Failed, 10));
        Assert.Equal(SessionFailureKind.Silent, client.Session.Failure!.Kind);
        TestClient again = host.Connect("walker");
        again.EnterAs("Walker");
    }

    [Fact]
    [Behaviour("server.network.gap", "spec/08, 2.6: a gap of more than 256 packets ends the session")]
    public void Who_has_lost_more_packets_than_can_be_asked_for_is_ended_and_can_come_back()
    {
        SimulatedHost host = new(ground);
        TestClient walker = host.Enter("Walker");
        walker.IsMute = true;
        for (int i = 0; i < 300; i++)
        {
            walker.Session.Send(new Talk("unheard"));
            walker.Session.Flush();
        }

        host.Run(1);
        walker.IsMute = false;
        walker.Session.Send(new Talk("heard"));
        host.Run(4.2);
        Assert.Equal(0, host.Server.Figures.Sessions);
        Assert.DoesNotContain("heard", walker.Texts);
        host.Enter("Walker", "Walker");
    }

    [Fact]
    [Behaviour("server.network.forged-gap", "spec/08, 2.3 and 2.6")]
    public void A_forged_packet_far_ahead_ends_nobodys_session()
    {
        SimulatedHost host = new(ground);
        TestClient walker = host.Enter("Walker");
        byte[] last = [];
        walker.Sends = bytes => last = (BitConverter.ToUInt32(bytes, 4) & 0x2) != 0 ? bytes : last;
        walker.Session.Send(new Talk("one"));
        host.Run(0.2);
        foreach (uint ahead in (uint[])[2, 255, 256, 257, 300, 4000, 5000, 0x7FFFFFFF, 0x80000000])
        {
            byte[] forged = [.. last];
            BitConverter.TryWriteBytes(forged, BitConverter.ToUInt32(last, 0) + ahead);
            host.SendAsStranger(forged, walker.Address);
        }

        host.Run(1);
        walker.Session.Send(new Talk("two"));
        Assert.True(host.RunUntil(() => walker.Texts.Contains("two"), 2));
    }

    [Fact]
    [Behaviour("server.shutdown", "spec/08, 3.5: error 4, going down")]
    public void A_server_that_goes_down_tells_its_clients_and_keeps_their_characters_in_its_file()
    {
        string path = Path.Combine(Path.GetTempPath(), $"characters-{Guid.NewGuid():N}.json");
        try
        {
            SimulatedHost host = new(ground, options => options with { CharacterFile = path });
            TestClient walker = host.Enter("Walker");
            WirePosition there = TestClient.Beside(walker.Place, 0, 1);
            walker.Session.Send(new Talk(FormattableString.Invariant(
                $"@teleloc 0x{there.Cell:X8} {there.Origin.X} {there.Origin.Y} {there.Origin.Z}")));
            host.Run(0.5);
            WirePosition left = walker.Place;
            host.Server.Dispose();
            host.Run(0.5);
            Assert.Equal(SessionFailureKind.ServerClosing, walker.Session.Failure!.Kind);

            SimulatedHost next = new(ground, options => options with { CharacterFile = path });
            TestClient back = next.Connect("walker");
            back.EnterAs("Walker");
            Assert.Equal(left.Origin, back.Objects[back.Id].Object.Physics.Position!.Value.Origin);
            Assert.Equal(2, back.Objects[back.Id].Object.Physics.Stamps.Instance);
        }
        finally
        {
            File.Delete(path);
        }
    }
}
