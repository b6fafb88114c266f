using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>What a server has told of the player's character, kept current from its messages (specification 08, section 7). Updates that
/// arrive after a newer one of the same kind are dropped by their numbers. Formulas over these numbers need the portal data and are not
/// here.</summary>
/// <param name="guid">The character's object; 0 where only its description tells it.</param>
public sealed class CharacterSheet(uint guid = 0)
{
    /// <summary>Skill of jumping.</summary>
    public const uint JumpSkill = 22;

    /// <summary>Skill of running.</summary>
    public const uint RunSkill = 24;

    private const uint BurdenProperty = 5, PlayerKillerProperty = 134, CarryProperty = 230;
    private const int Vitals = 3;

    private readonly Dictionary<uint, int> ints = [];
    private readonly Dictionary<uint, AttributeRecord> attributes = [];
    private readonly Dictionary<uint, SkillRecord> skills = [];
    private readonly VitalRecord[] vitals = new VitalRecord[Vitals];
    private readonly Dictionary<(ushort Spell, ushort Layer), Enchantment> enchantments = [];
    private readonly Dictionary<(Opcode Kind, uint Property), byte> sequences = [];

    /// <summary>The character's object; 0 before it is known.</summary>
    public uint Guid { get; private set; } = guid;

    /// <summary>The whole description came: the numbers are complete.</summary>
    public bool IsDescribed { get; private set; }

    /// <summary>Total weight carried.</summary>
    public int Burden => Int(BurdenProperty);

    /// <summary>Augmentations that let it carry more.</summary>
    public int CarryAugmentations => Int(CarryProperty);

    /// <summary>2 no player killer, 4 player killer, 0x20 free, 0x40 player killer lite.</summary>
    public int PlayerKillerStatus => Int(PlayerKillerProperty);

    /// <summary>Strength without enchantments.</summary>
    public uint Strength => Attribute(1);

    /// <summary>Health.</summary>
    public VitalRecord Health => vitals[0];

    /// <summary>Stamina.</summary>
    public VitalRecord Stamina => vitals[1];

    /// <summary>Mana.</summary>
    public VitalRecord Mana => vitals[2];

    /// <summary>The spells at work.</summary>
    public IReadOnlyCollection<Enchantment> Enchantments => enchantments.Values;

    /// <summary>Loss after a death; null without one.</summary>
    public Enchantment? Vitae { get; private set; }

    /// <summary>Messages about the character that could not be read. They changed nothing.</summary>
    public long UnreadableMessages { get; private set; }

    /// <summary>A property; 0 when it was not told.</summary>
    public int Int(uint property) => ints.GetValueOrDefault(property);

    /// <summary>An attribute without enchantments: 1 strength, 2 endurance, 3 quickness, 4 coordination, 5 focus, 6 self; 0 when it was not
    /// told.</summary>
    public uint Attribute(uint attribute)
        => attributes.TryGetValue(attribute, out AttributeRecord record)
            ? (uint)Math.Min((ulong)record.Ranks + record.Start, uint.MaxValue)
            : 0;

    /// <summary>A skill; empty when it was not told.</summary>
    public SkillRecord Skill(uint skill) => skills.GetValueOrDefault(skill);

    /// <summary>Takes a message.</summary>
    /// <returns>True when it changed something.</returns>
    public bool Apply(in WireMessage message) => message.Id.Opcode switch
    {
        Opcode.GameEvent => ApplyEvent(message),
        Opcode.PrivateUpdatePropertyInt => IsReadable(message, out PrivateUpdatePropertyInt update)
            && IsNewer(message.Id.Opcode, update.Property, update.Sequence) && Set(ints, update.Property, update.Value),
        Opcode.PublicUpdatePropertyInt => IsReadable(message, out PublicUpdatePropertyInt update) && update.Guid == Guid && Guid != 0
            && IsNewer(message.Id.Opcode, update.Property, update.Sequence) && Set(ints, update.Property, update.Value),
        Opcode.PrivateUpdateSkill => IsReadable(message, out PrivateUpdateSkill update)
            && IsNewer(message.Id.Opcode, update.Skill, update.Sequence) && Set(skills, update.Skill, update.Record),
        Opcode.PrivateUpdateAttribute => IsReadable(message, out PrivateUpdateAttribute update)
            && IsNewer(message.Id.Opcode, update.Attribute, update.Sequence) && Set(attributes, update.Attribute, update.Record),
        Opcode.PrivateUpdateVital => IsReadable(message, out PrivateUpdateVital update)
            && IsNewer(message.Id.Opcode, update.Vital, update.Sequence) && SetVital(update.Vital, update.Record),
        Opcode.PrivateUpdateAttribute2ndLevel => IsReadable(message, out PrivateUpdateAttribute2ndLevel update)
            && IsNewer(message.Id.Opcode, update.Vital, update.Sequence) && SetCurrent(update.Vital, update.Current),
        _ => false,
    };

    private bool ApplyEvent(in WireMessage message)
    {
        switch (message.Id.Event)
        {
            case GameEventType.PlayerDescription when IsReadable(message, out PlayerDescription description):
                Describe(message.Guid, description);
                return true;
            case GameEventType.UpdateEnchantment when IsReadable(message, out UpdateEnchantment update):
                enchantments[(update.Enchantment.Spell, update.Enchantment.Layer)] = update.Enchantment;
                return true;
            case GameEventType.RemoveEnchantment when IsReadable(message, out RemoveEnchantment remove):
                return enchantments.Remove((remove.Spell, remove.Layer));
            case GameEventType.PurgeEnchantments:
                bool had = enchantments.Count > 0;
                enchantments.Clear();
                return had;
            default:
                return false;
        }
    }

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value))
            return true;
        UnreadableMessages++;
        return false;
    }

    private void Describe(uint guid, PlayerDescription description)
    {
        Guid = guid;
        IsDescribed = true;
        sequences.Clear();
        ints.Clear();
        attributes.Clear();
        skills.Clear();
        enchantments.Clear();
        foreach (Property<int> property in description.Ints ?? default)
            ints[property.Id] = property.Value;
        foreach (Property<SkillRecord> property in description.Skills ?? default)
            skills[property.Id] = property.Value;
        if (description.Attributes is { } told)
        {
            AttributeRecord?[] records = [told.Strength, told.Endurance, told.Quickness, told.Coordination, told.Focus, told.Self];
            for (uint i = 0; i < records.Length; i++)
            {
                if (records[i] is { } record)
                    attributes[i + 1] = record;
            }
        }

        vitals[0] = description.Vitals?.Health ?? default;
        vitals[1] = description.Vitals?.Stamina ?? default;
        vitals[2] = description.Vitals?.Mana ?? default;
        Vitae = description.Enchantments?.Vitae;
        Add(description.Enchantments?.Multiplicative ?? default);
        Add(description.Enchantments?.Additive ?? default);

        void Add(ValueList<Enchantment> told)
        {
            foreach (Enchantment enchantment in told)
                enchantments[(enchantment.Spell, enchantment.Layer)] = enchantment;
        }
    }

    /// <summary>Each kind of update counts each property in one byte of its own; the first one is always taken.</summary>
    private bool IsNewer(Opcode kind, uint property, byte sequence)
    {
        if (sequences.TryGetValue((kind, property), out byte last) && (sbyte)(sequence - last) <= 0)
            return false;
        sequences[(kind, property)] = sequence;
        return true;
    }

    private bool SetVital(uint vital, VitalRecord record)
    {
        if (vital is not (1 or 3 or 5))
            return false;
        vitals[vital / 2] = record;
        return true;
    }

    private bool SetCurrent(uint vital, uint current)
    {
        if (vital is not (2 or 4 or 6))
            return false;
        int index = (int)(vital / 2) - 1;
        vitals[index] = vitals[index] with { Current = current };
        return true;
    }

    private static bool Set<T>(Dictionary<uint, T> values, uint key, T value)
    {
        values[key] = value;
        return true;
    }
}
