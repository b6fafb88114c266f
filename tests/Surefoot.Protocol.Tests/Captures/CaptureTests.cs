using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Captures;

/// <summary>Whole recorded sessions with a server of the field: every byte is explained.</summary>
public class CaptureTests
{
    public static TheoryData<string> Sessions => RecordedSessions.All;

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.packets", "08, 2")]
    public void Headers_sums_keys_options_and_fragments_of_every_recorded_datagram_are_found(string session)
    {
        Capture capture = RecordedSessions.Load(session);
        AssertFound(CaptureReplay.Packets(capture), capture.Datagrams.Length);
    }

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.verdicts", "08, 2.6 and 10")]
    public void The_receiver_takes_exactly_the_datagrams_that_count_with_exactly_their_keys(string session)
    {
        Capture capture = RecordedSessions.Load(session);
        AssertFound(CaptureReplay.Verdicts(capture), capture.Datagrams.Count(datagram => !datagram.Lost));
    }

    [Theory, MemberData(nameof(Sessions)), Behaviour("protocol.captures.messages", "08, 2.5 and 3 to 7")]
    public void The_messages_of_every_recorded_session_are_found_in_order_with_all_their_fields(string session)
    {
        Capture capture = RecordedSessions.Load(session);
        AssertFound(CaptureReplay.Messages(capture), capture.Messages.Count());
    }

    private static void AssertFound(IEnumerable<CaptureResult> results, int count)
    {
        CaptureResult[] all = [.. results];
        Assert.Equal(count, all.Length);
        Assert.All(all, result => Assert.True(result.Difference is null, $"{result.What} {result.Number}{result.Difference}"));
    }
}
