namespace Surefoot.Protocol.Messages;

public sealed partial record WeenieDescription
{
    private const uint HasPluralName = 0x1, HasItemCapacity = 0x2, HasContainerCapacity = 0x4, HasAmmoType = 0x100, HasValue = 0x8,
        HasUseability = 0x10, HasUseRadius = 0x20, HasTargetType = 0x80000, HasUiEffects = 0x80, HasCombatUse = 0x200,
        HasStructure = 0x400, HasMaxStructure = 0x800, HasStackSize = 0x1000, HasMaxStackSize = 0x2000, HasContainer = 0x4000,
        HasWielder = 0x8000, HasValidLocations = 0x10000, HasCurrentLocation = 0x20000, HasPriority = 0x40000, HasRadarColor = 0x100000,
        HasRadarBehavior = 0x800000, HasPhysicsScript = 0x8000000, HasWorkmanship = 0x1000000, HasBurden = 0x200000, HasSpell = 0x400000,
        HasHouseOwner = 0x2000000, HasRestrictions = 0x4000000, HasHookItemTypes = 0x20000000, HasMonarch = 0x40,
        HasHookType = 0x10000000, HasIconOverlay = 0x40000000, HasMaterial = 0x80000000;

    private const uint HasIconUnderlay = 0x1, HasCooldownId = 0x2, HasCooldownDuration = 0x4, HasPetOwner = 0x8;

    private const uint WithField2 = 0xF;

    /// <summary>The header flags: each has its field.</summary>
    internal uint Flags
        => Flag(PluralName is not null, HasPluralName)
            | Flag(ItemCapacity is not null, HasItemCapacity) | Flag(ContainerCapacity is not null, HasContainerCapacity)
            | Flag(AmmoType is not null, HasAmmoType) | Flag(Value is not null, HasValue)
            | Flag(Useability is not null, HasUseability) | Flag(UseRadius is not null, HasUseRadius)
            | Flag(TargetType is not null, HasTargetType) | Flag(UiEffects is not null, HasUiEffects)
            | Flag(CombatUse is not null, HasCombatUse) | Flag(Structure is not null, HasStructure)
            | Flag(MaxStructure is not null, HasMaxStructure) | Flag(StackSize is not null, HasStackSize)
            | Flag(MaxStackSize is not null, HasMaxStackSize) | Flag(Container is not null, HasContainer)
            | Flag(Wielder is not null, HasWielder) | Flag(ValidLocations is not null, HasValidLocations)
            | Flag(CurrentLocation is not null, HasCurrentLocation) | Flag(Priority is not null, HasPriority)
            | Flag(RadarColor is not null, HasRadarColor) | Flag(RadarBehavior is not null, HasRadarBehavior)
            | Flag(PhysicsScript is not null, HasPhysicsScript) | Flag(Workmanship is not null, HasWorkmanship)
            | Flag(Burden is not null, HasBurden) | Flag(Spell is not null, HasSpell)
            | Flag(HouseOwner is not null, HasHouseOwner) | Flag(Restrictions is not null, HasRestrictions)
            | Flag(HookItemTypes is not null, HasHookItemTypes) | Flag(Monarch is not null, HasMonarch)
            | Flag(HookType is not null, HasHookType) | Flag(IconOverlay is not null, HasIconOverlay)
            | Flag(Material is not null, HasMaterial);

    /// <summary>The second header flags.</summary>
    internal uint Flags2
        => OtherFlags2
            | Flag(IconUnderlay is not null, HasIconUnderlay) | Flag(CooldownId is not null, HasCooldownId)
            | Flag(CooldownDuration is not null, HasCooldownDuration) | Flag(PetOwner is not null, HasPetOwner);

    internal static WeenieDescription Read(ref WireReader reader)
    {
        uint flags = reader.ReadUInt32();
        string name = reader.ReadString16();
        uint classId = reader.ReadPackedUInt32(), icon = reader.ReadPackedId(IconIds), itemType = reader.ReadUInt32();
        uint description = reader.ReadUInt32();
        reader.Align4();
        uint flags2 = (description & HasSecondFlags) != 0 ? reader.ReadUInt32() : 0;
        var weenie = new WeenieDescription
        {
            Name = name,
            ClassId = classId,
            Icon = icon,
            ItemType = itemType,
            Description = description,
            PluralName = (flags & HasPluralName) != 0 ? reader.ReadString16() : null,
            ItemCapacity = (flags & HasItemCapacity) != 0 ? reader.ReadByte() : null,
            ContainerCapacity = (flags & HasContainerCapacity) != 0 ? reader.ReadByte() : null,
            AmmoType = (flags & HasAmmoType) != 0 ? reader.ReadUInt16() : null,
            Value = (flags & HasValue) != 0 ? reader.ReadUInt32() : null,
            Useability = (flags & HasUseability) != 0 ? reader.ReadUInt32() : null,
            UseRadius = (flags & HasUseRadius) != 0 ? reader.ReadSingle() : null,
            TargetType = (flags & HasTargetType) != 0 ? reader.ReadUInt32() : null,
            UiEffects = (flags & HasUiEffects) != 0 ? reader.ReadUInt32() : null,
            CombatUse = (flags & HasCombatUse) != 0 ? reader.ReadByte() : null,
            Structure = (flags & HasStructure) != 0 ? reader.ReadUInt16() : null,
            MaxStructure = (flags & HasMaxStructure) != 0 ? reader.ReadUInt16() : null,
            StackSize = (flags & HasStackSize) != 0 ? reader.ReadUInt16() : null,
            MaxStackSize = (flags & HasMaxStackSize) != 0 ? reader.ReadUInt16() : null,
            Container = (flags & HasContainer) != 0 ? reader.ReadUInt32() : null,
            Wielder = (flags & HasWielder) != 0 ? reader.ReadUInt32() : null,
            ValidLocations = (flags & HasValidLocations) != 0 ? reader.ReadUInt32() : null,
            CurrentLocation = (flags & HasCurrentLocation) != 0 ? reader.ReadUInt32() : null,
            Priority = (flags & HasPriority) != 0 ? reader.ReadUInt32() : null,
            RadarColor = (flags & HasRadarColor) != 0 ? reader.ReadByte() : null,
            RadarBehavior = (flags & HasRadarBehavior) != 0 ? reader.ReadByte() : null,
            PhysicsScript = (flags & HasPhysicsScript) != 0 ? reader.ReadUInt16() : null,
            Workmanship = (flags & HasWorkmanship) != 0 ? reader.ReadSingle() : null,
            Burden = (flags & HasBurden) != 0 ? reader.ReadUInt16() : null,
            Spell = (flags & HasSpell) != 0 ? reader.ReadUInt16() : null,
            HouseOwner = (flags & HasHouseOwner) != 0 ? reader.ReadUInt32() : null,
            Restrictions = (flags & HasRestrictions) != 0 ? HouseRestrictions.Read(ref reader) : null,
            HookItemTypes = (flags & HasHookItemTypes) != 0 ? reader.ReadUInt32() : null,
            Monarch = (flags & HasMonarch) != 0 ? reader.ReadUInt32() : null,
            HookType = (flags & HasHookType) != 0 ? reader.ReadUInt16() : null,
            IconOverlay = (flags & HasIconOverlay) != 0 ? reader.ReadPackedId(IconIds) : null,
            IconUnderlay = (flags2 & HasIconUnderlay) != 0 ? reader.ReadPackedId(IconIds) : null,
            Material = (flags & HasMaterial) != 0 ? reader.ReadUInt32() : null,
            CooldownId = (flags2 & HasCooldownId) != 0 ? reader.ReadUInt32() : null,
            CooldownDuration = (flags2 & HasCooldownDuration) != 0 ? reader.ReadDouble() : null,
            PetOwner = (flags2 & HasPetOwner) != 0 ? reader.ReadUInt32() : null,
            OtherFlags2 = flags2 & ~WithField2,
        };
        reader.Align4();
        return weenie;
    }

    internal void Write(ref WireWriter writer)
    {
        uint flags2 = Flags2;
        writer.WriteUInt32(Flags);
        writer.WriteString16(Name);
        writer.WritePackedUInt32(ClassId);
        writer.WritePackedId(Icon, IconIds);
        writer.WriteUInt32(ItemType);
        writer.WriteUInt32(Description | Flag(flags2 != 0, HasSecondFlags));
        writer.Align4();
        if (flags2 != 0 || (Description & HasSecondFlags) != 0)
            writer.WriteUInt32(flags2);
        if (PluralName is { } pluralName)
            writer.WriteString16(pluralName);
        if (ItemCapacity is { } itemCapacity)
            writer.WriteByte(itemCapacity);
        if (ContainerCapacity is { } containerCapacity)
            writer.WriteByte(containerCapacity);
        if (AmmoType is { } ammoType)
            writer.WriteUInt16(ammoType);
        if (Value is { } value)
            writer.WriteUInt32(value);
        if (Useability is { } useability)
            writer.WriteUInt32(useability);
        if (UseRadius is { } useRadius)
            writer.WriteSingle(useRadius);
        if (TargetType is { } targetType)
            writer.WriteUInt32(targetType);
        if (UiEffects is { } uiEffects)
            writer.WriteUInt32(uiEffects);
        if (CombatUse is { } combatUse)
            writer.WriteByte(combatUse);
        if (Structure is { } structure)
            writer.WriteUInt16(structure);
        if (MaxStructure is { } maxStructure)
            writer.WriteUInt16(maxStructure);
        if (StackSize is { } stackSize)
            writer.WriteUInt16(stackSize);
        if (MaxStackSize is { } maxStackSize)
            writer.WriteUInt16(maxStackSize);
        if (Container is { } container)
            writer.WriteUInt32(container);
        if (Wielder is { } wielder)
            writer.WriteUInt32(wielder);
        if (ValidLocations is { } validLocations)
            writer.WriteUInt32(validLocations);
        if (CurrentLocation is { } currentLocation)
            writer.WriteUInt32(currentLocation);
        if (Priority is { } priority)
            writer.WriteUInt32(priority);
        if (RadarColor is { } radarColor)
            writer.WriteByte(radarColor);
        if (RadarBehavior is { } radarBehavior)
            writer.WriteByte(radarBehavior);
        if (PhysicsScript is { } physicsScript)
            writer.WriteUInt16(physicsScript);
        if (Workmanship is { } workmanship)
            writer.WriteSingle(workmanship);
        if (Burden is { } burden)
            writer.WriteUInt16(burden);
        if (Spell is { } spell)
            writer.WriteUInt16(spell);
        if (HouseOwner is { } houseOwner)
            writer.WriteUInt32(houseOwner);
        if (Restrictions is { } restrictions)
            restrictions.Write(ref writer);
        if (HookItemTypes is { } hookItemTypes)
            writer.WriteUInt32(hookItemTypes);
        if (Monarch is { } monarch)
            writer.WriteUInt32(monarch);
        if (HookType is { } hookType)
            writer.WriteUInt16(hookType);
        if (IconOverlay is { } iconOverlay)
            writer.WritePackedId(iconOverlay, IconIds);
        if (IconUnderlay is { } iconUnderlay)
            writer.WritePackedId(iconUnderlay, IconIds);
        if (Material is { } material)
            writer.WriteUInt32(material);
        if (CooldownId is { } cooldownId)
            writer.WriteUInt32(cooldownId);
        if (CooldownDuration is { } cooldownDuration)
            writer.WriteDouble(cooldownDuration);
        if (PetOwner is { } petOwner)
            writer.WriteUInt32(petOwner);
        writer.Align4();
    }

    private static uint Flag(bool present, uint flag) => present ? flag : 0;
}
