namespace Surefoot.Protocol.Messages;

/// <summary>A line of text from the server (specification 08, 8.6).</summary>
/// <param name="Text">Windows-1252.</param>
/// <param name="Kind">Colour and window of the text.</param>
public readonly record struct Chat(string Text, uint Kind) : IInterfaceMessage<Chat>
{
    static Opcode IInterfaceMessage<Chat>.Opcode => Opcode.Chat;

    static Chat IMessage<Chat>.Read(ref WireReader reader) => new(reader.ReadString16(), reader.ReadUInt32());

    void IMessage<Chat>.Write(ref WireWriter writer)
    {
        writer.WriteString16(Text);
        writer.WriteUInt32(Kind);
    }
}

/// <summary>Something was said nearby.</summary>
/// <param name="Text">Windows-1252.</param>
/// <param name="Speaker">Name of who said it.</param>
/// <param name="Guid">Who said it.</param>
/// <param name="Kind">Colour and window of the text.</param>
public readonly record struct HearSpeech(string Text, string Speaker, uint Guid, uint Kind) : IInterfaceMessage<HearSpeech>
{
    static Opcode IInterfaceMessage<HearSpeech>.Opcode => Opcode.HearSpeech;

    static HearSpeech IMessage<HearSpeech>.Read(ref WireReader reader)
        => new(reader.ReadString16(), reader.ReadString16(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<HearSpeech>.Write(ref WireWriter writer)
    {
        writer.WriteString16(Text);
        writer.WriteString16(Speaker);
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Kind);
    }
}
