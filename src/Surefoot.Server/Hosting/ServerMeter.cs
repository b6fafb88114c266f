using System.Diagnostics.Metrics;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>A server's figures as instruments of the meter <c>Surefoot.Server</c>.</summary>
internal sealed class ServerMeter : IDisposable
{
    /// <summary>Name of the meter.</summary>
    public const string Name = "Surefoot.Server";

    private readonly Meter meter = new(Name);
    private readonly Histogram<double> steps;

    public ServerMeter(ServerFigures figures)
    {
        steps = meter.CreateHistogram<double>("surefoot.server.step", "s", "How long a pass of the server's loop takes.");
        meter.CreateObservableGauge("surefoot.server.sessions", () => figures.Sessions, description: "Sessions at the moment.");
        meter.CreateObservableGauge("surefoot.server.players", () => figures.Players, description: "Players in the world.");
        meter.CreateObservableGauge("surefoot.server.objects", () => figures.Objects, description: "Objects in the world.");
        Count("logins", () => figures.Logins, "Logins that began a session.");
        Count("logins.over_rate", () => figures.LoginsOverRate, "Logins not looked at because too many came from one address.");
        Count("entered", () => figures.Entered, "Characters that entered the world.");
        Count("claims", () => figures.Claims, "Claims about movement.");
        Count("claims.over_rate", () => figures.ClaimsOverRate, "Claims not looked at because a client made too many.");
        Count("datagrams.foreign", () => figures.ForeignDatagrams, "Datagrams of nobody's session.");
        Count("datagrams.received", () => figures.Network.DatagramsReceived, "Datagrams of sessions.");
        Count("datagrams.sent", () => figures.Network.DatagramsSent, "Datagrams to sessions.");
        Count("bytes.received", () => figures.Network.BytesReceived, "Bytes of sessions.");
        Count("bytes.sent", () => figures.Network.BytesSent, "Bytes to sessions.");
        Count("packets.resent", () => figures.Network.Resent, "Packets sent again because clients asked.");
        Count("packets.requested", () => figures.Network.RequestsSent, "Times that clients were asked to send again.");
        Count("messages.received", () => figures.Network.MessagesReceived, "Messages of clients.");
        Count("messages.sent", () => figures.Network.MessagesSent, "Messages to clients.");
        Count("clients.slow", () => figures.SlowClients, "Sessions ended because their clients did not take what was sent.");
        Count("faults", () => figures.Faults, "Messages that could not be handled.");
        CountEach<LoginRefusal>("logins.refused", figures.RefusedLogins, "Logins refused.");
        CountEach<ClaimReason>("claims.refused", figures.RefusedClaims, "Claims refused or put right.");
        CountEach<DropReason>("datagrams.dropped", figures.Dropped, "Datagrams or messages not used.");
    }

    /// <summary>A pass is over.</summary>
    public void Step(double seconds) => steps.Record(seconds);

    public void Dispose() => meter.Dispose();

    private void Count(string name, Func<long> value, string description) =>
        meter.CreateObservableCounter($"surefoot.server.{name}", value, description: description);

    private void CountEach<T>(string name, Func<T, long> value, string description)
        where T : struct, Enum => meter.CreateObservableCounter(
            $"surefoot.server.{name}",
            () => Enum.GetValues<T>().Select(
                one => new Measurement<long>(value(one), new KeyValuePair<string, object?>("reason", one.ToString()))),
            description: description);
}
