using System.Buffers.Binary;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Conformance;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Tool.Tests.Sniffing;

/// <summary>A form that capture files have.</summary>
/// <param name="Blocks">pcapng; else pcap.</param>
/// <param name="Swapped">Written on a machine of the other byte order.</param>
/// <param name="LinkType">1 Ethernet, 101 IP alone, 113 Linux "any", 276 its second version.</param>
/// <param name="Nanoseconds">Times in nanoseconds; else microseconds.</param>
public sealed record CaptureForm(bool Blocks, bool Swapped, ushort LinkType, bool Nanoseconds);

/// <summary>Writes recorded sessions as the capture files that tcpdump would have written of them.</summary>
internal sealed class CaptureWriter(CaptureForm form)
{
    private const uint Client = 0x7F000002, Server = 0x7F000001;
    private const ushort ClientPort = 51000, FirstPort = 9300;
    private readonly List<byte> file = [];

    /// <summary>A recorded session as a file.</summary>
    internal static byte[] Write(CaptureForm form, Capture session, double start)
    {
        var writer = new CaptureWriter(form);
        writer.Begin();
        foreach (CapturedDatagram datagram in session.Datagrams.Where(datagram => !datagram.Lost))
            writer.Add(start + datagram.Time, datagram);
        return [.. writer.file];
    }

    /// <summary>A session of tests/data/wire-captures.</summary>
    internal static Capture Recorded(string name)
    {
        using VectorFile file = VectorFile.Open(Repository.PathOf("tests", "data", "wire-captures", $"{name}.jsonl.gz"));
        return Capture.Load(file);
    }

    private void Begin()
    {
        if (form.Blocks)
        {
            Block(0x0A0D0D0A, [.. U32(0x1A2B3C4D), .. U16(1), .. U16(0), .. U32(uint.MaxValue), .. U32(uint.MaxValue)]);
            byte[] options = form.Nanoseconds ? [.. U16(9), .. U16(1), 9, 0, 0, 0, .. U32(0)] : [];
            Block(1, [.. U16(form.LinkType), .. U16(0), .. U32(0), .. options]);
        }
        else
        {
            uint magic = form.Nanoseconds ? 0xA1B23C4D : 0xA1B2C3D4;
            file.AddRange([.. U32(magic), .. U16(2), .. U16(4), .. U32(0), .. U32(0), .. U32(65535), .. U32(form.LinkType)]);
        }
    }

    private void Add(double time, CapturedDatagram datagram)
    {
        byte[] frame = [.. Link(), .. Ip(datagram)];
        ulong ticks = (ulong)Math.Round(time * (form.Nanoseconds ? 1e9 : 1e6));
        if (form.Blocks)
        {
            byte[] padding = new byte[-frame.Length & 3];
            byte[] length = U32((uint)frame.Length);
            Block(6, [.. U32(0), .. U32((uint)(ticks >> 32)), .. U32((uint)ticks), .. length, .. length, .. frame, .. padding]);
            return;
        }

        ulong second = form.Nanoseconds ? 1_000_000_000u : 1_000_000u;
        file.AddRange([.. U32((uint)(ticks / second)), .. U32((uint)(ticks % second))]);
        file.AddRange([.. U32((uint)frame.Length), .. U32((uint)frame.Length), .. frame]);
    }

    private void Block(uint type, byte[] body)
    {
        byte[] length = U32((uint)body.Length + 12);
        file.AddRange([.. U32(type), .. length, .. body, .. length]);
    }

    // What is on the wire is big-endian whatever machine writes the file.
    private byte[] Link() => form.LinkType switch
    {
        1 => [.. new byte[12], 0x08, 0x00],
        113 => [0, 0, 0x03, 0x04, 0, 6, .. new byte[8], 0x08, 0x00],
        276 => [0x08, 0x00, 0, 0, 0, 0, 0, 1, 0x03, 0x04, 0, 6, .. new byte[8]],
        _ => [],
    };

    private static byte[] Ip(CapturedDatagram datagram)
    {
        byte[] payload = datagram.Bytes;
        bool toServer = datagram.Direction == WireDirection.ClientToServer;
        ushort serverPort = (ushort)(FirstPort + (datagram.Port == ServerPort.First ? 0 : 1));
        byte[] bytes = new byte[28 + payload.Length];
        bytes[0] = 0x45;
        BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(2), (ushort)bytes.Length);
        bytes[8] = 64;
        bytes[9] = 17;
        BinaryPrimitives.WriteUInt32BigEndian(bytes.AsSpan(12), toServer ? Client : Server);
        BinaryPrimitives.WriteUInt32BigEndian(bytes.AsSpan(16), toServer ? Server : Client);
        BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(20), toServer ? ClientPort : serverPort);
        BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(22), toServer ? serverPort : ClientPort);
        BinaryPrimitives.WriteUInt16BigEndian(bytes.AsSpan(24), (ushort)(8 + payload.Length));
        payload.CopyTo(bytes, 28);
        return bytes;
    }

    private byte[] U32(uint value) => BitConverter.GetBytes(form.Swapped ? BinaryPrimitives.ReverseEndianness(value) : value);

    private byte[] U16(ushort value) => BitConverter.GetBytes(form.Swapped ? BinaryPrimitives.ReverseEndianness(value) : value);
}
