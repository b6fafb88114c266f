using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Session;

public class MessageOrderTests
{
    private readonly MessageOrder order = new();
    private readonly ReceivedMessages received = new();

    [Fact, Behaviour("protocol.order.by-number", "08, 2.5")]
    public void A_servers_messages_are_executed_in_the_order_of_their_numbers_from_one()
    {
        foreach (byte number in (byte[])[3, 1, 5, 2, 2, 1])
            order.Add(number, [number, 0, 0, 0], received);
        Assert.Equal([1, 2, 3], received.All.Select(bytes => (int)bytes[0]));
        Assert.Equal(1, order.Waiting);
        Assert.Equal(DropReason.Duplicate, order.Add(3, [3, 0, 0, 0], received));
    }

    [Fact, Behaviour("protocol.order.without-opcode", "08, 2.5")]
    public void A_message_that_is_too_short_counts_for_the_order()
    {
        Assert.Equal(DropReason.BadMessage, order.Add(1, [1, 2], received));
        Assert.Equal(DropReason.None, order.Add(2, [2, 0, 0, 0], received));
        Assert.Single(received.All);
    }

    [Fact, Behaviour("protocol.order.bounded", "08, 8.3")]
    public void Messages_that_wait_for_one_that_never_comes_take_bounded_memory()
    {
        for (uint number = 2; number < 20_000; number++)
            order.Add(number, [1, 0, 0, 0], received);
        Assert.Equal(MessageOrder.MostWaiting, order.Waiting);

        var longer = new MessageOrder();
        for (uint number = 2; number < 100; number++)
            longer.Add(number, new byte[60_000], received);
        Assert.InRange(longer.WaitingBytes, 1, MessageOrder.MostBytes);
        Assert.Equal(DropReason.NoRoom, longer.Add(200, new byte[60_000], received));
    }
}
