namespace Surefoot.Protocol.Messages;

public sealed partial record PlayerDescription : IGameEvent<PlayerDescription>
{
    private const uint HasInts = 0x001, HasBools = 0x002, HasDoubles = 0x004, HasDataIds = 0x008, HasStrings = 0x010, HasPositions = 0x020,
        HasInstanceIds = 0x040, HasInt64s = 0x080, WithField = 0x0FF;

    private const uint HasAttributes = 0x1, HasSkills = 0x2, HasSpells = 0x100, HasEnchantments = 0x200, VectorsWithField = 0x303;

    private const uint AttributesWithField = 0x1FF;

    // Choices with spell bars, filters and second options, and nothing else (specification 08, 8.6).
    private const uint PlainBelongings = 0x460;
    private const int SpellBarCount = 8;

    // Bucket counts as servers of the field write them.
    private const ushort ManyBuckets = 64, FewBuckets = 32, PositionBuckets = 16;

    static GameEventType IGameEvent<PlayerDescription>.Type => GameEventType.PlayerDescription;

    /// <summary>The property flags.</summary>
    internal uint Flags
        => OtherFlags
            | Flag(Ints is not null, HasInts) | Flag(Int64s is not null, HasInt64s) | Flag(Bools is not null, HasBools)
            | Flag(Doubles is not null, HasDoubles) | Flag(Strings is not null, HasStrings) | Flag(DataIds is not null, HasDataIds)
            | Flag(InstanceIds is not null, HasInstanceIds) | Flag(Positions is not null, HasPositions);

    /// <summary>The vector flags.</summary>
    internal uint Vectors
        => OtherVectors
            | Flag(Attributes is not null || Vitals is not null, HasAttributes) | Flag(Skills is not null, HasSkills)
            | Flag(Spells is not null, HasSpells) | Flag(Enchantments is not null, HasEnchantments);

    /// <summary>The attribute mask.</summary>
    internal uint AttributeMask
        => OtherAttributes
            | Flag(Attributes?.Strength is not null, 0x1) | Flag(Attributes?.Endurance is not null, 0x2)
            | Flag(Attributes?.Quickness is not null, 0x4) | Flag(Attributes?.Coordination is not null, 0x8)
            | Flag(Attributes?.Focus is not null, 0x10) | Flag(Attributes?.Self is not null, 0x20)
            | Flag(Vitals?.Health is not null, 0x40) | Flag(Vitals?.Stamina is not null, 0x80) | Flag(Vitals?.Mana is not null, 0x100);

    static PlayerDescription IMessage<PlayerDescription>.Read(ref WireReader reader)
    {
        uint flags = reader.ReadUInt32(), weenieType = reader.ReadUInt32();
        var player = new PlayerDescription
        {
            WeenieType = weenieType,
            OtherFlags = flags & ~WithField,
            Ints = (flags & HasInts) != 0 ? reader.ReadTable(8, static (ref r) => new Property<int>(r.ReadUInt32(), r.ReadInt32())) : null,
            Int64s = (flags & HasInt64s) != 0
                ? reader.ReadTable(12, static (ref r) => new Property<long>(r.ReadUInt32(), r.ReadInt64()))
                : null,
            Bools = (flags & HasBools) != 0 ? reader.ReadTable(8, ReadNumber) : null,
            Doubles = (flags & HasDoubles) != 0
                ? reader.ReadTable(12, static (ref r) => new Property<double>(r.ReadUInt32(), r.ReadDouble()))
                : null,
            Strings = (flags & HasStrings) != 0
                ? reader.ReadTable(8, static (ref r) => new Property<string>(r.ReadUInt32(), r.ReadString16()))
                : null,
            DataIds = (flags & HasDataIds) != 0 ? reader.ReadTable(8, ReadNumber) : null,
            InstanceIds = (flags & HasInstanceIds) != 0 ? reader.ReadTable(8, ReadNumber) : null,
            Positions = (flags & HasPositions) != 0
                ? reader.ReadTable(36, static (ref r) => new Property<WirePosition>(r.ReadUInt32(), WirePosition.Read(ref r)))
                : null,
        };

        uint vectors = reader.ReadUInt32(), hasHealth = reader.ReadUInt32();
        uint mask = (vectors & HasAttributes) != 0 ? reader.ReadUInt32() : 0;
        player = player with
        {
            OtherVectors = vectors & ~VectorsWithField,
            HasHealth = hasHealth,
            OtherAttributes = mask & ~AttributesWithField,
            Attributes = (vectors & HasAttributes) != 0 ? ReadAttributes(ref reader, mask) : null,
            Vitals = (vectors & HasAttributes) != 0 ? ReadVitals(ref reader, mask) : null,
            Skills = (vectors & HasSkills) != 0
                ? reader.ReadTable(
                    4 + SkillRecord.Size, static (ref r) => new Property<SkillRecord>(r.ReadUInt32(), SkillRecord.Read(ref r)))
                : null,
            Spells = (vectors & HasSpells) != 0
                ? reader.ReadTable(8, static (ref r) => new Property<float>(r.ReadUInt32(), r.ReadSingle()))
                : null,
            Enchantments = (vectors & HasEnchantments) != 0 ? ReadEnchantments(ref reader) : null,
        };

        CharacterBelongings? belongings = TryReadBelongings(ref reader);
        ReadOnlySpan<byte> rest = reader.ReadBytes(belongings is null ? reader.Remaining : 0);
        return player with { Belongings = belongings, Rest = ValueList.Create(rest) };
    }

    void IMessage<PlayerDescription>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Flags);
        writer.WriteUInt32(WeenieType);
        Table(ref writer, Ints, ManyBuckets, static (ref w, value) => w.WriteInt32(value));
        Table(ref writer, Int64s, ManyBuckets, static (ref w, value) => w.WriteInt64(value));
        Table(ref writer, Bools, FewBuckets, static (ref w, value) => w.WriteUInt32(value));
        Table(ref writer, Doubles, FewBuckets, static (ref w, value) => w.WriteDouble(value));
        Table(ref writer, Strings, FewBuckets, static (ref w, value) => w.WriteString16(value));
        Table(ref writer, DataIds, FewBuckets, static (ref w, value) => w.WriteUInt32(value));
        Table(ref writer, InstanceIds, FewBuckets, static (ref w, value) => w.WriteUInt32(value));
        Table(ref writer, Positions, PositionBuckets, static (ref w, value) => value.Write(ref w));

        uint vectors = Vectors;
        writer.WriteUInt32(vectors);
        writer.WriteUInt32(HasHealth);
        if ((vectors & HasAttributes) != 0)
            WriteAttributes(ref writer);
        Table(ref writer, Skills, FewBuckets, static (ref w, value) => value.Write(ref w));
        Table(ref writer, Spells, ManyBuckets, static (ref w, value) => w.WriteSingle(value));
        if (Enchantments is not null)
            WriteEnchantments(ref writer, Enchantments);
        if (Belongings is not null)
            WriteBelongings(ref writer, Belongings);
        writer.WriteBytes(Rest.Span);
    }

    private static CharacterAttributes ReadAttributes(ref WireReader reader, uint mask)
    {
        return new CharacterAttributes(
            One(ref reader, mask & 0x1), One(ref reader, mask & 0x2), One(ref reader, mask & 0x4),
            One(ref reader, mask & 0x8), One(ref reader, mask & 0x10), One(ref reader, mask & 0x20));

        static AttributeRecord? One(ref WireReader reader, uint bit) => bit != 0 ? AttributeRecord.Read(ref reader) : null;
    }

    private static CharacterVitals ReadVitals(ref WireReader reader, uint mask)
    {
        return new CharacterVitals(One(ref reader, mask & 0x40), One(ref reader, mask & 0x80), One(ref reader, mask & 0x100));

        static VitalRecord? One(ref WireReader reader, uint bit) => bit != 0 ? VitalRecord.Read(ref reader) : null;
    }

    private void WriteAttributes(ref WireWriter writer)
    {
        writer.WriteUInt32(AttributeMask);
        Attributes?.Strength?.Write(ref writer);
        Attributes?.Endurance?.Write(ref writer);
        Attributes?.Quickness?.Write(ref writer);
        Attributes?.Coordination?.Write(ref writer);
        Attributes?.Focus?.Write(ref writer);
        Attributes?.Self?.Write(ref writer);
        Vitals?.Health?.Write(ref writer);
        Vitals?.Stamina?.Write(ref writer);
        Vitals?.Mana?.Write(ref writer);
    }

    private static EnchantmentRegistry ReadEnchantments(ref WireReader reader)
    {
        uint mask = reader.ReadUInt32();
        return new EnchantmentRegistry(
            mask, List(ref reader, mask & 1), List(ref reader, mask & 2), List(ref reader, mask & 8),
            (mask & 4) != 0 ? Enchantment.Read(ref reader) : null);

        static ValueList<Enchantment> List(ref WireReader reader, uint bit)
            => bit != 0 ? reader.ReadList(Enchantment.Size, Enchantment.Read) : default;
    }

    private static void WriteEnchantments(ref WireWriter writer, EnchantmentRegistry registry)
    {
        if ((registry.Mask & 4) != 0 != registry.Vitae is not null)
            writer.Fail();
        writer.WriteUInt32(registry.Mask);
        List(ref writer, registry.Mask & 1, registry.Multiplicative);
        List(ref writer, registry.Mask & 2, registry.Additive);
        List(ref writer, registry.Mask & 8, registry.Cooldowns);
        registry.Vitae?.Write(ref writer);

        static void List(ref WireWriter writer, uint bit, ValueList<Enchantment> enchantments)
        {
            if (bit != 0)
                writer.WriteList(enchantments, Enchantment.Write);
        }
    }

    private static CharacterBelongings? TryReadBelongings(ref WireReader reader)
    {
        WireReader ahead = reader;
        if (ahead.ReadUInt32() != PlainBelongings)
            return null;
        var belongings = new CharacterBelongings(
            ahead.ReadUInt32(),
            ahead.ReadList(SpellBarCount, 4, static (ref r) => r.ReadList(4, static (ref one) => one.ReadUInt32())),
            ahead.ReadUInt32(),
            ahead.ReadUInt32(),
            ahead.ReadList(8, static (ref r) => new InventoryItem(r.ReadUInt32(), r.ReadUInt32())),
            ahead.ReadList(12, static (ref r) => new EquippedItem(r.ReadUInt32(), r.ReadUInt32(), r.ReadUInt32())));
        if (ahead.Fault != WireFault.None)
            return null;
        reader = ahead;
        return belongings;
    }

    private static void WriteBelongings(ref WireWriter writer, CharacterBelongings belongings)
    {
        if (belongings.SpellBars.Count != SpellBarCount)
            writer.Fail();
        writer.WriteUInt32(PlainBelongings);
        writer.WriteUInt32(belongings.Options1);
        foreach (ValueList<uint> bar in belongings.SpellBars)
            writer.WriteList(bar, static (ref w, spell) => w.WriteUInt32(spell));
        writer.WriteUInt32(belongings.SpellFilters);
        writer.WriteUInt32(belongings.Options2);
        writer.WriteList(belongings.Inventory, static (ref w, item) =>
        {
            w.WriteUInt32(item.Guid);
            w.WriteUInt32(item.Kind);
        });
        writer.WriteList(belongings.Equipment, static (ref w, item) =>
        {
            w.WriteUInt32(item.Guid);
            w.WriteUInt32(item.Location);
            w.WriteUInt32(item.Priority);
        });
    }

    private static Property<uint> ReadNumber(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    private static void Table<T>(ref WireWriter writer, ValueList<Property<T>>? table, ushort buckets, WriteElement<T> write)
    {
        if (table is not { } properties)
            return;
        writer.WriteUInt16(writer.CountOf(properties.Count, ushort.MaxValue));
        writer.WriteUInt16(buckets);
        foreach (Property<T> property in properties)
        {
            writer.WriteUInt32(property.Id);
            write(ref writer, property.Value);
        }
    }

    private static uint Flag(bool present, uint flag) => present ? flag : 0;
}
