using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>
/// Messages on their way: the bytes of each, and when they arrive. None overtakes another. The memory of messages that have arrived is used
/// again.
/// </summary>
internal sealed class MessageQueue
{
    private const int FirstSize = 128;
    private const int MostSize = 1 << 16;

    private Slot[] slots = [new(), new(), new(), new()];
    private int first;

    /// <summary>Messages that have not been taken off.</summary>
    public int Count { get; private set; }

    /// <summary>Puts a message behind the others.</summary>
    /// <param name="message">The message.</param>
    /// <param name="due">When it arrives, seconds.</param>
    /// <param name="stamp">Number of an ordered event.</param>
    /// <param name="guid">Object that an ordered event belongs to.</param>
    /// <exception cref="ArgumentException">It has no form on the wire.</exception>
    public void Enqueue<T>(in T message, double due, uint stamp = 0, uint guid = 0)
        where T : IMessage<T>
    {
        if (Count == slots.Length) Grow();
        Slot slot = slots[(first + Count) % slots.Length];
        while (!WireMessage.TryWrite(message, slot.Bytes, out slot.Length, stamp, guid))
        {
            if (slot.Bytes.Length >= MostSize) throw new ArgumentException($"This {T.Id} has no form on the wire.", nameof(message));
            slot.Bytes = new byte[2 * slot.Bytes.Length];
        }

        slot.Due = due;
        Count++;
    }

    /// <summary>The message that is first in the row, when it has arrived by now. It stays there.</summary>
    public bool TryPeek(double now, out WireMessage message)
    {
        message = default;
        Slot slot = slots[first];
        return Count > 0 && slot.Due <= now && WireMessage.TryParse(slot.Bytes.AsSpan(0, slot.Length), out message);
    }

    /// <summary>Takes off the message that is first in the row.</summary>
    public void Dequeue()
    {
        first = (first + 1) % slots.Length;
        Count--;
    }

    private void Grow()
    {
        Slot[] larger = new Slot[2 * slots.Length];
        for (int i = 0; i < larger.Length; i++) larger[i] = i < Count ? slots[(first + i) % slots.Length] : new Slot();
        (slots, first) = (larger, 0);
    }

    private sealed class Slot
    {
        internal byte[] Bytes = new byte[FirstSize];
        internal int Length;
        internal double Due;
    }
}
