namespace Surefoot.Protocol.Messages;

/// <summary>Which message it is.</summary>
/// <param name="Opcode">The first number of the message.</param>
/// <param name="Inner">The type of what a wrapper holds, for <see cref="Opcode.GameAction"/> and <see cref="Opcode.GameEvent"/>; else
/// 0.</param>
public readonly record struct MessageId(Opcode Opcode, uint Inner = 0)
{
    /// <summary>The type of a game action; 0 for other messages.</summary>
    public GameActionType Action => Opcode == Opcode.GameAction ? (GameActionType)Inner : 0;

    /// <summary>The type of an ordered event; 0 for other messages.</summary>
    public GameEventType Event => Opcode == Opcode.GameEvent ? (GameEventType)Inner : 0;

    /// <summary>Bytes before the body: the opcode and, for a wrapped message, the wrapper's fields.</summary>
    internal int HeaderSize => Opcode switch { Opcode.GameAction => 12, Opcode.GameEvent => 16, _ => 4 };

    /// <summary>The message's name, or its number where it has none here.</summary>
    public override string ToString() => Opcode switch
    {
        Opcode.GameAction => Name(Action, nameof(Opcode.GameAction)),
        Opcode.GameEvent => Name(Event, nameof(Opcode.GameEvent)),
        _ => Name(Opcode, ""),
    };

    private static string Name<TEnum>(TEnum value, string wrapper)
        where TEnum : struct, Enum => Enum.GetName(value) ?? $"{wrapper}0x{Convert.ToUInt32(value, null):X4}";
}
