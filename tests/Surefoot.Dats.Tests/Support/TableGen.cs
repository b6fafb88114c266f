using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Generates the tables of a character's numbers.</summary>
internal static class TableGen
{
    private static readonly Gen<AttributeFormula> Formula = Gen.Select(
        Gen.UInt, Gen.UInt, Gen.UInt, Gen.UInt, Gen.UInt, Gen.UInt,
        (w, x, y, z, first, second) => new AttributeFormula(w, x, y, z, first, second));

    private static readonly Gen<SkillBase> Skill = Gen.Select(
        Gen.Select(Gen.UInt, RecordGen.Texts, RecordGen.Texts, Gen.UInt),
        Gen.Select(Gen.Int, Gen.Int, Gen.UInt, Gen.UInt, Gen.UInt),
        Gen.Select(Formula, RecordGen.Doubles.Where(double.IsFinite), RecordGen.Doubles.Where(double.IsFinite)),
        (names, costs, rest) => new SkillBase
        {
            Skill = names.Item1,
            Description = names.Item2,
            Name = names.Item3,
            IconId = names.Item4,
            TrainedCost = costs.Item1,
            SpecializedCost = costs.Item2,
            Category = costs.Item3,
            CharacterCreationUse = costs.Item4,
            MinLevel = costs.Item5,
            Formula = rest.Item1,
            UpperBound = rest.Item2,
            LowerBound = rest.Item3,
            LearnModifier = 1,
        });

    public static Gen<VitalTable> Vitals() => Gen.Select(
        Formula, Formula, Formula,
        (health, stamina, mana) => new VitalTable { Id = 0x0E000003, Health = health, Stamina = stamina, Mana = mana });

    public static Gen<SkillTable> Skills() => Gen.Select(
        Gen.UShort, Skill.List(), (buckets, skills) => new SkillTable { Id = 0x0E000004, Buckets = buckets, Skills = skills });

    public static Gen<ExperienceTable> Experience() => Gen.Select(
        Gen.UInt.List(1), Gen.UInt.List(1), Gen.UInt.List(1), Gen.UInt.List(1),
        Gen.Select(Gen.ULong, Gen.UInt, (total, credits) => (total, credits)).List(1),
        (attribute, vital, trained, specialized, levels) => new ExperienceTable
        {
            Id = 0x0E000018,
            Attribute = attribute,
            Vital = vital,
            TrainedSkill = trained,
            SpecializedSkill = specialized,
            Level = [.. levels.Select(level => level.total)],
            LevelCredits = [.. levels.Select(level => level.credits)],
        });
}
