using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>A thing in the sky.</summary>
/// <param name="Begin">When it appears, as a share of the day.</param>
/// <param name="End">When it vanishes, as a share of the day.</param>
/// <param name="BeginAngle">Where it appears; degrees.</param>
/// <param name="EndAngle">Where it vanishes; degrees.</param>
/// <param name="TextureVelocityX">Widths a second.</param>
/// <param name="TextureVelocityY">Heights a second.</param>
/// <param name="GfxObjId">Its shape.</param>
/// <param name="ScriptId">Its physics script; 0 where the sky stores none.</param>
/// <param name="Properties">Bits.</param>
public readonly record struct SkyObject(
    float Begin,
    float End,
    float BeginAngle,
    float EndAngle,
    float TextureVelocityX,
    float TextureVelocityY,
    uint GfxObjId,
    uint ScriptId,
    uint Properties)
{
    private const int Word = 4;

    internal static int SizeOf(bool hasScript) => (hasScript ? 9 : 8) * Word;

    internal static SkyObject Read(ref DatReader reader, bool hasScript) => new(
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadSingle(),
        reader.ReadUInt32(),
        hasScript ? reader.ReadUInt32() : 0,
        reader.ReadUInt32());

    internal static void Write(DatWriter writer, SkyObject thing, bool hasScript)
    {
        DatWriter.Require(hasScript || thing.ScriptId == 0, "A thing in the sky has a script, but its sky stores none.");
        writer.WriteSingle(thing.Begin);
        writer.WriteSingle(thing.End);
        writer.WriteSingle(thing.BeginAngle);
        writer.WriteSingle(thing.EndAngle);
        writer.WriteSingle(thing.TextureVelocityX);
        writer.WriteSingle(thing.TextureVelocityY);
        writer.WriteUInt32(thing.GfxObjId);
        if (hasScript)
            writer.WriteUInt32(thing.ScriptId);
        writer.WriteUInt32(thing.Properties);
    }
}

/// <summary>Exchanges a thing in the sky for a while.</summary>
/// <param name="ObjectIndex">Index of the sky object.</param>
/// <param name="GfxObjId">Its shape then.</param>
/// <param name="Rotate">Degrees.</param>
/// <param name="Transparent">0 to 1.</param>
/// <param name="Luminosity">Its luminosity.</param>
/// <param name="MaxBright">Its greatest brightness.</param>
public readonly record struct SkyObjectReplacement(
    uint ObjectIndex, uint GfxObjId, float Rotate, float Transparent, float Luminosity, float MaxBright)
{
    internal const int Size = 24;

    internal static SkyObjectReplacement Read(ref DatReader reader) => new(
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());

    internal static void Write(DatWriter writer, SkyObjectReplacement replacement)
    {
        writer.WriteUInt32(replacement.ObjectIndex);
        writer.WriteUInt32(replacement.GfxObjId);
        writer.WriteSingle(replacement.Rotate);
        writer.WriteSingle(replacement.Transparent);
        writer.WriteSingle(replacement.Luminosity);
        writer.WriteSingle(replacement.MaxBright);
    }
}

/// <summary>Light and fog from a time of the day on.</summary>
public sealed record SkyTime
{
    internal const int LeastSize = 48;

    /// <summary>When it begins, as a share of the day.</summary>
    public float Begin { get; init; }

    /// <summary>Brightness of the sun.</summary>
    public float DirectionalBrightness { get; init; }

    /// <summary>Where the sun's light comes from; degrees.</summary>
    public float Heading { get; init; }

    /// <summary>How high the sun stands; degrees.</summary>
    public float Pitch { get; init; }

    /// <summary>Colour of the sun.</summary>
    public DatColor DirectionalColor { get; init; }

    /// <summary>Brightness of the surroundings.</summary>
    public float AmbientBrightness { get; init; }

    /// <summary>Colour of the surroundings.</summary>
    public DatColor AmbientColor { get; init; }

    /// <summary>Where fog begins; metres.</summary>
    public float MinFog { get; init; }

    /// <summary>Where fog is full; metres.</summary>
    public float MaxFog { get; init; }

    /// <summary>Colour of the fog.</summary>
    public DatColor FogColor { get; init; }

    /// <summary>Kind of fog.</summary>
    public uint FogMode { get; init; }

    /// <summary>Things exchanged meanwhile.</summary>
    public ImmutableArray<SkyObjectReplacement> Replacements { get; init; } = [];

    internal static SkyTime Read(ref DatReader reader)
    {
        var time = new SkyTime
        {
            Begin = reader.ReadSingle(),
            DirectionalBrightness = reader.ReadSingle(),
            Heading = reader.ReadSingle(),
            Pitch = reader.ReadSingle(),
            DirectionalColor = reader.ReadColor(),
            AmbientBrightness = reader.ReadSingle(),
            AmbientColor = reader.ReadColor(),
            MinFog = reader.ReadSingle(),
            MaxFog = reader.ReadSingle(),
            FogColor = reader.ReadColor(),
            FogMode = reader.ReadUInt32(),
            Replacements = reader.ReadList(SkyObjectReplacement.Size, SkyObjectReplacement.Read),
        };
        return time;
    }

    internal static void Write(DatWriter writer, SkyTime time)
    {
        writer.WriteSingle(time.Begin);
        writer.WriteSingle(time.DirectionalBrightness);
        writer.WriteSingle(time.Heading);
        writer.WriteSingle(time.Pitch);
        writer.WriteColor(time.DirectionalColor);
        writer.WriteSingle(time.AmbientBrightness);
        writer.WriteColor(time.AmbientColor);
        writer.WriteSingle(time.MinFog);
        writer.WriteSingle(time.MaxFog);
        writer.WriteColor(time.FogColor);
        writer.WriteUInt32(time.FogMode);
        writer.WriteList(time.Replacements, SkyObjectReplacement.Write);
    }
}

/// <summary>A kind of day, e.g. "Sunny".</summary>
/// <param name="Chance">How often it comes.</param>
/// <param name="Name">Its name.</param>
/// <param name="Objects">Things in the sky.</param>
/// <param name="Times">Light over the day.</param>
public sealed record DayGroup(float Chance, string Name, ImmutableArray<SkyObject> Objects, ImmutableArray<SkyTime> Times)
{
    internal const int LeastSize = 16;

    internal static DayGroup Read(ref DatReader reader, bool hasScripts) => new(
        reader.ReadSingle(),
        reader.ReadPString(),
        reader.ReadList(SkyObject.SizeOf(hasScripts), (ref r) => SkyObject.Read(ref r, hasScripts)),
        reader.ReadList(SkyTime.LeastSize, SkyTime.Read));

    internal static void Write(DatWriter writer, DayGroup group, bool hasScripts)
    {
        writer.WriteSingle(group.Chance);
        writer.WritePString(group.Name);
        writer.WriteList(group.Objects, (w, thing) => SkyObject.Write(w, thing, hasScripts));
        writer.WriteList(group.Times, SkyTime.Write);
    }
}

/// <summary>The sky of a region (spec 07, 7.15).</summary>
/// <remarks>Retail: SkyDesc::UnPack @0x00501CD0.</remarks>
/// <param name="TickSize">Seconds between ticks of the sky.</param>
/// <param name="LightTickSize">Seconds between ticks of the light.</param>
/// <param name="DayGroups">Kinds of days.</param>
public sealed record SkyDescription(double TickSize, double LightTickSize, ImmutableArray<DayGroup> DayGroups)
{
    /// <summary>
    /// Whether each thing in the sky is stored with a script, as in files from August 2012 on: nine words; without it eight. Nothing in a
    /// record says which, so it is found by reading.
    /// </summary>
    public bool HasScripts { get; init; } = true;

    internal static SkyDescription Read(ref DatReader reader, bool hasScripts)
    {
        double tick = reader.ReadDouble(), lightTick = reader.ReadDouble();
        ImmutableArray<DayGroup> groups = reader.ReadList(DayGroup.LeastSize, (ref r) => DayGroup.Read(ref r, hasScripts));
        return new(tick, lightTick, groups) { HasScripts = hasScripts };
    }

    internal void Write(DatWriter writer)
    {
        bool hasScripts = HasScripts;
        writer.WriteDouble(TickSize);
        writer.WriteDouble(LightTickSize);
        writer.WriteList(DayGroups, (w, group) => DayGroup.Write(w, group, hasScripts));
    }
}
