using System.Buffers.Binary;

namespace Surefoot.Protocol.Session;

/// <summary>Builds one datagram after the other in the same memory: optional headers in ascending order of their flags, then
/// fragments.</summary>
internal sealed class PacketBuilder
{
    /// <summary>Most bytes behind the header.</summary>
    public const int MostBody = 464;

    /// <summary>Most bytes of a datagram.</summary>
    public const int MostLength = PacketHeader.Length + MostBody;

    private readonly byte[] bytes = new byte[MostLength];
    private PacketFlags flags;
    private uint hash;
    private int length = PacketHeader.Length;

    /// <summary>Nothing has been added.</summary>
    public bool IsEmpty => flags == 0;

    /// <summary>Bytes that can be added.</summary>
    public int Room => MostLength - length;

    /// <summary>Sum of what has been added.</summary>
    public uint PayloadHash => hash;

    /// <summary>Begins a new one.</summary>
    public void Clear()
    {
        flags = 0;
        hash = 0;
        length = PacketHeader.Length;
    }

    /// <summary>Adds an optional header without a body.</summary>
    public void Add(PacketFlags flag) => flags |= flag;

    /// <summary>Adds an optional header.</summary>
    public void Add(PacketFlags flag, scoped ReadOnlySpan<byte> body)
    {
        flags |= flag;
        body.CopyTo(bytes.AsSpan(length));
        hash += Hash32.Of(body);
        length += body.Length;
    }

    /// <summary>Adds an optional header of a number.</summary>
    public void Add(PacketFlags flag, uint value)
    {
        Span<byte> body = stackalloc byte[4];
        BinaryPrimitives.WriteUInt32LittleEndian(body, value);
        Add(flag, body);
    }

    /// <summary>Adds an optional header of a clock.</summary>
    public void Add(PacketFlags flag, double seconds)
    {
        Span<byte> body = stackalloc byte[8];
        BinaryPrimitives.WriteDoubleLittleEndian(body, seconds);
        Add(flag, body);
    }

    /// <summary>Adds a counted list of numbers.</summary>
    public void Add(PacketFlags flag, ReadOnlySpan<uint> numbers)
    {
        Span<byte> body = stackalloc byte[4 + (4 * numbers.Length)];
        BinaryPrimitives.WriteUInt32LittleEndian(body, (uint)numbers.Length);
        for (int i = 0; i < numbers.Length; i++)
            BinaryPrimitives.WriteUInt32LittleEndian(body[(4 + (4 * i))..], numbers[i]);
        Add(flag, body);
    }

    /// <summary>Adds a fragment.</summary>
    public void Add(FragmentHeader fragment, ReadOnlySpan<byte> data)
    {
        flags |= PacketFlags.BlobFragments;
        Span<byte> target = bytes.AsSpan(length);
        fragment.Write(target);
        data.CopyTo(target[FragmentHeader.Length..]);
        hash += Hash32.Of(target[..FragmentHeader.Length]) + Hash32.Of(data);
        length += fragment.Size;
    }

    /// <summary>Completes a cleartext datagram.</summary>
    /// <returns>The datagram, until the next <see cref="Clear"/>.</returns>
    public ReadOnlySpan<byte> Seal(uint sequence, ushort id, ushort time, ushort iteration)
        => SealSummed(sequence, id, time, iteration, hash);

    /// <summary>Completes a datagram whose checksum is mixed with a word of the key stream.</summary>
    /// <returns>The datagram, until the next <see cref="Clear"/>.</returns>
    public ReadOnlySpan<byte> Seal(uint sequence, ushort id, ushort time, ushort iteration, uint key)
    {
        flags |= PacketFlags.EncryptedChecksum;
        return SealSummed(sequence, id, time, iteration, hash ^ key);
    }

    /// <summary>Marks a kept packet as sent again and renews its checksum.</summary>
    public static ReadOnlySpan<byte> Renew(SentPacket packet)
    {
        PacketHeader header = PacketHeader.Read(packet.Bytes);
        header = header with { Flags = header.Flags | PacketFlags.Retransmission };
        uint sum = header.IsEncrypted ? packet.PayloadHash ^ packet.Key : packet.PayloadHash;
        (header with { Checksum = header.Hash() + sum }).Write(packet.Bytes);
        return packet.Bytes.AsSpan(0, packet.Length);
    }

    private ReadOnlySpan<byte> SealSummed(uint sequence, ushort id, ushort time, ushort iteration, uint sum)
    {
        var header = new PacketHeader(sequence, flags, 0, id, time, (ushort)(length - PacketHeader.Length), iteration);
        (header with { Checksum = header.Hash() + sum }).Write(bytes);
        return bytes.AsSpan(0, length);
    }
}
