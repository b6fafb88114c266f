using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>What numbers a character has: vitals, skills, and what ranks and levels cost (spec 07, 7.17).</summary>
/// <remarks>A server computes run and jump skill from these; without them every character runs as if it had no skill.</remarks>
internal static class CharacterTables
{
    private const uint Strength = 1, Endurance = 2, Quickness = 3, Coordination = 4, Focus = 5, Self = 6;
    private const uint Combat = 1, Other = 2, Magic = 3;
    private const ushort Buckets = 32;

    // Ranks and levels of the game; what they cost is the demo world's own and grows with the cube.
    private const int AttributeRanks = 190, VitalRanks = 196, TrainedRanks = 208, SpecializedRanks = 226, Levels = 275;

    // Number, name, credits to train and to specialise, kind, least training for use (1 none, 2 trained), divisor, attributes.
    private static readonly SkillBase[] Skills =
    [
        Skill(6, "Melee Defense", 10, 20, Combat, 1, 3, Quickness, Coordination),
        Skill(7, "Missile Defense", 6, 10, Combat, 1, 5, Quickness, Coordination),
        Skill(14, "Arcane Lore", 2, 4, Other, 1, 3, Focus),
        Skill(15, "Magic Defense", 0, 12, Magic, 1, 7, Focus, Self),
        Skill(16, "Mana Conversion", 6, 12, Magic, 2, 6, Focus, Self),
        Skill(18, "Item Tinkering", 2, 4, Other, 2, 2, Focus, Coordination),
        Skill(19, "Assess Person", 2, 4, Other, 2, 1),
        Skill(20, "Deception", 4, 6, Other, 2, 1),
        Skill(21, "Healing", 6, 10, Other, 2, 3, Focus, Coordination),
        Skill(22, "Jump", 0, 4, Other, 1, 2, Strength, Coordination),
        Skill(23, "Lockpick", 6, 10, Other, 2, 3, Focus, Coordination),
        Skill(24, "Run", 0, 4, Other, 1, 1, Quickness),
        Skill(27, "Assess Creature", 2, 4, Other, 2, 1),
        Skill(28, "Weapon Tinkering", 4, 8, Other, 2, 2, Focus, Strength),
        Skill(29, "Armor Tinkering", 4, 8, Other, 2, 2, Focus, Endurance),
        Skill(30, "Magic Item Tinkering", 4, 8, Other, 2, 1, Focus),
        Skill(31, "Creature Enchantment", 8, 16, Magic, 2, 4, Focus, Self),
        Skill(32, "Item Enchantment", 8, 16, Magic, 2, 4, Focus, Self),
        Skill(33, "Life Magic", 12, 20, Magic, 2, 4, Focus, Self),
        Skill(34, "War Magic", 16, 28, Magic, 2, 4, Focus, Self),
        Skill(35, "Leadership", 4, 6, Other, 2, 1),
        Skill(36, "Loyalty", 0, 2, Other, 2, 1),
        Skill(37, "Fletching", 4, 8, Other, 2, 3, Focus, Coordination),
        Skill(38, "Alchemy", 6, 12, Other, 2, 3, Focus, Coordination),
        Skill(39, "Cooking", 4, 8, Other, 2, 3, Focus, Coordination),
        Skill(40, "Salvaging", 0, 9999, Other, 2, 1),
        Skill(41, "Two Handed Combat", 8, 16, Combat, 1, 3, Strength, Coordination),
        Skill(43, "Void Magic", 16, 28, Magic, 2, 4, Focus, Self),
        Skill(44, "Heavy Weapons", 6, 12, Combat, 1, 3, Strength, Coordination),
        Skill(45, "Light Weapons", 4, 8, Combat, 1, 3, Strength, Coordination),
        Skill(46, "Finesse Weapons", 4, 8, Combat, 1, 3, Quickness, Coordination),
        Skill(47, "Missile Weapons", 6, 12, Combat, 1, 2, Coordination),
        Skill(48, "Shield", 2, 4, Combat, 2, 2, Strength, Coordination),
        Skill(49, "Dual Wield", 2, 4, Combat, 2, 3, Coordination, Coordination),
        Skill(50, "Recklessness", 4, 6, Combat, 2, 3, Strength, Quickness),
        Skill(51, "Sneak Attack", 4, 6, Combat, 2, 3, Quickness, Coordination),
        Skill(52, "Dirty Fighting", 2, 4, Combat, 2, 3, Strength, Coordination),
        Skill(54, "Summoning", 8, 12, Magic, 2, 3, Endurance, Self),
    ];

    /// <summary>The three tables.</summary>
    public static IEnumerable<DatRecord> All() =>
    [
        new VitalTable
        {
            Id = 0x0E000003,
            Health = new(0, 1, 0, 2, Endurance, 0),
            Stamina = new(0, 1, 0, 1, Endurance, 0),
            Mana = new(0, 1, 0, 1, Self, 0),
        },
        new SkillTable
        {
            Id = 0x0E000004,
            Buckets = Buckets,
            Skills = [.. Skills.OrderBy(skill => skill.Skill % Buckets).ThenBy(skill => skill.Skill)],
        },
        new ExperienceTable
        {
            Id = 0x0E000018,
            Attribute = [.. Costs(AttributeRanks, 200)],
            Vital = [.. Costs(VitalRanks, 200)],
            TrainedSkill = [.. Costs(TrainedRanks, 100)],
            SpecializedSkill = [.. Costs(SpecializedRanks, 60)],
            Level = [.. Enumerable.Range(0, Levels + 1).Select(level => level < 2 ? 0ul : 500ul * Cube(level - 1))],
            LevelCredits = [.. Enumerable.Range(0, Levels + 1).Select(level => level > 0 && level % 5 == 0 ? 1u : 0u)],
        },
    ];

    private static SkillBase Skill(
        uint number, string name, int trained, int specialized, uint kind, uint leastTraining, uint divisor, uint first = 0,
        uint second = 0)
        => new()
        {
            Skill = number,
            Name = name,
            Description = string.Empty,
            TrainedCost = trained,
            SpecializedCost = specialized,
            Category = kind,
            CharacterCreationUse = 1,
            MinLevel = leastTraining,
            Formula = new(0, first == 0 ? 0u : 1, second == 0 ? 0u : 1, divisor, first, second),
            UpperBound = 100,
            LearnModifier = 1,
        };

    private static IEnumerable<uint> Costs(int ranks, uint first)
        => Enumerable.Range(0, ranks + 1).Select(rank => (uint)(first * Cube(rank)));

    private static ulong Cube(int value) => (ulong)value * (ulong)value * (ulong)value;
}
