using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>A place as it travels: 32 bytes (specification 08, 5.1).</summary>
/// <param name="Cell">Full id of the cell.</param>
/// <param name="Origin">Metres from the corner of the cell's landblock.</param>
/// <param name="Orientation">Rotation, as sent: not made unit length.</param>
/// <remarks>Retail: Position::Pack @0x005A9640.</remarks>
public readonly record struct WirePosition(uint Cell, Vector3 Origin, Quaternion Orientation)
{
    internal static WirePosition Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadVector3(), reader.ReadQuaternion());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Cell);
        writer.WriteVector3(Origin);
        writer.WriteQuaternion(Orientation);
    }
}
