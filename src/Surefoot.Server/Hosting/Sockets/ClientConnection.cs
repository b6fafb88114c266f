using System.Diagnostics.CodeAnalysis;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>One client's session: its link, its account, and what its messages are for at the moment.</summary>
internal sealed class ClientConnection : IMessageReceiver, IDatagramSink
{
    private readonly WorldServer server;
    private readonly IServerTransport transport;
    private ClientAddress answers;
    private uint eventStamp;

    public ClientConnection(WorldServer server, IServerTransport transport, ServerLinkOptions numbers, int loginLength, ClientAddress from)
    {
        this.server = server;
        this.transport = transport;
        Address = answers = from;
        Slot = numbers.NetId;
        Number = server.Figures.Logins;
        Link = new ServerLink(numbers, loginLength, this, server.Now);
    }

    /// <summary>Where its login came from.</summary>
    public ClientAddress Address { get; }

    /// <summary>Number of the session.</summary>
    public int Slot { get; }

    /// <summary>How many came before it.</summary>
    public long Number { get; }

    public ServerLink Link { get; }

    /// <summary>The account, in lower case; empty before the password was checked.</summary>
    public string Account { get; set; } = "";

    /// <summary>It may give commands.</summary>
    public bool IsAdministrator { get; set; }

    /// <summary>Its characters have been shown to it.</summary>
    public bool IsSelecting { get; set; }

    /// <summary>Its player in the world, or on its way out.</summary>
    public PlayerItem? Player { get; set; }

    /// <summary>When it sends next what has been put together, seconds.</summary>
    public double SendsAt { get; set; } = double.NegativeInfinity;

    /// <summary>When its account hears a sign of life next while it selects a character, seconds.</summary>
    public double NextPing { get; set; }

    /// <summary>Its password is checked, or its answer is waited for.</summary>
    public bool IsHalfOpen => Link.State is ServerLinkState.Verifying or ServerLinkState.AwaitingResponse;

    /// <summary>It has shown that it is where its datagrams say.</summary>
    public bool HasAnswered { get; private set; }

    /// <summary>It neither ends nor has ended.</summary>
    public bool IsAlive => Link.State is not (ServerLinkState.Terminating or ServerLinkState.Ended);

    /// <summary>Takes a connect response, which may come from another port of the client's machine than the login.</summary>
    /// <returns>True when it was the one that was waited for.</returns>
    public bool TryConnect(ReadOnlySpan<byte> datagram, ClientAddress from)
    {
        if (from.Address != Address.Address || Link.State != ServerLinkState.AwaitingResponse) return false;
        Link.Receive(datagram, ServerPort.Second, server.Now, this);
        if (Link.State != ServerLinkState.Connected) return false;
        answers = from;
        HasAnswered = true;
        return true;
    }

    /// <summary>Queues a message. A client for which there is no room any more has not listened for long: its session ends.</summary>
    public void Send<T>(in T message)
        where T : IMessage<T>
    {
        uint stamp = T.Id.Opcode == Opcode.GameEvent ? ++eventStamp : 0;
        uint guid = T.Id.Opcode == Opcode.GameEvent ? Player?.Id ?? 0 : 0;
        if (!Link.Send(message, guid, stamp)) Drop();
    }

    /// <summary>Queues the bytes of a message.</summary>
    public void Send(ReadOnlySpan<byte> message, MessageGroup group)
    {
        if (!Link.Send(message, group)) Drop();
    }

    /// <summary>Events are numbered from 1 again: a character enters the world.</summary>
    public void BeginEvents() => eventStamp = 0;

    void IDatagramSink.Send(ReadOnlySpan<byte> datagram, ServerPort port) => transport.Send(datagram, port, answers);

    [SuppressMessage("Design", "CA1031", Justification = "One client's message must not end the others' world; it is counted and told.")]
    void IMessageReceiver.OnMessage(in WireMessage message)
    {
        try
        {
            if (Player is { IsLeaving: false } player) player.Inbox.Take(message);
            else if (Player is null && IsSelecting) server.Lobby.Take(this, message);
        }
        catch (Exception error)
        {
            server.Figures.Faults++;
            server.Say($"the message {message.Id} of session {Slot} could not be handled; it ends: {error}");
            Link.Terminate(server.Now);
        }
    }

    private void Drop()
    {
        if (!IsAlive) return;
        server.Figures.SlowClients++;
        server.Say($"session {Slot} does not take what is sent to it; it ends");
        Link.Terminate(server.Now);
    }
}
