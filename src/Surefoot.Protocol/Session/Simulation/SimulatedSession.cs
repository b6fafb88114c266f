using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>
/// A server's session with a client over a network as bad as one likes, both ends in this process and all chance from a seed: what a
/// viewer's world hears of a server. It is opened for a viewer, given what the server says to it (<see cref="SendToClient"/>), and updated
/// each frame with a receiver for what has arrived, such as <c>RemoteWorld</c>. What the client says goes the other way in the same manner.
/// <code>
/// SimulatedSession session = new(new NetworkQuality(delay: 0.2, jitter: 0.1, loss: 0.05), seed: 1, now);
/// session.SendToClient(new UpdatePosition(…));   // as often as the server has something to say
/// session.Update(now, remoteWorld);              // each frame, after the physics' tick
/// session.Quality = session.Quality with { Loss = 0.1 };
/// </code>
/// </summary>
/// <remarks>
/// The packets, their acknowledgements and what is sent again are those of a real session. So what was lost comes late, nothing comes
/// twice, and the order is the sender's only where a session keeps it: a client hears messages in the order of arrival, which object stamps
/// put right, and a server in the order in which they were said. Messages of one frame share packets, and are lost and late together.
/// The same seed, times and messages give the same arrivals. Not safe for several threads. Specification 08, 2.6 and 8.9.
/// </remarks>
public sealed class SimulatedSession
{
    private const ushort NetId = 1;
    private const uint ServerSeed = 0x12345678, ClientSeed = 0x9ABCDEF0;

    /// <summary>So many bytes of login allow the server to answer.</summary>
    private const int LoginLength = 256;

    private const int LongestAction = 16384;

    private readonly SimulatedLine line;
    private readonly ClientLink client;
    private readonly ServerLink server;
    private readonly byte[] scratch = new byte[LongestAction];
    private double now;
    private uint actions;

    /// <summary>A session that is open: both ends know each other already.</summary>
    /// <param name="quality">How bad the network is from now on.</param>
    /// <param name="seed">Seed of everything that is left to chance.</param>
    /// <param name="now">Seconds, by the clock that is given later.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public SimulatedSession(NetworkQuality quality, ulong seed, double now = 0)
    {
        ThrowIfNotFinite(now);
        this.now = now;
        line = new SimulatedLine(seed);
        LoginRequest login = new(LoginRequest.LiveVersion, LoginRequest.PasswordAuth, 0, 0, "simulated", "simulated");
        client = new ClientLink(login, new Way(this, toServer: true));
        client.Open(now);
        while (line.TryTake(now, out SimulatedDatagram? request)) line.Free(request.Value);
        server = new ServerLink(
            new ServerLinkOptions(NetId, seed, ServerSeed, ClientSeed), LoginLength, new Way(this, toServer: false), now);
        server.Admit();

        // The handshake is over at once, on a perfect network.
        Deliver(Nobody.Instance, Nobody.Instance);
        server.Update(now);
        Deliver(Nobody.Instance, Nobody.Instance);
        line.Quality = quality;
    }

    /// <summary>How bad the network is for what is sent from now on; what is on its way arrives as it was going to.</summary>
    public NetworkQuality Quality
    {
        get => line.Quality;
        set => line.Quality = value;
    }

    /// <summary>
    /// Both ends still talk to each other. A network that lets nothing through for a minute, or clocks that stand still for as long, end
    /// a session; it does nothing any more then, and a new one is to be made.
    /// </summary>
    public bool IsAlive => client.State == LinkState.Connected && server.State == ServerLinkState.Connected;

    /// <summary>What the server's end has counted: packets sent again among it.</summary>
    public SessionStatistics ServerStatistics => server.Statistics;

    /// <summary>What the client's end has counted.</summary>
    public SessionStatistics ClientStatistics => client.Statistics;

    /// <summary>Datagrams on their way, both ways.</summary>
    public int UnderwayCount => line.Count;

    /// <summary>The server says something to the client; it goes out with the next <see cref="Update"/>.</summary>
    /// <param name="message">What it says.</param>
    /// <param name="guid">Object that an ordered event belongs to.</param>
    /// <param name="stamp">Number of an ordered event.</param>
    /// <returns>False when it has no form on the wire, there is no room for it, or the session is over.</returns>
    public bool SendToClient<T>(in T message, uint guid = 0, uint stamp = 0)
        where T : IMessage<T> => server.Send(message, guid, stamp);

    /// <summary>The client says something to the server; it goes out with the next <see cref="Update"/>.</summary>
    /// <param name="action">What it says.</param>
    /// <returns>False when it has no form on the wire, or the session is over.</returns>
    public bool SendToServer<T>(in T action)
        where T : IGameAction<T>
    {
        if (!WireMessage.TryWrite(action, scratch, out int length, actions + 1) || !client.Send(scratch.AsSpan(0, length), T.Group, now))
            return false;
        actions++;
        return true;
    }

    /// <summary>
    /// Lets the time pass: sends what was said and hands over what has arrived by now. To be called often, as each frame: nothing arrives
    /// in between.
    /// </summary>
    /// <param name="now">Seconds; a time before the last one counts as that.</param>
    /// <param name="atClient">Is told what the client hears.</param>
    /// <param name="atServer">Is told what the server hears; null for nobody.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Update(double now, IMessageReceiver atClient, IMessageReceiver? atServer = null)
    {
        ThrowIfNotFinite(now);
        ArgumentNullException.ThrowIfNull(atClient);
        this.now = Math.Max(this.now, now);
        server.Update(this.now);
        client.Flush(this.now);
        Deliver(atClient, atServer ?? Nobody.Instance);
        client.Update(this.now);
    }

    private static void ThrowIfNotFinite(double now)
    {
        if (!double.IsFinite(now))
            throw new ArgumentException("The time is not finite.", nameof(now));
    }

    private void Deliver(IMessageReceiver atClient, IMessageReceiver atServer)
    {
        while (line.TryTake(now, out SimulatedDatagram? taken))
        {
            SimulatedDatagram datagram = taken.Value;
            if (datagram.ToServer) server.Receive(datagram.Bytes, datagram.Port, now, atServer);
            else client.Receive(datagram.Bytes, now, atClient);
            line.Free(datagram);
        }
    }

    private sealed class Way(SimulatedSession session, bool toServer) : IDatagramSink
    {
        public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => session.line.Send(datagram, port, toServer, session.now);
    }

    private sealed class Nobody : IMessageReceiver
    {
        public static Nobody Instance { get; } = new();

        public void OnMessage(in WireMessage message)
        {
        }
    }
}
