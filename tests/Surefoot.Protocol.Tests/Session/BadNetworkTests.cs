using CsCheck;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>The same over bad networks: nothing is lost, nothing comes twice.</summary>
public class BadNetworkTests
{
    [Fact, Behaviour("protocol.session.bad-network", "08, 2.6")]
    public void Over_a_bad_network_every_message_arrives_once_in_both_directions()
        => Gen.Int.Sample(
            seed => Exchange(new SimulatedNetwork(seed, new NetworkQuality(0.2, 0.1, loss: 0.1, duplication: 0.05)), seconds: 60),
            iter: Fuzz.Cases(6),
            threads: 1);

    [Fact, Behaviour("protocol.session.damaged-network", "08, 2.6")]
    public void Damaged_datagrams_are_as_good_as_lost()
        => Gen.Int.Sample(
            seed => Exchange(new SimulatedNetwork(seed, new NetworkQuality(0.05, 0.03, loss: 0.02)) { Damage = 0.1 }, seconds: 60),
            iter: Fuzz.Cases(6),
            threads: 1);

    [Fact, Behaviour("protocol.session.long-walk", "08, 2.6")]
    public void Ten_minutes_of_movement_over_a_bad_network_leave_nothing_behind()
    {
        var network = new SimulatedNetwork(7, new NetworkQuality(0.1, 0.05, loss: 0.05, duplication: 0.02));
        Exchange(network, seconds: 600);
        Assert.InRange(network.Client.Statistics.Resent, 1, network.Client.Statistics.DatagramsSent);
        Assert.InRange(network.Server.Link!.HeldMessages, 0, 0);
    }

    [Fact, Behaviour("protocol.session.terrible-network", "08, 2.7")]
    public void At_forty_percent_loss_a_client_gets_in_or_says_within_thirty_seconds_that_it_cannot()
        => Gen.Int.Sample(
            seed =>
            {
                var network = new SimulatedNetwork(seed, new NetworkQuality(0.2, 0.1, loss: 0.4));
                network.Client.Connect(0);
                network.RunUntil(() => network.Client.State is SessionState.CharacterSelect or SessionState.Failed, 30.5);
                Assert.True(network.Client.State is SessionState.CharacterSelect or SessionState.Failed, network.Client.State.ToString());
            },
            iter: Fuzz.Cases(20),
            threads: 1);

    private static void Exchange(SimulatedNetwork network, double seconds)
    {
        network.EnterWorld();
        int greeted = network.Server.Received.Count;
        uint sent = 0, told = 0;
        double next = 0;
        network.Run(seconds, () =>
        {
            if (network.Now < next)
                return;
            next = network.Now + 0.1;
            Assert.True(network.Client.Send(new Talk(new string('x', (int)(sent % 900)) + $"#{sent++}")));
            for (int i = 0; i < 3; i++)
                network.Server.Send(new Popup(new string('y', (int)(told % 1300)) + $"#{told++}"));
        });

        // Time for what was lost at the end: the clocks that go on show that it is missing.
        network.Quality = network.Quality with { Loss = 0 };
        network.Damage = 0;
        network.Run(15);
        Assert.Equal(SessionState.InWorld, network.Client.State);
        Assert.Equal(0, network.Client.MissingPackets);
        Assert.Equal(
            Enumerable.Range(0, (int)sent).Select(i => $"#{i}"),
            network.Server.Received.Skip(greeted).Select(TextOf).OfType<string>());
        Assert.Equal(
            Enumerable.Range(0, (int)told).Select(i => $"#{i}").Order(),
            network.Received.Of<Popup>().Select(popup => popup.Text[popup.Text.IndexOf('#', StringComparison.Ordinal)..]).Order());
    }

    private static string? TextOf(byte[] bytes)
        => WireMessage.TryParse(bytes, out WireMessage message) && message.TryRead(out Talk talk)
            ? talk.Text[talk.Text.IndexOf('#', StringComparison.Ordinal)..]
            : null;
}
