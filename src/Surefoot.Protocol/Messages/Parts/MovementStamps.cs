namespace Surefoot.Protocol.Messages;

/// <summary>The local player's stored timestamps, behind every message about its movement (specification 08, 5.2).</summary>
/// <param name="Instance">Which life of the object.</param>
/// <param name="ServerControlledMove">Last movement that the server ordered.</param>
/// <param name="Teleport">Last teleport.</param>
/// <param name="ForcePosition">Last correction of its position.</param>
public readonly record struct MovementStamps(ushort Instance, ushort ServerControlledMove, ushort Teleport, ushort ForcePosition)
{
    internal static MovementStamps Read(ref WireReader reader)
        => new(reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt16());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(ServerControlledMove);
        writer.WriteUInt16(Teleport);
        writer.WriteUInt16(ForcePosition);
    }
}
