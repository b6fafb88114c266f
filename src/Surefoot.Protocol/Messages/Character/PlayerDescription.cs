namespace Surefoot.Protocol.Messages;

/// <summary>A property of a character or an object.</summary>
/// <typeparam name="T">Type of its value.</typeparam>
/// <param name="Id">Which property.</param>
/// <param name="Value">Its value.</param>
public readonly record struct Property<T>(uint Id, T Value);

/// <summary>A thing that a character has.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Kind">0 thing, 1 pack, 2 focus.</param>
public readonly record struct InventoryItem(uint Guid, uint Kind);

/// <summary>A thing that a character wields or wears.</summary>
/// <param name="Guid">The thing.</param>
/// <param name="Location">Where.</param>
/// <param name="Priority">What it covers.</param>
public readonly record struct EquippedItem(uint Guid, uint Location, uint Priority);

/// <summary>The six attributes; null is not told.</summary>
/// <param name="Strength">Strength.</param>
/// <param name="Endurance">Endurance.</param>
/// <param name="Quickness">Quickness.</param>
/// <param name="Coordination">Coordination.</param>
/// <param name="Focus">Focus.</param>
/// <param name="Self">Self.</param>
public sealed record CharacterAttributes(
    AttributeRecord? Strength,
    AttributeRecord? Endurance,
    AttributeRecord? Quickness,
    AttributeRecord? Coordination,
    AttributeRecord? Focus,
    AttributeRecord? Self);

/// <summary>Health, stamina and mana; null is not told.</summary>
/// <param name="Health">Health.</param>
/// <param name="Stamina">Stamina.</param>
/// <param name="Mana">Mana.</param>
public sealed record CharacterVitals(VitalRecord? Health, VitalRecord? Stamina, VitalRecord? Mana);

/// <summary>The spells at work on a character.</summary>
/// <param name="Mask">Which lists there are: 1 multiplicative, 2 additive, 4 vitae, 8 cooldowns.</param>
/// <param name="Multiplicative">Those that multiply.</param>
/// <param name="Additive">Those that add.</param>
/// <param name="Cooldowns">Waiting times.</param>
/// <param name="Vitae">Loss after a death.</param>
public sealed record EnchantmentRegistry(
    uint Mask,
    ValueList<Enchantment> Multiplicative,
    ValueList<Enchantment> Additive,
    ValueList<Enchantment> Cooldowns,
    Enchantment? Vitae);

/// <summary>What a character's player chose, and what the character carries.</summary>
/// <param name="Options1">Choices.</param>
/// <param name="SpellBars">Eight lists of spells.</param>
/// <param name="SpellFilters">Which spells are shown.</param>
/// <param name="Options2">More choices.</param>
/// <param name="Inventory">Things carried, one for each CreateObject that follows.</param>
/// <param name="Equipment">Things wielded and worn.</param>
public sealed record CharacterBelongings(
    uint Options1,
    ValueList<ValueList<uint>> SpellBars,
    uint SpellFilters,
    uint Options2,
    ValueList<InventoryItem> Inventory,
    ValueList<EquippedItem> Equipment);

/// <summary>All of the character (specification 08, 7.3). A table that is null was not sent.</summary>
/// <remarks>Retail: CACQualities::UnPack @0x00593420.</remarks>
public sealed partial record PlayerDescription
{
    /// <summary>10 for a character, 11 for an administrator's.</summary>
    public uint WeenieType { get; init; }

    /// <summary>5 burden, 25 level, 134 player-killer status, 230 carrying augmentation.</summary>
    public ValueList<Property<int>>? Ints { get; init; }

    /// <summary>64-bit numbers.</summary>
    public ValueList<Property<long>>? Int64s { get; init; }

    /// <summary>0 or 1.</summary>
    public ValueList<Property<uint>>? Bools { get; init; }

    /// <summary>Fractions.</summary>
    public ValueList<Property<double>>? Doubles { get; init; }

    /// <summary>1 is the name; an administrator's begins with '+'.</summary>
    public ValueList<Property<string>>? Strings { get; init; }

    /// <summary>Ids of records.</summary>
    public ValueList<Property<uint>>? DataIds { get; init; }

    /// <summary>Ids of objects.</summary>
    public ValueList<Property<uint>>? InstanceIds { get; init; }

    /// <summary>Places.</summary>
    public ValueList<Property<WirePosition>>? Positions { get; init; }

    /// <summary>Always 1.</summary>
    public uint HasHealth { get; init; } = 1;

    /// <summary>The attributes; told together with the vitals.</summary>
    public CharacterAttributes? Attributes { get; init; }

    /// <summary>The vitals; told together with the attributes.</summary>
    public CharacterVitals? Vitals { get; init; }

    /// <summary>Skills by their ids: 22 jump, 24 run.</summary>
    public ValueList<Property<SkillRecord>>? Skills { get; init; }

    /// <summary>Known spells.</summary>
    public ValueList<Property<float>>? Spells { get; init; }

    /// <summary>Spells at work.</summary>
    public EnchantmentRegistry? Enchantments { get; init; }

    /// <summary>Choices and belongings; null when they have parts without a layout here. Then they are in <see cref="Rest"/>.</summary>
    public CharacterBelongings? Belongings { get; init; }

    /// <summary>Bytes behind the enchantments that <see cref="Belongings"/> does not tell.</summary>
    public ValueList<byte> Rest { get; init; }

    /// <summary>Bits of the flags that say nothing of what is told here.</summary>
    internal uint OtherFlags { get; init; }

    /// <summary>Bits of the vector flags that say nothing of what is told here.</summary>
    internal uint OtherVectors { get; init; }

    /// <summary>Bits of the attribute mask that say nothing of what is told here.</summary>
    internal uint OtherAttributes { get; init; }
}
