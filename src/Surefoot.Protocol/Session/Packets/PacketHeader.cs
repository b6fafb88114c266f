using System.Buffers.Binary;

namespace Surefoot.Protocol.Session;

/// <summary>The first 20 bytes of a datagram (specification 08, 2.1).</summary>
/// <param name="Sequence">Number of the packet; 0 in the handshake.</param>
/// <param name="Flags">What it carries.</param>
/// <param name="Checksum">Sum over everything.</param>
/// <param name="Id">From a server its own id, from a client the number that the server gave it.</param>
/// <param name="Time">The sender's interval.</param>
/// <param name="Size">Bytes behind the header.</param>
/// <param name="Iteration">As the connect request had it; 0 before.</param>
public readonly record struct PacketHeader(
    uint Sequence,
    PacketFlags Flags,
    uint Checksum,
    ushort Id,
    ushort Time,
    ushort Size,
    ushort Iteration)
{
    /// <summary>Bytes of a header.</summary>
    public const int Length = 20;

    private const uint ChecksumPlaceholder = 0xBADD70DD;

    /// <summary>The checksum is mixed with a word of the key stream.</summary>
    public bool IsEncrypted => (Flags & PacketFlags.EncryptedChecksum) != 0;

    /// <summary>Sum of the header, whatever checksum it holds.</summary>
    /// <remarks>Retail: SharedNet::ChecksumHeader @0x00541990.</remarks>
    internal uint Hash()
    {
        Span<byte> bytes = stackalloc byte[Length];
        (this with { Checksum = ChecksumPlaceholder }).Write(bytes);
        return Hash32.Of(bytes);
    }

    /// <summary>Reads a header; the caller has seen to it that the bytes are there.</summary>
    internal static PacketHeader Read(ReadOnlySpan<byte> bytes) => new(
        BinaryPrimitives.ReadUInt32LittleEndian(bytes),
        (PacketFlags)BinaryPrimitives.ReadUInt32LittleEndian(bytes[4..]),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[8..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[12..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[14..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[16..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[18..]));

    /// <summary>Writes the header.</summary>
    internal void Write(Span<byte> bytes)
    {
        BinaryPrimitives.WriteUInt32LittleEndian(bytes, Sequence);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[4..], (uint)Flags);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[8..], Checksum);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[12..], Id);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[14..], Time);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[16..], Size);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[18..], Iteration);
    }
}
