namespace Surefoot.Protocol.Messages;

/// <summary>Which object is the player (specification 08, 6.1). Only the first one counts.</summary>
/// <param name="Guid">The player.</param>
/// <remarks>Retail: SmartBox::HandleCreatePlayer @0x00455110.</remarks>
public readonly record struct PlayerCreate(uint Guid) : IObjectMessage<PlayerCreate>
{
    static Opcode IObjectMessage<PlayerCreate>.Opcode => Opcode.PlayerCreate;

    static PlayerCreate IMessage<PlayerCreate>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<PlayerCreate>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}

/// <summary>An object is gone (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Instance">Which life of the object.</param>
/// <remarks>Retail: SmartBox::HandleDeleteObject @0x00451EA0.</remarks>
public readonly record struct DeleteObject(uint Guid, ushort Instance) : IObjectMessage<DeleteObject>
{
    static Opcode IObjectMessage<DeleteObject>.Opcode => Opcode.DeleteObject;

    static DeleteObject IMessage<DeleteObject>.Read(ref WireReader reader)
    {
        var message = new DeleteObject(reader.ReadUInt32(), reader.ReadUInt16());
        reader.Align4();
        return message;
    }

    void IMessage<DeleteObject>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt16(Instance);
        writer.Align4();
    }
}

/// <summary>An object is held by another one (specification 08, 6.1).</summary>
/// <param name="Parent">The holder.</param>
/// <param name="Child">What is held.</param>
/// <param name="Location">Number of the holder's holding location.</param>
/// <param name="Placement">Placement frame of what is held.</param>
/// <param name="ParentInstance">Which life of the holder.</param>
/// <param name="PositionStamp">Number of this position of what is held.</param>
/// <remarks>Retail: SmartBox::HandleParentEvent @0x004535D0.</remarks>
public readonly record struct ParentEvent(
    uint Parent,
    uint Child,
    uint Location,
    uint Placement,
    ushort ParentInstance,
    ushort PositionStamp) : IObjectMessage<ParentEvent>
{
    static Opcode IObjectMessage<ParentEvent>.Opcode => Opcode.ParentEvent;

    static ParentEvent IMessage<ParentEvent>.Read(ref WireReader reader) => new(
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(),
        reader.ReadUInt32(), reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<ParentEvent>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Parent);
        writer.WriteUInt32(Child);
        writer.WriteUInt32(Location);
        writer.WriteUInt32(Placement);
        writer.WriteUInt16(ParentInstance);
        writer.WriteUInt16(PositionStamp);
    }
}

/// <summary>An object left the world into somebody's hands or pack (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Instance">Which life of the object.</param>
/// <param name="PositionStamp">Number of this position.</param>
/// <remarks>Retail: SmartBox::HandlePickupEvent @0x00453530.</remarks>
public readonly record struct PickupEvent(uint Guid, ushort Instance, ushort PositionStamp) : IObjectMessage<PickupEvent>
{
    static Opcode IObjectMessage<PickupEvent>.Opcode => Opcode.PickupEvent;

    static PickupEvent IMessage<PickupEvent>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<PickupEvent>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(PositionStamp);
    }
}
