using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>The numbers of a character that its movement looks at, from what a server told of it: skills are as they are used.</summary>
/// <remarks>Retail: CACQualities; specification 01, 4.1 ("Skill used") and 08, 7.2 and 7.3.</remarks>
internal static class CharacterNumbers
{
    private const uint StrengthId = 1, QuicknessId = 3, CoordinationId = 4;
    private const uint JackOfAllTradesId = 326, SpecializationId = 344, AllSkillsId = 365;
    private const uint Specialized = 3;
    private const uint OfAttribute = 0x1, OfSkill = 0x10, Factor = 0x4000, Summand = 0x8000;
    private const int JackOfAllTradesBonus = 5, SpecializationBonus = 2;

    /// <summary>The numbers now.</summary>
    /// <param name="sheet">What was told.</param>
    /// <param name="attributesRaiseSkills">
    /// Attributes are part of skills: quickness of run, half of strength and coordination of jump.
    /// </param>
    public static CharacterStats Of(CharacterSheet sheet, bool attributesRaiseSkills)
    {
        long strength = Attribute(sheet, StrengthId);
        return new CharacterStats(
            Level(sheet, CharacterSheet.RunSkill, attributesRaiseSkills ? Attribute(sheet, QuicknessId) : 0),
            Level(sheet, CharacterSheet.JumpSkill, attributesRaiseSkills ? (strength + Attribute(sheet, CoordinationId) + 1) / 2 : 0),
            Bounded(sheet.Stamina.Current), Bounded(strength), sheet.CarryAugmentations, sheet.Burden);
    }

    private static int Level(CharacterSheet sheet, uint id, long fromAttributes)
    {
        SkillRecord skill = sheet.Skill(id);
        long level = skill.Initial + (long)skill.Ranks + fromAttributes + Math.Max(sheet.Int(AllSkillsId), 0);
        level = Enchant(sheet, OfSkill, id, level, sheet.Vitae?.StatModValue ?? 1);
        if (sheet.Int(JackOfAllTradesId) > 0) level += JackOfAllTradesBonus;
        int specialization = sheet.Int(SpecializationId);
        if (specialization > 0 && skill.Advancement == Specialized) level += (long)SpecializationBonus * specialization;
        return Bounded(level);
    }

    private static long Attribute(CharacterSheet sheet, uint id) => Enchant(sheet, OfAttribute, id, sheet.Attribute(id), 1);

    /// <summary>Factors first, then summands; at least 0. What is not a number is no enchantment.</summary>
    private static long Enchant(CharacterSheet sheet, uint kind, uint key, long value, double factor)
    {
        double summand = 0;
        foreach (Enchantment spell in sheet.Enchantments)
        {
            if ((spell.StatModType & kind) == 0 || spell.StatModKey != key || !float.IsFinite(spell.StatModValue)) continue;
            if ((spell.StatModType & Factor) != 0) factor *= spell.StatModValue;
            if ((spell.StatModType & Summand) != 0) summand += spell.StatModValue;
        }

        double enchanted = (value * factor) + summand;
        return double.IsFinite(enchanted) ? (long)Math.Clamp(Math.Round(enchanted, MidpointRounding.AwayFromZero), 0, int.MaxValue) : value;
    }

    private static int Bounded(long value) => (int)Math.Clamp(value, 0, int.MaxValue);
}
