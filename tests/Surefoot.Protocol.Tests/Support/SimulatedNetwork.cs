using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>How bad a network is.</summary>
/// <param name="Delay">Seconds each way.</param>
/// <param name="Jitter">Seconds that the delay varies both ways: datagrams overtake each other.</param>
/// <param name="Loss">Share that is lost.</param>
/// <param name="Duplication">Share that arrives twice.</param>
/// <param name="Damage">Share of which a bit flips.</param>
internal readonly record struct NetworkQuality(double Delay, double Jitter = 0, double Loss = 0, double Duplication = 0, double Damage = 0);

/// <summary>A client's session and a server's, joined by a seeded bad network, in simulated time.</summary>
internal sealed class SimulatedNetwork
{
    private const double Frame = 0.01;

    private readonly Random random;
    private readonly PriorityQueue<(byte[] Bytes, ServerPort Port, bool ToServer), double> underWay = new();

    public SimulatedNetwork(
        int seed, NetworkQuality quality, ClientSessionOptions? options = null, Func<IDatagramSink, ScriptedServer>? server = null)
    {
        random = new Random(seed);
        Quality = quality;
        options ??= new ClientSessionOptions { Account = "walker", Password = "testpass" };
        Client = new ClientSession(options, new Way(this, toServer: true));
        var toClient = new Way(this, toServer: false);
        Server = server?.Invoke(toClient) ?? new ScriptedServer(toClient);
    }

    public NetworkQuality Quality { get; set; }

    public ClientSession Client { get; }

    public ScriptedServer Server { get; }

    public ReceivedMessages Received { get; } = new();

    public double Now { get; private set; }

    /// <summary>The server is down: what is sent to it is lost, and it sends nothing.</summary>
    public bool ServerDown { get; set; }

    /// <summary>Bytes that have gone each way.</summary>
    public (long ToServer, long ToClient) Bytes { get; private set; }

    /// <summary>Lets time pass.</summary>
    public void Run(double seconds, Action? everyFrame = null)
    {
        double end = Now + seconds;
        while (Now < end)
        {
            Now += Frame;
            Deliver();
            everyFrame?.Invoke();
            Client.Update(Now, Received);
            if (!ServerDown)
                Server.Update(Now);
        }
    }

    /// <summary>Lets time pass until something holds.</summary>
    /// <returns>False when it did not within the time.</returns>
    public bool RunUntil(Func<bool> holds, double seconds)
    {
        double end = Now + seconds;
        while (!holds() && Now < end)
            Run(Frame);
        return holds();
    }

    /// <summary>Logs in and enters the world.</summary>
    public void EnterWorld()
    {
        Client.Connect(Now);
        Assert.True(RunUntil(() => Client.State == SessionState.CharacterSelect, 30), $"{Client.State} {Client.Failure}");
        Client.EnterWorld(ScriptedServer.Character);
        Assert.True(RunUntil(() => Client.State == SessionState.InWorld, 30), $"{Client.State} {Client.Failure}");
    }

    private void Deliver()
    {
        while (underWay.TryPeek(out (byte[] Bytes, ServerPort Port, bool ToServer) datagram, out double due) && due <= Now)
        {
            underWay.Dequeue();
            if (!datagram.ToServer)
                Client.Receive(datagram.Bytes, Now, Received);
            else if (!ServerDown)
                Server.Receive(datagram.Bytes, datagram.Port, Now);
        }
    }

    private void Send(ReadOnlySpan<byte> datagram, ServerPort port, bool toServer)
    {
        Bytes = toServer ? (Bytes.ToServer + datagram.Length, Bytes.ToClient) : (Bytes.ToServer, Bytes.ToClient + datagram.Length);
        for (int copies = random.NextDouble() < Quality.Duplication ? 2 : 1; copies > 0; copies--)
        {
            if (random.NextDouble() < Quality.Loss)
                continue;
            byte[] bytes = datagram.ToArray();
            if (random.NextDouble() < Quality.Damage)
                bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8));
            double delay = Quality.Delay + (Quality.Jitter * ((2 * random.NextDouble()) - 1));
            underWay.Enqueue((bytes, port, toServer), Now + Math.Max(0, delay));
        }
    }

    private sealed class Way(SimulatedNetwork network, bool toServer) : IDatagramSink
    {
        public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => network.Send(datagram, port, toServer);
    }
}
