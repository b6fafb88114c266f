using System.Net;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Sniffing;

/// <summary>Finds the sessions in a capture: each begins with a login request, which also tells the server's port.</summary>
/// <param name="port">The server's first port, where sessions began before the capture; null to wait for login requests.</param>
internal sealed class Sniffer(int? port)
{
    private readonly Dictionary<(IPEndPoint Client, IPAddress Server, int Port), SniffedSession> current = [];
    private readonly List<SniffedSession> sessions = [];
    private readonly MessageCatalog catalog = new();

    /// <summary>All sessions, in the order in which they began.</summary>
    internal IReadOnlyList<SniffedSession> Sessions => sessions;

    /// <summary>Datagrams of nothing that is known as a session.</summary>
    internal int Strangers { get; private set; }

    /// <summary>Looks at a datagram and gives what it says.</summary>
    internal IReadOnlyList<SniffedEvent> Observe(SniffedDatagram datagram, bool withPackets)
    {
        if (Find(datagram) is not var (session, direction))
        {
            Strangers++;
            return [];
        }

        return session.Observe(datagram, direction, withPackets);
    }

    private (SniffedSession Session, WireDirection Direction)? Find(SniffedDatagram seen)
    {
        bool isLogin = Datagram.TryParse(seen.Bytes, out Datagram datagram) == DropReason.None && datagram.Has(PacketFlags.LoginRequest)
            && LoginRequest.TryRead(datagram.Handshake) is not null;
        if (isLogin)
            return (Begin(seen, seen.From, seen.To), WireDirection.ClientToServer);
        return Known(seen.From, seen.To) is { } toServer ? (toServer, WireDirection.ClientToServer)
            : Known(seen.To, seen.From) is { } toClient ? (toClient, WireDirection.ServerToClient)
            : IsServer(seen.To) ? (Begin(seen, seen.From, new(seen.To.Address, port!.Value)), WireDirection.ClientToServer)
            : IsServer(seen.From) ? (Begin(seen, seen.To, new(seen.From.Address, port!.Value)), WireDirection.ServerToClient)
            : null;
    }

    private bool IsServer(IPEndPoint side) => port is { } first && (side.Port == first || side.Port == first + 1);

    private SniffedSession? Known(IPEndPoint client, IPEndPoint server)
        => current.GetValueOrDefault((client, server.Address, server.Port))
            ?? current.GetValueOrDefault((client, server.Address, server.Port - 1));

    // A login request that comes again belongs to the session it began, until that has got an answer.
    private SniffedSession Begin(SniffedDatagram seen, IPEndPoint client, IPEndPoint server)
    {
        var key = (client, server.Address, server.Port);
        if (current.TryGetValue(key, out SniffedSession? known) && !known.IsAnswered)
            return known;
        var session = new SniffedSession(sessions.Count + 1, client, server, seen.Time, catalog);
        current[key] = session;
        sessions.Add(session);
        return session;
    }
}
