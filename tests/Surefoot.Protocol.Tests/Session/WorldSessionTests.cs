using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>A session over real sockets of the loopback interface.</summary>
public class WorldSessionTests
{
    private static readonly Stopwatch Clock = Stopwatch.StartNew();

    private static readonly ClientSessionOptions Walker = new() { Account = "walker", Password = "testpass" };

    [Fact, Behaviour("protocol.socket.session", "08, 3")]
    public void A_session_over_sockets_logs_in_enters_talks_leaves_and_says_goodbye()
    {
        using var server = new SocketServer();
        using var session = new WorldSession(server.Address, Walker);
        var received = new ReceivedMessages();
        Enter(session, server, received);

        Assert.True(session.Send(new Talk(new string('a', 1000))));
        server.Scripted.Send(new Popup(new string('b', 2000)));
        Assert.True(Run(session, server, received, () => received.Of<Popup>().Count > 0 && Talks(server).Length > 0));
        Assert.Equal([new Talk(new string('a', 1000))], Talks(server));
        Assert.Equal([new Popup(new string('b', 2000))], received.Of<Popup>());

        session.LogOff();
        Assert.True(Run(session, server, received, () => session.State == SessionState.CharacterSelect));
        session.Dispose();
        Assert.True(Run(null, server, received, () => server.Scripted.Link!.State == ServerLinkState.Terminating));
        Assert.Equal(SessionState.Closed, session.State);
    }

    [Fact, Behaviour("protocol.socket.own-thread", "08, 2")]
    public void Messages_and_changes_of_state_come_on_the_thread_that_updates()
    {
        using var server = new SocketServer();
        using var session = new WorldSession(server.Address, Walker);
        var received = new Watchful();
        var watch = Stopwatch.StartNew();
        while (session.State != SessionState.CharacterSelect && watch.Elapsed.TotalSeconds < 20)
        {
            server.Pump(Clock.Elapsed.TotalSeconds);
            session.Update(received);
            Thread.Sleep(1);
        }

        Assert.Equal(SessionState.CharacterSelect, session.State);
        Assert.Equal([Environment.CurrentManagedThreadId], received.Threads);
    }

    [Fact, Behaviour("protocol.socket.back-pressure", "08, 2.6")]
    public void While_nobody_reads_datagrams_are_dropped_and_counted_and_come_later()
    {
        using var server = new SocketServer();
        using var session = new WorldSession(server.Address, Walker);
        var received = new ReceivedMessages();
        Enter(session, server, received);

        const int Messages = 700;
        for (int i = 0; i < Messages; i++)
        {
            server.Scripted.Send(new Popup(new string('b', 400) + i));
            server.Pump(Clock.Elapsed.TotalSeconds);
            if (i % 50 == 0)
                Thread.Sleep(1);
        }

        Assert.True(Run(session, server, received, () => received.Of<Popup>().Count == Messages, 40), $"{received.Of<Popup>().Count}");
        Assert.InRange(session.Statistics.Dropped(DropReason.NoRoom), 1, Messages);
    }

    [Fact, Behaviour("protocol.socket.server-restarts", "08, 2.7")]
    public void When_the_server_is_gone_the_session_says_so_and_a_new_one_connects_to_the_next_server()
    {
        IPEndPoint address;
        var received = new ReceivedMessages();
        using (var server = new SocketServer())
        {
            address = server.Address;
            using var session = new WorldSession(address, Walker with { SilenceTimeout = 1 });
            Enter(session, server, received);
            server.Dispose();
            Assert.True(Run(session, null, received, () => session.State == SessionState.Failed));
            Assert.Equal(SessionFailureKind.Silent, session.Failure?.Kind);
        }

        using var next = new SocketServer(address.Port);
        using var again = new WorldSession(address, Walker);
        Enter(again, next, received);
    }

    [Fact, Behaviour("protocol.socket.foreign-address", "08, 2.6")]
    public void Datagrams_from_another_address_are_counted_and_not_looked_at()
    {
        using var server = new SocketServer();
        using var session = new WorldSession(server.Address, Walker);
        var received = new ReceivedMessages();
        Enter(session, server, received);
        using var stranger = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        stranger.Bind(new IPEndPoint(IPAddress.Parse("127.0.0.2"), 0));
        for (int i = 0; i < 3; i++)
            stranger.SendTo(new byte[30], server.Client!);
        Assert.True(Run(session, server, received, () => session.ForeignDatagrams == 3));
        Assert.Equal(0, session.Statistics.Dropped(DropReason.Checksum));
    }

    [Fact, Behaviour("protocol.socket.handler-may-end-it", "design.md, 7")]
    public void A_handler_may_end_the_session_from_within()
    {
        using var server = new SocketServer();
        using var session = new WorldSession(server.Address, Walker);
        var handler = new Ender(session);
        var watch = Stopwatch.StartNew();
        while (session.State != SessionState.Closed && watch.Elapsed.TotalSeconds < 20)
        {
            server.Pump(Clock.Elapsed.TotalSeconds);
            session.Update(handler);
            Thread.Sleep(1);
        }

        Assert.Equal(SessionState.Closed, session.State);
        session.Update(handler);
        Assert.False(session.Send(new LoginComplete()));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(65535)]
    [Behaviour("protocol.socket.ports", "08, 3")]
    public void A_server_needs_two_ports(int port)
        => Assert.Throws<ArgumentOutOfRangeException>(() => new WorldSession(new IPEndPoint(IPAddress.Loopback, port), Walker));

    [Fact, Behaviour("protocol.socket.ring", "08, 2.6")]
    public void The_ring_between_the_threads_keeps_order_and_drops_what_it_has_no_room_for()
    {
        var ring = new DatagramRing(4);
        for (byte i = 0; i < 6; i++)
            ring.Write([i]);
        Assert.Equal(2, ring.Dropped);
        for (byte i = 0; i < 4; i++)
        {
            Assert.True(ring.TryPeek(out ReadOnlySpan<byte> datagram));
            Assert.Equal([i], datagram.ToArray());
            ring.Release();
            ring.Write([(byte)(10 + i)]);
        }

        Assert.True(ring.TryPeek(out ReadOnlySpan<byte> next));
        Assert.Equal([10], next.ToArray());
        Assert.Equal(2, ring.Dropped);
    }

    private static void Enter(WorldSession session, SocketServer server, ReceivedMessages received)
    {
        Reach(SessionState.CharacterSelect);
        session.EnterWorld(ScriptedServer.Character);
        Reach(SessionState.InWorld);

        void Reach(SessionState state)
            => Assert.True(Run(session, server, received, () => session.State == state), $"{session.State} {session.Failure}");
    }

    private static bool Run(WorldSession? session, SocketServer? server, ReceivedMessages received, Func<bool> holds, double seconds = 20)
    {
        var watch = Stopwatch.StartNew();
        while (!holds() && watch.Elapsed.TotalSeconds < seconds)
        {
            server?.Pump(Clock.Elapsed.TotalSeconds);
            session?.Update(received);
            Thread.Sleep(1);
        }

        return holds();
    }

    private static Talk[] Talks(SocketServer server)
    {
        List<Talk> found = [];
        foreach (byte[] bytes in server.Scripted.Received)
        {
            if (WireMessage.TryParse(bytes, out WireMessage message) && message.TryRead(out Talk talk))
                found.Add(talk);
        }

        return [.. found];
    }

    private sealed class Watchful : ISessionHandler
    {
        public HashSet<int> Threads { get; } = [];

        public void OnMessage(in WireMessage message) => Threads.Add(Environment.CurrentManagedThreadId);

        public void OnStateChanged(SessionState state) => Threads.Add(Environment.CurrentManagedThreadId);
    }

    private sealed class Ender(WorldSession session) : ISessionHandler
    {
        public void OnMessage(in WireMessage message) => session.Dispose();

        public void OnStateChanged(SessionState state)
        {
        }
    }
}
