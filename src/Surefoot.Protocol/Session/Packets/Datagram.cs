using System.Buffers.Binary;

namespace Surefoot.Protocol.Session;

/// <summary>The parts of one datagram (specification 08, section 2). It lives as long as the memory it looks at.</summary>
internal readonly ref struct Datagram
{
    private Datagram(PacketHeader header) => Header = header;

    /// <summary>The header.</summary>
    public PacketHeader Header { get; }

    /// <summary>Numbers asked for, four bytes each.</summary>
    internal ReadOnlySpan<byte> Requested { get; private init; }

    /// <summary>Numbers refused, four bytes each.</summary>
    internal ReadOnlySpan<byte> Rejected { get; private init; }

    /// <summary>The body of the handshake: a login request, connect request or connect response.</summary>
    internal ReadOnlySpan<byte> Handshake { get; private init; }

    /// <summary>Number up to which everything arrived.</summary>
    internal uint Ack { get; private init; }

    /// <summary>The sender's clock, seconds.</summary>
    internal double TimeSync { get; private init; }

    /// <summary>The client's clock, seconds; in a request or in a response.</summary>
    internal float Echo { get; private init; }

    /// <summary>The second number of an echo response.</summary>
    internal float EchoHold { get; private init; }

    /// <summary>Bytes received in an interval, and the interval.</summary>
    internal (uint Bytes, ushort Interval) Flow { get; private init; }

    /// <summary>The two numbers of a sign of life.</summary>
    internal (uint Command, uint Parameter) Cicmd { get; private init; }

    /// <summary>All fragments, one after the other.</summary>
    internal ReadOnlySpan<byte> FragmentBytes { get; private init; }

    /// <summary>Sum of everything but the header (specification 08, 2.3).</summary>
    /// <remarks>Retail: NetPacket::ComputeChecksum @0x005492B0.</remarks>
    internal uint PayloadHash { get; private init; }

    /// <summary>The word that the checksum was mixed with, if nothing is damaged.</summary>
    internal uint Key => (Header.Checksum - Header.Hash()) ^ PayloadHash;

    /// <summary>The checksum of a cleartext packet is right.</summary>
    internal bool IsIntact => Header.Checksum == Header.Hash() + PayloadHash;

    /// <summary>The fragments.</summary>
    internal FragmentEnumerable Fragments => new(FragmentBytes);

    /// <summary>Takes a datagram apart. Checksums are not looked at.</summary>
    internal static DropReason TryParse(ReadOnlySpan<byte> bytes, out Datagram datagram)
    {
        datagram = default;
        if (bytes.Length < PacketHeader.Length)
            return DropReason.TooShort;
        PacketHeader header = PacketHeader.Read(bytes);
        if (header.Size > bytes.Length - PacketHeader.Length)
            return DropReason.TooShort;

        var options = new OptionReader(bytes.Slice(PacketHeader.Length, header.Size), header.Flags);
        options.Take(PacketFlags.ServerSwitch, 8);
        options.Take(PacketFlags.LogonServerAddress, 16);
        options.Take(PacketFlags.Referral, 32);
        ReadOnlySpan<byte> requested = options.TakeNumbers(PacketFlags.RequestRetransmit);
        ReadOnlySpan<byte> rejected = options.TakeNumbers(PacketFlags.RejectRetransmit);
        ReadOnlySpan<byte> ack = options.Take(PacketFlags.AckSequence, 4);
        ReadOnlySpan<byte> login = options.Take(PacketFlags.LoginRequest, options.Rest.Length);
        options.Take(PacketFlags.WorldLoginRequest, 8);
        ReadOnlySpan<byte> request = options.Take(PacketFlags.ConnectRequest, ConnectRequest.Length);
        ReadOnlySpan<byte> response = options.Take(PacketFlags.ConnectResponse, 8);
        options.Take(PacketFlags.NetError, 8);
        options.Take(PacketFlags.NetErrorDisconnect, 8);
        ReadOnlySpan<byte> cicmd = options.Take(PacketFlags.CicmdCommand, 8);
        ReadOnlySpan<byte> timeSync = options.Take(PacketFlags.TimeSync, 8);
        ReadOnlySpan<byte> echo = options.Take(PacketFlags.EchoRequest, 4);
        ReadOnlySpan<byte> echoed = options.Take(PacketFlags.EchoResponse, 8);
        ReadOnlySpan<byte> flow = options.Take(PacketFlags.Flow, 6);
        bool hasFragments = (header.Flags & PacketFlags.BlobFragments) != 0;
        if (options.Failed || (!hasFragments && !options.Rest.IsEmpty))
            return DropReason.BadOptions;

        uint hash = options.Hash;
        if (hasFragments && !TryHashFragments(options.Rest, ref hash))
            return DropReason.BadFragment;

        datagram = new Datagram(header)
        {
            Requested = requested,
            Rejected = rejected,
            Ack = ack.IsEmpty ? 0 : BinaryPrimitives.ReadUInt32LittleEndian(ack),
            Handshake = !login.IsEmpty ? login : !request.IsEmpty ? request : response,
            Cicmd = cicmd.IsEmpty
                ? default
                : (BinaryPrimitives.ReadUInt32LittleEndian(cicmd), BinaryPrimitives.ReadUInt32LittleEndian(cicmd[4..])),
            TimeSync = timeSync.IsEmpty ? 0 : BinaryPrimitives.ReadDoubleLittleEndian(timeSync),
            Echo = !echo.IsEmpty ? BinaryPrimitives.ReadSingleLittleEndian(echo)
                : !echoed.IsEmpty ? BinaryPrimitives.ReadSingleLittleEndian(echoed) : 0,
            EchoHold = echoed.IsEmpty ? 0 : BinaryPrimitives.ReadSingleLittleEndian(echoed[4..]),
            Flow = flow.IsEmpty
                ? default
                : (BinaryPrimitives.ReadUInt32LittleEndian(flow), BinaryPrimitives.ReadUInt16LittleEndian(flow[4..])),
            FragmentBytes = options.Rest,
            PayloadHash = hash,
        };
        return DropReason.None;
    }

    /// <summary>The packet carries this.</summary>
    internal bool Has(PacketFlags flag) => (Header.Flags & flag) != 0;

    private static bool TryHashFragments(ReadOnlySpan<byte> rest, ref uint hash)
    {
        while (!rest.IsEmpty)
        {
            if (rest.Length < FragmentHeader.Length)
                return false;
            FragmentHeader fragment = FragmentHeader.Read(rest);
            if (!fragment.IsValid || fragment.Size > rest.Length)
                return false;
            hash += Hash32.Of(rest[..FragmentHeader.Length]) + Hash32.Of(rest[FragmentHeader.Length..fragment.Size]);
            rest = rest[fragment.Size..];
        }

        return true;
    }

    /// <summary>Takes optional headers from the front of a body and sums them up.</summary>
    private ref struct OptionReader(ReadOnlySpan<byte> body, PacketFlags flags)
    {
        public ReadOnlySpan<byte> Rest { get; private set; } = body;

        public uint Hash { get; private set; }

        public bool Failed { get; private set; }

        /// <summary>The body of an optional header; empty when the flag is not set or bytes are missing.</summary>
        public ReadOnlySpan<byte> Take(PacketFlags flag, int length)
        {
            if ((flags & flag) == 0 || Failed)
                return [];
            if (Rest.Length < length)
            {
                Failed = true;
                return [];
            }

            ReadOnlySpan<byte> taken = Rest[..length];
            Hash += Hash32.Of(taken);
            Rest = Rest[length..];
            return taken;
        }

        /// <summary>A counted list of numbers, without its count.</summary>
        public ReadOnlySpan<byte> TakeNumbers(PacketFlags flag)
        {
            long count = (flags & flag) != 0 && Rest.Length >= 4 ? BinaryPrimitives.ReadUInt32LittleEndian(Rest) : 0;
            ReadOnlySpan<byte> taken = Take(flag, (int)Math.Min(4 + (4 * count), int.MaxValue));
            return taken.IsEmpty ? taken : taken[4..];
        }
    }

    /// <summary>Walks over fragments that <see cref="TryParse"/> has found to be whole.</summary>
    internal readonly ref struct FragmentEnumerable(ReadOnlySpan<byte> bytes)
    {
        private readonly ReadOnlySpan<byte> bytes = bytes;

        public FragmentEnumerator GetEnumerator() => new(bytes);
    }

    /// <summary>Walks over fragments.</summary>
    internal ref struct FragmentEnumerator(ReadOnlySpan<byte> bytes)
    {
        private ReadOnlySpan<byte> rest = bytes;

        public Fragment Current { get; private set; }

        public bool MoveNext()
        {
            if (rest.IsEmpty)
                return false;
            FragmentHeader header = FragmentHeader.Read(rest);
            Current = new Fragment(header, rest[FragmentHeader.Length..header.Size]);
            rest = rest[header.Size..];
            return true;
        }
    }

    /// <summary>One fragment.</summary>
    internal readonly ref struct Fragment(FragmentHeader header, ReadOnlySpan<byte> data)
    {
        public FragmentHeader Header { get; } = header;

        public ReadOnlySpan<byte> Data { get; } = data;
    }
}
