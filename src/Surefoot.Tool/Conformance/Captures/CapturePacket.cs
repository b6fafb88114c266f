using System.Runtime.InteropServices;
using System.Text.Json;
using Surefoot.Protocol;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>Names what a datagram says as the recordings do.</summary>
internal static class CapturePacket
{
    /// <summary>What a datagram says.</summary>
    internal static Fields Of(Capture capture, CapturedDatagram captured, in Datagram datagram)
    {
        JsonElement expected = captured.Expected;
        PacketHeader header = datagram.Header;
        return new Fields
        {
            ["sequence"] = header.Sequence,
            ["flags"] = (uint)header.Flags,
            ["checksum"] = header.Checksum,
            ["id"] = header.Id,
            ["time"] = header.Time,
            ["size"] = header.Size,
            ["iteration"] = header.Iteration,
            ["headerHash"] = header.Hash(),
            ["payloadHash"] = datagram.PayloadHash,
            ["options"] = OptionsOf(datagram),
            ["fragments"] = FragmentsOf(datagram),
            ["i"] = expected.GetProperty("i").GetInt32(),
            ["dir"] = expected.GetProperty("dir").GetString(),
            ["flagNames"] = FlagNames(header.Flags),
            ["messages"] = expected.GetProperty("messages").EnumerateArray().Select(message => message.GetInt32()),
            ["verdict"] = expected.GetProperty("verdict").GetString(),
            ["valid"] = capture.Seed(captured.Direction) is null && header.IsEncrypted ? null : IsValid(capture, captured, datagram),
            ["key"] = expected.GetProperty("key") is { ValueKind: JsonValueKind.Number } key ? key.GetInt32() : null,
        };
    }

    private static bool IsValid(Capture capture, CapturedDatagram captured, in Datagram datagram)
    {
        if (!datagram.Header.IsEncrypted)
            return datagram.IsIntact;

        // No datagram uses more than one key.
        int index = captured.Expected.GetProperty("key").GetInt32();
        if (index < 0 || index >= capture.Datagrams.Length)
            return false;
        var keys = new KeyStream(capture.Seed(captured.Direction)!.Value);
        uint word = 0;
        for (int left = index; left >= 0; left--)
            word = keys.Next();
        return datagram.Key == word;
    }

    private static IEnumerable<string> FlagNames(PacketFlags flags) => Enum.GetValues<PacketFlags>()
        .Where(flag => flag != PacketFlags.None && (flags & flag) != 0)
        .Select(flag => flag == PacketFlags.CicmdCommand ? "CICMDCommand" : flag.ToString());

    private static List<Fields> FragmentsOf(in Datagram datagram)
    {
        List<Fields> fragments = [];
        foreach (Datagram.Fragment fragment in datagram.Fragments)
        {
            fragments.Add(new Fields
            {
                ["sequence"] = fragment.Header.Sequence,
                ["id"] = fragment.Header.Id,
                ["count"] = fragment.Header.Count,
                ["size"] = fragment.Header.Size,
                ["index"] = fragment.Header.Index,
                ["queue"] = (ushort)fragment.Header.Group,
            });
        }

        return fragments;
    }

    private static Fields OptionsOf(in Datagram datagram)
    {
        var options = new Fields
        {
            ["requestRetransmit"] = datagram.Has(PacketFlags.RequestRetransmit) ? Numbers(datagram.Requested) : null,
            ["rejectRetransmit"] = datagram.Has(PacketFlags.RejectRetransmit) ? Numbers(datagram.Rejected) : null,
            ["ack"] = datagram.Has(PacketFlags.AckSequence) ? datagram.Ack : null,
            ["cicmd"] = datagram.Has(PacketFlags.CicmdCommand) ? new[] { datagram.Cicmd.Command, datagram.Cicmd.Parameter } : null,
            ["timeSync"] = datagram.Has(PacketFlags.TimeSync) ? datagram.TimeSync : null,
            ["echoRequest"] = datagram.Has(PacketFlags.EchoRequest) ? datagram.Echo : null,
            ["echoResponse"] = datagram.Has(PacketFlags.EchoResponse) ? new[] { datagram.Echo, datagram.EchoHold } : null,
            ["flow"] = datagram.Has(PacketFlags.Flow)
                ? new Fields { ["bytes"] = datagram.Flow.Bytes, ["interval"] = datagram.Flow.Interval }
                : null,
        };
        if (datagram.Has(PacketFlags.LoginRequest) && LoginRequest.TryRead(datagram.Handshake) is { } login)
            options["loginRequest"] = Of(login, datagram.Handshake.Length);
        if (datagram.Has(PacketFlags.ConnectRequest))
            options["connectRequest"] = Of(ConnectRequest.Read(datagram.Handshake));
        if (datagram.Has(PacketFlags.ConnectResponse))
            options["connectResponse"] = new Fields { ["cookie"] = Cookie(BitConverter.ToUInt64(datagram.Handshake)) };
        return options;
    }

    private static Fields Of(LoginRequest login, int length)
    {
        var writer = new WireWriter(new byte[Math.Max(length, 256)]);
        login.Write(ref writer);
        return new Fields
        {
            ["version"] = login.Version,
            ["bytes"] = writer.Position - 8 - 4,
            ["authType"] = login.AuthType,
            ["authFlags"] = login.AuthFlags,
            ["stamp"] = login.Stamp,
            ["account"] = login.Account,
            ["crypto"] = 0,
            ["password"] = login.Password,
            ["padding"] = -(1 + login.Password.Length) & 3,
        };
    }

    private static Fields Of(ConnectRequest request) => new()
    {
        ["serverTime"] = request.ServerTime,
        ["cookie"] = Cookie(request.Cookie),
        ["netId"] = request.NetId,
        ["serverSeed"] = request.ServerSeed,
        ["clientSeed"] = request.ClientSeed,
        ["zero"] = 0,
    };

    private static string Cookie(ulong cookie) => $"0x{cookie:X16}";

    private static uint[] Numbers(ReadOnlySpan<byte> bytes) => MemoryMarshal.Cast<byte, uint>(bytes).ToArray();
}
