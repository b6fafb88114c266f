using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Tool.Serving;

/// <summary>A server's figures, as a table for people and as JSON for programs.</summary>
/// <param name="server">The server.</param>
/// <param name="load">Clients of our own; null without any.</param>
internal sealed class ServerReport(WorldServer server, LoadRun? load)
{
    private bool hasBegun;

    private static readonly JsonSerializerOptions Json = new() { PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    /// <summary>One line of JSON.</summary>
    internal string ToJson()
    {
        Begin();
        ServerFigures figures = server.Figures;
        return JsonSerializer.Serialize(
            new
            {
                Seconds = Math.Round(server.Now, 3),
                figures.Sessions,
                figures.Players,
                figures.Objects,
                figures.Logins,
                figures.Entered,
                RefusedLogins = Enum.GetValues<LoginRefusal>().ToDictionary(reason => Name(reason), figures.RefusedLogins),
                figures.LoginsOverRate,
                figures.Claims,
                RefusedClaims = Nonzero<ClaimReason>(figures.RefusedClaims),
                figures.ClaimsOverRate,
                Step = new
                {
                    figures.Steps.Count,
                    MedianMs = Milliseconds(figures.Steps.Within(0.5)),
                    P99Ms = Milliseconds(figures.Steps.Within(0.99)),
                    LongestMs = Milliseconds(figures.Steps.Longest),
                },
                Network = new
                {
                    figures.Network.DatagramsReceived,
                    figures.Network.DatagramsSent,
                    figures.Network.BytesReceived,
                    figures.Network.BytesSent,
                    figures.Network.MessagesReceived,
                    figures.Network.MessagesSent,
                    figures.Network.Resent,
                    figures.Network.RequestsSent,
                    Dropped = Nonzero<DropReason>(figures.Dropped),
                    Foreign = figures.ForeignDatagrams,
                },
                figures.SlowClients,
                figures.Faults,
                MemoryMb = Math.Round(GC.GetTotalMemory(forceFullCollection: false) / 1048576.0, 1),
                WorkingSetMb = Math.Round(Environment.WorkingSet / 1048576.0, 1),
                Load = load is null
                    ? null
                    : new { load.InWorld, load.Failed, load.Claims, load.Forced, load.Dropped, load.FirstFailure },
            },
            Json);
    }

    /// <summary>A table.</summary>
    internal Table ToTable()
    {
        Begin();
        ServerFigures figures = server.Figures;
        Table table = new() { Border = TableBorder.Rounded, Title = new TableTitle($"{server.EndPoint}") };
        table.AddColumn("");
        table.AddColumn(new TableColumn("") { Alignment = Justify.Right });
        table.AddColumn("");
        table.HideHeaders();
        Row("up", Text(server.Now, "0 s"), "");
        Row("sessions", Text(figures.Sessions), $"{figures.Logins} logins, {Refused<LoginRefusal>(figures.RefusedLogins)}");
        Row("players", Text(figures.Players), $"{figures.Entered} entered; {figures.Objects} objects");
        Row("step, median", Text(figures.Steps.Within(0.5) * 1000, "0.00 ms"), $"{figures.Steps.Count} passes");
        Row("step, p99", Text(figures.Steps.Within(0.99) * 1000, "0.00 ms"), $"longest {Text(figures.Steps.Longest * 1000, "0.0 ms")}");
        Row("claims", Text(figures.Claims), Refused<ClaimReason>(figures.RefusedClaims));
        Row("datagrams in", Text(figures.Network.DatagramsReceived),
            $"{Text(figures.Network.BytesReceived / 1e6, "0.0 MB")}; {Dropped(figures)}");
        Row("datagrams out", Text(figures.Network.DatagramsSent),
            $"{Text(figures.Network.BytesSent / 1e6, "0.0 MB")}; {figures.Network.Resent} sent again");
        Row("memory", Text(GC.GetTotalMemory(false) / 1048576.0, "0 MB"), $"of {Text(Environment.WorkingSet / 1048576.0, "0 MB")}");
        if (load is not null) Row("load", Text(load.InWorld), $"clients in the world; {load.Failed} failed, {load.Forced} times put right");
        return table;

        void Row(string name, string value, string rest) => table.AddRow(name, value, Markup.Escape(rest));
    }

    /// <summary>Logins, and code that runs for the first time, say little of how long steps take.</summary>
    private void Begin()
    {
        if (hasBegun || load is not { IsComplete: true }) return;
        hasBegun = true;
        server.ResetStepTimes();
    }

    private static string Dropped(ServerFigures figures)
    {
        string reasons = string.Join(", ", Nonzero<DropReason>(figures.Dropped).Select(one => $"{one.Value} {one.Key}"));
        return reasons.Length == 0 ? "none dropped" : $"dropped: {reasons}";
    }

    private static string Refused<T>(Func<T, long> count)
        where T : struct, Enum
    {
        string reasons = string.Join(", ", Nonzero(count).Select(one => $"{one.Value} {one.Key}"));
        return reasons.Length == 0 ? "none refused" : $"refused: {reasons}";
    }

    private static Dictionary<string, long> Nonzero<T>(Func<T, long> count)
        where T : struct, Enum =>
        Enum.GetValues<T>().Where(reason => count(reason) > 0).ToDictionary(reason => Name(reason), count);

    private static string Name<T>(T value)
        where T : struct, Enum => JsonNamingPolicy.CamelCase.ConvertName(value.ToString());

    private static double Milliseconds(double seconds) => Math.Round(seconds * 1000, 3);

    private static string Text(double value, string format = "0") => value.ToString(format, CultureInfo.InvariantCulture);
}
