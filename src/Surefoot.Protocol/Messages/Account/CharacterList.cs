namespace Surefoot.Protocol.Messages;

/// <summary>A character of an account.</summary>
/// <param name="Guid">Its object.</param>
/// <param name="Name">Its name; that of an administrator's character begins with '+'.</param>
/// <param name="Deletion">0 when it can be used, else seconds until it is deleted.</param>
public readonly record struct CharacterEntry(uint Guid, string Name, uint Deletion)
{
    internal static CharacterEntry Read(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadString16(), reader.ReadUInt32());

    internal static void Write(ref WireWriter writer, CharacterEntry entry)
    {
        writer.WriteUInt32(entry.Guid);
        writer.WriteString16(entry.Name);
        writer.WriteUInt32(entry.Deletion);
    }
}

/// <summary>The account's characters (specification 08, 3.4).</summary>
/// <param name="Status">Always 0.</param>
/// <param name="Characters">The characters, last played first.</param>
/// <param name="Others">A second set, always empty.</param>
/// <param name="Slots">How many characters the account may have.</param>
/// <param name="Account">The account's name as the server keeps it.</param>
/// <param name="UseTurbineChat">1 when there are chat channels.</param>
/// <param name="HasThroneOfDestiny">1 when the expansion is there.</param>
public readonly record struct CharacterList(
    uint Status,
    ValueList<CharacterEntry> Characters,
    ValueList<CharacterEntry> Others,
    uint Slots,
    string Account,
    uint UseTurbineChat,
    uint HasThroneOfDestiny) : IInterfaceMessage<CharacterList>
{
    static Opcode IInterfaceMessage<CharacterList>.Opcode => Opcode.CharacterList;

    static CharacterList IMessage<CharacterList>.Read(ref WireReader reader) => new(
        reader.ReadUInt32(), reader.ReadList(12, CharacterEntry.Read), reader.ReadList(12, CharacterEntry.Read),
        reader.ReadUInt32(), reader.ReadString16(), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<CharacterList>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Status);
        writer.WriteList(Characters, CharacterEntry.Write);
        writer.WriteList(Others, CharacterEntry.Write);
        writer.WriteUInt32(Slots);
        writer.WriteString16(Account);
        writer.WriteUInt32(UseTurbineChat);
        writer.WriteUInt32(HasThroneOfDestiny);
    }
}
