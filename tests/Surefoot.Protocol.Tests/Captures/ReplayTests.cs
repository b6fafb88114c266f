using System.Security.Cryptography;
using System.Text.Json;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Captures;

/// <summary>The recordings, played to our own client and our own server.</summary>
public class ReplayTests
{
    public static TheoryData<string> Sessions => RecordedSessions.All;

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.client-replay", "08, 2.6")]
    public void A_client_that_hears_the_recorded_server_gets_all_its_messages(string name)
    {
        Capture capture = RecordedSessions.Load(name);
        var client = new ClientSession(new ClientSessionOptions { Account = "wire", Password = "testpass" }, new SentDatagrams());
        var received = new ReceivedMessages();
        client.Connect(0);
        foreach (CapturedDatagram captured in capture.Datagrams)
        {
            if (!captured.Lost && captured.Direction == WireDirection.ServerToClient)
                client.Receive(captured.Bytes, captured.Time, received);
        }

        Assert.Equal(Expected(capture, "s2c").Select(HashOf), received.All.Select(HashOf));
        Assert.Equal(0, client.Statistics.Dropped(DropReason.Checksum));
        Assert.Equal(0, client.Statistics.Dropped(DropReason.BadMessage));
    }

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.server-replay", "08, 8.3")]
    public void A_server_that_hears_the_recorded_client_executes_its_messages_in_order(string name)
    {
        Capture capture = RecordedSessions.Load(name);
        if (capture.Seed(WireDirection.ClientToServer) is not { } clientSeed)
            return;

        ulong cookie = capture.Datagrams.Select(captured => captured.Expected.GetProperty("options"))
            .Where(options => options.TryGetProperty("connectRequest", out _))
            .Select(options => Convert.ToUInt64(options.GetProperty("connectRequest").GetProperty("cookie").GetString(), 16)).First();
        var link = new ServerLink(
            new ServerLinkOptions(
                capture.Expected.GetProperty("netId").GetUInt16(), cookie, capture.Seed(WireDirection.ServerToClient)!.Value, clientSeed),
            loginLength: 72,
            new SentDatagrams(),
            now: 0);
        link.Admit();
        var received = new ReceivedMessages();
        foreach (CapturedDatagram captured in capture.Datagrams)
        {
            if (!captured.Lost && captured.Direction == WireDirection.ClientToServer)
                link.Receive(captured.Bytes, captured.Port, captured.Time, received);
        }

        IEnumerable<string?> inOrder = Expected(capture, "c2s")
            .OrderBy(message => message.GetProperty("sequence").GetUInt32())
            .Select(HashOf);
        Assert.Equal(inOrder, received.All.Select(HashOf));
        Assert.Equal(0, link.HeldMessages);
        Assert.Equal(0, link.Statistics.Dropped(DropReason.Checksum));
    }

    private static IEnumerable<JsonElement> Expected(Capture capture, string direction)
        => capture.Messages.Where(message => message.GetProperty("dir").GetString() == direction);

    private static string HashOf(byte[] bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    private static string? HashOf(JsonElement message) => message.GetProperty("sha256").GetString();
}
