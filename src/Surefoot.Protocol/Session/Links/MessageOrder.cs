using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>Lets messages through strictly in the order of their numbers, from 1; those that come early wait (specification 08,
/// 2.5).</summary>
internal sealed class MessageOrder
{
    /// <summary>Most waiting messages: more than the shortest ones in all packets that may be outstanding.</summary>
    public const int MostWaiting = 8192;

    /// <summary>Most bytes of all waiting messages.</summary>
    public const int MostBytes = 1 << 20;

    private readonly Dictionary<uint, byte[]> waiting = [];
    private uint next = 1;

    /// <summary>Messages that wait for earlier ones.</summary>
    public int Waiting => waiting.Count;

    /// <summary>Bytes of memory that they hold.</summary>
    public int WaitingBytes { get; private set; }

    /// <summary>Takes a whole message, and lets it and those behind it through when it is its turn.</summary>
    /// <returns>Why it was not used.</returns>
    public DropReason Add(uint number, ReadOnlySpan<byte> message, IMessageReceiver receiver)
    {
        if (number != next)
        {
            if (!ReceiveWindow.IsNewer(next, number) || waiting.ContainsKey(number))
                return DropReason.Duplicate;
            if (waiting.Count >= MostWaiting || WaitingBytes + message.Length > MostBytes)
                return DropReason.NoRoom;
            waiting.Add(number, message.ToArray());
            WaitingBytes += message.Length;
            return DropReason.None;
        }

        DropReason reason = Pass(message, receiver);
        while (waiting.Remove(next, out byte[]? held))
        {
            WaitingBytes -= held.Length;
            DropReason later = Pass(held, receiver);
            reason = reason == DropReason.None ? later : reason;
        }

        return reason;
    }

    private DropReason Pass(ReadOnlySpan<byte> bytes, IMessageReceiver receiver)
    {
        next = ReceiveWindow.After(next);
        if (!WireMessage.TryParse(bytes, out WireMessage message))
            return DropReason.BadMessage;
        receiver.OnMessage(message);
        return DropReason.None;
    }
}
