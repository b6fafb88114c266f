using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Land;

/// <summary>The 32 terrain types of a terrain word (bits 2 to 6); 16 to 20 are water.</summary>
public enum TerrainKind
{
    /// <summary>Bare rock.</summary>
    BarrenRock = 0,

    /// <summary>Short grass.</summary>
    Grassland = 1,

    /// <summary>Ice.</summary>
    Ice = 2,

    /// <summary>Deep grass.</summary>
    LushGrass = 3,

    /// <summary>Swamp.</summary>
    MarshSparseSwamp = 4,

    /// <summary>Mud.</summary>
    MudRichDirt = 5,

    /// <summary>Obsidian.</summary>
    ObsidianPlain = 6,

    /// <summary>Trodden earth.</summary>
    PackedDirt = 7,

    /// <summary>Earth with grass.</summary>
    PatchyDirt = 8,

    /// <summary>Grass with earth.</summary>
    PatchyGrassland = 9,

    /// <summary>Yellow sand.</summary>
    SandYellow = 10,

    /// <summary>Grey sand.</summary>
    SandGrey = 11,

    /// <summary>Sand with stones.</summary>
    SandRockStrewn = 12,

    /// <summary>Layered rock.</summary>
    SedimentaryRock = 13,

    /// <summary>Rock with some green.</summary>
    SemiBarrenRock = 14,

    /// <summary>Snow.</summary>
    Snow = 15,

    /// <summary>River water.</summary>
    WaterRunning = 16,

    /// <summary>Lake water.</summary>
    WaterStandingFresh = 17,

    /// <summary>Sea near a coast.</summary>
    WaterShallowSea = 18,

    /// <summary>Still sea near a coast.</summary>
    WaterShallowStillSea = 19,

    /// <summary>Open sea.</summary>
    WaterDeepSea = 20,

    /// <summary>Ground under trees.</summary>
    ForestFloor = 21,
}

/// <summary>Names and colours of the terrain types, and which of them are water.</summary>
internal static class TerrainKinds
{
    /// <summary>How many types a terrain word can name.</summary>
    public const int Count = 32;

    /// <summary>Whether retail takes a type for water (spec 05, 2.6).</summary>
    public static bool IsWater(TerrainKind kind) => kind is >= TerrainKind.WaterRunning and <= TerrainKind.WaterDeepSea;

    /// <summary>Name of a type, of the unused ones too.</summary>
    public static string NameOf(int kind) => Enum.IsDefined((TerrainKind)kind) ? ((TerrainKind)kind).ToString() : $"Unused{kind}";

    /// <summary>Colour for maps and for viewers without textures.</summary>
    public static DatColor ColourOf(TerrainKind kind)
    {
        uint rgb = kind switch
        {
            TerrainKind.BarrenRock => 0x8A8580,
            TerrainKind.Grassland => 0x7FA650,
            TerrainKind.Ice => 0xCFE3EE,
            TerrainKind.LushGrass => 0x5F8F3E,
            TerrainKind.MarshSparseSwamp => 0x5C6B45,
            TerrainKind.MudRichDirt => 0x6B543B,
            TerrainKind.ObsidianPlain => 0x3B3640,
            TerrainKind.PackedDirt => 0xA88B62,
            TerrainKind.PatchyDirt => 0x97885A,
            TerrainKind.PatchyGrassland => 0x93A45A,
            TerrainKind.SandYellow => 0xD9C78A,
            TerrainKind.SandGrey => 0xBDB7A4,
            TerrainKind.SandRockStrewn => 0xB3A684,
            TerrainKind.SedimentaryRock => 0x9C8A78,
            TerrainKind.SemiBarrenRock => 0x85876B,
            TerrainKind.Snow => 0xF2F5F7,
            TerrainKind.WaterRunning => 0x5B9BC8,
            TerrainKind.WaterStandingFresh => 0x4A86B8,
            TerrainKind.WaterShallowSea => 0x4F9DB5,
            TerrainKind.WaterShallowStillSea => 0x5AA9B8,
            TerrainKind.WaterDeepSea => 0x2B5C86,
            TerrainKind.ForestFloor => 0x4B6B38,
            _ => 0x808080,
        };
        return new((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb, 0xFF);
    }
}
