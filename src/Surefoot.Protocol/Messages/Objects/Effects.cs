namespace Surefoot.Protocol.Messages;

/// <summary>A sound (specification 08, 6.1).</summary>
/// <param name="Guid">Where it comes from.</param>
/// <param name="SoundId">Which sound.</param>
/// <param name="Volume">1 is full.</param>
public readonly record struct Sound(uint Guid, uint SoundId, float Volume) : IObjectMessage<Sound>
{
    static Opcode IObjectMessage<Sound>.Opcode => Opcode.Sound;

    static Sound IMessage<Sound>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadSingle());

    void IMessage<Sound>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(SoundId);
        writer.WriteSingle(Volume);
    }
}

/// <summary>An effect, by its id (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Script">Id of the physics script.</param>
public readonly record struct PlayScriptId(uint Guid, uint Script) : IObjectMessage<PlayScriptId>
{
    static Opcode IObjectMessage<PlayScriptId>.Opcode => Opcode.PlayScriptId;

    static PlayScriptId IMessage<PlayScriptId>.Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<PlayScriptId>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Script);
    }
}

/// <summary>An effect, by its kind (specification 08, 6.1).</summary>
/// <param name="Guid">The object.</param>
/// <param name="Script">Kind of the effect.</param>
/// <param name="Speed">Factor on its speed.</param>
public readonly record struct PlayScriptType(uint Guid, uint Script, float Speed) : IObjectMessage<PlayScriptType>
{
    static Opcode IObjectMessage<PlayScriptType>.Opcode => Opcode.PlayScriptType;

    static PlayScriptType IMessage<PlayScriptType>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadSingle());

    void IMessage<PlayScriptType>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Guid);
        writer.WriteUInt32(Script);
        writer.WriteSingle(Speed);
    }
}
