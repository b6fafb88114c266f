using System.CommandLine;
using System.Globalization;
using System.Text.Json.Nodes;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Sniffing;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot sniff</c>: what a client and a server said to each other, from a capture file.</summary>
internal static class SniffCommand
{
    private const int BytesOfALine = 32;

    internal static Command Create()
    {
        Argument<FileInfo> file = new("FILE") { Description = "A capture: pcap or pcapng, as tcpdump -w and Wireshark write it." };
        Option<int?> port = new("--port")
        {
            Description = "The server's first port, for a capture that begins in the middle of a session. Without it sessions are found " +
                "by their login requests.",
        };
        Option<string[]> only = new("--only")
        {
            Description = "Only messages of these names, e.g. UpdatePosition.",
            AllowMultipleArgumentsPerToken = true,
        };
        Option<bool> packets = new("--packets")
        {
            Description = "A line for each packet, too: its flags, acknowledgement, key, and why it is of no use.",
        };
        Option<bool> bytes = new("--bytes") { Description = "The bytes of each message, too; of those that hold a password, none." };
        Option<bool> json = new("--json") { Description = "Print a JSON object a line." };
        Command command = new(
            "sniff",
            "Prints the messages of the sessions in a capture file. Passwords are hidden.\n\nExample:\n" +
            "  tcpdump -i any -w session.pcap udp port 9000 or udp port 9001\n" +
            "  surefoot sniff session.pcap --only MoveToState UpdateMotion")
        { file, port, only, packets, bytes, json };
        command.SetAction(parsed =>
        {
            FileInfo path = parsed.GetRequiredValue(file);
            if (parsed.GetValue(port) is < 1 or > 65534)
                throw new UsageException("--port is 1 to 65534: the server's first port; its second is the next one.");
            var sniffer = new Sniffer(parsed.GetValue(port));
            HashSet<string> names = new(parsed.GetValue(only) ?? [], StringComparer.OrdinalIgnoreCase);
            Action<SniffedEvent> print = parsed.GetValue(json)
                ? seen => Console.Out.WriteLine(ToJson(seen, parsed.GetValue(bytes)).ToJsonString())
                : seen => Print(seen, parsed.GetValue(bytes));
            int told = 0, frames = 0;
            using FileStream stream = path.OpenRead();
            foreach (CapturedFrame frame in CaptureFile.Read(stream, path.FullName))
            {
                frames++;
                if (SniffedDatagram.Of(frame) is not { } datagram)
                    continue;
                int known = sniffer.Sessions.Count;
                IReadOnlyList<SniffedEvent> events = sniffer.Observe(datagram, parsed.GetValue(packets));
                if (sniffer.Sessions.Count > known && !parsed.GetValue(json))
                    PrintBeginning(sniffer.Sessions[^1]);
                foreach (SniffedEvent seen in events.Where(seen => names.Count == 0 || names.Contains(seen.Name)))
                {
                    print(seen);
                    told++;
                }
            }

            if (!parsed.GetValue(json))
                PrintEnd(sniffer, frames, told);
            if (sniffer.Sessions.Count > 0)
                return ExitCode.Done;
            Console.Error.WriteLine(
                $"surefoot: {path.FullName}: no session begins in it ({frames} frames, {sniffer.Strangers} of them other datagrams). " +
                "If it begins in the middle of one, tell the server's first port: --port 9000.");
            return ExitCode.Failed;
        });
        return command;
    }

    private static void PrintBeginning(SniffedSession session) => Console.Out.WriteLine(
        $"== Session {session.Number}: {session.Client} with {session.Server}, {DateTime.UnixEpoch.AddSeconds(session.Start):u}");

    private static void Print(SniffedEvent seen, bool withBytes)
    {
        string arrow = seen.Direction == WireDirection.ClientToServer ? "->" : "<-";
        string fields = seen.Fields is null ? $"(not known here, {seen.Bytes?.Length ?? 0} bytes)" : FieldText.Of(seen.Fields);
        string time = seen.Time.ToString("0.000", CultureInfo.InvariantCulture);
        Console.Out.WriteLine($"{seen.Session} {time,9} {arrow} {seen.Number,5}  {seen.Name}  {fields}");
        if (!withBytes || seen.Bytes is not { } bytes)
            return;
        foreach (byte[] line in bytes.Chunk(BytesOfALine))
            Console.Out.WriteLine($"{"",22}{Convert.ToHexStringLower(line)}");
    }

    private static JsonObject ToJson(SniffedEvent seen, bool withBytes)
    {
        JsonObject line = new()
        {
            ["session"] = seen.Session,
            ["time"] = Math.Round(seen.Time, 6),
            ["direction"] = seen.Direction == WireDirection.ClientToServer ? "c2s" : "s2c",
            ["packet"] = seen.Number,
            ["name"] = seen.Name,
            ["fields"] = seen.Fields?.DeepClone(),
        };
        if (withBytes && seen.Bytes is { } bytes)
            line["bytes"] = Convert.ToHexStringLower(bytes);
        return line;
    }

    private static void PrintEnd(Sniffer sniffer, int frames, int told)
    {
        Console.Out.WriteLine($"== {frames} frames, {sniffer.Sessions.Count} sessions, {told} lines, {sniffer.Strangers} other datagrams");
        foreach (SniffedSession session in sniffer.Sessions)
        {
            string dropped = string.Join(", ", session.Dropped.Select(reason => $"{reason.Value} {reason.Key}"));
            Console.Out.WriteLine($"   session {session.Number}: {session.Datagrams} datagrams" +
                (dropped.Length == 0 ? "" : $", of no use to their receiver: {dropped}"));
        }
    }
}
