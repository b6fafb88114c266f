namespace Surefoot.Protocol.Messages;

/// <summary>The nine timestamps of an object, in the order of CreateObject (specification 08, 4.3).</summary>
/// <param name="Position">UpdatePosition, ParentEvent, PickupEvent.</param>
/// <param name="Movement">UpdateMotion.</param>
/// <param name="State">SetState.</param>
/// <param name="Vector">VectorUpdate.</param>
/// <param name="Teleport">Teleports.</param>
/// <param name="ServerControlledMove">UpdateMotion that the server ordered.</param>
/// <param name="ForcePosition">Corrections of a player's position.</param>
/// <param name="ObjDesc">ObjDescEvent.</param>
/// <param name="Instance">Which life of the object.</param>
public readonly record struct ObjectStamps(
    ushort Position,
    ushort Movement,
    ushort State,
    ushort Vector,
    ushort Teleport,
    ushort ServerControlledMove,
    ushort ForcePosition,
    ushort ObjDesc,
    ushort Instance)
{
    /// <summary>A stamp is newer than another one, around the wrap. Equal is not newer; at a distance of exactly 0x8000 the smaller number
    /// is.</summary>
    /// <remarks>Retail: CPhysicsObj::is_newer @0x00451AD0.</remarks>
    public static bool IsNewer(ushort stored, ushort incoming)
        => Math.Abs(incoming - stored) > 0x7FFF ? incoming < stored : stored < incoming;

    internal static ObjectStamps Read(ref WireReader reader) => new(
        reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16(),
        reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Position);
        writer.WriteUInt16(Movement);
        writer.WriteUInt16(State);
        writer.WriteUInt16(Vector);
        writer.WriteUInt16(Teleport);
        writer.WriteUInt16(ServerControlledMove);
        writer.WriteUInt16(ForcePosition);
        writer.WriteUInt16(ObjDesc);
        writer.WriteUInt16(Instance);
    }
}
