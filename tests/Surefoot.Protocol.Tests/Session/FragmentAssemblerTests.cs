using CsCheck;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Session;

public class FragmentAssemblerTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(448, 1)]
    [InlineData(449, 2)]
    [InlineData(896, 2)]
    [InlineData(1000, 3)]
    [Behaviour("protocol.fragments.count", "08, 2.5")]
    public void A_message_is_cut_into_parts_of_448_bytes(int length, int count) => Assert.Equal(count, FragmentHeader.CountFor(length));

    [Fact, Behaviour("protocol.fragments.any-order", "08, 2.5")]
    public void Messages_come_together_from_fragments_in_any_order_with_repeats_among_each_other()
        => Gen.Int.Sample(
            seed =>
            {
                var random = new Random(seed);
                byte[][] messages = [.. Enumerable.Range(0, 4).Select(_ => Bytes(random, random.Next(1, 3000)))];
                var parts = messages.SelectMany((message, i) => Cut(message, (uint)i)).ToList();
                parts.AddRange(parts.Where(part => part.Header.Count > 1 && random.Next(3) == 0).ToArray());
                (FragmentHeader Header, byte[] Data)[] mixed = [.. parts.OrderBy(_ => random.Next())];

                var assembler = new FragmentAssembler();
                var whole = new Dictionary<uint, string>();
                foreach ((FragmentHeader header, byte[] data) in mixed)
                {
                    assembler.Add(header, data, out ReadOnlySpan<byte> message);
                    if (!message.IsEmpty)
                        whole[header.Sequence] = Hex.Of(message);
                }

                Assert.Equal(messages.Select(message => Hex.Of(message)), messages.Select((_, i) => whole[(uint)i]));
            },
            iter: Fuzz.Cases(200),
            threads: 1);

    [Fact, Behaviour("protocol.fragments.contradictions", "08, 2.5")]
    public void Fragments_that_contradict_each_other_are_refused()
    {
        var assembler = new FragmentAssembler();
        byte[] full = new byte[448];
        Assert.Equal(DropReason.None, assembler.Add(Header(1, 3, 0, 448), full, out _));
        Assert.Equal(DropReason.BadMessage, assembler.Add(Header(1, 2, 1, 448), full, out _));
        Assert.Equal(DropReason.BadMessage, assembler.Add(Header(1, 3, 1, 10), full.AsSpan(0, 10), out _));
        Assert.Equal(DropReason.BadMessage, assembler.Add(Header(2, 1, 0, 0), [], out _));
        Assert.Equal(DropReason.BadMessage, assembler.Add(Header(3, ushort.MaxValue, 0, 448), full, out _));
        Assert.Equal(DropReason.Duplicate, assembler.Add(Header(1, 3, 0, 448), full, out _));
    }

    [Fact, Behaviour("protocol.fragments.bounded", "08, 8.3")]
    public void Messages_that_never_end_take_bounded_memory_and_the_oldest_goes()
    {
        var assembler = new FragmentAssembler();
        byte[] full = new byte[448];
        for (uint number = 0; number < 5000; number++)
            assembler.Add(Header(number, (ushort)(2 + (number % 140)), 0, 448), full, out _);
        Assert.InRange(assembler.Count, 1, FragmentAssembler.MostUnfinished);
        Assert.InRange(assembler.HeldBytes, 1, FragmentAssembler.MostBytes);
        Assert.Equal(5000, assembler.Count + assembler.Evicted);

        assembler.Add(Header(4999, (ushort)(2 + (4999 % 140)), 1, 448), full, out _);
        assembler.Add(Header(0, 2, 1, 4), [1, 2, 3, 4], out ReadOnlySpan<byte> evicted);
        Assert.True(evicted.IsEmpty);
    }

    private static byte[] Bytes(Random random, int length)
    {
        byte[] bytes = new byte[length];
        random.NextBytes(bytes);
        return bytes;
    }

    private static IEnumerable<(FragmentHeader Header, byte[] Data)> Cut(byte[] message, uint number)
    {
        var count = (ushort)FragmentHeader.CountFor(message.Length);
        return message.Chunk(448).Select((data, i) => (Header(number, count, (ushort)i, data.Length), data));
    }

    private static FragmentHeader Header(uint number, ushort count, ushort index, int data)
        => new(number, 0x80000000, count, (ushort)(16 + data), index, MessageGroup.Objects);
}
