using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Serving;

/// <summary>A client's socket without a thread: many of them are asked in turn by one.</summary>
internal sealed class LoadSocket : IDatagramSink, IDisposable
{
    private readonly Socket socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly SocketAddress first, second;

    internal LoadSocket(IPEndPoint server)
    {
        first = server.Serialize();
        second = new IPEndPoint(server.Address, server.Port + 1).Serialize();
        socket.Bind(new IPEndPoint(server.Address, 0));
    }

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port) =>
        socket.SendTo(datagram, SocketFlags.None, port == ServerPort.First ? first : second);

    public void Dispose() => socket.Dispose();

    /// <summary>Takes a datagram that has arrived; 0 bytes when there is none.</summary>
    internal int Receive(Span<byte> buffer) => socket.Poll(0, SelectMode.SelectRead) ? socket.Receive(buffer) : 0;
}
