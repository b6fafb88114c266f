using System.Diagnostics.CodeAnalysis;

namespace Surefoot.Protocol.Session;

/// <summary>Datagrams on their way over a bad network, both ways. What happens to them follows from a seed alone.</summary>
internal sealed class SimulatedLine(ulong seed)
{
    private readonly PriorityQueue<SimulatedDatagram, (double Due, long Number)> underway = new();
    private readonly Stack<byte[]> free = new();
    private ulong state = seed;
    private long sent;

    /// <summary>How bad the network is for what is sent from now on.</summary>
    internal NetworkQuality Quality { get; set; }

    /// <summary>Datagrams on their way.</summary>
    internal int Count => underway.Count;

    /// <summary>Sends a datagram, which may be lost or come twice.</summary>
    internal void Send(ReadOnlySpan<byte> datagram, ServerPort port, bool toServer, double now)
    {
        for (int copies = Roll() < Quality.Duplication ? 2 : 1; copies > 0; copies--)
        {
            if (Roll() < Quality.Loss) continue;
            double delay = Math.Max(0, Quality.Delay + (Quality.Jitter * ((2 * Roll()) - 1)));
            byte[] bytes = free.TryPop(out byte[]? old) && old.Length >= datagram.Length
                ? old
                : new byte[Math.Max(datagram.Length, PacketBuilder.MostLength)];
            datagram.CopyTo(bytes);
            underway.Enqueue(new SimulatedDatagram(bytes, datagram.Length, port, toServer), (now + delay, sent++));
        }
    }

    /// <summary>Takes the next datagram that has arrived; it is to be given back to <see cref="Free"/>.</summary>
    internal bool TryTake(double now, [NotNullWhen(true)] out SimulatedDatagram? datagram)
    {
        datagram = null;
        if (!underway.TryPeek(out SimulatedDatagram next, out (double Due, long Number) place) || place.Due > now) return false;
        underway.Dequeue();
        datagram = next;
        return true;
    }

    /// <summary>Nobody looks at a datagram any more.</summary>
    internal void Free(in SimulatedDatagram datagram) => free.Push(datagram.Memory);

    /// <summary>A number from 0 up to 1.</summary>
    /// <remarks>SplitMix64 (Steele, Lea and Flood, 2014): the same on every machine and in every version of the run time.</remarks>
    internal double Roll()
    {
        state += 0x9E3779B97F4A7C15;
        ulong z = state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        z ^= z >> 31;
        return (z >> 11) * (1.0 / (1UL << 53));
    }
}

/// <summary>A datagram on its way.</summary>
/// <param name="Memory">What its bytes lie in.</param>
/// <param name="Length">Number of its bytes.</param>
/// <param name="Port">The server's port that it goes to, or comes from.</param>
/// <param name="ToServer">Which way it goes.</param>
internal readonly record struct SimulatedDatagram(byte[] Memory, int Length, ServerPort Port, bool ToServer)
{
    internal Span<byte> Bytes => Memory.AsSpan(0, Length);
}
