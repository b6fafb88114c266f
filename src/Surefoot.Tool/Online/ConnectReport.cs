using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Client;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Tool.Commands;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Online;

/// <summary>What <c>surefoot connect</c> prints: progress as it happens, to the error stream; results as text or as one JSON
/// object.</summary>
/// <param name="json">One JSON object, at the end.</param>
/// <param name="server">The server, as it was given.</param>
internal sealed class ConnectReport(bool json, string server)
{
    private const int MostNear = 12;
    private const float FarthestNear = 120;

    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    private string? name;
    private object? start, end;
    private object[] near = [];

    /// <summary>Says what happens now.</summary>
    internal void Say(string line) => CommonOptions.Say($"{server}: {line}");

    /// <summary>The character stands in the world.</summary>
    internal void TellArrival(OnlineStay stay, CharacterEntry character)
    {
        name = character.Name;
        start = Form(stay);
        (RemoteBody Item, float Distance, double Heading)[] found = [.. Near(stay)];
        near = [.. found.Select(one => (object)new
        {
            name = one.Item.Weenie.Name,
            guid = $"{one.Item.Id:X8}",
            distance = Math.Round(one.Distance, 2),
            heading = Math.Round(one.Heading),
        })];
        if (json) return;
        Console.Out.WriteLine($"{name} is at {Place(stay.Player.Body.Position)} in '{stay.Session.Server?.Name}'.");
        if (found.Length == 0)
        {
            Console.Out.WriteLine("Nobody is near.");
            return;
        }

        Table table = new() { Border = TableBorder.Simple };
        foreach (string heading in (string[])["near", "metres", "towards"]) table.AddColumn(heading);
        foreach ((RemoteBody item, float distance, double heading) in found)
            table.AddRow(Markup.Escape(item.Weenie.Name), Text(distance, "0.0"), Text(heading, "0"));
        Terminal.Write(table);
    }

    /// <summary>The script is walked, and the server has answered.</summary>
    internal void TellWalk(OnlineStay stay)
    {
        end = Form(stay);
        if (json) return;
        Console.Out.WriteLine($"{name} is at {Place(stay.Player.Body.Position)}.");
        Console.Out.WriteLine(stay.Disagreement is { } metres
            ? $"The server says the same within {Text(metres * 100, "0.0")} cm."
            : "The server has not said where it is.");
    }

    /// <summary>The character is logged off.</summary>
    internal void Finish(OnlineStay stay)
    {
        if (!json)
        {
            Console.Out.WriteLine("Logged off.");
            return;
        }

        var counted = stay.Session.Statistics;
        Console.Out.WriteLine(JsonSerializer.Serialize(
            new
            {
                server,
                world = stay.Session.Server?.Name,
                character = name,
                start,
                near,
                end,
                disagreement = stay.Disagreement,
                roundTrip = stay.Session.RoundTrip,
                messagesReceived = counted.MessagesReceived,
                messagesSent = counted.MessagesSent,
                resent = counted.Resent,
                objectMessagesWithoutEffect = stay.Game!.Others.Drops.Total,
                unreadable = stay.Player.UnreadableMessages,
            }, Json));
    }

    /// <summary>It did not work.</summary>
    internal void Fail(ConnectException e)
    {
        Say(e.Message);
        if (json) Console.Out.WriteLine(JsonSerializer.Serialize(new { server, error = e.Message, exitCode = e.ExitCode }, Json));
    }

    private static IEnumerable<(RemoteBody Item, float Distance, double Heading)> Near(OnlineStay stay)
    {
        Position own = stay.Player.Body.Position;
        return stay.Game!.Others.Objects
            .Where(item => item.Body is { HasCell: true, Parent: null })
            .Select(item => (item, Way: WayTo(own, item.Body.Position)))
            .Where(one => one.Way.Length() <= FarthestNear)
            .OrderBy(one => one.Way.Length())
            .Take(MostNear)
            .Select(one => (one.item, one.Way.Length(), Towards(one.Way)));
    }

    private static Vector3 WayTo(in Position own, in Position other) =>
        CellIds.BlockOffset(own.CellId, other.CellId) + other.Frame.Origin - own.Frame.Origin;

    /// <summary>Degrees clockwise from north.</summary>
    private static double Towards(Vector3 way) => (450 - (Math.Atan2(way.Y, way.X) * 180 / Math.PI)) % 360;

    private static object Form(OnlineStay stay)
    {
        Position place = stay.Player.Body.Position;
        Vector3 o = place.Frame.Origin;
        return new { cell = $"{place.CellId:X8}", position = (float[])[o.X, o.Y, o.Z], heading = place.Frame.Heading };
    }

    private static string Place(in Position position)
    {
        Vector3 o = position.Frame.Origin;
        return string.Create(CultureInfo.InvariantCulture,
            $"0x{position.CellId:X8},{o.X:0.###},{o.Y:0.###},{o.Z:0.###}, heading {position.Frame.Heading:0}");
    }

    private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);
}
