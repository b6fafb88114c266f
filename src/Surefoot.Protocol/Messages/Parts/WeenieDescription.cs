namespace Surefoot.Protocol.Messages;

/// <summary>What an object is (specification 08, 6.7). What is null is not said.</summary>
/// <remarks>Retail: PublicWeenieDesc::UnPack @0x005AD470.</remarks>
public sealed partial record WeenieDescription
{
    private const uint IconIds = 0x06000000, HasSecondFlags = 0x04000000;

    /// <summary>Its name; that of an administrator's character begins with '+'.</summary>
    public string Name { get; init; } = "";

    /// <summary>Id of its kind.</summary>
    public uint ClassId { get; init; }

    /// <summary>Its picture; 0x06000000 for none.</summary>
    public uint Icon { get; init; } = IconIds;

    /// <summary>0x10 creature, 0x80 miscellaneous (doors), 0x10000 portal, 0x10000000 life stone.</summary>
    public uint ItemType { get; init; }

    /// <summary>Description flags: 0x4 stuck, 0x8 player, 0x10 attackable, 0x20 player killer, 0x1000 door, 0x40000 portal, 0x200000 free
    /// player killer,
    /// 0x400000 immune to cell restrictions, 0x2000000 player killer lite; the rest in the specification. 0x4000000 is set where it is
    /// needed.</summary>
    public uint Description { get; init; }

    /// <summary>Name of several.</summary>
    public string? PluralName { get; init; }

    /// <summary>Things that fit in.</summary>
    public byte? ItemCapacity { get; init; }

    /// <summary>Packs that fit in.</summary>
    public byte? ContainerCapacity { get; init; }

    /// <summary>Kind of ammunition.</summary>
    public ushort? AmmoType { get; init; }

    /// <summary>Price.</summary>
    public uint? Value { get; init; }

    /// <summary>How it can be used.</summary>
    public uint? Useability { get; init; }

    /// <summary>From how far it can be used, metres.</summary>
    public float? UseRadius { get; init; }

    /// <summary>What it can be used on.</summary>
    public uint? TargetType { get; init; }

    /// <summary>Glow of its icon.</summary>
    public uint? UiEffects { get; init; }

    /// <summary>What it is in a fight.</summary>
    public byte? CombatUse { get; init; }

    /// <summary>Uses left.</summary>
    public ushort? Structure { get; init; }

    /// <summary>Uses of a new one.</summary>
    public ushort? MaxStructure { get; init; }

    /// <summary>How many there are.</summary>
    public ushort? StackSize { get; init; }

    /// <summary>How many fit on a stack.</summary>
    public ushort? MaxStackSize { get; init; }

    /// <summary>What it lies in.</summary>
    public uint? Container { get; init; }

    /// <summary>Who wields or wears it.</summary>
    public uint? Wielder { get; init; }

    /// <summary>Where it can be worn.</summary>
    public uint? ValidLocations { get; init; }

    /// <summary>Where it is worn.</summary>
    public uint? CurrentLocation { get; init; }

    /// <summary>What it covers.</summary>
    public uint? Priority { get; init; }

    /// <summary>Colour on the radar.</summary>
    public byte? RadarColor { get; init; }

    /// <summary>When it shows on the radar.</summary>
    public byte? RadarBehavior { get; init; }

    /// <summary>Effect that it plays.</summary>
    public ushort? PhysicsScript { get; init; }

    /// <summary>1 to 10.</summary>
    public float? Workmanship { get; init; }

    /// <summary>Its weight.</summary>
    public ushort? Burden { get; init; }

    /// <summary>Spell that it casts.</summary>
    public ushort? Spell { get; init; }

    /// <summary>Who owns the house.</summary>
    public uint? HouseOwner { get; init; }

    /// <summary>Who may enter the house.</summary>
    public HouseRestrictions? Restrictions { get; init; }

    /// <summary>What can be hung up.</summary>
    public uint? HookItemTypes { get; init; }

    /// <summary>Head of its allegiance.</summary>
    public uint? Monarch { get; init; }

    /// <summary>Kind of hook.</summary>
    public ushort? HookType { get; init; }

    /// <summary>Picture over its icon.</summary>
    public uint? IconOverlay { get; init; }

    /// <summary>Picture under its icon.</summary>
    public uint? IconUnderlay { get; init; }

    /// <summary>What it is made of.</summary>
    public uint? Material { get; init; }

    /// <summary>Which things wait together.</summary>
    public uint? CooldownId { get; init; }

    /// <summary>How long it waits after use, seconds.</summary>
    public double? CooldownDuration { get; init; }

    /// <summary>Whose pet it is.</summary>
    public uint? PetOwner { get; init; }

    /// <summary>Second header flags without a field, as they were read.</summary>
    internal uint OtherFlags2 { get; init; }
}
