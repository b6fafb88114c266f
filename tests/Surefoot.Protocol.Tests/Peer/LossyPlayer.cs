using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Peer;

/// <summary>A player whose datagrams are lost at random in both directions, once that is switched on.</summary>
internal sealed class LossyPlayer : IDatagramSink, IDisposable
{
    private readonly Stopwatch watch = Stopwatch.StartNew();
    private readonly Socket socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly byte[] buffer = new byte[2048];
    private readonly Random random;
    private readonly IPEndPoint server;

    public LossyPlayer(IPEndPoint server, string account, int seed)
    {
        random = new Random(seed);
        this.server = server;
        socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        Session = new ClientSession(new ClientSessionOptions { Account = account, Password = "testpass" }, this);
        Session.Connect(0);
    }

    public ClientSession Session { get; }

    public ReceivedMessages Received { get; } = new();

    /// <summary>Share of the datagrams that is lost.</summary>
    public double Loss { get; set; }

    /// <summary>Lets real time pass until something holds.</summary>
    /// <returns>False when it did not within the time.</returns>
    public bool Until(Func<bool> holds, double seconds)
    {
        double end = watch.Elapsed.TotalSeconds + seconds;
        while (!holds() && watch.Elapsed.TotalSeconds < end)
        {
            while (socket.Available > 0)
            {
                int length = socket.Receive(buffer);
                if (random.NextDouble() >= Loss)
                    Session.Receive(buffer.AsSpan(0, length), watch.Elapsed.TotalSeconds, Received);
            }

            Session.Update(watch.Elapsed.TotalSeconds, Received);
            Thread.Sleep(10);
        }

        return holds();
    }

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port)
    {
        if (random.NextDouble() >= Loss)
            socket.SendTo(datagram, new IPEndPoint(server.Address, server.Port + (int)port));
    }

    public void Dispose()
    {
        Session.Close();
        socket.Dispose();
    }
}
