using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>The datagrams of specification 08, section 11, made and taken apart. The messages inside are in the messages' tests.</summary>
public class PacketExampleTests
{
    private const int AfterHeader = PacketHeader.Length, AfterFragmentHeader = AfterHeader + FragmentHeader.Length;
    private const uint Seed = 0x12345678, ClientBlob = 0x03000000, ServerBlob = 0x80000000;

    private static readonly LoginRequest Login =
        new(LoginRequest.LiveVersion, LoginRequest.PasswordAuth, AuthFlags: 0, Stamp: 0, "testaccount", "testpass");

    [Fact, Behaviour("protocol.examples.login-request", "08, 11.1")]
    public void The_example_of_a_login_request_is_what_a_client_sends_first()
    {
        var sent = new SentDatagrams();
        new ClientLink(Login, sent).Open(0);
        (byte[] bytes, ServerPort port) = Assert.Single(sent.All);
        Assert.Equal(Hex.Of(WorkedExamples.LoginRequest), Hex.Of(bytes));
        Assert.Equal(ServerPort.First, port);
        Assert.Equal(Login, ServerLink.TryReadLogin(WorkedExamples.LoginRequest));
        Assert.DoesNotContain("testpass", Login.ToString(), StringComparison.Ordinal);
    }

    [Fact, Behaviour("protocol.examples.connect-request", "08, 11.2")]
    public void The_example_of_a_connect_request_is_what_a_server_answers()
    {
        var sent = new SentDatagrams();
        _ = new ServerLink(new ServerLinkOptions(5, 0x1122334455667788, 0x12345678, 0x9ABCDEF0), loginLength: 80, sent, now: 1000.5);
        (byte[] bytes, ServerPort port) = Assert.Single(sent.All);
        Assert.Equal(Hex.Of(WorkedExamples.ConnectRequest), Hex.Of(bytes));
        Assert.Equal(ServerPort.First, port);

        Datagram datagram = Parse(WorkedExamples.ConnectRequest);
        Assert.True(datagram.IsIntact);
        Assert.Equal(new ConnectRequest(1000.5, 0x1122334455667788, 5, 0x12345678, 0x9ABCDEF0), ConnectRequest.Read(datagram.Handshake));
    }

    [Fact, Behaviour("protocol.examples.connect-response", "08, 11.3")]
    public void The_example_of_a_connect_response_is_what_a_client_sends_to_the_second_port()
    {
        var sent = new SentDatagrams();
        var link = new ClientLink(Login, sent);
        link.Open(0);
        link.Receive(WorkedExamples.ConnectRequest, 0.01, new ReceivedMessages());
        Assert.Equal(Hex.Of(WorkedExamples.ConnectResponse), Hex.Of(sent.Last));
        Assert.Equal(ServerPort.Second, sent.All[^1].Port);
    }

    [Fact, Behaviour("protocol.examples.ack-only", "08, 11.4")]
    public void The_example_of_an_acknowledgement_alone_is_clear_text_with_the_newest_number()
    {
        var packet = new PacketBuilder();
        packet.Add(PacketFlags.AckSequence, 7u);
        Assert.Equal(Hex.Of(WorkedExamples.AckOnly), Hex.Of(packet.Seal(12, 5, 3, 1)));

        Datagram datagram = Parse(WorkedExamples.AckOnly);
        Assert.True(datagram.IsIntact);
        Assert.Equal(7u, datagram.Ack);
    }

    [Fact, Behaviour("protocol.examples.disconnect", "08, 11.5")]
    public void The_example_of_a_goodbye_has_no_number_and_no_body()
    {
        var packet = new PacketBuilder();
        packet.Add(PacketFlags.Disconnect);
        Assert.Equal(Hex.Of(WorkedExamples.Disconnect), Hex.Of(packet.Seal(0, 5, 0, 1)));
        Assert.True(Parse(WorkedExamples.Disconnect).IsIntact);
    }

    [Fact, Behaviour("protocol.examples.packet-of-a-client", "08, 11.6")]
    public void The_example_of_a_packet_with_a_message_has_the_fifth_key()
        => Check(WorkedExamples.MoveToState, 6, 0xB5D6065D, 0x7ED4A1E7, (5, 4 | ClientBlob, MessageGroup.World), (5, 10));

    [Fact, Behaviour("protocol.examples.packet-sent-again", "08, 11.6")]
    public void The_example_of_a_packet_sent_again_has_the_same_key_and_another_sum()
    {
        byte[] original = WorkedExamples.MoveToState;
        var kept = new SentPacket { Key = 0x7ED4A1E7, PayloadHash = 0xB5D6065D, Length = original.Length, Bytes = [.. original] };
        PacketHeader again = PacketHeader.Read(PacketBuilder.Renew(kept));
        Assert.Equal((PacketFlags)7, again.Flags);
        Assert.Equal(0x85FF1901u, again.Checksum);
        Assert.Equal(Hex.Of(original.AsSpan(AfterHeader)), Hex.Of(kept.Bytes.AsSpan(AfterHeader)));
    }

    [Fact, Behaviour("protocol.examples.second-packet-of-a-client", "08, 11.7")]
    public void The_example_of_a_jump_has_the_sixth_key()
        => Check(WorkedExamples.Jump, 7, 0x312E0648, 0xB718A446, (6, 5 | ClientBlob, MessageGroup.World), (5, 10));

    [Fact, Behaviour("protocol.examples.ack-rides", "08, 11.8")]
    public void The_example_of_an_acknowledgement_that_rides_on_a_message_is_in_front_of_it()
        => Check(WorkedExamples.AutonomousPosition, 8, 0x70BA078D, 0x5FA77DF1, (7, 6 | ClientBlob, MessageGroup.World), (5, 10), ack: 9);

    [Fact, Behaviour("protocol.examples.packet-of-a-server", "08, 11.9")]
    public void The_example_of_a_servers_packet_has_the_first_key()
        => Check(WorkedExamples.UpdateMotion, 30, 0x10D8F7BD, 0xFDD4AFEB, (40, ServerBlob, MessageGroup.Objects), (0xB, 20));

    [Fact, Behaviour("protocol.examples.second-packet-of-a-server", "08, 11.10")]
    public void The_example_of_a_servers_next_packet_has_the_second_key()
        => Check(WorkedExamples.UpdatePosition, 31, 0x3DB31015, 0x398311D2, (41, ServerBlob, MessageGroup.Objects), (0xB, 20));

    [Fact, Behaviour("protocol.examples.client-numbers", "08, 2.5, 2.6 and 11.6")]
    public void A_client_numbers_packets_messages_blobs_and_actions_each_for_itself()
    {
        var sent = new SentDatagrams();
        var session = new ClientSession(new ClientSessionOptions { Account = "testaccount", Password = "testpass" }, sent);
        var received = new ReceivedMessages();
        session.Connect(0);
        session.Receive(WorkedExamples.ConnectRequest, 0, received);
        session.Receive(FirstServerPacket(), 0, received);
        sent.Take();
        session.Send(new CharacterEnterWorldRequest());
        session.Flush();
        session.Send(new LoginComplete());
        session.Send(new RequestPing());
        session.Flush();

        Assert.Equal([2u, 3u], sent.All.Select(datagram => Parse(datagram.Bytes).Header.Sequence));
        Assert.Equal(
            [(1u, 0x23000000u, 0u), (2u, 0x03000001u, 1u), (3u, 0x03000002u, 2u)],
            sent.All.SelectMany(datagram => FragmentsOf(datagram.Bytes)));
    }

    private static byte[] FirstServerPacket()
    {
        var packet = new PacketBuilder();
        packet.Add(PacketFlags.TimeSync, 1000.6);
        return packet.Seal(2, 0xB, 1000, 1, new KeyStream(Seed).Next()).ToArray();
    }

    private static List<(uint Sequence, uint Id, uint Stamp)> FragmentsOf(byte[] bytes)
    {
        List<(uint, uint, uint)> found = [];
        foreach (Datagram.Fragment fragment in Parse(bytes).Fragments)
        {
            Assert.True(WireMessage.TryParse(fragment.Data, out WireMessage message));
            found.Add((fragment.Header.Sequence, fragment.Header.Id, message.Stamp));
        }

        return found;
    }

    private static void Check(
        byte[] bytes,
        uint sequence,
        uint payloadHash,
        uint key,
        (uint Sequence, uint Id, MessageGroup Group) message,
        (ushort Id, ushort Time) sender,
        uint? ack = null)
    {
        int start = AfterFragmentHeader + (ack is null ? 0 : 4);
        var packet = new PacketBuilder();
        if (ack is { } number)
            packet.Add(PacketFlags.AckSequence, number);
        var header = new FragmentHeader(message.Sequence, message.Id, 1, (ushort)(16 + bytes.Length - start), 0, message.Group);
        packet.Add(header, bytes.AsSpan(start));
        Assert.Equal(payloadHash, packet.PayloadHash);
        Assert.Equal(Hex.Of(bytes), Hex.Of(packet.Seal(sequence, sender.Id, sender.Time, 1, key)));

        Datagram datagram = Parse(bytes);
        Assert.Equal(sequence, datagram.Header.Sequence);
        Assert.Equal(payloadHash, datagram.PayloadHash);
        Assert.Equal(key, datagram.Key);
        Assert.Equal(ack ?? 0, datagram.Ack);
        foreach (Datagram.Fragment fragment in datagram.Fragments)
        {
            Assert.Equal(header, fragment.Header);
            Assert.Equal(Hex.Of(bytes.AsSpan(start)), Hex.Of(fragment.Data));
        }
    }

    private static Datagram Parse(byte[] bytes)
    {
        Assert.Equal(DropReason.None, Datagram.TryParse(bytes, out Datagram datagram));
        return datagram;
    }
}
