using System.Collections.Immutable;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>Solid-colour surfaces, which are all that the demo world's shapes need.</summary>
internal static class Surfaces
{
    public const uint Skin = 0x08000001, Hair = 0x08000002, Shirt = 0x08000003, Trousers = 0x08000004, Boots = 0x08000005,
        Plaster = 0x08000010, Timber = 0x08000011, Boards = 0x08000012, Tiles = 0x08000013, Stone = 0x08000014,
        DarkStone = 0x08000015, Flagstones = 0x08000016, Bark = 0x08000017, Leaves = 0x08000018, Needles = 0x08000019,
        Rock = 0x0800001A, Hide = 0x0800001B, Scales = 0x0800001C, Sandstone = 0x0800001D, WarningRed = 0x0800001E;

    private static readonly (uint Id, uint Rgb)[] Colours =
    [
        (Skin, 0xD9A883), (Hair, 0x4A3220), (Shirt, 0x8C3B2E), (Trousers, 0x3F4A5C), (Boots, 0x3A2A1C),
        (Plaster, 0xD8CDB4), (Timber, 0x7A5A3A), (Boards, 0xA07C50), (Tiles, 0x9A4B38), (Stone, 0x8E8C86),
        (DarkStone, 0x5A5A60), (Flagstones, 0x77746C), (Bark, 0x5C4430), (Leaves, 0x4E7A32), (Needles, 0x32593A),
        (Rock, 0x7C7870), (Hide, 0x8A6A48), (Scales, 0x4F6E5A), (Sandstone, 0xB9A27A), (WarningRed, 0xB0574A),
    ];

    /// <summary>All surfaces of the world.</summary>
    public static IEnumerable<DatRecord> All() => Colours.Select(colour => Solid(colour.Id, colour.Rgb));

    // A Surface of one colour (spec 07, 7.16: kind 1, no leading id; colour B, G, R, A; translucency, luminosity, diffuse).
    private static RawRecord Solid(uint id, uint rgb)
    {
        byte[] bytes =
        [
            1, 0, 0, 0,
            (byte)rgb, (byte)(rgb >> 8), (byte)(rgb >> 16), 0xFF,
            .. BitConverter.GetBytes(0f), .. BitConverter.GetBytes(0f), .. BitConverter.GetBytes(1f),
        ];
        return new(DatRecordType.Surface) { Id = id, Bytes = ImmutableArray.Create(bytes) };
    }
}
