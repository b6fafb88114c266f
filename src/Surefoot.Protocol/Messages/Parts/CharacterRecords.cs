namespace Surefoot.Protocol.Messages;

/// <summary>A skill of a character: 28 bytes (specification 08, 7.2).</summary>
/// <param name="Ranks">Points bought.</param>
/// <param name="Version">1.</param>
/// <param name="Advancement">0 inactive, 1 untrained, 2 trained, 3 specialized.</param>
/// <param name="Experience">Experience spent.</param>
/// <param name="Initial">Points that come with the training.</param>
/// <param name="Resistance">Resistance of the last check.</param>
/// <param name="LastUsed">Seconds since the last use.</param>
/// <remarks>Retail: Skill::UnPack @0x005CAAC0.</remarks>
public readonly record struct SkillRecord(
    ushort Ranks,
    ushort Version,
    uint Advancement,
    uint Experience,
    uint Initial,
    uint Resistance,
    double LastUsed)
{
    internal const int Size = 28;

    internal static SkillRecord Read(ref WireReader reader) => new(
        reader.ReadUInt16(), reader.ReadUInt16(), reader.ReadUInt32(), reader.ReadUInt32(),
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadDouble());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Ranks);
        writer.WriteUInt16(Version);
        writer.WriteUInt32(Advancement);
        writer.WriteUInt32(Experience);
        writer.WriteUInt32(Initial);
        writer.WriteUInt32(Resistance);
        writer.WriteDouble(LastUsed);
    }
}

/// <summary>An attribute of a character: 12 bytes. Its value is ranks and start together (specification 08, 7.2).</summary>
/// <param name="Ranks">Points bought.</param>
/// <param name="Start">Points that it began with.</param>
/// <param name="Experience">Experience spent.</param>
/// <remarks>Retail: Attribute::UnPack @0x005CABF0.</remarks>
public readonly record struct AttributeRecord(uint Ranks, uint Start, uint Experience)
{
    internal static AttributeRecord Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Ranks);
        writer.WriteUInt32(Start);
        writer.WriteUInt32(Experience);
    }
}

/// <summary>Health, stamina or mana of a character: 16 bytes (specification 08, 7.2).</summary>
/// <param name="Ranks">Points bought.</param>
/// <param name="Start">Points that it began with.</param>
/// <param name="Experience">Experience spent.</param>
/// <param name="Current">The value as it is now.</param>
/// <remarks>Retail: SecondaryAttribute::UnPack @0x005CAC90.</remarks>
public readonly record struct VitalRecord(uint Ranks, uint Start, uint Experience, uint Current)
{
    internal static VitalRecord Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Ranks);
        writer.WriteUInt32(Start);
        writer.WriteUInt32(Experience);
        writer.WriteUInt32(Current);
    }
}
