namespace Surefoot.Protocol.Messages;

/// <summary>A number of the character (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Property">Id of the property: 5 burden, 25 level, 93 physics state, 134 player-killer status, 230 carrying
/// augmentation.</param>
/// <param name="Value">The number.</param>
public readonly record struct PrivateUpdatePropertyInt(
    byte Sequence,
    uint Property,
    int Value) : IInterfaceMessage<PrivateUpdatePropertyInt>
{
    static Opcode IInterfaceMessage<PrivateUpdatePropertyInt>.Opcode => Opcode.PrivateUpdatePropertyInt;

    static PrivateUpdatePropertyInt IMessage<PrivateUpdatePropertyInt>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadInt32());

    void IMessage<PrivateUpdatePropertyInt>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Property);
        writer.WriteInt32(Value);
    }
}

/// <summary>A number of an object (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Guid">The object.</param>
/// <param name="Property">Id of the property: 5 burden, 25 level, 93 physics state, 134 player-killer status, 230 carrying
/// augmentation.</param>
/// <param name="Value">The number.</param>
public readonly record struct PublicUpdatePropertyInt(
    byte Sequence,
    uint Guid,
    uint Property,
    int Value) : IInterfaceMessage<PublicUpdatePropertyInt>
{
    static Opcode IInterfaceMessage<PublicUpdatePropertyInt>.Opcode => Opcode.PublicUpdatePropertyInt;

    static PublicUpdatePropertyInt IMessage<PublicUpdatePropertyInt>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadInt32());

    void IMessage<PublicUpdatePropertyInt>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Property);
        writer.WriteInt32(Value);
    }
}

/// <summary>A 64-bit number of the character.</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Property">Id of the property.</param>
/// <param name="Value">The number.</param>
public readonly record struct PrivateUpdatePropertyInt64(
    byte Sequence,
    uint Property,
    long Value) : IInterfaceMessage<PrivateUpdatePropertyInt64>
{
    static Opcode IInterfaceMessage<PrivateUpdatePropertyInt64>.Opcode => Opcode.PrivateUpdatePropertyInt64;

    static PrivateUpdatePropertyInt64 IMessage<PrivateUpdatePropertyInt64>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadInt64());

    void IMessage<PrivateUpdatePropertyInt64>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Property);
        writer.WriteInt64(Value);
    }
}

/// <summary>A number of an object that names another object.</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Guid">The object.</param>
/// <param name="Property">Id of the property.</param>
/// <param name="Value">The other object.</param>
public readonly record struct PublicUpdatePropertyInstanceId(
    byte Sequence,
    uint Guid,
    uint Property,
    uint Value) : IInterfaceMessage<PublicUpdatePropertyInstanceId>
{
    static Opcode IInterfaceMessage<PublicUpdatePropertyInstanceId>.Opcode => Opcode.PublicUpdatePropertyInstanceId;

    static PublicUpdatePropertyInstanceId IMessage<PublicUpdatePropertyInstanceId>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<PublicUpdatePropertyInstanceId>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Property);
        writer.WriteUInt32(Value);
    }
}
