namespace Surefoot.Protocol.Session;

/// <summary>Datagrams on their way from the one thread that receives to the one that reads, in memory that is used again. When it is full,
/// what arrives is dropped and counted: the server is asked for it later.</summary>
internal sealed class DatagramRing
{
    /// <summary>Longest datagram that is taken whole; servers of the field send at most 1024 bytes.</summary>
    public const int MostLength = 2048;

    private readonly byte[][] slots;
    private readonly int[] lengths;
    private long written, read, dropped;

    /// <summary>An empty ring.</summary>
    /// <param name="capacity">Most datagrams that wait.</param>
    public DatagramRing(int capacity)
    {
        slots = [.. Enumerable.Range(0, capacity).Select(_ => new byte[MostLength])];
        lengths = new int[capacity];
    }

    /// <summary>Datagrams dropped because the ring was full.</summary>
    public long Dropped => Interlocked.Read(ref dropped);

    /// <summary>The receiving thread puts a datagram in.</summary>
    public void Write(ReadOnlySpan<byte> datagram)
    {
        long position = written;
        if (position - Volatile.Read(ref read) >= slots.Length)
        {
            Interlocked.Increment(ref dropped);
            return;
        }

        int slot = (int)(position % slots.Length);
        datagram.CopyTo(slots[slot]);
        lengths[slot] = datagram.Length;
        Volatile.Write(ref written, position + 1);
    }

    /// <summary>The reading thread looks at the oldest datagram.</summary>
    public bool TryPeek(out ReadOnlySpan<byte> datagram)
    {
        if (read >= Volatile.Read(ref written))
        {
            datagram = [];
            return false;
        }

        int slot = (int)(read % slots.Length);
        datagram = slots[slot].AsSpan(0, lengths[slot]);
        return true;
    }

    /// <summary>The reading thread lets go of the oldest datagram.</summary>
    public void Release() => Volatile.Write(ref read, read + 1);
}
