using CsCheck;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Captures;
using Surefoot.Protocol.Tests.Support;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>Any datagram, truncation or flipped bit: dropped, counted, and nothing else.</summary>
public class FuzzTests
{
    private const uint Seed = 0xC11E47;

    private static readonly Capture Walk = RecordedSessions.Load("walk"), Loss = RecordedSessions.Load("loss-gap-ack");

    [Fact, Behaviour("protocol.fuzz.flipped-bits", "08, 2.3")]
    public void A_flipped_bit_anywhere_is_counted_and_the_undamaged_datagram_is_still_taken()
    {
        CapturedDatagram[] datagrams = [.. Walk.Datagrams.Where(d => d.Direction == WireDirection.ServerToClient)];
        Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                var client = new ClientSession(new ClientSessionOptions { Account = "wire", Password = "testpass" }, new SentDatagrams());
                var received = new ReceivedMessages();
                client.Connect(0);
                long sent = 0, damaged = 0;
                foreach (CapturedDatagram captured in datagrams)
                {
                    for (int i = 0; i < 20 && sent > 0; i++, damaged++)
                    {
                        byte[] bytes = [.. captured.Bytes];
                        int bit = random.Next(bytes.Length * 8);
                        bytes[bit / 8] ^= (byte)(1 << (bit % 8));
                        client.Receive(bytes, captured.Time, received);
                    }

                    client.Receive(captured.Bytes, captured.Time, received);
                    sent++;
                }

                Assert.Equal(Walk.Messages.Count(message => message.GetProperty("dir").GetString() == "s2c"), received.All.Count);
                Assert.Equal(damaged, Enum.GetValues<DropReason>().Sum(client.Statistics.Dropped));
            },
            iter: Fuzz.Cases(40),
            threads: 1);
    }

    [Fact, Behaviour("protocol.fuzz.client", "08, 2")]
    public void A_client_survives_any_datagrams_with_bounded_memory()
        => Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                var network = new SimulatedNetwork(seed, new NetworkQuality(0.01));
                network.EnterWorld();
                for (int i = 0; i < 2000; i++)
                    network.Client.Receive(Bad(random, WireDirection.ServerToClient), network.Now, network.Received);
                Assert.InRange(network.Client.MissingPackets, 0, 40_000);
            },
            iter: Fuzz.Cases(100),
            threads: 1);

    [Fact, Behaviour("protocol.fuzz.server", "08, 8.3")]
    public void A_server_survives_any_datagrams_with_bounded_memory()
        => Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                var network = new SimulatedNetwork(seed, new NetworkQuality(0.01));
                network.EnterWorld();
                for (int i = 0; i < 2000; i++)
                {
                    byte[] bytes = Bad(random, WireDirection.ClientToServer);
                    network.Server.Receive(bytes, (ServerPort)random.Next(2), network.Now);
                }

                network.Server.Update(network.Now);
                Assert.InRange(network.Server.Link!.HeldMessages, 0, 256 + FragmentAssembler.MostUnfinished);
            },
            iter: Fuzz.Cases(100),
            threads: 1);

    [Fact, Behaviour("protocol.fuzz.tap", "08, 2")]
    public void A_tap_survives_any_datagrams()
        => Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                var tap = new WireTap();
                foreach (CapturedDatagram captured in Loss.Datagrams)
                {
                    var direction = (WireDirection)random.Next(2);
                    tap.Observe(direction, Bad(random, direction), new Reader());
                    tap.Observe(captured.Direction, captured.Bytes, new Reader());
                }
            },
            iter: Fuzz.Cases(100),
            threads: 1);

    [Fact, Behaviour("protocol.fuzz.authenticated-peer", "08, 8.3")]
    public void A_peer_that_knows_the_keys_and_sends_nonsense_is_survived_too()
        => Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                var sent = new SentDatagrams();
                var link = new ServerLink(new ServerLinkOptions(3, 1, 2, Seed), 100, sent, now: 0);
                link.Admit();
                var response = new PacketBuilder();
                response.Add(PacketFlags.ConnectResponse, [1, 0, 0, 0, 0, 0, 0, 0]);
                link.Receive(response.Seal(0, 3, 0, 1), ServerPort.Second, 0, new Reader());
                Assert.Equal(ServerLinkState.Connected, link.State);

                var keys = new KeyStream(Seed);
                for (uint number = 2; number < 1500; number++)
                {
                    var packet = new PacketBuilder();
                    var header = new FragmentHeader(
                        (uint)random.Next(4000), 0, (ushort)random.Next(1, 300), 464, (ushort)random.Next(300), MessageGroup.World);
                    packet.Add(header, new byte[448]);
                    link.Receive(packet.Seal(number, 3, 1, 1, keys.Next()), ServerPort.First, 0.01 * number, new Reader());
                    Assert.InRange(link.HeldMessages, 0, 4096 + FragmentAssembler.MostUnfinished);
                }
            },
            iter: Fuzz.Cases(20),
            threads: 1);

    [Fact, Behaviour("protocol.fuzz.no-amplification", "design.md, 7")]
    public void A_client_that_has_not_answered_is_sent_at_most_three_times_what_it_sent()
    {
        var sent = new SentDatagrams();
        byte[] login = WorkedExamples.LoginRequest;
        var link = new ServerLink(new ServerLinkOptions(3, 1, 2, Seed), login.Length, sent, now: 0);
        for (int i = 0; i < 50; i++)
            link.Send(new AccountBoot(" because of a long and winding road that leads to nobody's door, as it seems"));
        for (double now = 0; now < 20; now += 0.1)
            link.Update(now);
        Assert.InRange(sent.All.Sum(datagram => datagram.Bytes.Length), 1, 3 * login.Length);
        Assert.Equal(ServerLinkState.Ended, link.State);
    }

    /// <summary>A random datagram, a recorded one, a recorded one cut short or with bits flipped, or one whose checksum is right.</summary>
    private static byte[] Bad(Random random, WireDirection direction)
    {
        CapturedDatagram[] recorded = Walk.Datagrams;
        byte[] bytes = [.. recorded[random.Next(recorded.Length)].Bytes];
        switch (random.Next(5))
        {
            case 0:
                bytes = new byte[random.Next(1100)];
                random.NextBytes(bytes);
                return bytes;
            case 1:
                return bytes[..random.Next(bytes.Length + 1)];
            case 2:
                for (int flips = random.Next(1, 8); flips > 0; flips--)
                    bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8));
                return bytes;
            case 3:
                return bytes;
            default:
                return Sealed(random, direction);
        }
    }

    /// <summary>A cleartext datagram of any flags with any body, whose checksum is right.</summary>
    private static byte[] Sealed(Random random, WireDirection direction)
    {
        byte[] body = new byte[4 * random.Next(20)];
        random.NextBytes(body);
        if (body.Length >= 4 && random.Next(2) == 0)
            BitConverter.TryWriteBytes(body, (body.Length / 4) - 1);
        uint flag = 1u << random.Next(3, 28);
        var header = new PacketHeader(
            (uint)random.Next(-3, 600), (PacketFlags)flag, 0, direction == WireDirection.ServerToClient ? (ushort)11 : (ushort)3,
            (ushort)random.Next(70_000), (ushort)body.Length, 1);
        byte[] bytes = new byte[PacketHeader.Length + body.Length];
        (header with { Checksum = header.Hash() + Hash32.Of(body) }).Write(bytes);
        body.CopyTo(bytes, PacketHeader.Length);
        return bytes;
    }

    /// <summary>Reads what it gets as what it says it is.</summary>
    private sealed class Reader : ITapReceiver, IMessageReceiver
    {
        public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message) => OnMessage(message);

        public void OnMessage(in WireMessage message)
        {
            message.TryRead(out CreateObject _);
            message.TryRead(out UpdateMotion _);
            message.TryRead(out MoveToState _);
            message.TryRead(out PlayerDescription _);
        }
    }
}
