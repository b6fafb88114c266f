using System.Runtime.InteropServices;
using System.Security.Cryptography;
using System.Text.Json;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Captures;

/// <summary>Whole recorded sessions with a server of the field: every byte is explained.</summary>
public class CaptureTests
{
    public static TheoryData<string> Sessions => Capture.All;

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.packets", "08, 2")]
    public void Headers_sums_keys_options_and_fragments_of_every_recorded_datagram_are_found(string session)
    {
        Capture capture = Capture.Load(session);
        foreach (CapturedDatagram captured in capture.Datagrams)
        {
            JsonElement expected = captured.Expected;
            Assert.Equal(DropReason.None, Datagram.TryParse(captured.Bytes, out Datagram datagram));
            PacketHeader header = datagram.Header;
            Fields found = new()
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
            string? difference = found.DifferenceFrom(expected);
            Assert.True(difference is null, $"datagram {expected.GetProperty("i")}{difference}");
        }
    }

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.verdicts", "08, 2.6 and 10")]
    public void The_receiver_takes_exactly_the_datagrams_that_count_with_exactly_their_keys(string session)
    {
        Capture capture = Capture.Load(session);
        var tap = new WireTap();
        foreach (CapturedDatagram captured in capture.Datagrams.Where(datagram => !datagram.Lost))
        {
            TapReport report = tap.Observe(captured.Direction, captured.Bytes, new Nobody());
            string verdict = !report.IsVerified ? "unverifiable" : report.Reason switch
            {
                DropReason.None => "accept",
                DropReason.Duplicate => "duplicate",
                _ => report.Reason.ToString(),
            };
            string where = $"datagram {captured.Expected.GetProperty("i")}: ";
            Assert.Equal(where + captured.Expected.GetProperty("verdict").GetString(), where + verdict);
            if (report is { Reason: DropReason.None, IsVerified: true })
                Assert.Equal(where + captured.Expected.GetProperty("key"), where + report.KeyIndex);
        }
    }

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.messages", "08, 2.5 and 3 to 7")]
    public void The_messages_of_every_recorded_session_are_found_in_order_with_all_their_fields(string session)
    {
        Capture capture = Capture.Load(session);
        var tap = new WireTap();
        var messages = new Messages();
        foreach (CapturedDatagram captured in capture.Datagrams.Where(datagram => !datagram.Lost))
        {
            messages.Note(captured);
            tap.Observe(captured.Direction, captured.Bytes, messages);
        }

        JsonElement[] expected = [.. capture.Messages];
        for (int i = 0; i < Math.Min(expected.Length, messages.Found.Count); i++)
        {
            string? difference = messages.Found[i].DifferenceFrom(expected[i]);
            Assert.True(difference is null, $"message {i} {expected[i].GetProperty("name")}{difference}");
        }

        Assert.Equal(expected.Length, messages.Found.Count);
    }

    private static bool IsValid(Capture capture, CapturedDatagram captured, in Datagram datagram)
    {
        if (!datagram.Header.IsEncrypted)
            return datagram.IsIntact;
        var keys = new KeyStream(capture.Seed(captured.Direction)!.Value);
        uint word = 0;
        for (int left = captured.Expected.GetProperty("key").GetInt32(); left >= 0; left--)
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
        if (datagram.Has(PacketFlags.LoginRequest))
            options["loginRequest"] = Of(LoginRequest.TryRead(datagram.Handshake)!, datagram.Handshake.Length);
        if (datagram.Has(PacketFlags.ConnectRequest))
            options["connectRequest"] = Of(ConnectRequest.Read(datagram.Handshake));
        if (datagram.Has(PacketFlags.ConnectResponse))
            options["connectResponse"] = new Fields { ["cookie"] = Cookie(BitConverter.ToUInt64(datagram.Handshake)) };
        return options;
    }

    private static Fields Of(LoginRequest login, int length)
    {
        var writer = new WireWriter(new byte[256]);
        login.Write(ref writer);
        Assert.Equal(length, writer.Position);
        return new Fields
        {
            ["version"] = login.Version,
            ["bytes"] = length - 8 - 4,
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

    private sealed class Nobody : ITapReceiver
    {
        public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message)
        {
        }
    }

    /// <summary>Collects messages in the form that the recordings have.</summary>
    private sealed class Messages : ITapReceiver
    {
        private readonly Dictionary<(WireDirection, uint, uint), List<(int Datagram, int Index)>> arrivals = [];

        public List<Fields> Found { get; } = [];

        /// <summary>Takes note of the fragments of a datagram that is about to be looked at.</summary>
        public void Note(CapturedDatagram captured)
        {
            int number = captured.Expected.GetProperty("i").GetInt32();
            foreach (JsonElement fragment in captured.Expected.GetProperty("fragments").EnumerateArray())
            {
                var key = (captured.Direction, fragment.GetProperty("sequence").GetUInt32(), fragment.GetProperty("id").GetUInt32());
                int index = fragment.GetProperty("index").GetInt32();
                if (!arrivals.TryGetValue(key, out List<(int Datagram, int Index)>? parts))
                    arrivals.Add(key, parts = []);
                if (parts.All(part => part.Index != index))
                    parts.Add((number, index));
            }
        }

        public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message)
        {
            ReadMessage? read = CaptureFields.Read(direction, message);
            if (read is not null)
            {
                Assert.Equal(0, read.Unread);
                Assert.Equal(Hex.Of(message.Bytes), Hex.Of(read.Again));
            }

            arrivals.Remove((direction, fragment.Sequence, fragment.Id), out List<(int Datagram, int Index)>? parts);
            bool isWrapped = message.Id.Opcode is Opcode.GameAction or Opcode.GameEvent;
            Found.Add(new Fields
            {
                ["i"] = Found.Count,
                ["dir"] = direction == WireDirection.ClientToServer ? "c2s" : "s2c",
                ["datagrams"] = parts!.Select(part => part.Datagram).Distinct(),
                ["arrival"] = fragment.Count > 1 ? parts!.Select(part => part.Index) : null,
                ["unread"] = read?.Fields is null ? message.Body.Length : read.Unread,
                ["queue"] = (ushort)fragment.Group,
                ["sequence"] = fragment.Sequence,
                ["id"] = fragment.Id,
                ["fragments"] = fragment.Count,
                ["length"] = message.Bytes.Length,
                ["sha256"] = Convert.ToHexStringLower(SHA256.HashData(message.Bytes)),
                ["opcode"] = (uint)message.Id.Opcode,
                ["name"] = message.Id.ToString(),
                ["guid"] = message.Id.Opcode == Opcode.GameEvent ? message.Guid : null,
                ["stamp"] = isWrapped ? message.Stamp : null,
                ["event"] = message.Id.Opcode == Opcode.GameEvent ? message.Id.Inner : null,
                ["action"] = message.Id.Opcode == Opcode.GameAction ? message.Id.Inner : null,
                ["fields"] = read?.Fields,
            });
        }
    }
}
