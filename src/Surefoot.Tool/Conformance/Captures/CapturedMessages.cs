using System.Security.Cryptography;
using System.Text.Json;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>Collects the messages of a session in the form that the recordings have.</summary>
internal sealed class CapturedMessages : ITapReceiver
{
    private readonly Dictionary<(WireDirection, uint, uint), List<(int Datagram, int Index)>> arrivals = [];

    /// <summary>The messages in the order of their completion, and what is wrong with one by itself.</summary>
    public List<(Fields Fields, string? Fault)> Found { get; } = [];

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

    /// <inheritdoc/>
    public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message)
    {
        ReadMessage? read = CaptureFields.Read(direction, message);
        if (!arrivals.Remove((direction, fragment.Sequence, fragment.Id), out List<(int Datagram, int Index)>? parts))
            parts = [];
        bool isWrapped = message.Id.Opcode is Opcode.GameAction or Opcode.GameEvent;
        Fields fields = new()
        {
            ["i"] = Found.Count,
            ["dir"] = direction == WireDirection.ClientToServer ? "c2s" : "s2c",
            ["datagrams"] = parts.Select(part => part.Datagram).Distinct(),
            ["arrival"] = fragment.Count > 1 ? parts.Select(part => part.Index) : null,
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
        };
        Found.Add((fields, read?.Fault));
    }
}
