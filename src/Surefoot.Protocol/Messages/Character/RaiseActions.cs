namespace Surefoot.Protocol.Messages;

/// <summary>Spends experience on health, stamina or mana.</summary>
/// <param name="Vital">1 health, 3 stamina, 5 mana.</param>
/// <param name="Experience">Experience spent.</param>
public readonly record struct RaiseVital(uint Vital, uint Experience) : IGameAction<RaiseVital>
{
    static GameActionType IGameAction<RaiseVital>.Type => GameActionType.RaiseVital;

    static RaiseVital IMessage<RaiseVital>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<RaiseVital>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Vital);
        writer.WriteUInt32(Experience);
    }
}

/// <summary>Spends experience on an attribute.</summary>
/// <param name="Attribute">1 strength, 2 endurance, 3 quickness, 4 coordination, 5 focus, 6 self.</param>
/// <param name="Experience">Experience spent.</param>
public readonly record struct RaiseAttribute(uint Attribute, uint Experience) : IGameAction<RaiseAttribute>
{
    static GameActionType IGameAction<RaiseAttribute>.Type => GameActionType.RaiseAttribute;

    static RaiseAttribute IMessage<RaiseAttribute>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<RaiseAttribute>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Attribute);
        writer.WriteUInt32(Experience);
    }
}

/// <summary>Spends experience on a skill.</summary>
/// <param name="Skill">22 jump, 24 run.</param>
/// <param name="Experience">Experience spent.</param>
public readonly record struct RaiseSkill(uint Skill, uint Experience) : IGameAction<RaiseSkill>
{
    static GameActionType IGameAction<RaiseSkill>.Type => GameActionType.RaiseSkill;

    static RaiseSkill IMessage<RaiseSkill>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<RaiseSkill>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Skill);
        writer.WriteUInt32(Experience);
    }
}

/// <summary>Learns a skill.</summary>
/// <param name="Skill">22 jump, 24 run.</param>
/// <param name="Credits">Skill credits spent.</param>
public readonly record struct TrainSkill(uint Skill, uint Credits) : IGameAction<TrainSkill>
{
    static GameActionType IGameAction<TrainSkill>.Type => GameActionType.TrainSkill;

    static TrainSkill IMessage<TrainSkill>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<TrainSkill>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Skill);
        writer.WriteUInt32(Credits);
    }
}
