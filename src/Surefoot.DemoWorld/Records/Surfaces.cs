using System.Collections.Immutable;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>Solid-colour surfaces, which are all that the demo world's shapes need.</summary>
internal static class Surfaces
{
    /// <summary>A Surface record of one colour (spec 07, 7.16: kind 1, no leading id).</summary>
    public static RawRecord Solid(uint id, uint rgb)
    {
        byte[] bytes =
        [
            1, 0, 0, 0,
            (byte)rgb, (byte)(rgb >> 8), (byte)(rgb >> 16), 0xFF,
            .. BitConverter.GetBytes(0f), .. BitConverter.GetBytes(0f), .. BitConverter.GetBytes(1f),
        ];
        return new(DatRecordType.Surface) { Id = id, Bytes = ImmutableArray.Create(bytes) };
    }

    /// <summary>All surfaces of the world.</summary>
    public static IEnumerable<DatRecord> All()
    {
        yield return Solid(DemoIds.Skin, 0xD9A883);
        yield return Solid(DemoIds.Hair, 0x4A3220);
        yield return Solid(DemoIds.Shirt, 0x8C3B2E);
        yield return Solid(DemoIds.Trousers, 0x3F4A5C);
        yield return Solid(DemoIds.Boots, 0x3A2A1C);
    }
}
