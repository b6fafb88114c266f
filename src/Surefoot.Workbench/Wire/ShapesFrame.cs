using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>Writes what <c>/shapes/XXYY</c> answers.</summary>
internal static class ShapesFrame
{
    private const int HeaderLength = 12;

    /// <summary>
    /// <c>u32[3] triangles</c> of objects, building shells and rooms, then for each triangle in that order <c>f32[9]</c>, its corners in metres of the block,
    /// counter-clockwise seen from its front.
    /// </summary>
    public static byte[] Encode(BlockShapes shapes)
    {
        Vector3[][] groups = [shapes.Objects, shapes.Shells, shapes.Rooms];
        byte[] bytes = new byte[HeaderLength + (groups.Sum(group => group.Length) * 12)];
        Span<byte> rest = bytes.AsSpan(HeaderLength);
        for (int i = 0; i < groups.Length; i++)
        {
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(4 * i), (uint)(groups[i].Length / 3));
            foreach (float number in MemoryMarshal.Cast<Vector3, float>(groups[i]))
            {
                BinaryPrimitives.WriteSingleLittleEndian(rest, number);
                rest = rest[4..];
            }
        }

        return bytes;
    }
}
