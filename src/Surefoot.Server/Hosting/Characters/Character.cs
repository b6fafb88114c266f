using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>The six attributes of a character, 10 to 100 each.</summary>
internal readonly record struct CharacterAttributeValues(
    uint Strength, uint Endurance, uint Quickness, uint Coordination, uint Focus, uint Self)
{
    private const uint Least = 10, Most = 100, MostTogether = 330;

    /// <summary>A new character may have them.</summary>
    public bool IsAllowed =>
        IsOne(Strength) && IsOne(Endurance) && IsOne(Quickness) && IsOne(Coordination) && IsOne(Focus) && IsOne(Self) &&
        Strength + Endurance + Quickness + Coordination + Focus + Self <= MostTogether;

    private static bool IsOne(uint value) => value is >= Least and <= Most;
}

/// <summary>A character: what of it stays when nobody plays it.</summary>
internal sealed class Character
{
    private const int TrainedPoints = 5, SpecializedPoints = 10;
    private const uint Specialized = 3;

    public required uint Guid { get; init; }

    public required string Name { get; init; }

    /// <summary>The account, in lower case.</summary>
    public required string Account { get; init; }

    public required CharacterAttributeValues Attributes { get; init; }

    /// <summary>Points of running and jumping beside those that come from attributes.</summary>
    public required int RunPoints { get; init; }

    public required int JumpPoints { get; init; }

    /// <summary>Where it is, or was last.</summary>
    public required Position Place { get; set; }

    /// <summary>How often it has entered the world: which life of its object it is.</summary>
    public ushort Logins { get; set; }

    /// <summary>It is in the world, or on its way out.</summary>
    public bool IsOnline { get; set; }

    /// <summary>Points of running and of jumping that come from attributes, and the greatest stamina.</summary>
    /// <remarks>Specification 08, 7.2.</remarks>
    public int RunFormula => (int)Attributes.Quickness;

    public int JumpFormula => (int)((Attributes.Strength + Attributes.Coordination + 1) / 2);

    public int Stamina => (int)Attributes.Endurance;

    /// <summary>The numbers of its movement.</summary>
    public CharacterStats Stats =>
        new(RunFormula + RunPoints, JumpFormula + JumpPoints, Stamina, (int)Attributes.Strength);

    /// <summary>Points that come with a training.</summary>
    public static int PointsOf(uint training) => training == Specialized ? SpecializedPoints : TrainedPoints;

    /// <summary>All of it, for its own client.</summary>
    /// <remarks>Specification 08, 8.6: the smallest useful description.</remarks>
    public PlayerDescription Describe(bool administrator)
    {
        const uint burden = 5, level = 25, killerStatus = 134, name = 1, jump = 22, run = 24, trained = 2, character = 10, warden = 11;
        const int noKiller = 2;
        CharacterAttributeValues own = Attributes;
        return new PlayerDescription
        {
            WeenieType = administrator ? warden : character,
            Ints = [new Property<int>(burden, 0), new Property<int>(level, 1), new Property<int>(killerStatus, noKiller)],
            Strings = [new Property<string>(name, Name)],
            Attributes = new CharacterAttributes(
                Of(own.Strength), Of(own.Endurance), Of(own.Quickness), Of(own.Coordination), Of(own.Focus), Of(own.Self)),
            Vitals = new CharacterVitals(
                Vital((own.Endurance + 1) / 2), Vital(own.Endurance), Vital(own.Self)),
            Skills = [new Property<SkillRecord>(jump, Skill(JumpPoints)), new Property<SkillRecord>(run, Skill(RunPoints))],
            Belongings = new CharacterBelongings(0, [default, default, default, default, default, default, default, default], 0, 0, [], []),
        };

        static AttributeRecord Of(uint value) => new(0, value, 0);
        static VitalRecord Vital(uint most) => new(0, 0, 0, most);
        static SkillRecord Skill(int points) => new(0, 1, trained, 0, (uint)points, 0, 0);
    }
}
