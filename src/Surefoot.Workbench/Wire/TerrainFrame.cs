using System.Buffers.Binary;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>Writes a landblock of what <c>/terrain/XXYY/RADIUS</c> answers.</summary>
internal static class TerrainFrame
{
    /// <summary>Length of a landblock, bytes.</summary>
    public const int Length = 4 + (81 * 4) + (81 * 2) + 64;

    /// <summary>
    /// <c>u16 block, u16 0, f32[81] heights, u16[81] terrain words, u8[64] 1 where the cell is cut SW–NE</c>, little-endian.
    /// </summary>
    public static byte[] Encode(ushort block, TerrainBlock terrain)
    {
        byte[] bytes = new byte[Length];
        BinaryPrimitives.WriteUInt16LittleEndian(bytes, block);
        Span<byte> rest = bytes.AsSpan(4);
        foreach (float height in terrain.Heights)
        {
            BinaryPrimitives.WriteSingleLittleEndian(rest, height);
            rest = rest[4..];
        }

        foreach (ushort word in terrain.Terrain)
        {
            BinaryPrimitives.WriteUInt16LittleEndian(rest, word);
            rest = rest[2..];
        }

        for (int i = 0; i < 64; i++) rest[i] = terrain.SouthWestCut[i] ? (byte)1 : (byte)0;
        return bytes;
    }
}
