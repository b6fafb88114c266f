using System.Buffers.Binary;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>The numbered packets of a connected session, both ways: what client and server do alike.</summary>
internal sealed class PacketChannel
{
    /// <summary>Most numbers in a request to send again.</summary>
    public const int MostRequested = 114;

    private readonly PacketBuilder fragments = new();
    private readonly PacketBuilder control = new();
    private readonly KeyStream keys;
    private readonly SentPackets sent;
    private readonly IDatagramSink sink;
    private readonly SessionStatistics statistics;
    private uint next = 2;

    public PacketChannel(
        uint outgoingSeed,
        ReceiveWindow incoming,
        ushort id,
        ushort iteration,
        int mostKept,
        IDatagramSink sink,
        SessionStatistics statistics)
    {
        keys = new KeyStream(outgoingSeed);
        Incoming = incoming;
        Id = id;
        Iteration = iteration;
        sent = new SentPackets(mostKept);
        this.sink = sink;
        this.statistics = statistics;
    }

    /// <summary>What has arrived.</summary>
    public ReceiveWindow Incoming { get; }

    /// <summary>What goes into every header.</summary>
    public ushort Id { get; }

    /// <summary>What goes into every header.</summary>
    public ushort Iteration { get; }

    /// <summary>The sender's interval, for the headers.</summary>
    public ushort Time { get; set; }

    /// <summary>From a server: the port to send from.</summary>
    public ServerPort Port { get; set; }

    /// <summary>An acknowledgement that is due: it rides on the next packet that has room for it.</summary>
    public uint? DueAck { get; set; }

    /// <summary>A report of received bytes that rides on the next packet that has room for it.</summary>
    public (uint Bytes, ushort Interval)? DueFlow { get; set; }

    /// <summary>Number of the newest packet sent.</summary>
    public uint NewestSent { get; private set; } = 1;

    /// <summary>Puts a message into packets; those that are full leave at once.</summary>
    public void Append(ReadOnlySpan<byte> message, uint sequence, uint id, MessageGroup group, double now)
    {
        int count = FragmentHeader.CountFor(message.Length);
        for (int index = 0; index < count; index++)
        {
            ReadOnlySpan<byte> data = message[(index * FragmentHeader.MostData)..];
            if (data.Length > FragmentHeader.MostData)
                data = data[..FragmentHeader.MostData];
            var header = new FragmentHeader(
                sequence, id, (ushort)count, (ushort)(FragmentHeader.Length + data.Length), (ushort)index, group);
            if (fragments.Room < header.Size)
                Flush(now);
            if (fragments.IsEmpty)
                AddDue(fragments, header.Size);
            fragments.Add(header, data);
        }

        statistics.MessagesSent++;
    }

    /// <summary>Sends what has been put together.</summary>
    public void Flush(double now)
    {
        if (!fragments.IsEmpty)
            SendNumbered(fragments, now);
    }

    /// <summary>Sends clocks: the client's with an echo request, or the server's, with an echo response or alone.</summary>
    public void SendClock(double? timeSync, float? echoRequest, (float Echo, float Hold)? echoResponse, double now)
    {
        control.Clear();
        if (DueAck is { } ack)
            control.Add(PacketFlags.AckSequence, ack);
        DueAck = null;
        if (timeSync is { } clock)
            control.Add(PacketFlags.TimeSync, clock);
        if (echoRequest is { } request)
            control.Add(PacketFlags.EchoRequest, BitConverter.SingleToUInt32Bits(request));
        if (echoResponse is { } response)
            AddEchoResponse(response.Echo, response.Hold);
        AddFlow(control, 0);
        SendNumbered(control, now);
    }

    /// <summary>Sends an acknowledgement that nothing carried.</summary>
    public void SendDueAck()
    {
        if (DueAck is not { } ack)
            return;
        DueAck = null;
        control.Clear();
        control.Add(PacketFlags.AckSequence, ack);
        Send(control.Seal(NewestSent, Id, Time, Iteration));
    }

    /// <summary>Asks for missing packets.</summary>
    public void RequestMissing()
    {
        ReadOnlySpan<uint> missing = Incoming.Missing;
        control.Clear();
        control.Add(PacketFlags.RequestRetransmit, missing[..Math.Min(missing.Length, MostRequested)]);
        Send(control.Seal(NewestSent, Id, Time, Iteration));
        statistics.RequestsSent++;
    }

    /// <summary>Sends packets again.</summary>
    /// <param name="numbers">Four bytes each.</param>
    /// <param name="rejects">Say of which there are none any more, in a packet that has a number but no word of the key stream.</param>
    /// <param name="now">The time.</param>
    public void Resend(ReadOnlySpan<byte> numbers, bool rejects, double now)
    {
        Span<uint> gone = stackalloc uint[MostRequested];
        int count = 0;
        for (; numbers.Length >= 4; numbers = numbers[4..])
        {
            uint number = BinaryPrimitives.ReadUInt32LittleEndian(numbers);
            if (sent.TryFind(number, out SentPacket? packet))
            {
                Send(PacketBuilder.Renew(packet));
                statistics.Resent++;
            }
            else if (count < gone.Length)
            {
                gone[count++] = number;
            }
        }

        if (!rejects || count == 0)
            return;
        control.Clear();
        control.Add(PacketFlags.RejectRetransmit, gone[..count]);
        uint sequence = TakeNumber();
        ReadOnlySpan<byte> bytes = control.Seal(sequence, Id, Time, Iteration);
        sent.Keep(sequence, 0, control.PayloadHash, now, bytes);
        Send(bytes);
    }

    /// <summary>The other side has everything before a number.</summary>
    public void Acknowledge(uint number) => sent.Acknowledge(number);

    /// <summary>Packets sent before a time are not kept any longer.</summary>
    public void ForgetBefore(double time) => sent.ForgetBefore(time);

    /// <summary>Sends a cleartext packet without a number.</summary>
    public void SendBare(PacketFlags flag, ReadOnlySpan<byte> body, ushort id, ushort time, ServerPort port)
    {
        control.Clear();
        control.Add(flag, body);
        ReadOnlySpan<byte> bytes = control.Seal(0, id, time, Iteration);
        statistics.DatagramsSent++;
        statistics.BytesSent += bytes.Length;
        sink.Send(bytes, port);
    }

    private void SendNumbered(PacketBuilder packet, double now)
    {
        uint sequence = TakeNumber(), key = keys.Next();
        ReadOnlySpan<byte> bytes = packet.Seal(sequence, Id, Time, Iteration, key);
        sent.Keep(sequence, key, packet.PayloadHash, now, bytes);
        Send(bytes);
        packet.Clear();
    }

    private uint TakeNumber()
    {
        NewestSent = next;
        next = ReceiveWindow.After(next);
        return NewestSent;
    }

    private void AddDue(PacketBuilder packet, int needed)
    {
        if (DueAck is { } ack && packet.Room >= needed + 4)
        {
            packet.Add(PacketFlags.AckSequence, ack);
            DueAck = null;
        }

        AddFlow(packet, needed);
    }

    private void AddFlow(PacketBuilder packet, int needed)
    {
        const int Size = 6;
        if (DueFlow is not { } flow || packet.Room < needed + Size)
            return;
        Span<byte> body = stackalloc byte[Size];
        BinaryPrimitives.WriteUInt32LittleEndian(body, flow.Bytes);
        BinaryPrimitives.WriteUInt16LittleEndian(body[4..], flow.Interval);
        packet.Add(PacketFlags.Flow, body);
        DueFlow = null;
    }

    private void AddEchoResponse(float echo, float hold)
    {
        Span<byte> body = stackalloc byte[8];
        BinaryPrimitives.WriteSingleLittleEndian(body, echo);
        BinaryPrimitives.WriteSingleLittleEndian(body[4..], hold);
        control.Add(PacketFlags.EchoResponse, body);
    }

    private void Send(ReadOnlySpan<byte> bytes)
    {
        statistics.DatagramsSent++;
        statistics.BytesSent += bytes.Length;
        sink.Send(bytes, Port);
    }
}
