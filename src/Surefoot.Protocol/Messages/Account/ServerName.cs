namespace Surefoot.Protocol.Messages;

/// <summary>Name of the server's world (specification 08, 3.4).</summary>
/// <param name="Online">Players online.</param>
/// <param name="Most">Players that it takes.</param>
/// <param name="Name">Name of the world.</param>
public readonly record struct ServerName(int Online, int Most, string Name) : IInterfaceMessage<ServerName>
{
    static Opcode IInterfaceMessage<ServerName>.Opcode => Opcode.ServerName;

    static ServerName IMessage<ServerName>.Read(ref WireReader reader)
        => new(reader.ReadInt32(), reader.ReadInt32(), reader.ReadString16());

    void IMessage<ServerName>.Write(ref WireWriter writer)
    {
        writer.WriteInt32(Online);
        writer.WriteInt32(Most);
        writer.WriteString16(Name);
    }
}
