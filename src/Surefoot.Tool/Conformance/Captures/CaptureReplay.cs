using System.Text.Json;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>One thing that there was to find in a recorded session.</summary>
/// <param name="Session">Name of the session.</param>
/// <param name="Number">Datagram or message, counted from 0.</param>
/// <param name="What">What was compared.</param>
/// <param name="Difference">What differs; null when nothing does.</param>
internal sealed record CaptureResult(string Session, int Number, string What, string? Difference);

/// <summary>Looks at recorded sessions as a correct decoder does, and compares with what there is to find.</summary>
internal static class CaptureReplay
{
    /// <summary>Everything there is to find.</summary>
    /// <exception cref="InvalidDataException">What there is to find is not told as it should be.</exception>
    internal static List<CaptureResult> Run(Capture capture) =>
        Capture.Guarded(capture.Name, () => (List<CaptureResult>)[.. Packets(capture), .. Verdicts(capture), .. Messages(capture)]);

    /// <summary>Headers, sums, keys, options and fragments of each datagram.</summary>
    internal static IEnumerable<CaptureResult> Packets(Capture capture) => capture.Datagrams.Select((captured, i) =>
    {
        DropReason reason = Datagram.TryParse(captured.Bytes, out Datagram datagram);
        string? difference = reason == DropReason.None
            ? CapturePacket.Of(capture, captured, datagram).DifferenceFrom(captured.Expected)
            : $" is no datagram: {reason}";
        return new CaptureResult(capture.Name, i, "datagram", difference);
    });

    /// <summary>Does the receiver take exactly the datagrams that count, with exactly their keys?</summary>
    internal static IEnumerable<CaptureResult> Verdicts(Capture capture)
    {
        var tap = new WireTap();
        for (int i = 0; i < capture.Datagrams.Length; i++)
        {
            CapturedDatagram captured = capture.Datagrams[i];
            if (captured.Lost)
                continue;
            TapReport report = tap.Observe(captured.Direction, captured.Bytes, new Nobody());
            var found = new Fields { ["verdict"] = VerdictOf(report) };
            bool hasKey = captured.Expected.GetProperty("key").ValueKind == JsonValueKind.Number;
            if (report is { Reason: DropReason.None, IsVerified: true } && (hasKey || report.KeyIndex is not null))
                found["key"] = report.KeyIndex ?? -1;
            yield return new CaptureResult(capture.Name, i, "verdict", found.DifferenceWhereTold(captured.Expected));
        }
    }

    /// <summary>The messages in their order, with all their fields, and written again with the same bytes.</summary>
    internal static IEnumerable<CaptureResult> Messages(Capture capture)
    {
        var tap = new WireTap();
        var messages = new CapturedMessages();
        foreach (CapturedDatagram captured in capture.Datagrams.Where(datagram => !datagram.Lost))
        {
            messages.Note(captured);
            tap.Observe(captured.Direction, captured.Bytes, messages);
        }

        JsonElement[] expected = [.. capture.Messages];
        for (int i = 0; i < Math.Max(expected.Length, messages.Found.Count); i++)
        {
            string? difference = i >= messages.Found.Count ? " is missing"
                : i >= expected.Length ? " is not expected"
                : messages.Found[i].Fault ?? messages.Found[i].Fields.DifferenceFrom(expected[i]);
            string name = i < expected.Length ? $"message {expected[i].GetProperty("name")}" : "message";
            yield return new CaptureResult(capture.Name, i, name, difference);
        }
    }

    private static string VerdictOf(in TapReport report) => !report.IsVerified ? "unverifiable" : report.Reason switch
    {
        DropReason.None => "accept",
        DropReason.Duplicate => "duplicate",
        _ => report.Reason.ToString(),
    };

    private sealed class Nobody : ITapReceiver
    {
        public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message)
        {
        }
    }
}
