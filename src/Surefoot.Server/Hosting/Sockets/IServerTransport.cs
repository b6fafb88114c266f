using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>A server's two ports, on a network or on a simulated one.</summary>
internal interface IServerTransport : IDisposable
{
    /// <summary>Number of the first port.</summary>
    int Port { get; }

    /// <summary>Takes a datagram that has arrived.</summary>
    /// <param name="buffer">Takes its bytes.</param>
    /// <param name="datagram">Its bytes in the buffer.</param>
    /// <param name="from">Who sent it.</param>
    /// <param name="port">The port that it came to.</param>
    /// <returns>False when there is none.</returns>
    bool TryReceive(Span<byte> buffer, out ReadOnlySpan<byte> datagram, out ClientAddress from, out ServerPort port);

    /// <summary>Sends a datagram; it may be lost.</summary>
    void Send(ReadOnlySpan<byte> datagram, ServerPort port, ClientAddress to);

    /// <summary>Waits until something arrives at the first port, or for so long.</summary>
    void Wait(TimeSpan longest);
}
