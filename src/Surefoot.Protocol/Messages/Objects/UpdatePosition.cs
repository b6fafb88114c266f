namespace Surefoot.Protocol.Messages;

/// <summary>Where an object is (specification 08, 6.3).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Pack">Where it is, and the stamps.</param>
/// <remarks>Retail: SmartBox::UnpackPositionEvent @0x004542C0.</remarks>
public readonly record struct UpdatePosition(uint Guid, PositionPack Pack) : IObjectMessage<UpdatePosition>
{
    static Opcode IObjectMessage<UpdatePosition>.Opcode => Opcode.UpdatePosition;

    static UpdatePosition IMessage<UpdatePosition>.Read(ref WireReader reader) => new(reader.ReadUInt32(), PositionPack.Read(ref reader));

    void IMessage<UpdatePosition>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        Pack.Write(ref writer);
    }
}

/// <summary>Where an object is and what it does from now on (specification 08, 6.1). Servers of the field do not send it.</summary>
/// <param name="Position">Where it is.</param>
/// <param name="Motion">What it does; its object and instance are those of the position.</param>
public readonly record struct PositionAndMovement(UpdatePosition Position, UpdateMotion Motion) : IObjectMessage<PositionAndMovement>
{
    static Opcode IObjectMessage<PositionAndMovement>.Opcode => Opcode.PositionAndMovement;

    static PositionAndMovement IMessage<PositionAndMovement>.Read(ref WireReader reader)
    {
        var position = new UpdatePosition(reader.ReadUInt32(), PositionPack.Read(ref reader));
        return new PositionAndMovement(position, UpdateMotion.ReadMovement(position.Guid, position.Pack.Instance, ref reader));
    }

    void IMessage<PositionAndMovement>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Position.Guid);
        Position.Pack.Write(ref writer);
        Motion.WriteMovement(ref writer);
    }
}
