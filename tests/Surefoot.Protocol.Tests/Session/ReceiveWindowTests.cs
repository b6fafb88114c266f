using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Session;

public class ReceiveWindowTests
{
    private const uint Seed = 77;

    private readonly ReceiveWindow window = new(Seed, farthest: 0x7FFF, mostMissing: 40_000);
    private readonly uint[] words = [.. Words(600)];

    [Fact, Behaviour("protocol.window.in-order", "08, 2.6")]
    public void Packets_in_order_take_one_word_each()
    {
        for (uint number = 2; number < 300; number++)
            Assert.Equal((DropReason.None, (int)number - 2), Accept(number, words[number - 2]));
        Assert.Equal(299u, window.Newest);
        Assert.Equal(299u, window.InOrder);
        Assert.Equal(0, window.Missing.Length);
    }

    [Fact, Behaviour("protocol.window.gap", "08, 2.6")]
    public void Packets_that_a_newer_one_skips_are_missing_and_keep_their_words()
    {
        Accept(2, words[0]);
        Accept(6, words[4]);
        Assert.Equal([3u, 4u, 5u], window.Missing.ToArray());
        Assert.Equal(2u, window.InOrder);
        Assert.Equal((DropReason.None, 2), Accept(4, words[2]));
        Assert.Equal([3u, 5u], window.Missing.ToArray());
        Assert.Equal((DropReason.None, 1), Accept(3, words[1]));
        Assert.Equal((DropReason.None, 3), Accept(5, words[3]));
        Assert.Equal(6u, window.InOrder);
        Assert.Equal(0, window.KeptWords);
    }

    [Fact, Behaviour("protocol.window.duplicate", "08, 2.6")]
    public void What_has_arrived_is_not_taken_twice()
    {
        Accept(2, words[0]);
        Accept(3, words[1]);
        Assert.Equal(DropReason.Duplicate, Accept(3, words[1]).Reason);
        Assert.Equal(DropReason.Duplicate, Accept(2, words[0]).Reason);
    }

    [Fact, Behaviour("protocol.window.damage-changes-nothing", "08, 2.6")]
    public void A_damaged_packet_changes_nothing_and_comes_again_with_the_same_word()
    {
        Accept(2, words[0]);
        Assert.Equal(DropReason.Checksum, Accept(900, 1).Reason);
        Assert.Equal(2u, window.Newest);
        Assert.Equal(0, window.Missing.Length);
        Assert.Equal((DropReason.None, 1), Accept(3, words[1]));
    }

    [Fact, Behaviour("protocol.window.numbered-clear-text", "08, 2.6")]
    public void A_clear_packet_with_the_number_of_one_that_did_not_arrive_makes_that_one_missing()
    {
        Accept(2, words[0]);
        Assert.Equal(DropReason.None, AcceptClear(4, PacketFlags.AckSequence));
        Assert.Equal([3u, 4u], window.Missing.ToArray());
        Assert.Equal((DropReason.None, 2), Accept(4, words[2]));
    }

    [Fact, Behaviour("protocol.window.refusal-takes-a-number-but-no-word", "08, 2.6 and 10")]
    public void A_refusal_to_send_again_has_a_number_but_no_word()
    {
        Accept(2, words[0]);
        Assert.Equal(DropReason.None, AcceptClear(3, PacketFlags.RejectRetransmit));
        Assert.Equal(0, window.Missing.Length);
        Assert.Equal((DropReason.None, 1), Accept(4, words[1]));
    }

    [Fact, Behaviour("protocol.window.lost-refusal", "08, 10")]
    public void After_a_lost_refusal_the_words_find_their_place_again()
    {
        // 3 and 5 are refusals that are lost; 4 is lost too.
        Accept(2, words[0]);
        Assert.Equal((DropReason.None, 2), Accept(6, words[2]));
        Assert.Equal((DropReason.None, 3), Accept(7, words[3]));
        Assert.Equal([3u, 4u, 5u], window.Missing.ToArray());
        Assert.Equal((DropReason.None, 1), Accept(4, words[1]));
        Assert.Equal(DropReason.None, AcceptClear(3, PacketFlags.RejectRetransmit | PacketFlags.Retransmission));
        Assert.Equal(DropReason.None, AcceptClear(5, PacketFlags.RejectRetransmit | PacketFlags.Retransmission));
        Assert.Equal(7u, window.InOrder);
        Assert.Equal((DropReason.None, 4), Accept(8, words[4]));
    }

    [Fact, Behaviour("protocol.window.word-taken-too-early", "08, 10")]
    public void Words_that_were_taken_for_refusals_go_to_the_packets_behind_them()
    {
        // 3 and 4 are refusals that are lost; an acknowledgement shows that 5 was sent too, so three words are taken for them.
        Accept(2, words[0]);
        AcceptClear(5, PacketFlags.AckSequence);
        Assert.Equal((DropReason.None, 2), Accept(6, words[2]));
        Assert.Equal((DropReason.None, 1), Accept(5, words[1]));
        Assert.Equal((DropReason.None, 3), Accept(7, words[3]));
        Assert.Equal((DropReason.None, 4), Accept(8, words[4]));
        Assert.Equal([3u, 4u], window.Missing.ToArray());
        Assert.Equal(0, window.KeptWords);
    }

    [Fact, Behaviour("protocol.window.words-ahead", "08, 10")]
    public void A_word_up_to_256_ahead_is_found()
    {
        Accept(2, words[0]);
        Assert.Equal((DropReason.None, 257), Accept(3, words[257]));
        Assert.Equal((DropReason.None, 258), Accept(4, words[258]));
        Assert.Equal(DropReason.Checksum, Accept(5, words[258 + 258]).Reason);
    }

    [Fact, Behaviour("protocol.window.forget", "08, 2.6")]
    public void What_the_sender_no_longer_has_is_not_waited_for()
    {
        Accept(2, words[0]);
        Accept(6, words[4]);
        window.Forget([4, 0, 0, 0, 9, 0, 0, 0]);
        Assert.Equal([3u, 5u], window.Missing.ToArray());
        Assert.Equal(DropReason.Duplicate, Accept(4, words[2]).Reason);
        Assert.Equal((DropReason.None, 3), Accept(5, words[3]));
    }

    [Fact, Behaviour("protocol.window.too-far-ahead", "08, 2.6")]
    public void A_number_too_far_ahead_is_refused()
    {
        Accept(2, words[0]);
        Assert.Equal(DropReason.TooFarAhead, Accept(2 + 0x8000, 0).Reason);
        Assert.Equal(DropReason.TooFarAhead, AcceptClear(2 + 0x8000, PacketFlags.AckSequence));
    }

    [Fact, Behaviour("protocol.window.bounded", "08, 2.6")]
    public void No_more_than_forty_thousand_packets_are_waited_for()
    {
        Assert.Equal(DropReason.None, AcceptClear(0x7FFF, PacketFlags.AckSequence));
        Assert.Equal(DropReason.TooManyMissing, AcceptClear(0x7FFF + 0x7000, PacketFlags.AckSequence));
        Assert.Equal(0x7FFE, window.Missing.Length);
    }

    [Fact, Behaviour("protocol.window.number-zero", "08, 2.6")]
    public void An_encrypted_packet_without_a_number_is_refused() => Assert.Equal(DropReason.Unexpected, Accept(0, words[0]).Reason);

    private static IEnumerable<uint> Words(int count)
    {
        var keys = new KeyStream(Seed);
        return Enumerable.Range(0, count).Select(_ => keys.Next());
    }

    private (DropReason Reason, int KeyIndex) Accept(uint number, uint word)
    {
        var packet = new PacketBuilder();
        packet.Add(PacketFlags.EchoRequest, number * 3);
        Datagram.TryParse(packet.Seal(number, 11, 5, 1, word), out Datagram datagram);
        return (window.Accept(datagram, out int keyIndex), keyIndex);
    }

    private DropReason AcceptClear(uint number, PacketFlags flags)
    {
        var packet = new PacketBuilder();
        packet.Add(flags & PacketFlags.Retransmission);
        packet.Add(flags & ~PacketFlags.Retransmission, (flags & PacketFlags.RejectRetransmit) != 0 ? 0u : 1u);
        Datagram.TryParse(packet.Seal(number, 11, 5, 1), out Datagram datagram);
        return window.Accept(datagram, out _);
    }
}
