using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>The numbers of the player's character that its movement looks at, as a server told them. What was not told is 0.</summary>
/// <remarks>Retail: CACQualities; specification 01, 4.1 ("Skill used") and 08, section 7. Spells at work are not looked at.</remarks>
public sealed class CharacterSheet
{
    private const uint JumpId = 22, RunId = 24;
    private const uint StrengthId = 1, QuicknessId = 3, CoordinationId = 4;
    private const uint MaxStamina = 3, CurrentStamina = 4;
    private const uint BurdenId = 5, PlayerKillerId = 134, CarryingId = 230, JackOfAllTradesId = 326, SpecializationId = 344,
        AllSkillsId = 365;
    private const uint Specialized = 3;
    private const int JackOfAllTradesBonus = 5, SpecializationBonus = 2;

    private readonly bool attributesRaiseSkills;
    private SkillRecord run, jump;
    private AttributeRecord strength, quickness, coordination;
    private uint stamina;
    private int burden, carrying, jackOfAllTrades, specialization, allSkills;

    /// <param name="attributesRaiseSkills">Attributes are part of skills: quickness of run, half of strength and coordination of
    /// jump.</param>
    internal CharacterSheet(bool attributesRaiseSkills) => this.attributesRaiseSkills = attributesRaiseSkills;

    /// <summary>The numbers, skills as they are used.</summary>
    public CharacterStats Stats => new(
        Level(run, ValueOf(quickness)), Level(jump, (ValueOf(strength) + ValueOf(coordination) + 1) / 2),
        (int)Math.Min(stamina, int.MaxValue), (int)Math.Min(ValueOf(strength), int.MaxValue), carrying, burden);

    /// <summary>2 no player killer, 4 player killer, 0x20 free, 0x40 player killer lite.</summary>
    public int PlayerKillerStatus { get; private set; }

    /// <summary>Takes in all of the character. What it does not tell stays.</summary>
    internal void Take(PlayerDescription all)
    {
        foreach (Property<int> property in all.Ints ?? default) TakeProperty(property.Id, property.Value);
        foreach (Property<SkillRecord> skill in all.Skills ?? default) TakeSkill(skill.Id, skill.Value);
        strength = all.Attributes?.Strength ?? strength;
        quickness = all.Attributes?.Quickness ?? quickness;
        coordination = all.Attributes?.Coordination ?? coordination;
        stamina = all.Vitals?.Stamina?.Current ?? stamina;
    }

    /// <summary>Takes in a skill.</summary>
    internal void TakeSkill(uint id, in SkillRecord record)
    {
        if (id == RunId) run = record;
        else if (id == JumpId) jump = record;
    }

    /// <summary>Takes in an attribute.</summary>
    internal void TakeAttribute(uint id, in AttributeRecord record)
    {
        if (id == StrengthId) strength = record;
        else if (id == QuicknessId) quickness = record;
        else if (id == CoordinationId) coordination = record;
    }

    /// <summary>Takes in a vital as it is now.</summary>
    internal void TakeVital(uint id, uint current)
    {
        if (id is MaxStamina or CurrentStamina) stamina = current;
    }

    /// <summary>Takes in a number.</summary>
    internal void TakeProperty(uint id, int value)
    {
        switch (id)
        {
            case BurdenId: burden = value; break;
            case PlayerKillerId: PlayerKillerStatus = value; break;
            case CarryingId: carrying = value; break;
            case JackOfAllTradesId: jackOfAllTrades = value; break;
            case SpecializationId: specialization = value; break;
            case AllSkillsId: allSkills = value; break;
        }
    }

    private int Level(in SkillRecord skill, long fromAttributes)
    {
        long level = skill.Initial + (long)skill.Ranks;
        if (attributesRaiseSkills) level += fromAttributes;
        if (allSkills > 0) level += allSkills;
        if (jackOfAllTrades > 0) level += JackOfAllTradesBonus;
        if (specialization > 0 && skill.Advancement == Specialized) level += (long)SpecializationBonus * specialization;
        return (int)Math.Min(level, int.MaxValue);
    }

    private static long ValueOf(in AttributeRecord attribute) => (long)attribute.Ranks + attribute.Start;
}
