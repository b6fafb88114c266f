using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>The tables of a character's numbers parse to the values that come with the samples.</summary>
public sealed class TableSampleTests
{
    [Fact]
    [Behaviour("dats.sample.vital-table", "data/dat-samples/README.md; spec/07, 7.17")]
    public void Vital_table()
    {
        var table = TestData.Sample<VitalTable>("vitaltable-0E000003");

        Assert.Equal(new AttributeFormula(0, 1, 0, 2, 2, 0), table.Health);
        Assert.Equal(new AttributeFormula(0, 1, 0, 1, 2, 0), table.Stamina);
        Assert.Equal(new AttributeFormula(0, 1, 0, 1, 6, 0), table.Mana);
        Assert.Equal(TestData.SampleBytes("vitaltable-0E000003"), table.Encode());
    }

    [Fact]
    [Behaviour("dats.sample.skill-table", "data/dat-samples/README.md; spec/07, 7.17")]
    public void Skill_table()
    {
        var table = TestData.Sample<SkillTable>("skilltable-0E000004");

        Assert.Equal(32, table.Buckets);
        Assert.Equal([(22u, "Jump"), (24u, "Run")], table.Skills.Select(skill => (skill.Skill, skill.Name)));
        Assert.Equal([new(0, 1, 1, 2, 1, 4), new AttributeFormula(0, 1, 0, 1, 3, 0)], table.Skills.Select(skill => skill.Formula));
        Assert.All(table.Skills, skill =>
        {
            Assert.Equal((string.Empty, 0u), (skill.Description, skill.IconId));
            Assert.Equal((0, 4), (skill.TrainedCost, skill.SpecializedCost));
            Assert.Equal((3u, 1u, 1u), (skill.Category, skill.CharacterCreationUse, skill.MinLevel));
            Assert.Equal((100.0, 0.0, 1.0), (skill.UpperBound, skill.LowerBound, skill.LearnModifier));
        });
        Assert.Equal(TestData.SampleBytes("skilltable-0E000004"), table.Encode());
    }

    [Fact]
    [Behaviour("dats.sample.experience-table", "data/dat-samples/README.md; spec/07, 7.17")]
    public void Experience_table()
    {
        var table = TestData.Sample<ExperienceTable>("xptable-0E000018");

        Assert.All([table.Attribute, table.Vital, table.TrainedSkill, table.SpecializedSkill], costs => Assert.Equal([0u, 100u], costs));
        Assert.Equal([0ul, 0ul], table.Level);
        Assert.Equal([0u, 0u], table.LevelCredits);
        Assert.Equal(TestData.SampleBytes("xptable-0E000018"), table.Encode());
    }

    [Fact]
    [Behaviour("dats.table.contradictions", "spec/07, 7.17")]
    public void An_experience_table_without_a_level_or_with_levels_that_give_nothing_is_not_written()
    {
        Assert.Throws<InvalidOperationException>(() => new ExperienceTable { Id = 0x0E000018, Level = [], LevelCredits = [] }.Encode());
        Assert.Throws<InvalidOperationException>(() => new ExperienceTable { Id = 0x0E000018, Vital = [] }.Encode());
        Assert.Throws<InvalidOperationException>(() => new ExperienceTable { Id = 0x0E000018, Level = [0, 10] }.Encode());
    }
}
