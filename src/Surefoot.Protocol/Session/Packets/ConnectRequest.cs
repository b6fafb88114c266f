namespace Surefoot.Protocol.Session;

/// <summary>A server's answer to a login request (specification 08, 3.2).</summary>
/// <param name="ServerTime">The server's clock, seconds.</param>
/// <param name="Cookie">To be sent back to the second port.</param>
/// <param name="NetId">The client's number, of which 16 bits go into its headers; 0 is a number like others.</param>
/// <param name="ServerSeed">Seed of the server's key stream.</param>
/// <param name="ClientSeed">Seed of the client's key stream.</param>
public readonly record struct ConnectRequest(double ServerTime, ulong Cookie, uint NetId, uint ServerSeed, uint ClientSeed)
{
    /// <summary>Bytes of its body.</summary>
    internal const int Length = 32;

    internal static ConnectRequest Read(ReadOnlySpan<byte> body)
    {
        var reader = new WireReader(body);
        return new ConnectRequest(reader.ReadDouble(), reader.ReadUInt64(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteDouble(ServerTime);
        writer.WriteUInt64(Cookie);
        writer.WriteUInt32(NetId);
        writer.WriteUInt32(ServerSeed);
        writer.WriteUInt32(ClientSeed);
        writer.WriteUInt32(0);
    }
}
