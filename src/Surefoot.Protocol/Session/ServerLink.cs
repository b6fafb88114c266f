using System.Buffers.Binary;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>How far a server's session with one client has come (specification 08, 8.1).</summary>
public enum ServerLinkState
{
    /// <summary>The connect request has been sent; the password is being checked.</summary>
    Verifying,

    /// <summary>The password is right; the connect response is waited for.</summary>
    AwaitingResponse,

    /// <summary>Messages go both ways.</summary>
    Connected,

    /// <summary>No message is taken any more; what is queued still goes out.</summary>
    Terminating,

    /// <summary>Nothing happens any more.</summary>
    Ended,
}

/// <summary>What a server chooses for a session.</summary>
/// <param name="NetId">Number of the session; 0 is a number like others.</param>
/// <param name="Cookie">A random number that the client must send back.</param>
/// <param name="ServerSeed">Random seed of the server's key stream.</param>
/// <param name="ClientSeed">Random seed of the client's key stream.</param>
/// <param name="ServerId">What goes into the server's headers.</param>
public readonly record struct ServerLinkOptions(ushort NetId, ulong Cookie, uint ServerSeed, uint ClientSeed, ushort ServerId = 0x000B);

/// <summary>A server's side of a session with one client: handshake, numbers, acknowledgements, clocks (specification 08, section 8). It
/// reads no clock and knows no socket: who owns it finds it by the client's address, hands in datagrams and the time, and sends what comes
/// out.</summary>
public sealed class ServerLink
{
    private const double AckInterval = 2.0, ClockInterval = 20, NakInterval = 1, Linger = 2, PacketLife = 120;
    private const double VerifyTimeout = 15, Timeout = 60;
    private const int Window = 256, MostKeptPackets = 4096;
    private const uint Blob = 0x80000000;
    private const ushort Iteration = 1, DefaultServerId = 0x000B;

    private readonly ServerLinkOptions options;
    private readonly PacketChannel channel;
    private readonly FragmentAssembler assembler = new();
    private readonly MessageOrder order = new();
    private readonly MessageBundles bundles = new();
    private byte[]? scratch;
    private double lastReceived, lastAck, lastNak, endsAt;
    private double lastClock = double.NegativeInfinity;
    private float? dueEcho;
    private uint nextMessage;
    private bool hasAnswered;

    /// <summary>Begins a session: sends the connect request.</summary>
    /// <param name="options">Numbers of the session.</param>
    /// <param name="loginLength">Bytes of the login request's datagram: until the client has answered, at most three times what it sent is
    /// sent to it.</param>
    /// <param name="sink">Sends datagrams to the client.</param>
    /// <param name="now">The server's clock, seconds; it goes into headers and clocks too.</param>
    public ServerLink(ServerLinkOptions options, int loginLength, IDatagramSink sink, double now)
    {
        this.options = options;
        Statistics.BytesReceived = loginLength;
        channel = new PacketChannel(
            options.ServerSeed, new ReceiveWindow(options.ClientSeed, Window, Window), options.ServerId, Iteration, MostKeptPackets,
            new Sender(this, sink), Statistics);
        lastReceived = lastAck = now;
        lastNak = double.NegativeInfinity;
        SendConnectRequest(now);
    }

    /// <summary>How far it has come.</summary>
    public ServerLinkState State { get; private set; }

    /// <summary>What it has counted.</summary>
    public SessionStatistics Statistics { get; } = new();

    /// <summary>Messages that wait for earlier ones, and unfinished ones: what the client makes the server keep.</summary>
    public int HeldMessages => order.Waiting + assembler.Count;

    /// <summary>Reads a login request, which is what makes a server begin a session.</summary>
    /// <returns>Null for any other datagram and for a damaged one.</returns>
    public static LoginRequest? TryReadLogin(ReadOnlySpan<byte> bytes)
    {
        if (Datagram.TryParse(bytes, out Datagram datagram) != DropReason.None)
            return null;
        return datagram.Has(PacketFlags.LoginRequest) && !datagram.Header.IsEncrypted && datagram.IsIntact
            ? LoginRequest.TryRead(datagram.Handshake)
            : null;
    }

    /// <summary>Writes the packet that refuses a client of another version. It belongs to no session: its number is 0, and its checksum is
    /// made with a word that nobody knows (specification 08, 3.2).</summary>
    /// <param name="boot">What it is told.</param>
    /// <param name="now">The server's clock, seconds.</param>
    /// <param name="word">Any number.</param>
    /// <returns>The datagram; empty when the text is too long for one.</returns>
    public static byte[] WriteRefusalOfVersion(in AccountBoot boot, double now, uint word)
    {
        Span<byte> bytes = stackalloc byte[FragmentHeader.MostData];
        if (!WireMessage.TryWrite(boot, bytes, out int length))
            return [];
        var packet = new PacketBuilder();
        packet.Add(
            new FragmentHeader(0, Blob, 1, (ushort)(FragmentHeader.Length + length), 0, MessageGroup.Interface), bytes[..length]);
        return packet.Seal(0, DefaultServerId, TimeOf(now), Iteration, word).ToArray();
    }

    /// <summary>The client's login request came again, so that the connect request may have been lost: sends it again, unless the client
    /// has answered.</summary>
    /// <param name="loginLength">Bytes of the repeated datagram.</param>
    /// <param name="now">The time.</param>
    public void Repeat(int loginLength, double now)
    {
        if (State is not (ServerLinkState.Verifying or ServerLinkState.AwaitingResponse))
            return;
        Statistics.BytesReceived += loginLength;
        SendConnectRequest(now);
    }

    /// <summary>The password is right: the connect response is taken from now on.</summary>
    public void Admit()
    {
        if (State == ServerLinkState.Verifying)
            State = ServerLinkState.AwaitingResponse;
    }

    /// <summary>Takes a datagram of the client.</summary>
    /// <param name="bytes">The datagram.</param>
    /// <param name="port">The port that it came to.</param>
    /// <param name="now">The time.</param>
    /// <param name="receiver">Takes the messages, in the order in which the client made them.</param>
    public void Receive(ReadOnlySpan<byte> bytes, ServerPort port, double now, IMessageReceiver receiver)
    {
        Statistics.DatagramsReceived++;
        Statistics.BytesReceived += bytes.Length;
        DropReason reason = Datagram.TryParse(bytes, out Datagram datagram);
        if (reason == DropReason.None)
            reason = port == ServerPort.Second ? ReceiveResponse(datagram, now) : ReceivePacket(datagram, now, receiver);
        Statistics.Count(reason);
    }

    /// <summary>Queues a message.</summary>
    /// <param name="message">The message.</param>
    /// <param name="guid">Object that an ordered event belongs to.</param>
    /// <param name="stamp">Number of an ordered event.</param>
    /// <returns>False when it has no form on the wire, or there is no room for it.</returns>
    public bool Send<T>(in T message, uint guid = 0, uint stamp = 0)
        where T : IMessage<T>
    {
        // Who never gets so far must not cost so much.
        scratch ??= new byte[FragmentAssembler.MostLength];
        return WireMessage.TryWrite(message, scratch, out int length, stamp, guid) && Send(scratch.AsSpan(0, length), T.Group);
    }

    /// <summary>Queues the bytes of a message.</summary>
    /// <returns>False when there is no room for it.</returns>
    public bool Send(ReadOnlySpan<byte> message, MessageGroup group)
        => State is not ServerLinkState.Ended && message.Length is > 0 and <= FragmentAssembler.MostLength && bundles.Add(message, group);

    /// <summary>Sends a last message and lets the session end.</summary>
    public void Refuse<T>(in T message, double now)
        where T : IMessage<T>
    {
        Send(message);
        Terminate(now);
    }

    /// <summary>Lets the session end: after two seconds, in which what is queued goes out.</summary>
    public void Terminate(double now)
    {
        if (State is ServerLinkState.Terminating or ServerLinkState.Ended)
            return;
        State = ServerLinkState.Terminating;
        endsAt = now + Linger;
    }

    /// <summary>Does what time asks for, and sends what is queued.</summary>
    public void Update(double now)
    {
        if (State == ServerLinkState.Ended)
            return;
        channel.Time = TimeOf(now);
        double patience = State is ServerLinkState.Verifying or ServerLinkState.AwaitingResponse ? VerifyTimeout : Timeout;
        if (now - lastReceived > patience)
            Terminate(now);
        channel.ForgetBefore(now - PacketLife);

        if (hasAnswered && now - lastAck >= AckInterval)
        {
            channel.DueAck = channel.Incoming.InOrder;
            lastAck = now;
        }

        bool isClockDue = State == ServerLinkState.Connected && now - lastClock >= ClockInterval;
        if (isClockDue || dueEcho is not null)
        {
            channel.SendClock(isClockDue ? now : null, null, dueEcho is { } echo ? (echo, (float)now - echo) : null, now);
            lastClock = isClockDue ? now : lastClock;
            dueEcho = null;
        }

        channel.SendDueAck();
        bundles.MoveTo(channel, ref nextMessage, Blob, now);
        channel.Flush(now);
        if (State == ServerLinkState.Terminating && now >= endsAt)
            State = ServerLinkState.Ended;
    }

    private void SendConnectRequest(double now)
    {
        var writer = new WireWriter(stackalloc byte[ConnectRequest.Length]);
        new ConnectRequest(now, options.Cookie, options.NetId, options.ServerSeed, options.ClientSeed).Write(ref writer);
        channel.SendBare(PacketFlags.ConnectRequest, writer.Written, options.ServerId, TimeOf(now), ServerPort.First);
    }

    private static ushort TimeOf(double now) => (ushort)(long)now;

    private DropReason ReceiveResponse(in Datagram datagram, double now)
    {
        if (!datagram.Has(PacketFlags.ConnectResponse) || State != ServerLinkState.AwaitingResponse)
            return DropReason.Unexpected;
        if (datagram.Header.IsEncrypted || !datagram.IsIntact)
            return DropReason.Checksum;
        if (BinaryPrimitives.ReadUInt64LittleEndian(datagram.Handshake) != options.Cookie)
            return DropReason.Foreign;
        State = ServerLinkState.Connected;
        hasAnswered = true;
        channel.Port = ServerPort.Second;
        lastReceived = now;
        return DropReason.None;
    }

    private DropReason ReceivePacket(in Datagram datagram, double now, IMessageReceiver receiver)
    {
        if (State is ServerLinkState.Ended or ServerLinkState.Verifying or ServerLinkState.AwaitingResponse)
            return DropReason.Unexpected;
        if (datagram.Header.Id != options.NetId)
            return DropReason.Foreign;
        if (!datagram.Header.IsEncrypted)
            return ReceiveCleartext(datagram, now);

        DropReason reason = channel.Incoming.Accept(datagram, out _);

        // So many are missing that they cannot be asked for: the session would wait for them for ever.
        if (reason is DropReason.TooFarAhead or DropReason.TooManyMissing && channel.Incoming.IsMadeWithDueWord(datagram))
            Terminate(now);
        if (reason != DropReason.None)
            return reason;
        lastReceived = now;
        if (datagram.Has(PacketFlags.NetErrorDisconnect))
            Terminate(now);
        if (datagram.Header.Sequence - channel.Incoming.InOrder is >= 3 and <= Window && now - lastNak > NakInterval)
        {
            channel.RequestMissing();
            lastNak = now;
        }

        if (datagram.Has(PacketFlags.EchoRequest))
            dueEcho = datagram.Echo;
        if (datagram.Has(PacketFlags.AckSequence))
            channel.Acknowledge(datagram.Ack);
        if (State == ServerLinkState.Connected)
            Deliver(datagram, now, receiver);
        return DropReason.None;
    }

    private DropReason ReceiveCleartext(in Datagram datagram, double now)
    {
        // Only these come in clear text; none has a number of its own.
        if ((datagram.Header.Flags & ~(PacketFlags.RequestRetransmit | PacketFlags.AckSequence | PacketFlags.Disconnect)) != 0)
            return DropReason.Unexpected;
        if (!datagram.IsIntact)
            return DropReason.Checksum;
        if (datagram.Has(PacketFlags.Disconnect))
            Terminate(now);
        lastReceived = now;
        if (datagram.Has(PacketFlags.RequestRetransmit))
            channel.Resend(datagram.Requested, rejects: true, now);
        if (datagram.Has(PacketFlags.AckSequence))
            channel.Acknowledge(datagram.Ack);
        return DropReason.None;
    }

    private void Deliver(in Datagram datagram, double now, IMessageReceiver receiver)
    {
        foreach (Datagram.Fragment fragment in datagram.Fragments)
        {
            Statistics.Count(assembler.Add(fragment.Header with { Id = 0 }, fragment.Data, out ReadOnlySpan<byte> message));
            if (message.IsEmpty)
                continue;
            Statistics.MessagesReceived++;
            DropReason reason = order.Add(fragment.Header.Sequence, message, receiver);
            Statistics.Count(reason);

            // What does not wait is lost, and everything behind it would wait for ever.
            if (reason == DropReason.NoRoom || assembler.Evicted > 0)
                Terminate(now);
            if (State != ServerLinkState.Connected)
                return;
        }
    }

    /// <summary>Sends little to a client that has not shown that it is where its datagrams say.</summary>
    private sealed class Sender(ServerLink link, IDatagramSink sink) : IDatagramSink
    {
        private const int MostAmplification = 3;

        private long sent;

        public void Send(ReadOnlySpan<byte> datagram, ServerPort port)
        {
            if (!link.hasAnswered && sent + datagram.Length > MostAmplification * link.Statistics.BytesReceived)
                return;
            sent += datagram.Length;
            sink.Send(datagram, port);
        }
    }
}
