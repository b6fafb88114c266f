namespace Surefoot.Protocol.Messages;

/// <summary>May a character enter the world? (Specification 08, 3.5.)</summary>
public readonly record struct CharacterEnterWorldRequest : IMessage<CharacterEnterWorldRequest>
{
    static MessageId IMessage<CharacterEnterWorldRequest>.Id => new(Opcode.CharacterEnterWorldRequest);

    static MessageGroup IMessage<CharacterEnterWorldRequest>.Group => MessageGroup.Logon;

    static CharacterEnterWorldRequest IMessage<CharacterEnterWorldRequest>.Read(ref WireReader reader) => default;

    void IMessage<CharacterEnterWorldRequest>.Write(ref WireWriter writer)
    {
    }
}

/// <summary>A character may enter the world (specification 08, 3.5).</summary>
public readonly record struct EnterWorldServerReady : IInterfaceMessage<EnterWorldServerReady>
{
    static Opcode IInterfaceMessage<EnterWorldServerReady>.Opcode => Opcode.EnterWorldServerReady;

    static EnterWorldServerReady IMessage<EnterWorldServerReady>.Read(ref WireReader reader) => default;

    void IMessage<EnterWorldServerReady>.Write(ref WireWriter writer)
    {
    }
}

/// <summary>Enter the world with a character (specification 08, 3.5).</summary>
/// <param name="Guid">The character.</param>
/// <param name="Account">The account's name as the character list has it.</param>
public readonly record struct CharacterEnterWorld(uint Guid, string Account) : IMessage<CharacterEnterWorld>
{
    static MessageId IMessage<CharacterEnterWorld>.Id => new(Opcode.CharacterEnterWorld);

    static MessageGroup IMessage<CharacterEnterWorld>.Group => MessageGroup.Logon;

    static CharacterEnterWorld IMessage<CharacterEnterWorld>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadString16());

    void IMessage<CharacterEnterWorld>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteString16(Account);
    }
}

/// <summary>Leave the world, from the client (specification 08, 3.6).</summary>
/// <param name="Guid">The character.</param>
public readonly record struct LogOffRequest(uint Guid) : IMessage<LogOffRequest>
{
    static MessageId IMessage<LogOffRequest>.Id => new(Opcode.CharacterLogOff);

    static MessageGroup IMessage<LogOffRequest>.Group => MessageGroup.Logon;

    static LogOffRequest IMessage<LogOffRequest>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<LogOffRequest>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}

/// <summary>The world has been left, from the server (specification 08, 3.6).</summary>
public readonly record struct LogOffReply : IInterfaceMessage<LogOffReply>
{
    static Opcode IInterfaceMessage<LogOffReply>.Opcode => Opcode.CharacterLogOff;

    static LogOffReply IMessage<LogOffReply>.Read(ref WireReader reader) => default;

    void IMessage<LogOffReply>.Write(ref WireWriter writer)
    {
    }
}

/// <summary>Asks again for an object of which only other messages came (specification 08, 5.6).</summary>
/// <param name="Guid">The object.</param>
public readonly record struct ForceObjDesc(uint Guid) : IMessage<ForceObjDesc>
{
    static MessageId IMessage<ForceObjDesc>.Id => new(Opcode.ForceObjDesc);

    static MessageGroup IMessage<ForceObjDesc>.Group => MessageGroup.Control;

    static ForceObjDesc IMessage<ForceObjDesc>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<ForceObjDesc>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}
