using System.Buffers.Binary;

namespace Surefoot.Tool.Sniffing;

/// <summary>One frame of a capture file.</summary>
/// <param name="Time">When it was seen, seconds since 1970; 0 where the file does not say.</param>
/// <param name="LinkType">What its first bytes are, by the numbers of tcpdump.org: 1 Ethernet, 101 IP, 113 and 276 Linux "any".</param>
/// <param name="Bytes">As much of it as was kept.</param>
internal readonly record struct CapturedFrame(double Time, ushort LinkType, byte[] Bytes);

/// <summary>Reads what tcpdump, dumpcap and Wireshark write: pcap and pcapng, of either byte order.</summary>
internal static class CaptureFile
{
    private const uint SectionHeader = 0x0A0D0D0A, ByteOrder = 0x1A2B3C4D, Microseconds = 0xA1B2C3D4, Nanoseconds = 0xA1B23C4D;

    // No frame of a network is longer, and no block of such a file.
    private const int MostBytes = 1 << 24;

    /// <summary>The frames in the order of the file. Where it ends in the middle of one, that one is left out.</summary>
    /// <param name="stream">The file, at its beginning.</param>
    /// <param name="name">Its name, for errors.</param>
    /// <exception cref="InvalidDataException">It is no capture file, or damaged.</exception>
    internal static IEnumerable<CapturedFrame> Read(Stream stream, string name)
    {
        byte[] start = new byte[4];
        if (stream.ReadAtLeast(start, 4, throwOnEndOfStream: false) < 4)
            throw NotOne(name);
        uint magic = BinaryPrimitives.ReadUInt32LittleEndian(start);
        if (magic == SectionHeader)
            return ReadBlocks(stream, name);
        bool swapped = BinaryPrimitives.ReverseEndianness(magic) is Microseconds or Nanoseconds;
        uint told = swapped ? BinaryPrimitives.ReverseEndianness(magic) : magic;
        if (told is not (Microseconds or Nanoseconds))
            throw NotOne(name);
        return ReadRecords(stream, name, swapped, told == Nanoseconds ? 1e-9 : 1e-6);
    }

    private static IEnumerable<CapturedFrame> ReadRecords(Stream stream, string name, bool swapped, double unit)
    {
        if (Take(stream, 20) is not { } rest)
            throw NotOne(name);
        ushort link = (ushort)Number(rest, 16, swapped);
        while (Take(stream, 16) is { } header)
        {
            double time = Number(header, 0, swapped) + (Number(header, 4, swapped) * unit);
            if (Take(stream, Length(Number(header, 8, swapped), name)) is not { } bytes)
                yield break;
            yield return new CapturedFrame(time, link, bytes);
        }
    }

    private static IEnumerable<CapturedFrame> ReadBlocks(Stream stream, string name)
    {
        const uint interfaces = 1, simple = 3, enhanced = 6;
        uint type = SectionHeader;
        bool swapped = false;
        List<(ushort Link, double Unit)> sources = [];
        do
        {
            if (Take(stream, 4) is not { } lengthBytes)
                yield break;
            byte[]? order = null;
            if (type == SectionHeader)
            {
                // A section chooses its own byte order, and counts its interfaces anew.
                if ((order = Take(stream, 4)) is null)
                    yield break;
                swapped = Number(order, 0, swapped: true) == ByteOrder;
                if (!swapped && Number(order, 0, swapped: false) != ByteOrder)
                    throw NotOne(name);
                sources.Clear();
            }

            int length = Length(Number(lengthBytes, 0, swapped), name) - 8 - (order?.Length ?? 0);
            if (length < 4)
                throw new InvalidDataException($"{name}: a block is shorter than its own header: the file is damaged.");
            if (Take(stream, length) is not { } block)
                yield break;
            if (type == interfaces && block.Length >= 12)
            {
                sources.Add(((ushort)Short(block, 0, swapped), UnitOf(block, swapped)));
            }
            else if (type == enhanced && block.Length >= 24)
            {
                int size = (int)Math.Min(Number(block, 12, swapped), (uint)block.Length - 24);
                ulong time = ((ulong)Number(block, 4, swapped) << 32) | Number(block, 8, swapped);
                (ushort link, double unit) = Source(sources, Number(block, 0, swapped), name);
                yield return new CapturedFrame(time * unit, link, block[20..(20 + size)]);
            }
            else if (type == simple && block.Length >= 8)
            {
                int size = (int)Math.Min(Number(block, 0, swapped), (uint)block.Length - 8);
                yield return new CapturedFrame(0, Source(sources, 0, name).Link, block[4..(4 + size)]);
            }

            if (Take(stream, 4) is not { } next)
                yield break;
            type = Number(next, 0, swapped);
        }
        while (true);
    }

    private static (ushort Link, double Unit) Source(List<(ushort Link, double Unit)> sources, uint index, string name)
        => index < sources.Count ? sources[(int)index]
            : throw new InvalidDataException($"{name}: a frame came from an interface that the file does not describe: it is damaged.");

    // Option 9 of an interface: ticks of a second, 10 to this power, or 2 with the top bit; without it microseconds.
    private static double UnitOf(byte[] block, bool swapped)
    {
        const int resolution = 9;
        for (int at = 8; at + 4 <= block.Length - 4;)
        {
            int code = Short(block, at, swapped), length = Short(block, at + 2, swapped);
            if (code == 0 || at + 4 + length > block.Length - 4)
                break;
            if (code == resolution && length > 0)
                return Math.Pow((block[at + 4] & 0x80) != 0 ? 2 : 10, -(block[at + 4] & 0x7F));
            at += 4 + ((length + 3) & ~3);
        }

        return 1e-6;
    }

    private static byte[]? Take(Stream stream, int count)
    {
        byte[] bytes = new byte[count];
        return stream.ReadAtLeast(bytes, count, throwOnEndOfStream: false) == count ? bytes : null;
    }

    private static int Length(uint length, string name) => length <= MostBytes ? (int)length
        : throw new InvalidDataException($"{name}: something in it is {length:N0} bytes long: the file is damaged.");

    private static uint Number(byte[] bytes, int at, bool swapped)
    {
        uint value = BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(at));
        return swapped ? BinaryPrimitives.ReverseEndianness(value) : value;
    }

    private static int Short(byte[] bytes, int at, bool swapped)
    {
        ushort value = BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(at));
        return swapped ? BinaryPrimitives.ReverseEndianness(value) : value;
    }

    private static InvalidDataException NotOne(string name)
        => new($"{name}: not a capture file. Write one with tcpdump -w, dumpcap or Wireshark (pcap or pcapng).");
}
