using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>Two sockets. What arrives waits in the system's own bounded buffers; the thread that asks is the only one there is.</summary>
internal sealed class UdpTransport : IServerTransport
{
    private const int KernelBuffer = 4 << 20, Attempts = 64;

    private readonly Socket first, second;
    private readonly SocketAddress sender, receiver;
    private bool asksSecond;

    /// <summary>Opens the ports.</summary>
    /// <param name="address">Address of this machine.</param>
    /// <param name="port">The first port; 0 for any that is free together with the next one.</param>
    /// <exception cref="SocketException">A port is taken, or not for us.</exception>
    public UdpTransport(IPAddress address, int port)
    {
        (first, second) = Open(address, port);
        sender = new SocketAddress(address.AddressFamily);
        receiver = new IPEndPoint(address, 1).Serialize();
        Port = ((IPEndPoint)first.LocalEndPoint!).Port;
    }

    public int Port { get; }

    public bool TryReceive(Span<byte> buffer, out ReadOnlySpan<byte> datagram, out ClientAddress from, out ServerPort port)
    {
        // By turns: who floods one port does not close the other.
        asksSecond = !asksSecond;
        port = asksSecond ? ServerPort.Second : ServerPort.First;
        if (TryReceive(asksSecond ? second : first, buffer, out datagram, out from)) return true;
        port = asksSecond ? ServerPort.First : ServerPort.Second;
        return TryReceive(asksSecond ? first : second, buffer, out datagram, out from);
    }

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port, ClientAddress to)
    {
        to.WriteTo(receiver);
        try
        {
            (port == ServerPort.First ? first : second).SendTo(datagram, SocketFlags.None, receiver);
        }
        catch (SocketException)
        {
            // As good as lost on the way: the other side asks for it.
        }
    }

    public void Wait(TimeSpan longest) => first.Poll(longest, SelectMode.SelectRead);

    public void Dispose()
    {
        first.Dispose();
        second.Dispose();
    }

    private bool TryReceive(Socket socket, Span<byte> buffer, out ReadOnlySpan<byte> datagram, out ClientAddress from)
    {
        datagram = [];
        from = default;
        while (socket.Poll(0, SelectMode.SelectRead))
        {
            try
            {
                datagram = buffer[..socket.ReceiveFrom(buffer, SocketFlags.None, sender)];
                from = ClientAddress.Of(sender);
                return true;
            }
            catch (SocketException)
            {
                // Too long for anybody's packet, or word of a client that is gone: others may follow.
            }
        }

        return false;
    }

    private static (Socket First, Socket Second) Open(IPAddress address, int port)
    {
        for (int attempt = 1; ; attempt++)
        {
            Socket? one = null;
            try
            {
                one = Bind(address, port);
                return (one, Bind(address, ((IPEndPoint)one.LocalEndPoint!).Port + 1));
            }
            catch (Exception error) when (error is SocketException or ArgumentOutOfRangeException)
            {
                // The next one may be somebody's: another pair is looked for.
                one?.Dispose();
                if (port != 0 || attempt == Attempts) throw;
            }
        }
    }

    private static Socket Bind(IPAddress address, int port)
    {
        Socket socket = new(address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
        try
        {
            socket.ReceiveBufferSize = socket.SendBufferSize = KernelBuffer;
            socket.Bind(new IPEndPoint(address, port));
            return socket;
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }
}
