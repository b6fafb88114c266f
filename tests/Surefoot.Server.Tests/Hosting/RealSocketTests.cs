using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Surefoot.DemoWorld;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>The server on real sockets, with clients as users have them.</summary>
public sealed class RealSocketTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(60);

    [Fact]
    [Behaviour("server.sockets", "spec/08, 8.1")]
    public void A_client_enters_over_real_sockets_and_another_one_sees_it_move()
    {
        using Running server = new(ground);
        using Player walker = new(server.EndPoint, "walker"), watcher = new(server.EndPoint, "watcher");
        walker.Enter();
        watcher.Enter();
        Assert.True(Player.Wait(() => watcher.Objects.ContainsKey(walker.Session.Player), walker, watcher));
        WirePosition place = walker.Objects[walker.Session.Player].Object.Physics.Position!.Value;
        walker.Session.Send(new MoveToState(new WireRawMotion(2, forwardCommand: 0x45000005), place, new(1, 0, 0, 0), true, false));
        Assert.True(Player.Wait(() => watcher.Motions.Any(motion => motion.Guid == walker.Session.Player), walker, watcher));
        walker.Session.LogOff();
        Assert.True(Player.Wait(() => walker.Session.State == SessionState.CharacterSelect, walker, watcher));
    }

    [Fact]
    [Behaviour("server.sockets.bad-network", "spec/08, 2.6: 200 ± 100 ms, 10 % loss, 5 % duplication and reordering")]
    public void A_client_enters_over_a_bad_network_between_real_sockets_and_hears_each_thing_it_says_once()
    {
        using Running server = new(ground);
        using BadProxy proxy = new(server.EndPoint, new NetworkQuality(0.2, 0.1, 0.1, 0.05), seed: 3);
        using Player walker = new(proxy.EndPoint, "walker");
        walker.Enter();
        for (int i = 0; i < 30; i++) walker.Session.Send(new Talk($"{i}"));
        Assert.True(Player.Wait(() => walker.Texts.Count >= 30, walker));
        Assert.Equal(Enumerable.Range(0, 30), walker.Texts.Select(int.Parse).Order());
    }

    [Fact]
    [Behaviour("server.sockets.taken", "design, decision 7")]
    public void A_port_that_is_taken_is_an_error_of_the_caller_and_leaves_none_open()
    {
        using Socket taken = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        int port;
        using (Running free = new(ground)) port = free.EndPoint.Port;
        taken.Bind(new IPEndPoint(IPAddress.Loopback, port + 1));
        Assert.Throws<SocketException>(() => new WorldServer(ground.Cache, Running.Options with { Port = port }));
        taken.Close();
        new WorldServer(ground.Cache, Running.Options with { Port = port }).Dispose();
    }

    [Theory]
    [InlineData(0, 0, 1.0)]
    [InlineData(70_000, 0, 1.0)]
    [InlineData(4, -1, 1.0)]
    [InlineData(4, 0, 0.0)]
    [InlineData(4, 0, double.NaN)]
    [Behaviour("server.options", "design, decision 7")]
    public void Options_out_of_range_are_refused(int slots, int perAddress, double logins) =>
        Assert.ThrowsAny<ArgumentException>(() => new WorldServer(
            ground.Cache, Running.Options with { Slots = slots, MostPerAddress = perAddress, LoginsPerSecond = logins }));

    /// <summary>A server on a thread of its own, on ports that are free.</summary>
    private sealed class Running : IDisposable
    {
        private readonly CancellationTokenSource ends = new();
        private readonly WorldServer server;
        private readonly Thread thread;

        internal Running(DemoGround ground)
        {
            server = new WorldServer(ground.Cache, Options);
            thread = new Thread(() => server.Run(ends.Token)) { IsBackground = true };
            thread.Start();
        }

        internal static WorldServerOptions Options => new() { Port = 0, Start = DemoGround.At(DemoPlaces.All[0].Name) };

        internal IPEndPoint EndPoint => server.EndPoint;

        public void Dispose()
        {
            ends.Cancel();
            thread.Join();
            server.Dispose();
            ends.Dispose();
        }
    }

    private sealed class Player(IPEndPoint server, string account) : ISessionHandler, IDisposable
    {
        internal WorldSession Session { get; } = new(server, new ClientSessionOptions { Account = account, Password = "secret" });

        internal Dictionary<uint, CreateObject> Objects { get; } = [];

        internal List<UpdateMotion> Motions { get; } = [];

        internal List<string> Texts { get; } = [];

        internal static bool Wait(Func<bool> isSo, params Player[] players)
        {
            for (long began = Stopwatch.GetTimestamp(); !isSo() && Stopwatch.GetElapsedTime(began) < Patience; Thread.Sleep(5))
                foreach (Player player in players) player.Session.Update(player);
            return isSo();
        }

        internal void Enter()
        {
            Assert.True(Wait(() => Session.State == SessionState.CharacterSelect, this), Session.Failure?.Sentence);
            Session.CreateCharacter(new CharacterCreate { Name = account });
            Assert.True(Wait(() => Session.Creation is not null, this));
            Session.EnterWorld(Session.Creation!.Value.Character!.Value.Guid);
            Assert.True(Wait(() => Session.Player != 0 && Objects.ContainsKey(Session.Player), this));
            Session.Send(new LoginComplete());
        }

        void ISessionHandler.OnStateChanged(SessionState state)
        {
        }

        void IMessageReceiver.OnMessage(in WireMessage message)
        {
            if (message.TryRead(out CreateObject create)) Objects[create.Object.Guid] = create;
            else if (message.TryRead(out UpdateMotion motion)) Motions.Add(motion);
            else if (message.TryRead(out HearSpeech speech)) Texts.Add(speech.Text);
        }

        public void Dispose() => Session.Dispose();
    }
}
