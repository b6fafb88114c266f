using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>0x0E000018: experience in total that each rank and level takes (spec 07, 7.17).</summary>
/// <remarks>Every list begins with rank or level 0.</remarks>
public sealed class ExperienceTable : DatRecord, IDatRecord<ExperienceTable>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.ExperienceTable;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Of the ranks of an attribute; at least one.</summary>
    public ImmutableArray<uint> Attribute { get; init; } = [0];

    /// <summary>Of the ranks of a vital; at least one.</summary>
    public ImmutableArray<uint> Vital { get; init; } = [0];

    /// <summary>Of the ranks of a trained skill; at least one.</summary>
    public ImmutableArray<uint> TrainedSkill { get; init; } = [0];

    /// <summary>Of the ranks of a specialised skill; at least one.</summary>
    public ImmutableArray<uint> SpecializedSkill { get; init; } = [0];

    /// <summary>Of the levels of a character; at least one.</summary>
    public ImmutableArray<ulong> Level { get; init; } = [0];

    /// <summary>Skill credits that each level gives; as many as levels.</summary>
    public ImmutableArray<uint> LevelCredits { get; init; } = [0];

    /// <inheritdoc/>
    public static ExperienceTable Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        uint attribute = reader.ReadUInt32();
        uint vital = reader.ReadUInt32();
        uint trained = reader.ReadUInt32();
        uint specialized = reader.ReadUInt32();
        uint level = reader.ReadUInt32();
        return new()
        {
            Id = id,
            Attribute = reader.ReadUInt32Array(attribute + 1L),
            Vital = reader.ReadUInt32Array(vital + 1L),
            TrainedSkill = reader.ReadUInt32Array(trained + 1L),
            SpecializedSkill = reader.ReadUInt32Array(specialized + 1L),
            Level = reader.ReadArray(level + 1L, 8, static (ref r) => r.ReadUInt32() | (ulong)r.ReadUInt32() << 32),
            LevelCredits = reader.ReadUInt32Array(level + 1L),
        };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        DatWriter.Require(
            Attribute.Length > 0 && Vital.Length > 0 && TrainedSkill.Length > 0 && SpecializedSkill.Length > 0 && Level.Length > 0,
            "Every list of an experience table has at least one entry: the format stores last indices.");
        DatWriter.Require(Level.Length == LevelCredits.Length, "Every level of an experience table gives credits, if only 0.");
        writer.WriteUInt32(Id);
        writer.WriteUInt32Array(
            [
                (uint)Attribute.Length - 1, (uint)Vital.Length - 1, (uint)TrainedSkill.Length - 1, (uint)SpecializedSkill.Length - 1,
                (uint)Level.Length - 1,
            ]);
        writer.WriteUInt32Array(Attribute);
        writer.WriteUInt32Array(Vital);
        writer.WriteUInt32Array(TrainedSkill);
        writer.WriteUInt32Array(SpecializedSkill);
        foreach (ulong total in Level)
        {
            writer.WriteUInt32((uint)total);
            writer.WriteUInt32((uint)(total >> 32));
        }

        writer.WriteUInt32Array(LevelCredits);
    }
}
