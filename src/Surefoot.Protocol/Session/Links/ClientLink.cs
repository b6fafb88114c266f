using System.Buffers.Binary;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>How far a client's connection has come.</summary>
internal enum LinkState
{
    Idle,
    Requesting,
    Responding,
    Connected,
    Closed,
}

/// <summary>A client's side of the packets: handshake, numbers, acknowledgements, clocks (specification 08, 2 and 3). It reads no clock and
/// knows no socket: datagrams and the time come in, datagrams and messages go out.</summary>
internal sealed class ClientLink
{
    private const double LoginRetry = 2.0, ResponseRetry = 0.333333333, AckInterval = 2.0, NakInterval = 0.6, Interval = 0.5;
    private const int MostLoginRequests = 20, ClockIntervals = 6, SignOfLifeIntervals = 220;
    private const int MostKeptPackets = 4096, MostMissing = 40_000, MostServerId = 0x100;
    private const uint FarthestAhead = 0x7FFF, WorldBlob = 0x03000000, LogonBlob = 0x23000000;

    private readonly LoginRequest login;
    private readonly IDatagramSink sink;
    private readonly byte[] scratch = new byte[PacketBuilder.MostLength];
    private FragmentAssembler assembler = new();
    private PacketChannel? channel;
    private ConnectRequest request;
    private double opened, lastSent, lastReceived, lastControl, connected;
    private int loginRequests;
    private uint intervals = 1, messageSequence;
    private ushort blobStamp, flowInterval;
    private uint flowBytes;
    private bool hasFlowInterval;

    public ClientLink(LoginRequest login, IDatagramSink sink)
    {
        this.login = login;
        this.sink = sink;
    }

    public LinkState State { get; private set; }

    public SessionStatistics Statistics { get; } = new();

    /// <summary>The server closed the session.</summary>
    public bool ClosedByServer { get; private set; }

    /// <summary>No request for the login is left to be sent.</summary>
    public bool IsOutOfRequests { get; private set; }

    /// <summary>A message came before the server said anything that could be checked: a refusal.</summary>
    public bool IsRefusedUnseen => State == LinkState.Requesting;

    /// <summary>Such a refusal had no number: the server made no session at all, because of the client's version.</summary>
    public bool IsVersionRefused { get; private set; }

    /// <summary>The server's clock at the time of its last word of it, and that time; seconds.</summary>
    public (double ServerTime, double At)? Clock { get; private set; }

    /// <summary>Seconds that an echo took.</summary>
    public double? RoundTrip { get; private set; }

    /// <summary>Packets that are waited for.</summary>
    public int MissingPackets => channel?.Incoming.Missing.Length ?? 0;

    /// <summary>When something good came last.</summary>
    public double LastReceived => lastReceived;

    /// <summary>Asks the server for a session.</summary>
    public void Open(double now)
    {
        State = LinkState.Requesting;
        opened = lastReceived = now;
        SendLoginRequest(now);
    }

    /// <summary>Takes a datagram of the server.</summary>
    public void Receive(ReadOnlySpan<byte> bytes, double now, IMessageReceiver receiver)
    {
        Statistics.DatagramsReceived++;
        Statistics.BytesReceived += bytes.Length;
        DropReason reason = Datagram.TryParse(bytes, out Datagram datagram);
        if (reason == DropReason.None)
        {
            reason = State switch
            {
                LinkState.Requesting => ReceiveAnswer(datagram, now, receiver),
                LinkState.Responding or LinkState.Connected => ReceivePacket(datagram, now, receiver),
                _ => DropReason.Unexpected,
            };
        }

        Statistics.Count(reason);
    }

    /// <summary>Does what time asks for, and sends what has been put together.</summary>
    public void Update(double now)
    {
        switch (State)
        {
            case LinkState.Requesting when now - lastSent >= LoginRetry:
                if (loginRequests >= MostLoginRequests)
                    IsOutOfRequests = true;
                else
                    SendLoginRequest(now);
                break;
            case LinkState.Responding when now - lastSent > ResponseRetry:
                SendConnectResponse(now);
                break;
            case LinkState.Connected:
                UpdateConnected(channel!, now);
                break;
        }
    }

    /// <summary>Puts a message into packets.</summary>
    /// <returns>False when there is no connection.</returns>
    public bool Send(ReadOnlySpan<byte> message, MessageGroup group, double now)
    {
        if (State != LinkState.Connected)
            return false;
        NoteDueAck(channel!, now);
        uint blob = (group is MessageGroup.Logon or MessageGroup.Database ? LogonBlob : WorldBlob) | blobStamp++;
        channel!.Append(message, ++messageSequence, blob, group, now);
        return true;
    }

    /// <summary>Sends what has been put together.</summary>
    public void Flush(double now)
    {
        if (State == LinkState.Connected)
            channel!.Flush(now);
    }

    /// <summary>Says goodbye, when there is anybody, and ends.</summary>
    public void Close(double now)
    {
        if (State is LinkState.Connected)
        {
            channel!.Flush(now);
            channel.SendBare(PacketFlags.Disconnect, [], channel.Id, 0, ServerPort.First);
        }

        State = LinkState.Closed;
    }

    private DropReason ReceiveAnswer(in Datagram datagram, double now, IMessageReceiver receiver)
    {
        if (datagram.Has(PacketFlags.ConnectRequest))
        {
            if (datagram.Header.IsEncrypted || !datagram.IsIntact)
                return DropReason.Checksum;
            Connect(datagram, now);
            return DropReason.None;
        }

        // Before its seeds are known a server's refusal cannot be checked; who receives it takes nothing but refusals.
        if (!datagram.Has(PacketFlags.BlobFragments))
            return DropReason.Unexpected;
        IsVersionRefused = datagram.Header.Sequence == 0;
        Deliver(datagram, receiver);
        return DropReason.None;
    }

    private void Connect(in Datagram datagram, double now)
    {
        request = ConnectRequest.Read(datagram.Handshake);
        assembler = new FragmentAssembler();
        channel = new PacketChannel(
            request.ClientSeed, new ReceiveWindow(request.ServerSeed, FarthestAhead, MostMissing),
            (ushort)request.NetId, datagram.Header.Iteration, MostKeptPackets, sink, Statistics)
        { Time = 1 };
        Clock = (request.ServerTime, now);
        lastReceived = now;
        State = LinkState.Responding;
        SendConnectResponse(now);
    }

    private DropReason ReceivePacket(in Datagram datagram, double now, IMessageReceiver receiver)
    {
        if (datagram.Has(PacketFlags.ConnectRequest))
            return DropReason.Duplicate;
        if (datagram.Header.Id >= MostServerId || datagram.Header.Iteration != channel!.Iteration)
            return DropReason.Foreign;
        DropReason reason = channel.Incoming.Accept(datagram, out _);
        if (reason != DropReason.None)
            return reason;

        lastReceived = now;
        if (State == LinkState.Responding)
        {
            State = LinkState.Connected;
            connected = lastControl = now;
        }

        NoteFlow(datagram.Header);
        ReceiveOptions(datagram, now);
        Deliver(datagram, receiver);
        return DropReason.None;
    }

    private void ReceiveOptions(in Datagram datagram, double now)
    {
        // Servers of the field ignore a word that a packet is gone, and may take it for that packet: none is sent.
        if (datagram.Has(PacketFlags.RequestRetransmit))
            channel!.Resend(datagram.Requested, rejects: false, now);
        if (datagram.Has(PacketFlags.RejectRetransmit))
            channel!.Incoming.Forget(datagram.Rejected);
        if (datagram.Has(PacketFlags.AckSequence))
            channel!.Acknowledge(datagram.Ack);
        if (datagram.Has(PacketFlags.TimeSync))
            Clock = (datagram.TimeSync, now);
        if (datagram.Has(PacketFlags.EchoResponse))
            RoundTrip = now - opened - datagram.Echo;
        if (datagram.Has(PacketFlags.Disconnect) || datagram.Has(PacketFlags.NetErrorDisconnect))
            ClosedByServer = true;
    }

    private void Deliver(in Datagram datagram, IMessageReceiver receiver)
    {
        foreach (Datagram.Fragment fragment in datagram.Fragments)
        {
            if (State == LinkState.Closed)
                return;
            Statistics.Count(assembler.Add(fragment.Header, fragment.Data, out ReadOnlySpan<byte> bytes));
            if (bytes.IsEmpty)
                continue;
            if (!WireMessage.TryParse(bytes, out WireMessage message))
            {
                Statistics.Count(DropReason.BadMessage);
                continue;
            }

            Statistics.MessagesReceived++;
            receiver.OnMessage(message);
        }
    }

    private void UpdateConnected(PacketChannel channel, double now)
    {
        uint reached = 1 + (uint)((now - connected) / Interval);
        bool isClockDue = (reached - 1) / ClockIntervals > (intervals - 1) / ClockIntervals;
        bool isSignOfLifeDue = (reached - 1) / SignOfLifeIntervals > (intervals - 1) / SignOfLifeIntervals;
        intervals = reached;
        channel.Time = (ushort)reached;

        if (channel.Incoming.Missing.Length > 0)
        {
            if (now - lastControl > NakInterval)
            {
                channel.RequestMissing();
                lastControl = now;
            }
        }
        else
        {
            NoteDueAck(channel, now);
        }

        if (isClockDue)
            channel.SendClock(now - opened, (float)(now - opened), null, now);
        channel.Flush(now);
        channel.SendDueAck();
        if (isSignOfLifeDue)
            SendSignOfLife(channel);
    }

    private void NoteDueAck(PacketChannel channel, double now)
    {
        if (channel.Incoming.Missing.Length > 0 || now - lastControl < AckInterval)
            return;
        channel.DueAck = channel.Incoming.Newest;
        lastControl = now;
    }

    private void NoteFlow(in PacketHeader header)
    {
        if (hasFlowInterval && ObjectStamps.IsNewer(flowInterval, header.Time))
        {
            channel!.DueFlow = (flowBytes, flowInterval);
            flowBytes = 0;
        }

        if (!hasFlowInterval || ObjectStamps.IsNewer(flowInterval, header.Time))
            flowInterval = header.Time;
        hasFlowInterval = true;
        flowBytes += (uint)(PacketHeader.Length + header.Size);
    }

    private void SendLoginRequest(double now)
    {
        loginRequests++;
        lastSent = now;
        var writer = new WireWriter(scratch.AsSpan(PacketHeader.Length));
        login.Write(ref writer);
        var header = new PacketHeader(0, PacketFlags.LoginRequest, 0, 0, 0, (ushort)writer.Position, 0);
        (header with { Checksum = header.Hash() + Hash32.Of(writer.Written) }).Write(scratch);
        Statistics.DatagramsSent++;
        Statistics.BytesSent += PacketHeader.Length + writer.Position;
        sink.Send(scratch.AsSpan(0, PacketHeader.Length + writer.Position), ServerPort.First);
    }

    private void SendConnectResponse(double now)
    {
        lastSent = now;
        Span<byte> cookie = stackalloc byte[8];
        BinaryPrimitives.WriteUInt64LittleEndian(cookie, request.Cookie);
        channel!.SendBare(PacketFlags.ConnectResponse, cookie, channel.Id, 0, ServerPort.Second);
    }

    private static void SendSignOfLife(PacketChannel channel)
        => channel.SendBare(PacketFlags.CicmdCommand, [1, 0, 0, 0, 0, 0, 0, 0], 0, channel.Time, ServerPort.Second);
}
