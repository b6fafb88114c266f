using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>A session both ends of which are in this process, over a network as bad as one likes.</summary>
public class SimulatedSessionTests
{
    private const double Frame = 0.01;

    private static readonly NetworkQuality Bad = new(delay: 0.2, jitter: 0.1, loss: 0.05, duplication: 0.02);

    [Fact, Behaviour("simulated-network.delay", "NetworkQuality")]
    public void Without_jitter_each_message_takes_the_delay_both_ways()
    {
        var session = new SimulatedSession(new NetworkQuality(0.25), seed: 1, now: 100);
        Heard client = new(), server = new();
        Assert.True(session.SendToClient(Deletion(1)));
        Assert.True(session.SendToServer(new Talk("2")));
        session.Update(100, client, server);
        session.Update(100.24, client, server);
        Assert.Equal((0, 0), (client.Numbers.Count, server.Numbers.Count));
        session.Update(100.25, client, server);
        Assert.Equal([1u], client.Numbers);
        Assert.Equal([2u], server.Numbers);
    }

    [Fact, Behaviour("simulated-network.perfect", "NetworkQuality")]
    public void Over_a_perfect_network_a_message_arrives_at_once()
    {
        var session = new SimulatedSession(default, seed: 1);
        Heard client = new();
        session.SendToClient(Deletion(1));
        session.Update(0, client);
        Assert.Equal([1u], client.Numbers);
        Assert.True(session.IsAlive);
    }

    [Fact, Behaviour("simulated-network.jitter-reorders", "NetworkQuality")]
    public void With_jitter_delays_fill_the_range_and_messages_overtake_each_other()
    {
        Exchange run = new(new NetworkQuality(0.2, 0.1), seed: 5, frames: 3000);
        Assert.All(run.ClientDelays, delay => Assert.InRange(delay, 0.1 - 1e-9, 0.3 + Frame + 1e-9));
        Assert.Contains(run.ClientDelays, delay => delay < 0.12);
        Assert.Contains(run.ClientDelays, delay => delay > 0.29);
        // 0.2 s and half a frame, ± 4 standard errors of an even spread over 0.2 s.
        Assert.InRange(run.ClientDelays.Average(), 0.205 - 0.0043, 0.205 + 0.0043);
        Assert.NotEqual(run.AtClient.Numbers.Order(), run.AtClient.Numbers);
    }

    [Fact, Behaviour("simulated-network.lost-messages-come-again", "08, 2.6")]
    public void What_is_lost_comes_late_and_nothing_comes_twice()
    {
        Exchange run = new(Bad, seed: 6, frames: 3000);
        Assert.Equal(run.Sent, run.AtClient.Numbers.Order());
        Assert.Equal(run.Sent[..(run.Sent.Length / 5)], run.AtServer.Numbers);
        Assert.NotEqual(run.Sent, run.AtClient.Numbers);

        // At least what was lost: a twentieth of 3000 packets, less 4 standard deviations.
        Assert.InRange(run.Session.ServerStatistics.Resent, 100, 3000);

        // A client waits 0.6 s before it asks, and the question and the answer take their ways.
        Assert.InRange(run.ClientDelays.Max(), 0.6 + 0.1 + 0.1, 10);
    }

    [Fact, Behaviour("simulated-network.shares", "NetworkQuality")]
    public void As_many_datagrams_are_lost_and_doubled_as_the_quality_says()
    {
        var line = new SimulatedLine(3) { Quality = Bad };
        for (int i = 0; i < 10000; i++) line.Send([1, 2, 3], ServerPort.First, toServer: true, now: 0);

        // 1.02 copies of each, of which 0.95 arrive: 9690, ± 4 standard deviations of 26.
        Assert.InRange(line.Count, 9690 - 106, 9690 + 106);
    }

    [Fact, Behaviour("simulated-network.twins", "08, 2.6")]
    public void Twins_are_heard_once()
    {
        Exchange run = new(new NetworkQuality(0.1, 0.05, duplication: 1), seed: 7, frames: 500);
        Assert.Equal(run.Sent, run.AtClient.Numbers.Order());
        Assert.Equal(run.Sent[..(run.Sent.Length / 5)], run.AtServer.Numbers);
        Assert.True(run.Session.ClientStatistics.Dropped(DropReason.Duplicate) >= 500);
    }

    [Fact, Behaviour("simulated-network.same-seed-same-arrivals", "design, decision 5")]
    public void The_same_seed_gives_the_same_arrivals_and_another_seed_others()
    {
        Exchange one = new(Bad, seed: 8, frames: 500), same = new(Bad, seed: 8, frames: 500), other = new(Bad, seed: 9, frames: 500);
        Assert.Equal(one.ClientDelays, same.ClientDelays);
        Assert.NotEqual(one.ClientDelays, other.ClientDelays);
    }

    [Fact, Behaviour("simulated-network.quality-changes", "NetworkQuality")]
    public void A_changed_quality_counts_for_what_is_sent_from_then_on()
    {
        var session = new SimulatedSession(new NetworkQuality(1), seed: 1);
        Heard client = new();
        session.SendToClient(Deletion(1));
        session.Update(0, client);
        session.Quality = default;
        session.SendToClient(Deletion(2));
        session.Update(0.5, client);
        Assert.Equal([2u], client.Numbers);
        session.Update(1, client);
        Assert.Equal([2u, 1u], client.Numbers);
    }

    [Fact, Behaviour("simulated-network.nothing-through-ends-it", "08, 2.7")]
    public void A_network_that_lets_nothing_through_ends_the_session()
    {
        var session = new SimulatedSession(new NetworkQuality(0.1, loss: 1), seed: 1);
        Heard client = new();
        for (double now = 0; now < 70; now += 0.5)
        {
            session.SendToClient(Deletion(1));
            session.Update(now, client);
        }

        Assert.False(session.IsAlive);
        Assert.False(session.SendToClient(Deletion(1)));
        Assert.Empty(client.Numbers);
        Assert.Equal(0, session.UnderwayCount);
    }

    [Theory, Behaviour("simulated-network.bad-arguments", "design, decision 7")]
    [InlineData(-0.001, 0, 0, 0)]
    [InlineData(double.NaN, 0, 0, 0)]
    [InlineData(10.001, 0, 0, 0)]
    [InlineData(0, double.PositiveInfinity, 0, 0)]
    [InlineData(0, 0, 1.001, 0)]
    [InlineData(0, 0, 0, -0.001)]
    [InlineData(0, 0, double.NaN, 0)]
    public void A_quality_out_of_bounds_is_refused(double delay, double jitter, double loss, double duplication)
        => Assert.Throws<ArgumentOutOfRangeException>(() => new NetworkQuality(delay, jitter, loss, duplication));

    [Fact, Behaviour("simulated-network.bad-time", "design, decision 7")]
    public void A_time_that_is_none_is_refused_and_one_before_the_last_counts_as_that()
    {
        var session = new SimulatedSession(default, seed: 1, now: 5);
        Heard client = new();
        session.SendToClient(Deletion(1));
        Assert.Throws<ArgumentException>(() => session.Update(double.NaN, client));
        Assert.Throws<ArgumentException>(() => new SimulatedSession(default, 1, double.PositiveInfinity));
        session.Update(4, client);
        Assert.Equal([1u], client.Numbers);
    }

    private static DeleteObject Deletion(uint number) => new(number, 1);

    /// <summary>Numbers that were heard, in order.</summary>
    private sealed class Heard : IMessageReceiver
    {
        public List<uint> Numbers { get; } = [];

        public void OnMessage(in WireMessage message)
        {
            if (message.TryRead(out DeleteObject deletion))
                Numbers.Add(deletion.Guid);
            else if (message.TryRead(out Talk talk))
                Numbers.Add(uint.Parse(talk.Text, System.Globalization.CultureInfo.InvariantCulture));
            else
                Assert.Fail($"Nobody said this: {message.Id}");
        }
    }

    /// <summary>A message a frame to the client, one in five frames to the server, and then time for what was lost last.</summary>
    private sealed class Exchange
    {
        private const int FramesPerAction = 5;

        internal Exchange(NetworkQuality quality, ulong seed, int frames)
        {
            Session = new SimulatedSession(quality, seed);
            Sent = [.. Enumerable.Range(1, frames).Select(i => (uint)i)];
            for (int frame = 1; frame <= frames + (int)(15 / Frame); frame++)
            {
                double now = frame * Frame;
                if (frame <= frames)
                {
                    Assert.True(Session.SendToClient(Deletion((uint)frame)));
                    if (frame % FramesPerAction == 0) Assert.True(Session.SendToServer(new Talk($"{frame / FramesPerAction}")));
                }

                int before = AtClient.Numbers.Count;
                Session.Update(now, AtClient, AtServer);
                ClientDelays.AddRange(AtClient.Numbers.Skip(before).Select(number => now - (number * Frame)));
            }

            Assert.True(Session.IsAlive);
        }

        internal SimulatedSession Session { get; }

        internal uint[] Sent { get; }

        internal Heard AtClient { get; } = new();

        internal Heard AtServer { get; } = new();

        internal List<double> ClientDelays { get; } = [];
    }
}
