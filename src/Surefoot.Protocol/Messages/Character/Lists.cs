namespace Surefoot.Protocol.Messages;

/// <summary>The character's titles (specification 08, 8.6).</summary>
/// <param name="One">Always 1.</param>
/// <param name="Title">The title shown.</param>
/// <param name="Known">All titles.</param>
public readonly record struct Titles(uint One, uint Title, ValueList<uint> Known) : IGameEvent<Titles>
{
    static GameEventType IGameEvent<Titles>.Type => GameEventType.Titles;

    static Titles IMessage<Titles>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadList(4, static (ref r) => r.ReadUInt32()));

    void IMessage<Titles>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(One);
        writer.WriteUInt32(Title);
        writer.WriteList(Known, static (ref w, title) => w.WriteUInt32(title));
    }
}

/// <summary>An empty friends list (specification 08, 8.6). One with friends in it has no layout here and stays bytes.</summary>
/// <param name="Kind">0: the whole list.</param>
public readonly record struct Friends(uint Kind) : IGameEvent<Friends>
{
    static GameEventType IGameEvent<Friends>.Type => GameEventType.Friends;

    static Friends IMessage<Friends>.Read(ref WireReader reader)
    {
        if (reader.ReadUInt32() != 0)
            reader.Fail(WireFault.BadValue);
        return new Friends(reader.ReadUInt32());
    }

    void IMessage<Friends>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(0);
        writer.WriteUInt32(Kind);
    }
}

/// <summary>Numbers of the ten chat channels.</summary>
/// <param name="Channels">Ten numbers.</param>
public readonly record struct SetTurbineChatChannels(ValueList<uint> Channels) : IGameEvent<SetTurbineChatChannels>
{
    private const int Count = 10;

    static GameEventType IGameEvent<SetTurbineChatChannels>.Type => GameEventType.SetTurbineChatChannels;

    static SetTurbineChatChannels IMessage<SetTurbineChatChannels>.Read(ref WireReader reader)
        => new(reader.ReadList(Count, 4, static (ref r) => r.ReadUInt32()));

    void IMessage<SetTurbineChatChannels>.Write(ref WireWriter writer)
    {
        if (Channels.Count != Count)
            writer.Fail();
        writer.WriteElements(Channels, static (ref w, channel) => w.WriteUInt32(channel));
    }
}
