namespace Surefoot.Protocol.Messages;

/// <summary>A skill of the character (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Skill">22 jump, 24 run.</param>
/// <param name="Record">The skill.</param>
public readonly record struct PrivateUpdateSkill(byte Sequence, uint Skill, SkillRecord Record) : IInterfaceMessage<PrivateUpdateSkill>
{
    static Opcode IInterfaceMessage<PrivateUpdateSkill>.Opcode => Opcode.PrivateUpdateSkill;

    static PrivateUpdateSkill IMessage<PrivateUpdateSkill>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), SkillRecord.Read(ref reader));

    void IMessage<PrivateUpdateSkill>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Skill);
        Record.Write(ref writer);
    }
}

/// <summary>The level of a skill of the character (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Skill">22 jump, 24 run.</param>
/// <param name="Level">The level.</param>
public readonly record struct PrivateUpdateSkillLevel(byte Sequence, uint Skill, uint Level) : IInterfaceMessage<PrivateUpdateSkillLevel>
{
    static Opcode IInterfaceMessage<PrivateUpdateSkillLevel>.Opcode => Opcode.PrivateUpdateSkillLevel;

    static PrivateUpdateSkillLevel IMessage<PrivateUpdateSkillLevel>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<PrivateUpdateSkillLevel>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Skill);
        writer.WriteUInt32(Level);
    }
}

/// <summary>An attribute of the character (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Attribute">1 strength, 2 endurance, 3 quickness, 4 coordination, 5 focus, 6 self.</param>
/// <param name="Record">The attribute.</param>
public readonly record struct PrivateUpdateAttribute(
    byte Sequence,
    uint Attribute,
    AttributeRecord Record) : IInterfaceMessage<PrivateUpdateAttribute>
{
    static Opcode IInterfaceMessage<PrivateUpdateAttribute>.Opcode => Opcode.PrivateUpdateAttribute;

    static PrivateUpdateAttribute IMessage<PrivateUpdateAttribute>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), AttributeRecord.Read(ref reader));

    void IMessage<PrivateUpdateAttribute>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Attribute);
        Record.Write(ref writer);
    }
}

/// <summary>Health, stamina or mana of the character, with its greatest value (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Vital">Which: 1 or 2 health, 3 or 4 stamina, 5 or 6 mana; even numbers mean the value as it is now.</param>
/// <param name="Record">The vital.</param>
public readonly record struct PrivateUpdateVital(byte Sequence, uint Vital, VitalRecord Record) : IInterfaceMessage<PrivateUpdateVital>
{
    static Opcode IInterfaceMessage<PrivateUpdateVital>.Opcode => Opcode.PrivateUpdateVital;

    static PrivateUpdateVital IMessage<PrivateUpdateVital>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), VitalRecord.Read(ref reader));

    void IMessage<PrivateUpdateVital>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Vital);
        Record.Write(ref writer);
    }
}

/// <summary>Health, stamina or mana of the character as it is now (specification 08, 7.1).</summary>
/// <param name="Sequence">Number of this update, of its kind and property.</param>
/// <param name="Vital">Which: 1 or 2 health, 3 or 4 stamina, 5 or 6 mana; even numbers mean the value as it is now.</param>
/// <param name="Current">The value.</param>
public readonly record struct PrivateUpdateAttribute2ndLevel(
    byte Sequence,
    uint Vital,
    uint Current) : IInterfaceMessage<PrivateUpdateAttribute2ndLevel>
{
    static Opcode IInterfaceMessage<PrivateUpdateAttribute2ndLevel>.Opcode => Opcode.PrivateUpdateAttribute2ndLevel;

    static PrivateUpdateAttribute2ndLevel IMessage<PrivateUpdateAttribute2ndLevel>.Read(ref WireReader reader)
        => new(reader.ReadByte(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<PrivateUpdateAttribute2ndLevel>.Write(ref WireWriter writer)
    {
        writer.WriteByte(Sequence);
        writer.WriteUInt32(Vital);
        writer.WriteUInt32(Current);
    }
}
