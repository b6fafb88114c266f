using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>A <see cref="ScriptedServer"/> on two real ports of the loopback interface. It does something only when it is pumped.</summary>
internal sealed class SocketServer : IDatagramSink, IDisposable
{
    private readonly byte[] buffer = new byte[2048];
    private readonly Socket[] sockets;

    /// <summary>A server on a port and the one after it.</summary>
    /// <param name="port">0 for any that are free.</param>
    public SocketServer(int port = 0)
    {
        sockets = port == 0 ? FreePair() : TryPair(port) ?? throw new InvalidOperationException($"Port {port} is taken.");
        Scripted = new ScriptedServer(this);
    }

    public ScriptedServer Scripted { get; }

    /// <summary>Where the last datagram came from.</summary>
    public EndPoint? Client { get; private set; }

    public IPEndPoint Address => (IPEndPoint)sockets[0].LocalEndPoint!;

    /// <summary>Takes what has arrived and does what time asks for.</summary>
    public void Pump(double now)
    {
        for (int port = 0; port < sockets.Length; port++)
        {
            while (sockets[port].Available > 0)
            {
                EndPoint sender = new IPEndPoint(IPAddress.Any, 0);
                int length = sockets[port].ReceiveFrom(buffer, ref sender);
                Client = sender;
                Scripted.Receive(buffer.AsSpan(0, length), (ServerPort)port, now);
            }
        }

        Scripted.Update(now);
    }

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => sockets[(int)port].SendTo(datagram, Client!);

    public void Dispose()
    {
        foreach (Socket socket in sockets)
            socket.Dispose();
    }

    private static Socket[] FreePair()
    {
        while (true)
        {
            if (TryPair(Random.Shared.Next(20_000, 60_000)) is { } pair)
                return pair;
        }
    }

    private static Socket[]? TryPair(int port)
    {
        Socket[] pair = [Udp(), Udp()];
        try
        {
            for (int i = 0; i < pair.Length; i++)
                pair[i].Bind(new IPEndPoint(IPAddress.Loopback, port + i));
            return pair;
        }
        catch (SocketException)
        {
            foreach (Socket socket in pair)
                socket.Dispose();
            return null;
        }
    }

    private static Socket Udp() => new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
}
