namespace Surefoot.Protocol.Messages;

/// <summary>An enchantment began or changed (specification 08, 7.3).</summary>
/// <param name="Enchantment">The spell at work.</param>
public readonly record struct UpdateEnchantment(Enchantment Enchantment) : IGameEvent<UpdateEnchantment>
{
    static GameEventType IGameEvent<UpdateEnchantment>.Type => GameEventType.UpdateEnchantment;

    static UpdateEnchantment IMessage<UpdateEnchantment>.Read(ref WireReader reader) => new(Enchantment.Read(ref reader));

    void IMessage<UpdateEnchantment>.Write(ref WireWriter writer) => Enchantment.Write(ref writer);
}

/// <summary>An enchantment ended (specification 08, 7.3).</summary>
/// <param name="Spell">Id of the spell.</param>
/// <param name="Layer">Which casting of it.</param>
public readonly record struct RemoveEnchantment(ushort Spell, ushort Layer) : IGameEvent<RemoveEnchantment>
{
    static GameEventType IGameEvent<RemoveEnchantment>.Type => GameEventType.RemoveEnchantment;

    static RemoveEnchantment IMessage<RemoveEnchantment>.Read(ref WireReader reader) => new(reader.ReadUInt16(), reader.ReadUInt16());

    void IMessage<RemoveEnchantment>.Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Spell);
        writer.WriteUInt16(Layer);
    }
}

/// <summary>All enchantments ended (specification 08, 7.3).</summary>
public readonly record struct PurgeEnchantments : IGameEvent<PurgeEnchantments>
{
    static GameEventType IGameEvent<PurgeEnchantments>.Type => GameEventType.PurgeEnchantments;

    static PurgeEnchantments IMessage<PurgeEnchantments>.Read(ref WireReader reader) => default;

    void IMessage<PurgeEnchantments>.Write(ref WireWriter writer)
    {
    }
}
