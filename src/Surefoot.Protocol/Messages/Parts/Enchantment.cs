namespace Surefoot.Protocol.Messages;

/// <summary>A spell at work on a character: 60 bytes, or 64 (specification 08, 7.3).</summary>
/// <param name="Spell">Id of the spell.</param>
/// <param name="Layer">Which casting of it.</param>
/// <param name="Category">Spells of one category replace each other.</param>
/// <param name="Power">How strong it is.</param>
/// <param name="Start">When it began, seconds.</param>
/// <param name="Duration">How long it lasts, seconds.</param>
/// <param name="Caster">Who cast it.</param>
/// <param name="DegradeModifier">How it fades.</param>
/// <param name="DegradeLimit">How far it fades.</param>
/// <param name="LastDegraded">When it faded last, seconds.</param>
/// <param name="StatModType">What it changes: 0x1 attribute, 0x10 skill; 0x4000 by a factor, 0x8000 by a summand.</param>
/// <param name="StatModKey">Which attribute or skill.</param>
/// <param name="StatModValue">The factor or summand.</param>
/// <param name="SpellSet">Set of equipment that it comes from.</param>
/// <param name="HasSpellSet">The word on the wire; <paramref name="SpellSet"/> travels when it is not 0.</param>
public readonly record struct Enchantment(
    ushort Spell,
    ushort Layer,
    ushort Category,
    uint Power,
    double Start,
    double Duration,
    uint Caster,
    float DegradeModifier,
    float DegradeLimit,
    double LastDegraded,
    uint StatModType,
    uint StatModKey,
    float StatModValue,
    uint SpellSet,
    ushort HasSpellSet)
{
    internal const int Size = 60;

    internal static Enchantment Read(ref WireReader reader)
    {
        ushort spell = reader.ReadUInt16(), layer = reader.ReadUInt16(), category = reader.ReadUInt16(), hasSpellSet = reader.ReadUInt16();
        return new Enchantment(
            spell, layer, category, reader.ReadUInt32(), reader.ReadDouble(), reader.ReadDouble(), reader.ReadUInt32(),
            reader.ReadSingle(), reader.ReadSingle(), reader.ReadDouble(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadSingle(),
            hasSpellSet != 0 ? reader.ReadUInt32() : 0, hasSpellSet);
    }

    internal static void Write(ref WireWriter writer, Enchantment enchantment) => enchantment.Write(ref writer);

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Spell);
        writer.WriteUInt16(Layer);
        writer.WriteUInt16(Category);
        writer.WriteUInt16(HasSpellSet);
        writer.WriteUInt32(Power);
        writer.WriteDouble(Start);
        writer.WriteDouble(Duration);
        writer.WriteUInt32(Caster);
        writer.WriteSingle(DegradeModifier);
        writer.WriteSingle(DegradeLimit);
        writer.WriteDouble(LastDegraded);
        writer.WriteUInt32(StatModType);
        writer.WriteUInt32(StatModKey);
        writer.WriteSingle(StatModValue);
        if (HasSpellSet != 0)
            writer.WriteUInt32(SpellSet);
    }
}
