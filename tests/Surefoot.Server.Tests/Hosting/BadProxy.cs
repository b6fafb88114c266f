using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>A bad network between the real sockets of one client and a server: what is lost, late or doubled follows from a seed.</summary>
internal sealed class BadProxy : IDisposable
{
    private const int Longest = 2048;

    private readonly SimulatedLine line;
    private readonly Socket first, second, back;
    private readonly IPEndPoint server;
    private readonly Thread thread;
    private readonly long began = Stopwatch.GetTimestamp();
    private EndPoint? client;
    private volatile bool ends;

    internal BadProxy(IPEndPoint server, NetworkQuality quality, ulong seed)
    {
        this.server = server;
        line = new SimulatedLine(seed) { Quality = quality };
        back = Bind(0);
        for (; ; )
        {
            first = Bind(0);
            try
            {
                second = Bind(((IPEndPoint)first.LocalEndPoint!).Port + 1);
                break;
            }
            catch (Exception error) when (error is SocketException or ArgumentOutOfRangeException)
            {
                first.Dispose();
            }
        }

        thread = new Thread(Run) { IsBackground = true };
        thread.Start();
    }

    /// <summary>Where the client finds the server.</summary>
    internal IPEndPoint EndPoint => (IPEndPoint)first.LocalEndPoint!;

    private double Now => Stopwatch.GetElapsedTime(began).TotalSeconds;

    public void Dispose()
    {
        ends = true;
        thread.Join();
        first.Dispose();
        second.Dispose();
        back.Dispose();
    }

    private static Socket Bind(int port)
    {
        Socket socket = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Loopback, port));
        return socket;
    }

    private void Run()
    {
        byte[] buffer = new byte[Longest];
        while (!ends)
        {
            EndPoint from = new IPEndPoint(IPAddress.Any, 0);
            for (int i = 0; i < 2; i++)
            {
                while ((i == 0 ? first : second).Poll(0, SelectMode.SelectRead))
                {
                    int length = (i == 0 ? first : second).ReceiveFrom(buffer, ref from);
                    client = from;
                    line.Send(buffer.AsSpan(0, length), i == 0 ? ServerPort.First : ServerPort.Second, toServer: true, Now);
                }
            }

            while (back.Poll(0, SelectMode.SelectRead))
            {
                int length = back.ReceiveFrom(buffer, ref from);
                ServerPort port = ((IPEndPoint)from).Port == server.Port ? ServerPort.First : ServerPort.Second;
                line.Send(buffer.AsSpan(0, length), port, toServer: false, Now);
            }

            while (line.TryTake(Now, out SimulatedDatagram? taken))
            {
                SimulatedDatagram datagram = taken.Value;
                int number = datagram.Port == ServerPort.First ? 0 : 1;
                if (datagram.ToServer) back.SendTo(datagram.Bytes, new IPEndPoint(server.Address, server.Port + number));
                else if (client is not null) (number == 0 ? first : second).SendTo(datagram.Bytes, client);
                line.Free(datagram);
            }

            Thread.Sleep(1);
        }
    }
}
