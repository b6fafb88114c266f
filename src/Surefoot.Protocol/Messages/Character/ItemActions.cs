namespace Surefoot.Protocol.Messages;

/// <summary>Moves a thing into a container.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Container">The container, or the character.</param>
/// <param name="Place">Index in it.</param>
public readonly record struct PutItemInContainer(uint Guid, uint Container, int Place) : IGameAction<PutItemInContainer>
{
    static GameActionType IGameAction<PutItemInContainer>.Type => GameActionType.PutItemInContainer;

    static PutItemInContainer IMessage<PutItemInContainer>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadInt32());

    void IMessage<PutItemInContainer>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Container);
        writer.WriteInt32(Place);
    }
}

/// <summary>Takes a thing into the hand or puts it on.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Location">Where to.</param>
public readonly record struct GetAndWieldItem(uint Guid, uint Location) : IGameAction<GetAndWieldItem>
{
    static GameActionType IGameAction<GetAndWieldItem>.Type => GameActionType.GetAndWieldItem;

    static GetAndWieldItem IMessage<GetAndWieldItem>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<GetAndWieldItem>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Location);
    }
}

/// <summary>Drops a thing.</summary>
/// <param name="Guid">The thing.</param>
public readonly record struct DropItem(uint Guid) : IGameAction<DropItem>
{
    static GameActionType IGameAction<DropItem>.Type => GameActionType.DropItem;

    static DropItem IMessage<DropItem>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<DropItem>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}
