using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>One skill of the <see cref="SkillTable"/> (spec 07, 7.17).</summary>
public readonly record struct SkillBase
{
    internal const int Size = 72;

    /// <summary>Its number: 22 is Jump, 24 Run.</summary>
    public uint Skill { get; init; }

    /// <summary>A sentence for the player.</summary>
    public string Description { get; init; }

    /// <summary>Its name.</summary>
    public string Name { get; init; }

    /// <summary>Icon; 0 for none.</summary>
    public uint IconId { get; init; }

    /// <summary>Credits to train it.</summary>
    public int TrainedCost { get; init; }

    /// <summary>Credits to train and specialise it.</summary>
    public int SpecializedCost { get; init; }

    /// <summary>Kind of skill: 1 combat, 2 other, 3 magic.</summary>
    public uint Category { get; init; }

    /// <summary>Non-zero: offered when a character is made.</summary>
    public uint CharacterCreationUse { get; init; }

    /// <summary>Least training for use: 1 untrained, 2 trained, 3 specialised.</summary>
    public uint MinLevel { get; init; }

    /// <summary>What attributes give.</summary>
    public AttributeFormula Formula { get; init; }

    /// <summary>Greatest value.</summary>
    public double UpperBound { get; init; }

    /// <summary>Least value.</summary>
    public double LowerBound { get; init; }

    /// <summary>Scales what use teaches.</summary>
    public double LearnModifier { get; init; }

    internal static SkillBase Read(ref DatReader reader) => new()
    {
        Skill = reader.ReadUInt32(),
        Description = reader.ReadPString(),
        Name = reader.ReadPString(),
        IconId = reader.ReadUInt32(),
        TrainedCost = reader.ReadInt32(),
        SpecializedCost = reader.ReadInt32(),
        Category = reader.ReadUInt32(),
        CharacterCreationUse = reader.ReadUInt32(),
        MinLevel = reader.ReadUInt32(),
        Formula = AttributeFormula.Read(ref reader),
        UpperBound = reader.ReadDouble(),
        LowerBound = reader.ReadDouble(),
        LearnModifier = reader.ReadDouble(),
    };

    internal static void Write(DatWriter writer, SkillBase skill)
    {
        writer.WriteUInt32(skill.Skill);
        writer.WritePString(skill.Description);
        writer.WritePString(skill.Name);
        writer.WriteUInt32(skill.IconId);
        writer.WriteInt32(skill.TrainedCost);
        writer.WriteInt32(skill.SpecializedCost);
        writer.WriteUInt32(skill.Category);
        writer.WriteUInt32(skill.CharacterCreationUse);
        writer.WriteUInt32(skill.MinLevel);
        skill.Formula.Write(writer);
        writer.WriteDouble(skill.UpperBound);
        writer.WriteDouble(skill.LowerBound);
        writer.WriteDouble(skill.LearnModifier);
    }
}

/// <summary>0x0E000004: the skills, what they cost and how attributes make them (spec 07, 7.17).</summary>
public sealed class SkillTable : DatRecord, IDatRecord<SkillTable>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.SkillTable;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Buckets of the hash table; the order of the skills follows from it: by number modulo buckets.</summary>
    public ushort Buckets { get; init; } = 32;

    /// <summary>The skills in the order of the file.</summary>
    public ImmutableArray<SkillBase> Skills { get; init; } = [];

    /// <inheritdoc/>
    public static SkillTable Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        int count = reader.ReadUInt16();
        return new() { Id = id, Buckets = reader.ReadUInt16(), Skills = reader.ReadArray(count, SkillBase.Size, SkillBase.Read) };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        DatWriter.Require(Skills.Length <= ushort.MaxValue, "A skill table holds at most 65,535 skills.");
        writer.WriteUInt32(Id);
        writer.WriteUInt16((ushort)Skills.Length);
        writer.WriteUInt16(Buckets);
        writer.WriteArray(Skills, SkillBase.Write);
    }
}
