using System.Net;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>A client's session with a server over UDP. One thread receives and puts what comes into a bounded queue; everything else
/// happens within the calls of the owner, so that messages and changes of state come on the owner's thread and nothing waits. While the
/// owner does not call, the queue fills; when it is full, datagrams are dropped, counted as <see cref="DropReason.NoRoom"/> and asked for
/// again later. It is not safe for several threads.</summary>
public sealed class WorldSession : IDisposable
{
    private readonly ServerSocket socket;
    private readonly TimeProvider clock;
    private readonly long began;
    private readonly ClientSession session;
    private long countedDrops;

    /// <summary>Opens a socket and asks the server for a session.</summary>
    /// <param name="server">The server's first port; the next one is used too.</param>
    /// <param name="options">Who logs in.</param>
    /// <param name="clock">Measures time; the system's by default.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no next port, or no port at all.</exception>
    /// <exception cref="System.Net.Sockets.SocketException">The system gives no socket.</exception>
    public WorldSession(IPEndPoint server, ClientSessionOptions options, TimeProvider? clock = null)
    {
        ArgumentOutOfRangeException.ThrowIfZero(server.Port, nameof(server));
        ArgumentOutOfRangeException.ThrowIfEqual(server.Port, IPEndPoint.MaxPort, nameof(server));
        this.clock = clock ?? TimeProvider.System;
        began = this.clock.GetTimestamp();
        socket = new ServerSocket(server);
        session = new ClientSession(options, socket);
        session.Connect(Now);
    }

    /// <summary>How far it has come.</summary>
    public SessionState State => session.State;

    /// <summary>Why the session ended by itself; null while it has not.</summary>
    public SessionFailure? Failure => session.Failure;

    /// <summary>Why the last wish to enter the world was refused; null when it was not.</summary>
    public SessionFailure? Refusal => session.Refusal;

    /// <summary>The account's characters; null before they are known.</summary>
    public CharacterList? Characters => session.Characters;

    /// <summary>Name of the server's world; null before it is known.</summary>
    public ServerName? Server => session.Server;

    /// <summary>What came of the last character that was to be made; null before.</summary>
    public CharacterCreateResponse? Creation => session.Creation;

    /// <summary>The player's object; 0 outside of the world.</summary>
    public uint Player => session.Player;

    /// <summary>What the session has counted.</summary>
    public SessionStatistics Statistics => session.Statistics;

    /// <summary>Seconds that the last echo took; null before the first.</summary>
    public double? RoundTrip => session.RoundTrip;

    /// <summary>Seconds since the server was heard last.</summary>
    public double SilentFor => session.SilentFor;

    /// <summary>The server's clock; null before it was heard.</summary>
    public double? ServerTime => session.ServerTime;

    /// <summary>Datagrams that came from another address than the server's.</summary>
    public long ForeignDatagrams => socket.Foreign;

    private double Now => clock.GetElapsedTime(began).TotalSeconds;

    /// <summary>Takes what has arrived, does what time asks for and sends what has been put together. To be called every frame, and at
    /// least every tenth of a second.</summary>
    /// <param name="handler">Told what has come.</param>
    public void Update(ISessionHandler handler)
    {
        while (socket.Arrived.TryPeek(out ReadOnlySpan<byte> datagram))
        {
            session.Receive(datagram, Now, handler);
            socket.Arrived.Release();
        }

        for (long drops = socket.Arrived.Dropped; countedDrops < drops; countedDrops++)
            Statistics.Count(DropReason.NoRoom);
        session.Update(Now, handler);
    }

    /// <summary>Sends what has been put together at once, instead of with the next <see cref="Update"/>.</summary>
    public void Flush() => session.Flush();

    /// <inheritdoc cref="ClientSession.Send{T}(in T)"/>
    public bool Send<T>(in T message)
        where T : IMessage<T> => session.Send(message);

    /// <inheritdoc cref="ClientSession.Send(ReadOnlySpan{byte}, MessageGroup)"/>
    public bool Send(ReadOnlySpan<byte> message, MessageGroup group) => session.Send(message, group);

    /// <inheritdoc cref="ClientSession.CreateCharacter"/>
    public void CreateCharacter(CharacterCreate character) => session.CreateCharacter(character);

    /// <inheritdoc cref="ClientSession.EnterWorld"/>
    public void EnterWorld(uint guid) => session.EnterWorld(guid);

    /// <inheritdoc cref="ClientSession.LogOff"/>
    public void LogOff() => session.LogOff();

    /// <inheritdoc cref="ClientSession.AwaitObject"/>
    public void AwaitObject(uint guid) => session.AwaitObject(guid);

    /// <inheritdoc cref="ClientSession.ForgetObject"/>
    public void ForgetObject(uint guid) => session.ForgetObject(guid);

    /// <summary>Says goodbye and closes the socket. A character in the world is logged off by the server then.</summary>
    public void Dispose()
    {
        session.Close();
        socket.Dispose();
    }
}
