using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client.Tests;

/// <summary>From what a server tells of a character to what its movement asks.</summary>
public class CharacterNumbersTests
{
    private const uint Run = 24, Jump = 22, Trained = 2, Specialized = 3, Strength = 1, Quickness = 3;
    private const uint Burden = 5, PlayerKiller = 134, Carrying = 230, JackOfAllTrades = 326, Specialization = 344, AllSkills = 365;
    private const uint AttributeFactor = 0x4001, AttributeSummand = 0x8001, SkillFactor = 0x4010, SkillSummand = 0x8010;

    private static SkillRecord Skill(ushort ranks, uint initial, uint advancement = Trained) =>
        new(ranks, 1, advancement, 0, initial, 0, 0);

    private static CharacterSheet Sheet(EnchantmentRegistry? enchantments = null)
    {
        CharacterSheet sheet = new();
        Tell(sheet, new PlayerDescription
        {
            Ints = [new(Burden, 4000), new(PlayerKiller, 2), new(Carrying, 3)],
            Attributes = new CharacterAttributes(
                new AttributeRecord(10, 80, 0), new AttributeRecord(0, 30, 0), new AttributeRecord(25, 50, 0),
                new AttributeRecord(1, 60, 0), null, null),
            Vitals = new CharacterVitals(null, new VitalRecord(5, 10, 0, 90), null),
            Skills = [new(Jump, Skill(20, 5)), new(Run, Skill(200, 10, Specialized)), new(6, Skill(1, 1))],
            Enchantments = enchantments,
        });
        return sheet;
    }

    private static void Tell<T>(CharacterSheet sheet, in T message)
        where T : IMessage<T>
    {
        byte[] bytes = new byte[2048];
        Assert.True(WireMessage.TryWrite(message, bytes, out int length, stamp: 1, guid: KeyFixture.Id));
        Assert.True(WireMessage.TryParse(bytes.AsSpan(0, length), out WireMessage parsed));
        sheet.Apply(parsed);
    }

    private static CharacterStats Stats(CharacterSheet sheet, bool attributes = false) => CharacterNumbers.Of(sheet, attributes);

    private static void Cast(CharacterSheet sheet, ushort spell, uint type, uint key, float value) =>
        Tell(sheet, new UpdateEnchantment(new Enchantment(spell, 1, 9, 1, 0, 60, 7, 0, 0, 0, type, key, value, 0, 0)));

    [Fact]
    [Behaviour("client.sheet.description", "spec/08, 7.2 and 7.3; spec/01, 4.1")]
    public void A_description_tells_all_numbers()
    {
        CharacterSheet sheet = Sheet();
        Assert.Equal(new CharacterStats(210, 25, Stamina: 90, Strength: 90, Augmentations: 3, Burden: 4000), Stats(sheet));
        Assert.Equal(2, sheet.PlayerKillerStatus);
    }

    [Fact]
    [Behaviour("client.sheet.attributes-raise-skills", "spec/08, 7.2")]
    public void Quickness_is_part_of_run_and_half_of_strength_and_coordination_of_jump_rounded()
    {
        // Run: 210 + 75. Jump: 25 + 151 / 2 = 25 + 76.
        CharacterStats stats = Stats(Sheet(), attributes: true);
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
        Tell(sheet, new PrivateUpdatePropertyInt(0, property, value));
        Assert.Equal((run, jump), (Stats(sheet).RunSkill, Stats(sheet).JumpSkill));
    }

    [Fact]
    [Behaviour("client.sheet.enchantments", "spec/08, 7.2 and 7.3; spec/01, 4.1 (skill used)")]
    public void Spells_on_skills_and_on_the_attributes_below_them_count_factors_first_until_they_end()
    {
        CharacterSheet sheet = Sheet();
        Cast(sheet, 1, AttributeSummand, Quickness, 25);
        Cast(sheet, 2, SkillFactor, Run, 1.5f);
        Cast(sheet, 3, SkillSummand, Run, 11);
        Cast(sheet, 4, AttributeFactor, Strength, 2);

        // Run: (210 + 75 + 25) x 1.5 + 11. Jump: 25 + (180 + 61 + 1) / 2. Load looks at the strength enchanted.
        Assert.Equal((476, 146, 180), (Stats(sheet, true).RunSkill, Stats(sheet, true).JumpSkill, Stats(sheet, true).Strength));
        Tell(sheet, new RemoveEnchantment(2, 1));
        Assert.Equal(321, Stats(sheet, true).RunSkill);
        Cast(sheet, 5, SkillSummand, Run, -5000);
        Assert.Equal(0, Stats(sheet, true).RunSkill);
    }

    [Fact]
    [Behaviour("client.sheet.vitae", "spec/08, 7.2 and 7.3")]
    public void A_death_costs_a_share_of_every_skill_and_augmentations_are_not_part_of_it()
    {
        CharacterSheet sheet = Sheet(new EnchantmentRegistry(
            Mask: 4, default, default, default, new Enchantment(666, 1, 0, 0, 0, -1, 0, 0, 0, 0, SkillFactor, 0, 0.93f, 0, 0)));
        Tell(sheet, new PrivateUpdatePropertyInt(0, JackOfAllTrades, 1));

        // 210 x 0.93 = 195.3 and 25 x 0.93 = 23.25, rounded; then 5.
        Assert.Equal((200, 28), (Stats(sheet).RunSkill, Stats(sheet).JumpSkill));
    }

    [Fact]
    [Behaviour("client.sheet.no-stamina-no-skill", "spec/01, 4.1 (skill used) and 6")]
    public void Without_stamina_every_skill_counts_as_none()
    {
        CharacterSheet sheet = Sheet();
        Tell(sheet, new PrivateUpdateAttribute2ndLevel(0, 4, 0));
        Assert.Equal(1f, Stats(sheet).RunRate());
        Tell(sheet, new PrivateUpdateVital(0, 3, new VitalRecord(0, 100, 0, 7)));
        Assert.Equal(7, Stats(sheet).Stamina);
        Assert.True(Stats(sheet).RunRate() > 2);
    }

    [Fact]
    [Behaviour("client.sheet.what-is-not-told-stays", "spec/08, 7.1")]
    public void What_is_not_told_stays_as_it_was()
    {
        CharacterSheet sheet = Sheet();
        Tell(sheet, new PrivateUpdatePropertyInt(0, Burden, 1));
        Tell(sheet, new PrivateUpdateAttribute(0, 2, new AttributeRecord(999, 0, 0)));
        Tell(sheet, new PrivateUpdateAttribute2ndLevel(0, 2, 999));
        Tell(sheet, new PrivateUpdateSkill(0, 6, Skill(999, 0)));
        Tell(sheet, new PrivateUpdatePropertyInt(0, 25, 999));
        Assert.Equal(new CharacterStats(210, 25, Stamina: 90, Strength: 90, Augmentations: 3, Burden: 1), Stats(sheet));
    }

    [Fact]
    [Behaviour("client.sheet.hostile-numbers", "design, decision 7")]
    public void The_greatest_numbers_of_the_wire_stay_numbers()
    {
        CharacterSheet sheet = Sheet();
        Tell(sheet, new PrivateUpdateAttribute(0, Strength, new AttributeRecord(uint.MaxValue, uint.MaxValue, 0)));
        Tell(sheet, new PrivateUpdateAttribute(0, Quickness, new AttributeRecord(uint.MaxValue, uint.MaxValue, 0)));
        Tell(sheet, new PrivateUpdateSkill(0, Run, Skill(ushort.MaxValue, uint.MaxValue, Specialized)));
        Tell(sheet, new PrivateUpdateSkill(0, Jump, Skill(ushort.MaxValue, uint.MaxValue)));
        Tell(sheet, new PrivateUpdateAttribute2ndLevel(0, 4, uint.MaxValue));
        Tell(sheet, new PrivateUpdatePropertyInt(0, AllSkills, int.MaxValue));
        Tell(sheet, new PrivateUpdatePropertyInt(0, Specialization, int.MaxValue));
        Cast(sheet, 1, SkillFactor, Run, float.NaN);
        Cast(sheet, 2, SkillFactor, Run, float.MaxValue);
        CharacterStats stats = Stats(sheet, attributes: true);
        Assert.Equal((int.MaxValue, int.MaxValue, int.MaxValue, int.MaxValue),
            (stats.RunSkill, stats.JumpSkill, stats.Stamina, stats.Strength));
        Assert.Equal(4.5f, stats.RunRate());
    }
}
