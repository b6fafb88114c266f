using Surefoot.DemoWorld;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>A server of the demo world on a simulated network, and its clients; time passes when a test says so.</summary>
internal sealed class SimulatedHost : IServerTransport
{
    private const double Frame = 1.0 / 60;
    private const int FirstPort = 9000;

    private readonly Dictionary<ClientAddress, TestClient> clients = [];
    private readonly Queue<(byte[] Bytes, ClientAddress From, ServerPort Port)> arrived = new();
    private ushort nextPort = 40000;

    internal SimulatedHost(DemoGround ground, Func<WorldServerOptions, WorldServerOptions>? change = null, double now = 0)
    {
        Now = now;
        WorldServerOptions options = new()
        {
            Start = DemoGround.At(DemoPlaces.All[0].Name),
            Spawns = Inhabitants(),
            RunSkill = 200,
            JumpSkill = 200,
            Log = line => Lines.Add(line),
        };
        Server = new WorldServer(ground.Cache, change is null ? options : change(options), this);
    }

    internal WorldServer Server { get; private set; }

    internal double Now { get; private set; }

    /// <summary>What the server said to its operator.</summary>
    internal List<string> Lines { get; } = [];

    /// <summary>Bytes that the server sent to an address that no client has.</summary>
    internal Dictionary<ClientAddress, long> SentToStrangers { get; } = [];

    internal IEnumerable<TestClient> Clients => clients.Values;

    int IServerTransport.Port => FirstPort;

    /// <summary>What the demo world has, its creatures standing.</summary>
    internal static IReadOnlyList<WorldSpawn> Inhabitants() =>
    [
        .. DemoSpawns.All.Select(spawn => new WorldSpawn(
            spawn.Name, spawn.Kind == DemoSpawnKind.Door ? WorldSpawnKind.Door : WorldSpawnKind.Creature, spawn.SetupId,
            new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)))),
    ];

    /// <summary>A client that asks for a session.</summary>
    internal TestClient Connect(
        string account, string password = "secret", NetworkQuality quality = default, ulong seed = 1,
        Func<ClientSessionOptions, ClientSessionOptions>? change = null, UInt128? from = null)
    {
        ClientAddress address = new(from ?? Loopback, nextPort++);
        TestClient client = new(this, address, account, password, quality, seed, change);
        clients.Add(address, client);
        client.Session.Connect(Now);
        return client;
    }

    /// <summary>A client whose character has entered the world and loaded it.</summary>
    internal TestClient Enter(string account, string? name = null, NetworkQuality quality = default, ulong seed = 1)
    {
        TestClient client = Connect(account, quality: quality, seed: seed);
        client.EnterAs(name ?? account);
        return client;
    }

    /// <summary>Lets time pass.</summary>
    internal void Run(double seconds, Action? eachFrame = null)
    {
        for (double end = Now + seconds; Now < end;)
        {
            Now += Frame;
            eachFrame?.Invoke();
            foreach (TestClient client in clients.Values) client.Update();
            Server.Tick(Now);
        }
    }

    /// <summary>Lets time pass until something is so, at most for so long.</summary>
    internal bool RunUntil(Func<bool> isSo, double longest = 30)
    {
        for (double end = Now + longest; Now < end && !isSo();) Run(Frame);
        return isSo();
    }

    /// <summary>A stranger sends something.</summary>
    internal void SendAsStranger(byte[] datagram, ClientAddress from, ServerPort port = ServerPort.First) =>
        arrived.Enqueue((datagram, from, port));

    /// <summary>The server's process is gone without a word; a new one is there at once.</summary>
    internal void Restart(DemoGround ground)
    {
        arrived.Clear();
        Server = new WorldServer(ground.Cache, Server.Options, this);
    }

    internal static UInt128 Loopback => ((UInt128)0xFFFF << 32) | 0x7F000001;

    bool IServerTransport.TryReceive(
        Span<byte> buffer, out ReadOnlySpan<byte> datagram, out ClientAddress from, out ServerPort port)
    {
        datagram = [];
        (from, port) = (default, default);
        foreach (TestClient client in clients.Values) client.Deliver(arrived);
        if (!arrived.TryDequeue(out (byte[] Bytes, ClientAddress From, ServerPort Port) next)) return false;
        next.Bytes.CopyTo(buffer);
        datagram = buffer[..next.Bytes.Length];
        (from, port) = (next.From, next.Port);
        return true;
    }

    void IServerTransport.Send(ReadOnlySpan<byte> datagram, ServerPort port, ClientAddress to)
    {
        if (clients.TryGetValue(to, out TestClient? client)) client.SendFromServer(datagram, port);
        else SentToStrangers[to] = SentToStrangers.GetValueOrDefault(to) + datagram.Length;
    }

    void IServerTransport.Wait(TimeSpan longest)
    {
    }

    void IDisposable.Dispose()
    {
    }
}
