using System.Buffers;
using System.Buffers.Binary;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.Tool.Conformance;

/// <summary>
/// Rooms as the recorder of the oracle vectors read them: a portal leads outdoors when the cell behind it is 0xFFFF. Its world file says so
/// of its houses in no other way, whereas retail looks at a flag alone (specification 05, 2.5; 07, 7.11).
/// </summary>
/// <param name="source">The files as they are.</param>
internal sealed class PeerPortals(IDatSource source) : IDatSource
{
    private const int SecondId = 8, SurfaceCount = 12, PortalCount = 13, Surfaces = 16;
    private const int BeforePortals = 2 + 2 + 28;
    private const int PortalSize = 8, OtherCell = 4;
    private const ushort Nowhere = 0xFFFF;

    /// <inheritdoc/>
    public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
    {
        if (!source.TryRead(id, out bytes)) return false;
        if ((id & 0xFFFF) is >= 0x100 and <= 0xFFFD && bytes.Length > Surfaces)
            bytes = new ReadOnlySequence<byte>(WithFlags(id, bytes.ToArray()));
        return true;
    }

    /// <summary>A room tells its own id twice; other records are left as they are.</summary>
    private static byte[] WithFlags(uint id, byte[] record)
    {
        if (BinaryPrimitives.ReadUInt32LittleEndian(record.AsSpan(SecondId)) != id) return record;
        Span<byte> portals = record.AsSpan(Math.Min(Surfaces + (2 * record[SurfaceCount]) + BeforePortals, record.Length));
        for (int i = 0; i < record[PortalCount] && portals.Length >= PortalSize; i++, portals = portals[PortalSize..])
        {
            if (BinaryPrimitives.ReadUInt16LittleEndian(portals[OtherCell..]) == Nowhere) portals[0] |= (byte)PortalFlags.Outside;
        }

        return record;
    }
}
