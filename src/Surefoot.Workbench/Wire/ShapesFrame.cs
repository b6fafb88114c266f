using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>Writes what <c>/shapes/XXYY</c> answers.</summary>
internal static class ShapesFrame
{
    private const int HeaderLength = 24;
    private const int ShapeLength = 8;
    private const int PlantLength = 24;
    private const int MovingLength = 8;

    /// <summary>
    /// <c>u32[2] triangles</c> of objects and of rocks, <c>u32 shells, u32 rooms, u32 plants, u32 moving parts</c>; for each shell, then
    /// each room, <c>u32 id, u32 triangles</c>; for each plant <c>f32[3] low point, f32 radius, f32 height, u32 1 for a sphere</c>; for
    /// each moving part <c>u16 object, u16 part, u32 triangles</c>; then all triangles in the order in which they were counted,
    /// <c>f32[9]</c> each: its corners in metres of the block, or of the moving part's own frame, counter-clockwise seen from its front.
    /// </summary>
    public static byte[] Encode(BlockShapes shapes)
    {
        NamedShape[] named = [.. shapes.Shells, .. shapes.Rooms];
        Vector3[][] groups =
            [shapes.Objects, shapes.Rocks, .. named.Select(one => one.Triangles), .. shapes.Moving.Select(one => one.Triangles)];
        int triangles =
            HeaderLength + (named.Length * ShapeLength) + (shapes.Plants.Count * PlantLength) + (shapes.Moving.Count * MovingLength);
        byte[] bytes = new byte[triangles + (groups.Sum(group => group.Length) * 12)];
        Span<byte> rest = bytes;
        Count(ref rest, shapes.Objects.Length / 3);
        Count(ref rest, shapes.Rocks.Length / 3);
        Count(ref rest, shapes.Shells.Count);
        Count(ref rest, shapes.Rooms.Count);
        Count(ref rest, shapes.Plants.Count);
        Count(ref rest, shapes.Moving.Count);
        foreach (NamedShape one in named)
        {
            Count(ref rest, (int)one.Id);
            Count(ref rest, one.Triangles.Length / 3);
        }

        foreach (Plant plant in shapes.Plants)
        {
            foreach (float number in (ReadOnlySpan<float>)[plant.Low.X, plant.Low.Y, plant.Low.Z, plant.Radius, plant.Height])
                Number(ref rest, number);
            Count(ref rest, plant.IsRound ? 1 : 0);
        }

        foreach (MovingShape one in shapes.Moving)
        {
            Count(ref rest, one.Object | (one.Part << 16));
            Count(ref rest, one.Triangles.Length / 3);
        }

        foreach (Vector3[] group in groups)
            foreach (float number in MemoryMarshal.Cast<Vector3, float>(group)) Number(ref rest, number);
        return bytes;
    }

    private static void Count(ref Span<byte> rest, int value)
    {
        BinaryPrimitives.WriteInt32LittleEndian(rest, value);
        rest = rest[4..];
    }

    private static void Number(ref Span<byte> rest, float value)
    {
        BinaryPrimitives.WriteSingleLittleEndian(rest, value);
        rest = rest[4..];
    }
}
