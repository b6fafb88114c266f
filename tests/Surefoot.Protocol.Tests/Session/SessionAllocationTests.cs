using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Session;

public class SessionAllocationTests
{
    private static readonly WirePosition Place = new(0xA9B40019, new Vector3(84, 7, 94), Quaternion.Identity);

    [Fact, Behaviour("protocol.session.movement-allocates-nothing", "design.md, 4")]
    public void Movement_goes_through_both_sessions_without_allocating()
    {
        var pair = new Pair();
        for (int i = 0; i < 400; i++)
            pair.Advance();
        int before = pair.Seen;
        long start = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 400; i++)
            pair.Advance();
        long allocated = GC.GetAllocatedBytesForCurrentThread() - start;
        Assert.Equal(2 * 400, pair.Seen - before);
        Assert.Equal(0, allocated);
    }

    /// <summary>A client and a server that hand each other their datagrams at once.</summary>
    private sealed class Pair : IMessageReceiver, ISessionHandler
    {
        private readonly ClientSession client;
        private readonly ServerLink server;
        private double now;

        public Pair()
        {
            var toServer = new Way();
            var toClient = new Way();
            client = new ClientSession(new ClientSessionOptions { Account = "walker", Password = "testpass" }, toServer);
            server = new ServerLink(new ServerLinkOptions(3, 5, 6, 7), 72, toClient, 0);
            server.Admit();
            toServer.Receive = (bytes, port) => server.Receive(bytes, port, now, this);
            toClient.Receive = (bytes, _) => client.Receive(bytes, now, this);
            client.Connect(0);
            client.Receive(toClient.First, now, this);
        }

        public int Seen { get; private set; }

        public void Advance()
        {
            now += 1.0 / 60;
            client.Send(new AutonomousPosition(Place, new MovementStamps(1, 2, 3, 4), true));
            server.Send(new UpdatePosition(1, new PositionPack(Place, true, 1, 2, 3, 4)));
            client.Update(now, this);
            server.Update(now);
        }

        public void OnMessage(in WireMessage message)
        {
            if (message.TryRead(out AutonomousPosition _) || message.TryRead(out UpdatePosition _))
                Seen++;
        }

        public void OnStateChanged(SessionState state)
        {
        }

        private delegate void Taker(ReadOnlySpan<byte> bytes, ServerPort port);

        private sealed class Way : IDatagramSink
        {
            public byte[] First { get; private set; } = [];

            public Taker? Receive { get; set; }

            public void Send(ReadOnlySpan<byte> datagram, ServerPort port)
            {
                if (Receive is null)
                    First = datagram.ToArray();
                else
                    Receive(datagram, port);
            }
        }
    }
}
