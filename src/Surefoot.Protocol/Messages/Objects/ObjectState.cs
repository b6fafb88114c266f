using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>Physics state of an object (specification 08, 6.1; the bits are in 6.2).</summary>
/// <param name="Guid">The object.</param>
/// <param name="State">The whole state word.</param>
/// <param name="Instance">Which life of the object.</param>
/// <param name="StateStamp">Number of this state.</param>
/// <remarks>Retail: SmartBox::HandleSetState @0x004533E0.</remarks>
public readonly record struct SetState(uint Guid, uint State, ushort Instance, ushort StateStamp) : IObjectMessage<SetState>
{
    static Opcode IObjectMessage<SetState>.Opcode => Opcode.SetState;

    static SetState IMessage<SetState>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<SetState>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(State);
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(StateStamp);
    }
}

/// <summary>Velocity of an object (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Velocity">m/s, in the axes of the world.</param>
/// <param name="Omega">Radians a second, in the axes of the world.</param>
/// <param name="Instance">Which life of the object.</param>
/// <param name="VectorStamp">Number of this velocity.</param>
/// <remarks>Retail: SmartBox::HandleVectorUpdate @0x00453480.</remarks>
public readonly record struct VectorUpdate(
    uint Guid,
    Vector3 Velocity,
    Vector3 Omega,
    ushort Instance,
    ushort VectorStamp) : IObjectMessage<VectorUpdate>
{
    static Opcode IObjectMessage<VectorUpdate>.Opcode => Opcode.VectorUpdate;

    static VectorUpdate IMessage<VectorUpdate>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadVector3(), reader.ReadVector3(), reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<VectorUpdate>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteVector3(Velocity);
        writer.WriteVector3(Omega);
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(VectorStamp);
    }
}

/// <summary>The player is about to be teleported (specification 08, 6.1 and 4.3).</summary>
/// <param name="Teleport">Number of the teleport.</param>
/// <remarks>Retail: SmartBox::HandlePlayerTeleport @0x00452150.</remarks>
public readonly record struct PlayerTeleport(ushort Teleport) : IObjectMessage<PlayerTeleport>
{
    static Opcode IObjectMessage<PlayerTeleport>.Opcode => Opcode.PlayerTeleport;

    static PlayerTeleport IMessage<PlayerTeleport>.Read(ref WireReader reader)
    {
        var message = new PlayerTeleport(reader.ReadUInt16());
        reader.Align4();
        return message;
    }

    void IMessage<PlayerTeleport>.Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Teleport);
        writer.Align4();
    }
}

/// <summary>An object looks different (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Model">What it looks like now.</param>
/// <param name="Instance">Which life of the object.</param>
/// <param name="ObjDescStamp">Number of this look.</param>
/// <remarks>Retail: SmartBox::HandleObjDescEvent @0x00453340.</remarks>
public readonly record struct ObjDescEvent(uint Guid, ModelData Model, ushort Instance, ushort ObjDescStamp) : IObjectMessage<ObjDescEvent>
{
    static Opcode IObjectMessage<ObjDescEvent>.Opcode => Opcode.ObjDescEvent;

    static ObjDescEvent IMessage<ObjDescEvent>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), ModelData.Read(ref reader), reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<ObjDescEvent>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        Model.Write(ref writer);
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(ObjDescStamp);
    }
}
