namespace Surefoot.Protocol.Messages;

/// <summary>Sets how much the client decides: 2 in normal play (specification 08, 5.6). Servers of the field do not know it.</summary>
/// <param name="Level">0 to 2.</param>
public readonly record struct AutonomyLevel(uint Level) : IGameAction<AutonomyLevel>
{
    static GameActionType IGameAction<AutonomyLevel>.Type => GameActionType.AutonomyLevel;

    static AutonomyLevel IMessage<AutonomyLevel>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<AutonomyLevel>.Write(ref WireWriter writer) => writer.WriteUInt32(Level);
}

/// <summary>Asks the server to begin a motion, at autonomy level 0 only.</summary>
/// <param name="Motion">Full id of the command.</param>
/// <param name="Speed">Factor on its speed.</param>
/// <param name="HoldKey">1 none, 2 run.</param>
public readonly record struct DoMovementCommand(uint Motion, float Speed, uint HoldKey) : IGameAction<DoMovementCommand>
{
    static GameActionType IGameAction<DoMovementCommand>.Type => GameActionType.DoMovementCommand;

    static DoMovementCommand IMessage<DoMovementCommand>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadSingle(), reader.ReadUInt32());

    void IMessage<DoMovementCommand>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Motion);
        writer.WriteSingle(Speed);
        writer.WriteUInt32(HoldKey);
    }
}

/// <summary>Asks the server to end a motion, at autonomy level 0 only.</summary>
/// <param name="Motion">Full id of the command.</param>
/// <param name="HoldKey">1 none, 2 run.</param>
public readonly record struct StopMovementCommand(uint Motion, uint HoldKey) : IGameAction<StopMovementCommand>
{
    static GameActionType IGameAction<StopMovementCommand>.Type => GameActionType.StopMovementCommand;

    static StopMovementCommand IMessage<StopMovementCommand>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<StopMovementCommand>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Motion);
        writer.WriteUInt32(HoldKey);
    }
}

/// <summary>Asks the server to jump, at autonomy level 0 only.</summary>
/// <param name="Extent">Charge, 0.001 to 1.</param>
public readonly record struct JumpNonAutonomous(float Extent) : IGameAction<JumpNonAutonomous>
{
    static GameActionType IGameAction<JumpNonAutonomous>.Type => GameActionType.JumpNonAutonomous;

    static JumpNonAutonomous IMessage<JumpNonAutonomous>.Read(ref WireReader reader) => new(reader.ReadSingle());

    void IMessage<JumpNonAutonomous>.Write(ref WireWriter writer) => writer.WriteSingle(Extent);
}
