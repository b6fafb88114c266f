using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

public class CharacterSheetTests
{
    private const uint Run = 24, Jump = 22, Trained = 2, Specialized = 3;
    private const uint Burden = 5, PlayerKiller = 134, Carrying = 230, JackOfAllTrades = 326, Specialization = 344, AllSkills = 365;

    private static SkillRecord Skill(ushort ranks, uint initial, uint advancement = Trained) =>
        new(ranks, 1, advancement, 0, initial, 0, 0);

    private static CharacterSheet Sheet(bool attributes = false)
    {
        CharacterSheet sheet = new(attributes);
        sheet.Take(new PlayerDescription
        {
            Ints = [new(Burden, 4000), new(PlayerKiller, 2), new(Carrying, 3)],
            Attributes = new CharacterAttributes(
                new AttributeRecord(10, 80, 0), new AttributeRecord(0, 30, 0), new AttributeRecord(25, 50, 0),
                new AttributeRecord(1, 60, 0), null, null),
            Vitals = new CharacterVitals(null, new VitalRecord(5, 10, 0, 90), null),
            Skills = [new(Jump, Skill(20, 5)), new(Run, Skill(200, 10, Specialized)), new(6, Skill(1, 1))],
        });
        return sheet;
    }

    [Fact]
    [Behaviour("client.sheet.description", "spec/08, 7.2 and 7.3; spec/01, 4.1")]
    public void A_description_tells_all_numbers()
    {
        CharacterSheet sheet = Sheet();
        Assert.Equal(new CharacterStats(210, 25, Stamina: 90, Strength: 90, Augmentations: 3, Burden: 4000), sheet.Stats);
        Assert.Equal(2, sheet.PlayerKillerStatus);
    }

    [Fact]
    [Behaviour("client.sheet.attributes-raise-skills", "spec/08, 7.2")]
    public void Quickness_is_part_of_run_and_half_of_strength_and_coordination_of_jump_rounded()
    {
        // Run: 210 + 75. Jump: 25 + 151 / 2 = 25 + 76.
        CharacterStats stats = Sheet(attributes: true).Stats;
        Assert.Equal((285, 101), (stats.RunSkill, stats.JumpSkill));
    }

    [Theory]
    [Behaviour("client.sheet.augmentations", "spec/01, 4.1 (skill used)")]
    [InlineData(AllSkills, 4, 214, 29)]
    [InlineData(AllSkills, -4, 210, 25)]
    [InlineData(JackOfAllTrades, 1, 215, 30)]
    [InlineData(JackOfAllTrades, 2, 215, 30)]
    [InlineData(JackOfAllTrades, 0, 210, 25)]
    [InlineData(Specialization, 5, 220, 25)]
    [InlineData(Specialization, -5, 210, 25)]
    public void Augmentations_raise_skills(uint property, int value, int run, int jump)
    {
        CharacterSheet sheet = Sheet();
        sheet.TakeProperty(property, value);
        Assert.Equal((run, jump), (sheet.Stats.RunSkill, sheet.Stats.JumpSkill));
    }

    [Fact]
    [Behaviour("client.sheet.no-stamina-no-skill", "spec/01, 4.1 (skill used) and 6")]
    public void Without_stamina_every_skill_counts_as_none()
    {
        CharacterSheet sheet = Sheet();
        sheet.TakeVital(4, 0);
        Assert.Equal(1f, sheet.Stats.RunRate());
        sheet.TakeVital(3, 7);
        Assert.Equal(7, sheet.Stats.Stamina);
        Assert.True(sheet.Stats.RunRate() > 2);
    }

    [Fact]
    [Behaviour("client.sheet.what-is-not-told-stays", "spec/08, 7.1")]
    public void What_is_not_told_stays_as_it_was()
    {
        CharacterSheet sheet = Sheet();
        sheet.Take(new PlayerDescription { Ints = [new(Burden, 1)] });
        sheet.TakeAttribute(2, new AttributeRecord(999, 0, 0));
        sheet.TakeVital(2, 999);
        sheet.TakeSkill(6, Skill(999, 0));
        sheet.TakeProperty(25, 999);
        Assert.Equal(new CharacterStats(210, 25, Stamina: 90, Strength: 90, Augmentations: 3, Burden: 1), sheet.Stats);
    }

    [Fact]
    [Behaviour("client.sheet.hostile-numbers", "design, decision 7")]
    public void The_greatest_numbers_of_the_wire_stay_numbers()
    {
        CharacterSheet sheet = Sheet(attributes: true);
        sheet.TakeAttribute(1, new AttributeRecord(uint.MaxValue, uint.MaxValue, 0));
        sheet.TakeAttribute(3, new AttributeRecord(uint.MaxValue, uint.MaxValue, 0));
        sheet.TakeSkill(Run, Skill(ushort.MaxValue, uint.MaxValue, Specialized));
        sheet.TakeVital(4, uint.MaxValue);
        sheet.TakeProperty(AllSkills, int.MaxValue);
        sheet.TakeProperty(Specialization, int.MaxValue);
        Assert.Equal((int.MaxValue, int.MaxValue, int.MaxValue, int.MaxValue),
            (sheet.Stats.RunSkill, sheet.Stats.JumpSkill, sheet.Stats.Stamina, sheet.Stats.Strength));
        Assert.Equal(4.5f, sheet.Stats.RunRate());
    }
}
