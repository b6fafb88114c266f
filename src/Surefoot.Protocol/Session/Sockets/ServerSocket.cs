using System.Net;
using System.Net.Sockets;

namespace Surefoot.Protocol.Session;

/// <summary>A client's one socket for both ports of a server, and the thread that receives.</summary>
internal sealed class ServerSocket : IDatagramSink, IDisposable
{
    private const int Waiting = 512, StackSize = 256 * 1024, KernelBuffer = 1 << 20;

    private readonly Socket socket;
    private readonly SocketAddress first, second;
    private readonly Thread thread;
    private volatile bool disposed;
    private long foreign;

    public ServerSocket(IPEndPoint server)
    {
        first = server.Serialize();
        second = new IPEndPoint(server.Address, server.Port + 1).Serialize();
        socket = new Socket(server.AddressFamily, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = KernelBuffer };
        bool isLocal = IPAddress.IsLoopback(server.Address);
        bool isV6 = server.AddressFamily == AddressFamily.InterNetworkV6;
        socket.Bind(new IPEndPoint(isLocal ? server.Address : isV6 ? IPAddress.IPv6Any : IPAddress.Any, 0));
        thread = new Thread(Receive, StackSize) { IsBackground = true, Name = "Surefoot session" };
        thread.Start();
    }

    /// <summary>What has arrived from the server.</summary>
    public DatagramRing Arrived { get; } = new(Waiting);

    /// <summary>Datagrams that came from another address.</summary>
    public long Foreign => Interlocked.Read(ref foreign);

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port)
    {
        try
        {
            socket.SendTo(datagram, SocketFlags.None, port == ServerPort.First ? first : second);
        }
        catch (SocketException)
        {
            // As good as lost on the way: the other side asks for it.
        }
    }

    public void Dispose()
    {
        disposed = true;
        socket.Dispose();
        thread.Join();
    }

    private void Receive()
    {
        byte[] buffer = new byte[DatagramRing.MostLength];
        var sender = new SocketAddress(socket.AddressFamily);
        while (!disposed)
        {
            try
            {
                int length = socket.ReceiveFrom(buffer, SocketFlags.None, sender);
                if (IsFromServer(sender))
                    Arrived.Write(buffer.AsSpan(0, length));
                else
                    Interlocked.Increment(ref foreign);
            }
            catch (SocketException)
            {
                // A port that nobody listens to, or a datagram that is too long: others may follow. After the socket is closed the
                // loop ends.
            }
            catch (ObjectDisposedException)
            {
                return;
            }
        }
    }

    /// <summary>The address counts, not the port (specification 08, 2.6).</summary>
    private bool IsFromServer(SocketAddress sender)
    {
        (int start, int length) = sender.Family == AddressFamily.InterNetworkV6 ? (8, 16) : (4, 4);
        return sender.Family == first.Family
            && sender.Buffer.Span.Slice(start, length).SequenceEqual(first.Buffer.Span.Slice(start, length));
    }
}
