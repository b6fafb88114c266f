namespace Surefoot.Protocol.Messages;

/// <summary>A thing went into a container.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Container">The container, or the character.</param>
/// <param name="Place">Index in it.</param>
/// <param name="Kind">0 thing, 1 pack, 2 focus.</param>
public readonly record struct ItemServerSaysContainId(
    uint Guid,
    uint Container,
    uint Place,
    uint Kind) : IGameEvent<ItemServerSaysContainId>
{
    static GameEventType IGameEvent<ItemServerSaysContainId>.Type => GameEventType.ItemServerSaysContainId;

    static ItemServerSaysContainId IMessage<ItemServerSaysContainId>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<ItemServerSaysContainId>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Container);
        writer.WriteUInt32(Place);
        writer.WriteUInt32(Kind);
    }
}

/// <summary>A thing was taken into the hand or put on.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Location">Where.</param>
public readonly record struct WieldItem(uint Guid, uint Location) : IGameEvent<WieldItem>
{
    static GameEventType IGameEvent<WieldItem>.Type => GameEventType.WieldItem;

    static WieldItem IMessage<WieldItem>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<WieldItem>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Location);
    }
}

/// <summary>A thing was put down.</summary>
/// <param name="Guid">The thing.</param>
public readonly record struct InventoryPutObjectIn3D(uint Guid) : IGameEvent<InventoryPutObjectIn3D>
{
    static GameEventType IGameEvent<InventoryPutObjectIn3D>.Type => GameEventType.InventoryPutObjectIn3D;

    static InventoryPutObjectIn3D IMessage<InventoryPutObjectIn3D>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<InventoryPutObjectIn3D>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}

/// <summary>Using an object is over (specification 08, 5.7).</summary>
/// <param name="Error">0, or why it was not used.</param>
public readonly record struct UseDone(uint Error) : IGameEvent<UseDone>
{
    static GameEventType IGameEvent<UseDone>.Type => GameEventType.UseDone;

    static UseDone IMessage<UseDone>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<UseDone>.Write(ref WireWriter writer) => writer.WriteUInt32(Error);
}
