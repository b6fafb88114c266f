using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>A client's session and a server's, joined by a seeded bad network, in simulated time.</summary>
internal sealed class SimulatedNetwork
{
    private const double Frame = 0.01;

    private readonly SimulatedLine line;

    public SimulatedNetwork(
        int seed, NetworkQuality quality, ClientSessionOptions? options = null, Func<IDatagramSink, ScriptedServer>? server = null)
    {
        line = new SimulatedLine((ulong)seed) { Quality = quality };
        options ??= new ClientSessionOptions { Account = "walker", Password = "testpass" };
        Client = new ClientSession(options, new Way(this, toServer: true));
        var toClient = new Way(this, toServer: false);
        Server = server?.Invoke(toClient) ?? new ScriptedServer(toClient);
    }

    public NetworkQuality Quality
    {
        get => line.Quality;
        set => line.Quality = value;
    }

    /// <summary>Share of datagrams of which a bit flips.</summary>
    public double Damage { get; set; }

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
        while (line.TryTake(Now, out SimulatedDatagram? taken))
        {
            SimulatedDatagram datagram = taken.Value;
            if (line.Roll() < Damage)
                datagram.Bytes[(int)(line.Roll() * datagram.Length)] ^= (byte)(1 << (int)(line.Roll() * 8));
            if (!datagram.ToServer)
                Client.Receive(datagram.Bytes, Now, Received);
            else if (!ServerDown)
                Server.Receive(datagram.Bytes, datagram.Port, Now);
            line.Free(datagram);
        }
    }

    private void Send(ReadOnlySpan<byte> datagram, ServerPort port, bool toServer)
    {
        Bytes = toServer ? (Bytes.ToServer + datagram.Length, Bytes.ToClient) : (Bytes.ToServer, Bytes.ToClient + datagram.Length);
        line.Send(datagram, port, toServer, Now);
    }

    private sealed class Way(SimulatedNetwork network, bool toServer) : IDatagramSink
    {
        public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => network.Send(datagram, port, toServer);
    }
}
