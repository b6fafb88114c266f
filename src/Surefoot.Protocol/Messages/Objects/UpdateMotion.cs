namespace Surefoot.Protocol.Messages;

/// <summary>What an object does from now on (specification 08, 6.4).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Instance">Which life of the object.</param>
/// <param name="MovementStamp">Number of this movement.</param>
/// <param name="ServerControlledMove">Number of the last movement that the server ordered.</param>
/// <param name="Autonomous">Its own player asked for it; else the server did.</param>
/// <param name="Movement">What it does.</param>
/// <remarks>Retail: CPhysics::SetObjectMovement @0x00509690.</remarks>
public readonly record struct UpdateMotion(
    uint Guid,
    ushort Instance,
    ushort MovementStamp,
    ushort ServerControlledMove,
    bool Autonomous,
    MovementData Movement) : IObjectMessage<UpdateMotion>
{
    static Opcode IObjectMessage<UpdateMotion>.Opcode => Opcode.UpdateMotion;

    static UpdateMotion IMessage<UpdateMotion>.Read(ref WireReader reader)
        => ReadMovement(reader.ReadUInt32(), reader.ReadUInt16(), ref reader);

    void IMessage<UpdateMotion>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt16(Instance);
        WriteMovement(ref writer);
    }

    internal static UpdateMotion ReadMovement(uint guid, ushort instance, ref WireReader reader)
    {
        ushort movement = reader.ReadUInt16(), serverControlled = reader.ReadUInt16();
        bool autonomous = reader.ReadByte() != 0;
        reader.Align4();
        return new UpdateMotion(guid, instance, movement, serverControlled, autonomous, MovementData.Read(ref reader));
    }

    internal void WriteMovement(ref WireWriter writer)
    {
        writer.WriteUInt16(MovementStamp);
        writer.WriteUInt16(ServerControlledMove);
        writer.WriteByte(Autonomous ? (byte)1 : (byte)0);
        writer.Align4();
        Movement.Write(ref writer);
    }
}
