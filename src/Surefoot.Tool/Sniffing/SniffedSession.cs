using System.Net;
using System.Text.Json.Nodes;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Sniffing;

/// <summary>Something that a session said.</summary>
/// <param name="Time">Seconds since the session's first datagram.</param>
/// <param name="Session">Which session, from 1.</param>
/// <param name="Direction">Who said it.</param>
/// <param name="Number">Number of the packet; 0 for those without one.</param>
/// <param name="Name">Name of the message, or of what the packet's header says.</param>
/// <param name="Fields">What it carries; null when that is not known.</param>
/// <param name="Bytes">Its bytes; null where they hold a secret.</param>
internal sealed record SniffedEvent(
    double Time, int Session, WireDirection Direction, uint Number, string Name, JsonNode? Fields, byte[]? Bytes);

/// <summary>One client's session with a server, as somebody between them sees it.</summary>
internal sealed class SniffedSession(int number, IPEndPoint client, IPEndPoint server, double start, MessageCatalog catalog) : ITapReceiver
{
    private const string Hidden = "(hidden)";

    // Texts in which people give passwords to a server's console.
    private static readonly string[] SecretCommands = ["password", "passwd", "accountcreate"];

    private readonly WireTap tap = new();
    private readonly List<SniffedEvent> events = [];
    private uint packet;
    private double now;

    /// <summary>Which session, from 1.</summary>
    internal int Number => number;

    /// <summary>The client.</summary>
    internal IPEndPoint Client => client;

    /// <summary>The server; its second port is the next one.</summary>
    internal IPEndPoint Server => server;

    /// <summary>When it began, seconds since 1970.</summary>
    internal double Start => start;

    /// <summary>What the datagram that was looked at last said.</summary>
    internal IReadOnlyList<SniffedEvent> Events => events;

    /// <summary>How many datagrams were seen.</summary>
    internal int Datagrams { get; private set; }

    /// <summary>The server has taken the login.</summary>
    internal bool IsAnswered => tap.Session is not null;

    /// <summary>Datagrams that their receiver does not use, by reason.</summary>
    internal SortedDictionary<DropReason, int> Dropped { get; } = [];

    /// <summary>Looks at a datagram and gives what it says.</summary>
    internal IReadOnlyList<SniffedEvent> Observe(SniffedDatagram seen, WireDirection direction, bool withPackets)
    {
        events.Clear();
        Datagrams++;
        now = seen.Time - start;
        packet = 0;
        if (Datagram.TryParse(seen.Bytes, out Datagram datagram) == DropReason.None)
        {
            packet = datagram.Header.Sequence;
            AddHandshake(direction, datagram);
        }

        int before = events.Count;
        TapReport report = tap.Observe(direction, seen.Bytes, this);
        if (report.Reason != DropReason.None)
            Dropped[report.Reason] = Dropped.GetValueOrDefault(report.Reason) + 1;
        if (withPackets)
            events.Insert(before, PacketEvent(direction, datagram, report, seen.Bytes));
        return events;
    }

    /// <inheritdoc/>
    public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message)
    {
        JsonNode? fields = catalog.Fields(message);
        bool secret = message.Id.Action == GameActionType.Talk && Conceal(fields);
        events.Add(new SniffedEvent(
            now, number, direction, packet, message.Id.ToString(), fields, secret ? null : message.Bytes.ToArray()));
    }

    private static bool Conceal(JsonNode? talk)
    {
        string text = talk?["text"]?.GetValue<string>() ?? "";
        if (!SecretCommands.Any(command => text.Contains(command, StringComparison.OrdinalIgnoreCase)))
            return false;
        talk!["text"] = $"{text.Split(' ')[0]} {Hidden}";
        return true;
    }

    private void AddHandshake(WireDirection direction, in Datagram datagram)
    {
        if (datagram.Has(PacketFlags.LoginRequest) && LoginRequest.TryRead(datagram.Handshake) is { } login)
            Add(direction, "LoginRequest", new() { ["version"] = login.Version, ["account"] = login.Account, ["password"] = Hidden });
        if (datagram.Has(PacketFlags.ConnectRequest))
            Add(direction, "ConnectRequest", new() { ["netId"] = ConnectRequest.Read(datagram.Handshake).NetId });
        if (datagram.Has(PacketFlags.ConnectResponse))
            Add(direction, "ConnectResponse", []);
        if (datagram.Has(PacketFlags.Disconnect))
            Add(direction, "Disconnect", []);
    }

    private void Add(WireDirection direction, string name, JsonObject fields)
        => events.Add(new SniffedEvent(now, number, direction, packet, name, fields, null));

    private SniffedEvent PacketEvent(WireDirection direction, in Datagram datagram, in TapReport report, byte[] bytes)
    {
        JsonObject fields = new() { ["flags"] = report.Header.Flags.ToString(), ["bytes"] = bytes.Length };
        if (report.KeyIndex is { } key)
            fields["key"] = key;
        if (datagram.Has(PacketFlags.AckSequence))
            fields["ack"] = datagram.Ack;
        if (report.Reason != DropReason.None)
            fields["dropped"] = report.Reason.ToString();
        return new SniffedEvent(now, number, direction, packet, "packet", fields, null);
    }
}
