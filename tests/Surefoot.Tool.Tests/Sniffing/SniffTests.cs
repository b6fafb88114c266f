using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Conformance.Captures;
using Surefoot.Tool.Sniffing;
using Surefoot.Tool.Tests.Commands;

namespace Surefoot.Tool.Tests.Sniffing;

/// <summary><c>surefoot sniff</c> over capture files made of recorded sessions.</summary>
public sealed class SniffTests : IDisposable
{
    private const double Start = 1_700_000_000.5;
    private static readonly CaptureForm Ethernet = new(Blocks: false, Swapped: false, LinkType: 1, Nanoseconds: false);
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-sniff");

    public static TheoryData<CaptureForm> Forms =>
    [
        Ethernet,
        new CaptureForm(Blocks: false, Swapped: true, LinkType: 101, Nanoseconds: true),
        new CaptureForm(Blocks: true, Swapped: false, LinkType: 276, Nanoseconds: true),
        new CaptureForm(Blocks: true, Swapped: true, LinkType: 113, Nanoseconds: false),
    ];

    public void Dispose() => folder.Delete(recursive: true);

    [Theory, Behaviour("tool.sniff.every-form-of-file", "pcap and pcapng, tcpdump.org; data/wire-captures/README.md")]
    [MemberData(nameof(Forms))]
    public void The_messages_of_a_session_come_out_whole_and_in_order_from_every_form_of_file(CaptureForm form)
    {
        Capture session = CaptureWriter.Recorded("walk");
        var (sniffer, events) = Sniff(CaptureWriter.Write(form, session, Start), port: null);

        SniffedSession found = Assert.Single(sniffer.Sessions);
        Assert.Equal(0, sniffer.Strangers);
        Assert.Equal(Start + session.Datagrams[0].Time, found.Start, 1e-5);
        Assert.Equal(Names(session), Messages(events).Select(seen => seen.Name));
        Assert.All(events.Zip(events.Skip(1)), pair => Assert.True(pair.First.Time <= pair.Second.Time));
    }

    [Theory, Behaviour("tool.sniff.every-session", "data/wire-captures/README.md")]
    [InlineData("enter")]
    [InlineData("door-far")]
    [InlineData("equip")]
    [InlineData("loss")]
    [InlineData("many")]
    [InlineData("teleport")]
    [InlineData("two-watcher")]
    [InlineData("wrong-password")]
    [InlineData("wrong-version")]
    public void All_messages_are_named_and_every_known_one_has_its_fields(string name)
    {
        Capture session = CaptureWriter.Recorded(name);
        var (_, events) = Sniff(CaptureWriter.Write(Ethernet, session, Start), port: null);

        JsonElement[] expected = [.. session.Messages];
        SniffedEvent[] messages = [.. Messages(events)];
        Assert.Equal(Names(session), messages.Select(seen => seen.Name));
        Assert.All(expected.Zip(messages), pair =>
            Assert.True(IsNull(pair.First.GetProperty("fields")) || pair.Second.Fields is not null, pair.Second.Name));
    }

    [Fact, Behaviour("tool.sniff.no-password", "spec/08, 3.1")]
    public async Task The_password_is_in_nothing_that_is_printed()
    {
        string path = Save(CaptureWriter.Write(Ethernet, CaptureWriter.Recorded("enter"), Start));
        string hex = Convert.ToHexStringLower(Encoding.ASCII.GetBytes("testpass"));
        foreach (string[] options in (string[][])[["--packets", "--bytes"], ["--packets", "--bytes", "--json"]])
        {
            CommandLine.Outcome run = await CommandLine.RunAsync(["sniff", path, .. options]);
            Assert.Equal(0, run.ExitCode);
            Assert.Contains("LoginRequest", run.Output, StringComparison.Ordinal);
            Assert.Contains("(hidden)", run.Output, StringComparison.Ordinal);
            Assert.DoesNotContain("testpass", run.Output, StringComparison.OrdinalIgnoreCase);
            Assert.DoesNotContain(hex, run.Output, StringComparison.OrdinalIgnoreCase);
        }
    }

    [Theory, Behaviour("tool.sniff.console-passwords", "spec/08, 4.1")]
    [InlineData("@accountcreate bob geheim 0", true)]
    [InlineData("@set-accountpassword bob geheim", true)]
    [InlineData("/passwd geheim", true)]
    [InlineData("nothing to hide: geheim", false)]
    public void What_is_told_to_a_servers_console_about_passwords_is_hidden(string text, bool hidden)
    {
        byte[] bytes = new byte[200];
        Assert.True(WireMessage.TryWrite(new Talk(text), bytes, out int length, stamp: 1));
        Assert.True(WireMessage.TryParse(bytes.AsSpan(0, length), out WireMessage message));
        var session = new SniffedSession(1, new(0x0100007F, 5), new(0x0100007F, 9000), 0, new MessageCatalog());
        session.OnMessage(WireDirection.ClientToServer, default, message);

        SniffedEvent seen = Assert.Single(session.Events);
        Assert.Equal(!hidden, FieldText.Of(seen.Fields!).Contains("geheim", StringComparison.Ordinal));
        Assert.Equal(hidden, seen.Bytes is null);
    }

    [Fact, Behaviour("tool.sniff.in-the-middle", "spec/08, 2")]
    public async Task A_capture_that_begins_in_the_middle_needs_the_servers_port_and_says_so()
    {
        Capture session = CaptureWriter.Recorded("walk");
        byte[] whole = CaptureWriter.Write(Ethernet, session, Start);
        byte[] rest = [.. whole[..24], .. whole[EndOfFrames(whole, 5)..]];

        CommandLine.Outcome run = await CommandLine.RunAsync("sniff", Save(rest));
        Assert.Equal(1, run.ExitCode);
        Assert.Contains("--port", run.Error, StringComparison.Ordinal);
        var (sniffer, events) = Sniff(rest, port: 9300);
        Assert.Single(sniffer.Sessions);
        Assert.Contains(events, seen => seen.Name == "UpdatePosition");
    }

    [Fact, Behaviour("tool.sniff.cut-short", "pcap, tcpdump.org")]
    public void A_file_that_ends_in_the_middle_of_a_frame_gives_all_before_it()
    {
        byte[] whole = CaptureWriter.Write(Ethernet, CaptureWriter.Recorded("walk"), Start);
        int all = CaptureFile.Read(new MemoryStream(whole), "whole").Count();
        Assert.Equal(all - 1, CaptureFile.Read(new MemoryStream(whole[..^3]), "cut").Count());
    }

    [Fact, Behaviour("tool.sniff.not-a-capture", "design.md, decision 7")]
    public async Task Another_file_is_one_sentence_that_says_what_to_give()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("sniff", Save(Encoding.ASCII.GetBytes("# not a capture at all")));
        Assert.Equal(1, run.ExitCode);
        string line = Assert.Single(run.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
        Assert.Contains("tcpdump -w", line, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.sniff.only", "design.md, The tool")]
    public async Task Only_the_messages_asked_for_are_printed_as_json_objects()
    {
        Capture session = CaptureWriter.Recorded("walk");
        CommandLine.Outcome run = await CommandLine.RunAsync(
            "sniff", Save(CaptureWriter.Write(Ethernet, session, Start)), "--json", "--only", "MoveToState", "jump");
        JsonNode[] lines = [.. run.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonNode.Parse(line)!)];

        string[] wanted = ["MoveToState", "Jump"];
        Assert.Equal(
            Names(session).Where(wanted.Contains),
            lines.Select(line => line["name"]!.GetValue<string>()));
        JsonNode move = lines.First(line => line["name"]!.GetValue<string>() == "MoveToState")["fields"]!;
        Assert.Equal(4, move["position"]!["orientation"]!.AsArray().Count);
    }

    [Fact, Behaviour("tool.sniff.text-is-no-command", "design.md, decision 7")]
    public void A_text_from_the_wire_is_no_command_to_the_terminal()
        => Assert.Equal(
            "text=\"\\x1B[2J\" guid=0x50000001", FieldText.Of(new JsonObject { ["text"] = "\u001B[2J", ["guid"] = 0x50000001u }));

    private static bool IsNull(JsonElement element) => element.ValueKind == JsonValueKind.Null;

    private static IEnumerable<string> Names(Capture session)
        => session.Messages.Select(message => message.GetProperty("name").GetString()!);

    private static IEnumerable<SniffedEvent> Messages(IEnumerable<SniffedEvent> events)
        => events.Where(seen => seen.Name is not ("LoginRequest" or "ConnectRequest" or "ConnectResponse" or "Disconnect"));

    private static (Sniffer Sniffer, List<SniffedEvent> Events) Sniff(byte[] file, int? port)
    {
        var sniffer = new Sniffer(port);
        List<SniffedEvent> events = [];
        foreach (CapturedFrame frame in CaptureFile.Read(new MemoryStream(file), "test"))
        {
            SniffedDatagram? datagram = SniffedDatagram.Of(frame);
            Assert.NotNull(datagram);
            events.AddRange(sniffer.Observe(datagram, withPackets: false));
        }

        return (sniffer, events);
    }

    // Where the first frames of a pcap file end: 24 bytes of file header, 16 before each frame with its length at 8.
    private static int EndOfFrames(byte[] file, int frames)
    {
        int at = 24;
        for (int i = 0; i < frames; i++)
            at += 16 + BitConverter.ToInt32(file, at + 8);
        return at;
    }

    private string Save(byte[] bytes)
    {
        string path = Path.Combine(folder.FullName, "capture.pcap");
        File.WriteAllBytes(path, bytes);
        return path;
    }
}
