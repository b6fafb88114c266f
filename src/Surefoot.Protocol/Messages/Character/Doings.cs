namespace Surefoot.Protocol.Messages;

/// <summary>Says something; a text that begins with @ is a command to the server (specification 08, 5.6).</summary>
/// <param name="Text">Windows-1252.</param>
public readonly record struct Talk(string Text) : IGameAction<Talk>
{
    static GameActionType IGameAction<Talk>.Type => GameActionType.Talk;

    static Talk IMessage<Talk>.Read(ref WireReader reader) => new(reader.ReadString16());

    void IMessage<Talk>.Write(ref WireWriter writer) => writer.WriteString16(Text);
}

/// <summary>Uses an object: the server walks the player there (specification 08, 5.7).</summary>
/// <param name="Guid">The object.</param>
public readonly record struct Use(uint Guid) : IGameAction<Use>
{
    static GameActionType IGameAction<Use>.Type => GameActionType.Use;

    static Use IMessage<Use>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<Use>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}

/// <summary>Looks at an object.</summary>
/// <param name="Guid">The object.</param>
public readonly record struct IdentifyObject(uint Guid) : IGameAction<IdentifyObject>
{
    static GameActionType IGameAction<IdentifyObject>.Type => GameActionType.IdentifyObject;

    static IdentifyObject IMessage<IdentifyObject>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<IdentifyObject>.Write(ref WireWriter writer) => writer.WriteUInt32(Guid);
}

/// <summary>Draws or sheathes the weapon.</summary>
/// <param name="Mode">1 peace, 2 melee.</param>
public readonly record struct ChangeCombatMode(uint Mode) : IGameAction<ChangeCombatMode>
{
    static GameActionType IGameAction<ChangeCombatMode>.Type => GameActionType.ChangeCombatMode;

    static ChangeCombatMode IMessage<ChangeCombatMode>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<ChangeCombatMode>.Write(ref WireWriter writer) => writer.WriteUInt32(Mode);
}
