namespace Surefoot.Protocol.Messages;

/// <summary>A refusal (specification 08, 3.5).</summary>
/// <param name="Code">1 account in use, 3 account, 4 server down, 9 invalid account, 0x0A unknown account, 0x0B no such character, 0x0D
/// character still in the world, 0x0F not your character, 0x14 cannot be placed, 0x15 server full.</param>
public readonly record struct CharacterError(uint Code) : IInterfaceMessage<CharacterError>
{
    static Opcode IInterfaceMessage<CharacterError>.Opcode => Opcode.CharacterError;

    static CharacterError IMessage<CharacterError>.Read(ref WireReader reader) => new(reader.ReadUInt32());

    void IMessage<CharacterError>.Write(ref WireWriter writer) => writer.WriteUInt32(Code);
}

/// <summary>The account is thrown out (specification 08, 3.5).</summary>
/// <param name="Reason">Why, beginning with a space; null when nothing is said.</param>
public readonly record struct AccountBoot(string? Reason) : IInterfaceMessage<AccountBoot>
{
    static Opcode IInterfaceMessage<AccountBoot>.Opcode => Opcode.AccountBoot;

    static AccountBoot IMessage<AccountBoot>.Read(ref WireReader reader) => new(reader.Remaining > 0 ? reader.ReadString16() : null);

    void IMessage<AccountBoot>.Write(ref WireWriter writer)
    {
        if (Reason is not null)
            writer.WriteString16(Reason);
    }
}

/// <summary>The account is banned (specification 08, 3.5).</summary>
/// <param name="SecondsLeft">For how long.</param>
/// <param name="Reason">Why; null when nothing is said.</param>
public readonly record struct AccountBanned(uint SecondsLeft, string? Reason) : IInterfaceMessage<AccountBanned>
{
    static Opcode IInterfaceMessage<AccountBanned>.Opcode => Opcode.AccountBanned;

    static AccountBanned IMessage<AccountBanned>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.Remaining > 0 ? reader.ReadString16() : null);

    void IMessage<AccountBanned>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(SecondsLeft);
        if (Reason is not null)
            writer.WriteString16(Reason);
    }
}
