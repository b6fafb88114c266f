using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>A sound heard now and then.</summary>
/// <param name="SoundType">Entry of the sound table.</param>
/// <param name="Volume">0 to 1.</param>
/// <param name="BaseChance">0 to 1.</param>
/// <param name="MinRate">Least time between; seconds.</param>
/// <param name="MaxRate">Greatest time between; seconds.</param>
public readonly record struct AmbientSound(uint SoundType, float Volume, float BaseChance, float MinRate, float MaxRate);

/// <summary>The sounds of a kind of land.</summary>
/// <param name="SoundTableId">The table.</param>
/// <param name="Sounds">Its sounds.</param>
public sealed record AmbientSounds(uint SoundTableId, ImmutableArray<AmbientSound> Sounds)
{
    internal static AmbientSounds Read(ref DatReader reader) => new(
        reader.ReadUInt32(),
        reader.ReadList(
            20, static (ref r) => new AmbientSound(r.ReadUInt32(), r.ReadSingle(), r.ReadSingle(), r.ReadSingle(), r.ReadSingle())));

    internal static void Write(DatWriter writer, AmbientSounds sounds)
    {
        writer.WriteUInt32(sounds.SoundTableId);
        writer.WriteList(sounds.Sounds, static (w, sound) =>
        {
            w.WriteUInt32(sound.SoundType);
            w.WriteSingle(sound.Volume);
            w.WriteSingle(sound.BaseChance);
            w.WriteSingle(sound.MinRate);
            w.WriteSingle(sound.MaxRate);
        });
    }
}

/// <summary>Scenes of which one is drawn for a cell (spec 05).</summary>
/// <param name="SoundIndex">Index into <see cref="Region.Sounds"/>; 0xFFFFFFFF none.</param>
/// <param name="SceneIds">The scenes.</param>
public sealed record SceneType(uint SoundIndex, ImmutableArray<uint> SceneIds)
{
    /// <summary>No sound, in <see cref="SoundIndex"/>.</summary>
    public const uint NoSound = 0xFFFFFFFF;

    internal static SceneType Read(ref DatReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32Array(reader.ReadUInt32()));

    internal static void Write(DatWriter writer, SceneType type)
    {
        writer.WriteUInt32(type.SoundIndex);
        writer.WriteUInt32((uint)type.SceneIds.Length);
        writer.WriteUInt32Array(type.SceneIds);
    }
}

/// <summary>A kind of ground.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Color">Its colour on the map.</param>
/// <param name="SceneTypes">Index into <see cref="Region.SceneTypes"/> for each scenery type of a terrain word; 0xFFFFFFFF none.</param>
public sealed record TerrainType(string Name, DatColor Color, ImmutableArray<uint> SceneTypes)
{
    internal static TerrainType Read(ref DatReader reader)
        => new(reader.ReadPString(), reader.ReadColor(), reader.ReadUInt32Array(reader.ReadUInt32()));

    internal static void Write(DatWriter writer, TerrainType type)
    {
        writer.WritePString(type.Name);
        writer.WriteColor(type.Color);
        writer.WriteUInt32((uint)type.SceneTypes.Length);
        writer.WriteUInt32Array(type.SceneTypes);
    }
}

/// <summary>A texture under a code of corners, sides or roads.</summary>
/// <param name="Code">The code.</param>
/// <param name="TextureId">The texture.</param>
public readonly record struct TerrainMap(uint Code, uint TextureId);

/// <summary>Texture of a kind of ground.</summary>
/// <param name="TerrainType">The kind.</param>
/// <param name="TextureId">Its texture.</param>
/// <param name="Tiling">Repeats.</param>
/// <param name="MaxBright">Greatest change of brightness.</param>
/// <param name="MinBright">Least change of brightness.</param>
/// <param name="MaxSaturation">Greatest change of saturation.</param>
/// <param name="MinSaturation">Least change of saturation.</param>
/// <param name="MaxHue">Greatest change of hue.</param>
/// <param name="MinHue">Least change of hue.</param>
/// <param name="DetailTiling">Repeats of the detail texture.</param>
/// <param name="DetailTextureId">The detail texture.</param>
public readonly record struct TerrainTexture(
    uint TerrainType,
    uint TextureId,
    uint Tiling,
    uint MaxBright,
    uint MinBright,
    uint MaxSaturation,
    uint MinSaturation,
    uint MaxHue,
    uint MinHue,
    uint DetailTiling,
    uint DetailTextureId);

/// <summary>How the ground is textured: texture merge, the only kind in use.</summary>
public sealed record LandSurface
{
    private const uint TextureMerge = 0;

    /// <summary>Size of the merged texture in texels.</summary>
    public uint BaseTextureSize { get; init; }

    /// <summary>Corner maps.</summary>
    public ImmutableArray<TerrainMap> CornerMaps { get; init; } = [];

    /// <summary>Side maps.</summary>
    public ImmutableArray<TerrainMap> SideMaps { get; init; } = [];

    /// <summary>Road maps.</summary>
    public ImmutableArray<TerrainMap> RoadMaps { get; init; } = [];

    /// <summary>A texture for each kind of ground.</summary>
    public ImmutableArray<TerrainTexture> TerrainTextures { get; init; } = [];

    internal static LandSurface Read(ref DatReader reader)
    {
        uint kind = reader.ReadUInt32();
        if (kind != TextureMerge)
            throw reader.Error($"land surface of kind {kind}; only 0 (texture merge) is known", reader.Position - 4);
        return new()
        {
            BaseTextureSize = reader.ReadUInt32(),
            CornerMaps = reader.ReadList(8, ReadMap),
            SideMaps = reader.ReadList(8, ReadMap),
            RoadMaps = reader.ReadList(8, ReadMap),
            TerrainTextures = reader.ReadList(44, ReadTexture),
        };
    }

    internal void Write(DatWriter writer)
    {
        writer.WriteUInt32(TextureMerge);
        writer.WriteUInt32(BaseTextureSize);
        writer.WriteList(CornerMaps, WriteMap);
        writer.WriteList(SideMaps, WriteMap);
        writer.WriteList(RoadMaps, WriteMap);
        writer.WriteList(TerrainTextures, WriteTexture);
    }

    private static TerrainMap ReadMap(ref DatReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    private static void WriteMap(DatWriter writer, TerrainMap map)
    {
        writer.WriteUInt32(map.Code);
        writer.WriteUInt32(map.TextureId);
    }

    private static TerrainTexture ReadTexture(ref DatReader reader) => new(
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32(),
        reader.ReadUInt32());

    private static void WriteTexture(DatWriter writer, TerrainTexture texture)
    {
        writer.WriteUInt32(texture.TerrainType);
        writer.WriteUInt32(texture.TextureId);
        writer.WriteUInt32(texture.Tiling);
        writer.WriteUInt32(texture.MaxBright);
        writer.WriteUInt32(texture.MinBright);
        writer.WriteUInt32(texture.MaxSaturation);
        writer.WriteUInt32(texture.MinSaturation);
        writer.WriteUInt32(texture.MaxHue);
        writer.WriteUInt32(texture.MinHue);
        writer.WriteUInt32(texture.DetailTiling);
        writer.WriteUInt32(texture.DetailTextureId);
    }
}
