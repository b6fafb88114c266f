namespace Surefoot.Protocol.Messages;

/// <summary>A text to read and close (specification 08, 8.6).</summary>
/// <param name="Text">Windows-1252.</param>
public readonly record struct Popup(string Text) : IGameEvent<Popup>
{
    static GameEventType IGameEvent<Popup>.Type => GameEventType.Popup;

    static Popup IMessage<Popup>.Read(ref WireReader reader) => new(reader.ReadString16());

    void IMessage<Popup>.Write(ref WireWriter writer) => writer.WriteString16(Text);
}

/// <summary>A sign of life (specification 08, 5.6).</summary>
public readonly record struct PingResponse : IGameEvent<PingResponse>
{
    static GameEventType IGameEvent<PingResponse>.Type => GameEventType.PingResponse;

    static PingResponse IMessage<PingResponse>.Read(ref WireReader reader) => default;

    void IMessage<PingResponse>.Write(ref WireWriter writer)
    {
    }
}

/// <summary>A remark by its number.</summary>
/// <param name="Code">Number of the remark.</param>
public readonly record struct WeenieError(uint Code) : IGameEvent<WeenieError>
{
    static GameEventType IGameEvent<WeenieError>.Type => GameEventType.WeenieError;

    static WeenieError IMessage<WeenieError>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<WeenieError>.Write(ref WireWriter writer) => writer.WriteUInt32(Code);
}

/// <summary>A remark by its number, with a text.</summary>
/// <param name="Code">Number of the remark.</param>
/// <param name="Text">What it is about.</param>
public readonly record struct WeenieErrorWithString(uint Code, string Text) : IGameEvent<WeenieErrorWithString>
{
    static GameEventType IGameEvent<WeenieErrorWithString>.Type => GameEventType.WeenieErrorWithString;

    static WeenieErrorWithString IMessage<WeenieErrorWithString>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadString16());

    void IMessage<WeenieErrorWithString>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Code);
        writer.WriteString16(Text);
    }
}
