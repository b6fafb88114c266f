namespace Surefoot.Protocol.Messages;

/// <summary>A message as an immutable value, with its bytes both ways.</summary>
/// <typeparam name="TSelf">The message's own type.</typeparam>
public interface IMessage<TSelf>
    where TSelf : IMessage<TSelf>
{
    /// <summary>Which message it is.</summary>
    static abstract MessageId Id { get; }

    /// <summary>The group that its sender puts it in.</summary>
    static abstract MessageGroup Group { get; }

    /// <summary>Reads what follows the opcode or the wrapper. What cannot be read is told by <see cref="WireReader.Fault"/>.</summary>
    static abstract TSelf Read(ref WireReader reader);

    /// <summary>Writes what follows the opcode or the wrapper. What cannot be written is told by <see cref="WireWriter.Failed"/>.</summary>
    void Write(ref WireWriter writer);
}

/// <summary>What a client does in the world (specification 08, 4.1).</summary>
/// <typeparam name="TSelf">The message's own type.</typeparam>
public interface IGameAction<TSelf> : IMessage<TSelf>
    where TSelf : IGameAction<TSelf>
{
    /// <summary>Which action it is.</summary>
    static abstract GameActionType Type { get; }

    static MessageId IMessage<TSelf>.Id => new(Opcode.GameAction, (uint)TSelf.Type);

    static MessageGroup IMessage<TSelf>.Group => MessageGroup.World;
}

/// <summary>An event that the server numbers (specification 08, 4.2).</summary>
/// <typeparam name="TSelf">The message's own type.</typeparam>
public interface IGameEvent<TSelf> : IMessage<TSelf>
    where TSelf : IGameEvent<TSelf>
{
    /// <summary>Which event it is.</summary>
    static abstract GameEventType Type { get; }

    static MessageId IMessage<TSelf>.Id => new(Opcode.GameEvent, (uint)TSelf.Type);

    static MessageGroup IMessage<TSelf>.Group => MessageGroup.Interface;
}

/// <summary>What a server says of its objects (specification 08, section 6).</summary>
/// <typeparam name="TSelf">The message's own type.</typeparam>
public interface IObjectMessage<TSelf> : IMessage<TSelf>
    where TSelf : IObjectMessage<TSelf>
{
    /// <summary>Which message it is.</summary>
    static abstract Opcode Opcode { get; }

    static MessageId IMessage<TSelf>.Id => new(TSelf.Opcode);

    static MessageGroup IMessage<TSelf>.Group => MessageGroup.Objects;
}

/// <summary>What a server says of the character or the account outside of ordered events.</summary>
/// <typeparam name="TSelf">The message's own type.</typeparam>
public interface IInterfaceMessage<TSelf> : IMessage<TSelf>
    where TSelf : IInterfaceMessage<TSelf>
{
    /// <summary>Which message it is.</summary>
    static abstract Opcode Opcode { get; }

    static MessageId IMessage<TSelf>.Id => new(TSelf.Opcode);

    static MessageGroup IMessage<TSelf>.Group => MessageGroup.Interface;
}
