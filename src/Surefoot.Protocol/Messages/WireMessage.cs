using System.Buffers.Binary;

namespace Surefoot.Protocol.Messages;

/// <summary>The bytes of one whole message, known or not, and what its wrapper says. It lives as long as the memory it looks at.</summary>
public readonly ref struct WireMessage
{
    private WireMessage(ReadOnlySpan<byte> bytes, MessageId id, uint stamp, uint guid)
    {
        Bytes = bytes;
        Id = id;
        Stamp = stamp;
        Guid = guid;
    }

    /// <summary>All bytes, opcode included.</summary>
    public ReadOnlySpan<byte> Bytes { get; }

    /// <summary>Which message it is; the inner type is 0 where a wrapper is cut short.</summary>
    public MessageId Id { get; }

    /// <summary>The wrapper's stamp: the number of the action or event; else 0.</summary>
    public uint Stamp { get; }

    /// <summary>The object that an ordered event belongs to; else 0.</summary>
    public uint Guid { get; }

    /// <summary>The bytes behind the opcode or the wrapper.</summary>
    public ReadOnlySpan<byte> Body => Bytes[Math.Min(Id.HeaderSize, Bytes.Length)..];

    /// <summary>Looks at a message.</summary>
    /// <returns>False for fewer than four bytes: there is no opcode.</returns>
    public static bool TryParse(ReadOnlySpan<byte> bytes, out WireMessage message)
    {
        message = default;
        if (bytes.Length < 4)
            return false;

        var opcode = (Opcode)Number(bytes, 0);
        message = opcode switch
        {
            Opcode.GameAction when bytes.Length >= 12 => new(bytes, new MessageId(opcode, Number(bytes, 8)), Number(bytes, 4), 0),
            Opcode.GameEvent when bytes.Length >= 16
                => new(bytes, new MessageId(opcode, Number(bytes, 12)), Number(bytes, 8), Number(bytes, 4)),
            _ => new(bytes, new MessageId(opcode), 0, 0),
        };
        return true;

        static uint Number(ReadOnlySpan<byte> bytes, int offset) => BinaryPrimitives.ReadUInt32LittleEndian(bytes[offset..]);
    }

    /// <summary>Writes a whole message.</summary>
    /// <param name="message">What to write.</param>
    /// <param name="target">Where.</param>
    /// <param name="length">Bytes written.</param>
    /// <param name="stamp">Number of the action or event, for a wrapped message.</param>
    /// <param name="guid">Object that an ordered event belongs to.</param>
    /// <returns>False when it does not fit or has no form on the wire.</returns>
    public static bool TryWrite<T>(in T message, Span<byte> target, out int length, uint stamp = 0, uint guid = 0)
        where T : IMessage<T>
    {
        var writer = new WireWriter(target);
        writer.WriteUInt32((uint)T.Id.Opcode);
        if (T.Id.Opcode == Opcode.GameEvent)
            writer.WriteUInt32(guid);
        if (T.Id.Opcode is Opcode.GameAction or Opcode.GameEvent)
        {
            writer.WriteUInt32(stamp);
            writer.WriteUInt32(T.Id.Inner);
        }

        message.Write(ref writer);
        length = writer.Failed ? 0 : writer.Position;
        return !writer.Failed;
    }

    /// <summary>Reads the message as a <typeparamref name="T"/>. Bytes behind its fields are no mistake.</summary>
    /// <returns>False when it is another message or its bytes are damaged.</returns>
    public bool TryRead<T>(out T message)
        where T : IMessage<T> => TryRead(out message, out _);

    /// <summary>Reads the message as a <typeparamref name="T"/>. Bytes behind its fields are no mistake.</summary>
    /// <param name="message">The message, when nothing is wrong.</param>
    /// <param name="fault">What is wrong.</param>
    /// <returns>False when it is another message or its bytes are damaged.</returns>
    public bool TryRead<T>(out T message, out WireFault fault)
        where T : IMessage<T> => TryRead(out message, out _, out fault);

    /// <summary>As the others; tells also how many bytes there are behind the fields.</summary>
    internal bool TryRead<T>(out T message, out int unread, out WireFault fault)
        where T : IMessage<T>
    {
        var reader = new WireReader(Bytes);
        if (Id == T.Id)
            reader.ReadBytes(Id.HeaderSize);
        else
            reader.Fail(WireFault.OtherMessage);
        message = reader.Fault == WireFault.None ? T.Read(ref reader) : default!;
        (unread, fault) = (reader.Remaining, reader.Fault);
        if (fault != WireFault.None)
            message = default!;
        return fault == WireFault.None;
    }
}
