using System.Diagnostics.CodeAnalysis;

namespace Surefoot.Protocol.Session;

/// <summary>A packet kept so that it can be sent again.</summary>
internal sealed class SentPacket
{
    public uint Sequence;
    public uint Key;
    public uint PayloadHash;
    public double SentAt;
    public int Length;
    public byte[] Bytes = [];
}

/// <summary>The numbered packets that the other side has not acknowledged, oldest first; their memory is used again.</summary>
internal sealed class SentPackets(int most)
{
    private readonly Queue<SentPacket> kept = new();
    private readonly Stack<SentPacket> free = new();

    /// <summary>Keeps a packet. When there are too many, the oldest goes.</summary>
    public void Keep(uint sequence, uint key, uint payloadHash, double now, ReadOnlySpan<byte> bytes)
    {
        if (kept.Count >= most)
            free.Push(kept.Dequeue());
        if (!free.TryPop(out SentPacket? packet))
            packet = new SentPacket();
        if (packet.Bytes.Length < bytes.Length)
            packet.Bytes = new byte[Math.Max(bytes.Length, PacketBuilder.MostLength)];
        packet.Sequence = sequence;
        packet.Key = key;
        packet.PayloadHash = payloadHash;
        packet.SentAt = now;
        packet.Length = bytes.Length;
        bytes.CopyTo(packet.Bytes);
        kept.Enqueue(packet);
    }

    /// <summary>Lets go of the packets before a number; the one of the number itself is kept, as by both sides of the field.</summary>
    public void Acknowledge(uint number)
    {
        while (kept.TryPeek(out SentPacket? oldest) && ReceiveWindow.IsNewer(oldest.Sequence, number))
            free.Push(kept.Dequeue());
    }

    /// <summary>Lets go of the packets sent before a time.</summary>
    public void ForgetBefore(double time)
    {
        while (kept.TryPeek(out SentPacket? oldest) && oldest.SentAt < time)
            free.Push(kept.Dequeue());
    }

    /// <summary>Finds a packet by its number.</summary>
    public bool TryFind(uint sequence, [NotNullWhen(true)] out SentPacket? packet)
    {
        foreach (SentPacket candidate in kept)
        {
            if (candidate.Sequence == sequence)
            {
                packet = candidate;
                return true;
            }
        }

        packet = null;
        return false;
    }
}
