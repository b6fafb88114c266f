using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>Bits of <see cref="Region.Parts"/>.</summary>
[Flags]
public enum RegionParts : uint
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Ambient sounds.</summary>
    Sound = 0x01,

    /// <summary>Scene types.</summary>
    Scenes = 0x02,

    /// <summary>Sky.</summary>
    Sky = 0x10,

    /// <summary>Miscellaneous ids.</summary>
    Misc = 0x200,
}

/// <summary>Measures of the land as stored. Retail skips them and uses those of <see cref="Retail"/>, whatever is there.</summary>
/// <param name="BlocksX">Blocks west to east.</param>
/// <param name="BlocksY">Blocks south to north.</param>
/// <param name="SquareLength">Side of a square; metres.</param>
/// <param name="SquaresPerSide">Squares along a block's side.</param>
/// <param name="VerticesPerCell">Vertices per cell.</param>
/// <param name="MaxObjectHeight">Metres.</param>
/// <param name="SkyHeight">Metres.</param>
/// <param name="RoadWidth">Metres.</param>
public readonly record struct RegionLand(
    int BlocksX,
    int BlocksY,
    float SquareLength,
    int SquaresPerSide,
    int VerticesPerCell,
    float MaxObjectHeight,
    float SkyHeight,
    float RoadWidth)
{
    /// <summary>The values that retail uses.</summary>
    public static RegionLand Retail { get; } = new(255, 255, 24, 8, 1, 200, 1000, 5);

    internal static RegionLand Read(ref DatReader reader) => new(
        reader.ReadInt32(),
        reader.ReadInt32(),
        reader.ReadSingle(),
        reader.ReadInt32(),
        reader.ReadInt32(),
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadSingle());

    internal void Write(DatWriter writer)
    {
        writer.WriteInt32(BlocksX);
        writer.WriteInt32(BlocksY);
        writer.WriteSingle(SquareLength);
        writer.WriteInt32(SquaresPerSide);
        writer.WriteInt32(VerticesPerCell);
        writer.WriteSingle(MaxObjectHeight);
        writer.WriteSingle(SkyHeight);
        writer.WriteSingle(RoadWidth);
    }
}

/// <summary>The six ids of the region's last part.</summary>
/// <param name="Version">Version of the part.</param>
/// <param name="GameMapId">Picture of the map.</param>
/// <param name="AutotestMapId">Picture of the test map.</param>
/// <param name="AutotestMapSize">Its size.</param>
/// <param name="ClearCellId">A GfxObj.</param>
/// <param name="ClearMonsterId">A GfxObj.</param>
public readonly record struct RegionMisc(
    uint Version, uint GameMapId, uint AutotestMapId, uint AutotestMapSize, uint ClearCellId, uint ClearMonsterId);

/// <summary>0x13000000: heights, terrain and scenery of the land, its calendar and sky (spec 07, 7.15).</summary>
/// <remarks>Retail: CRegionDesc::UnPack @0x004FF440.</remarks>
public sealed class Region : DatRecord, IDatRecord<Region>
{
    /// <summary>Entries of the height table.</summary>
    public const int HeightCount = 256;

    /// <summary>The version that exists.</summary>
    public const uint CurrentVersion = 3;

    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Region;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Number of the region; the cell file's name carries it.</summary>
    public uint Number { get; init; } = 1;

    /// <summary>Version of the record.</summary>
    public uint Version { get; init; } = CurrentVersion;

    /// <summary>Its name.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>Measures of the land; retail does not read them.</summary>
    public RegionLand Land { get; init; } = RegionLand.Retail;

    /// <summary>256 heights in metres, as stored. Retail copies them up to the first outside 0 … 800; the rest stays 0.</summary>
    public required ImmutableArray<float> HeightTable { get; init; }

    /// <summary>The calendar.</summary>
    public GameTime Time { get; init; } = new();

    /// <summary>Which parts are stored.</summary>
    public RegionParts Parts { get; init; } = RegionParts.Scenes;

    /// <summary>The sky; null without <see cref="RegionParts.Sky"/>.</summary>
    public SkyDescription? Sky { get; init; }

    /// <summary>Ambient sounds; empty without <see cref="RegionParts.Sound"/>.</summary>
    public ImmutableArray<AmbientSounds> Sounds { get; init; } = [];

    /// <summary>Scene types; empty without <see cref="RegionParts.Scenes"/>.</summary>
    public ImmutableArray<SceneType> SceneTypes { get; init; } = [];

    /// <summary>Terrain types; a terrain word's 5-bit type is the position.</summary>
    public ImmutableArray<TerrainType> TerrainTypes { get; init; } = [];

    /// <summary>How the ground is textured.</summary>
    public LandSurface Surface { get; init; } = new();

    /// <summary>The last part; null without <see cref="RegionParts.Misc"/>.</summary>
    public RegionMisc? Misc { get; init; }

    /// <inheritdoc/>
    public static Region Decode(ref DatReader reader)
    {
        uint id = reader.ReadId(), number = reader.ReadUInt32(), version = reader.ReadUInt32();
        if (version != CurrentVersion)
            reader.Remark($"region version {version}; only 3 is known", reader.Position - 4);
        string name = reader.ReadPString();
        RegionLand land = RegionLand.Read(ref reader);
        ImmutableArray<float> heights = reader.ReadArray(HeightCount, 4, static (ref r) => r.ReadSingle());
        GameTime time = GameTime.Read(ref reader);
        var parts = (RegionParts)reader.ReadUInt32();
        bool hasScripts = FitOf(reader, parts, hasScripts: true) >= FitOf(reader, parts, hasScripts: false);
        Rest rest = Rest.Read(ref reader, parts, hasScripts);
        return new()
        {
            Id = id,
            Number = number,
            Version = version,
            Name = name,
            Land = land,
            HeightTable = heights,
            Time = time,
            Parts = parts,
            Sky = rest.Sky,
            Sounds = rest.Sounds,
            SceneTypes = rest.SceneTypes,
            TerrainTypes = rest.TerrainTypes,
            Surface = rest.Surface,
            Misc = rest.Misc,
        };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        DatWriter.Require(HeightTable.Length == HeightCount, $"Region 0x{Id:X8} needs {HeightCount} heights.");
        RequirePart(RegionParts.Sky, Sky is not null, Sky is null);
        RequirePart(RegionParts.Sound, true, Sounds.IsEmpty);
        RequirePart(RegionParts.Scenes, true, SceneTypes.IsEmpty);
        RequirePart(RegionParts.Misc, Misc is not null, Misc is null);
        writer.WriteUInt32(Id);
        writer.WriteUInt32(Number);
        writer.WriteUInt32(Version);
        writer.WritePString(Name);
        Land.Write(writer);
        writer.WriteArray(HeightTable, static (w, height) => w.WriteSingle(height));
        Time.Write(writer);
        writer.WriteUInt32((uint)Parts);
        Sky?.Write(writer);
        if (Parts.HasFlag(RegionParts.Sound))
            writer.WriteList(Sounds, AmbientSounds.Write);
        if (Parts.HasFlag(RegionParts.Scenes))
            writer.WriteList(SceneTypes, SceneType.Write);
        writer.WriteList(TerrainTypes, TerrainType.Write);
        Surface.Write(writer);
        if (Misc is RegionMisc misc)
            WriteMisc(writer, misc);
    }

    /// <summary>
    /// How well a reading with or without scripts in the sky fits: 2 ends exactly on the record's end, 1 leaves only what aligns it, 0
    /// fails.
    /// </summary>
    private static int FitOf(in DatReader atSky, RegionParts parts, bool hasScripts)
    {
        DatReader trial = atSky.Fork();
        try
        {
            _ = Rest.Read(ref trial, parts, hasScripts);
            return trial.ReadEnd() == 0 ? 2 : 1;
        }
        catch (DatFormatException)
        {
            return 0;
        }
    }

    private static RegionMisc ReadMisc(ref DatReader reader) => new(
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    private static void WriteMisc(DatWriter writer, RegionMisc misc)
    {
        writer.WriteUInt32(misc.Version);
        writer.WriteUInt32(misc.GameMapId);
        writer.WriteUInt32(misc.AutotestMapId);
        writer.WriteUInt32(misc.AutotestMapSize);
        writer.WriteUInt32(misc.ClearCellId);
        writer.WriteUInt32(misc.ClearMonsterId);
    }

    private void RequirePart(RegionParts part, bool canBeWritten, bool absent)
        => DatWriter.Require(
            Parts.HasFlag(part) ? canBeWritten : absent,
            $"Region 0x{Id:X8}: the mask and the content of the part {part} contradict each other.");

    /// <summary>What stands behind the mask of parts.</summary>
    private sealed record Rest(
        SkyDescription? Sky,
        ImmutableArray<AmbientSounds> Sounds,
        ImmutableArray<SceneType> SceneTypes,
        ImmutableArray<TerrainType> TerrainTypes,
        LandSurface Surface,
        RegionMisc? Misc)
    {
        public static Rest Read(ref DatReader reader, RegionParts parts, bool hasScripts) => new(
            parts.HasFlag(RegionParts.Sky) ? SkyDescription.Read(ref reader, hasScripts) : null,
            parts.HasFlag(RegionParts.Sound) ? reader.ReadList(8, AmbientSounds.Read) : [],
            parts.HasFlag(RegionParts.Scenes) ? reader.ReadList(8, SceneType.Read) : [],
            reader.ReadList(12, TerrainType.Read),
            LandSurface.Read(ref reader),
            parts.HasFlag(RegionParts.Misc) ? ReadMisc(ref reader) : null);
    }
}
