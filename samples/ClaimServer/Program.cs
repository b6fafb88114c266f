// A server that lets players say where they are, and judges it. One line a message, over TCP on this machine:
//     enter RUN JUMP PLACE                                 ->  at PLACE        (run and jump skill)
//     keys SECONDS FORWARD,SIDESTEP,TURN,HOLD,BITS PLACE   ->  accepted | corrected | refused PLACE: why
//     jump SECONDS EXTENT,X,Y,Z PLACE                      ->  the same
//     claim SECONDS - PLACE                                ->  the same        (seconds since the line before)
// with what MoveToState, Jump and AutonomousPosition carry (commands in hexadecimal), and a place as /loc prints it.
// "error: why" where a line makes no sense.      dotnet run --project samples/ClaimServer -- DIR [PORT]
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Numerics;
using Surefoot;
using Surefoot.Dats;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

CultureInfo.DefaultThreadCurrentCulture = CultureInfo.InvariantCulture;
if (args.Length is < 1 or > 2 || (args.Length == 2 && !ushort.TryParse(args[1], out _)))
{
    Console.Error.WriteLine("usage: claimserver DIR [PORT]   where DIR has client_portal.dat and client_cell_1.dat");
    return 2;
}

try
{
    using Simulation world = Simulation.Open(args[0]);
    using TcpListener listener = new(IPAddress.Loopback, args.Length == 2 ? ushort.Parse(args[1]) : 0);
    listener.Start();
    Console.WriteLine($"listening on {listener.LocalEndpoint}");
    while (true)
    {
        TcpClient client = await listener.AcceptTcpClientAsync();
        _ = Task.Run(() => ServeAsync(client, world));
    }
}
catch (Exception e) when (e is DatFolderException or DatFormatException or IOException or SocketException)
{
    Console.Error.WriteLine(e.Message);
    return 1;
}

static async Task ServeAsync(TcpClient client, Simulation world)
{
    using (client)
    {
        try
        {
            using StreamReader reader = new(client.GetStream());
            await using StreamWriter writer = new(client.GetStream()) { AutoFlush = true };
            Claims claims = new(world);
            while (await reader.ReadLineAsync() is { } line) await writer.WriteLineAsync(claims.Answer(line));
        }
        catch (Exception e) when (e is IOException or SocketException)
        {
        }
    }
}

// What one player claims.
internal sealed class Claims(Simulation world)
{
    private static readonly MovementStamps Stamps = new(Instance: 1, 0, 0, 0);
    private MovementAuthority? authority;
    private double now;

    public string Answer(string line)
    {
        try
        {
            // Finding a place may load what is around it, and a world is changed by one at a time.
            lock (world)
            {
                return line.Split(' ', 4) switch
                {
                    ["enter", string run, string jump, string place] => Enter(new(int.Parse(run), int.Parse(jump)), Place.Parse(place)),
                    ["keys" or "jump" or "claim", ..] when authority is null => "error: enter first",
                    [string what, string seconds, string words, string place] =>
                        Judge(what, double.Parse(seconds), words.Split(','), place),
                    _ => "error: say enter, keys, jump or claim",
                };
            }
        }
        catch (Exception e) when (e is FormatException or OverflowException or PlaceException or ArgumentException)
        {
            return $"error: {e.Message}";
        }
    }

    private string Enter(CharacterStats stats, Place place)
    {
        MovementAuthority entering = new(world.Engine, world.Human, world.HumanMotions, stats);
        if (!entering.TryPlace(world.Find(place), now)) return "error: there is no room";
        authority = entering;
        return $"at {new Place(authority.Position)}";
    }

    private string Judge(string what, double seconds, string[] words, string place)
    {
        if (!(seconds is >= 0 and <= 60)) throw new FormatException("a line is due every minute, and time does not run backwards");
        now += seconds;
        Position there = world.Find(Place.Parse(place));
        WirePosition at = new(there.CellId, there.Frame.Origin, there.Frame.Rotation);
        ClaimVerdict verdict = (what, words.Length) switch
        {
            ("keys", 5) => authority!.Judge(Keys([.. words.Select(word => uint.Parse(word, NumberStyles.HexNumber))], at), now),
            ("jump", 4) => authority!.Judge(Jump([.. words.Select(float.Parse)], at), now),
            ("claim", _) => authority!.Judge(new AutonomousPosition(at, Stamps, Contact: true), now),
            _ => throw new FormatException($"{words.Length} words are no {what}"),
        };
        return $"{verdict.Outcome.ToString().ToLowerInvariant()} {new Place(verdict.Position)}: {verdict.Reason}";
    }

    private static MoveToState Keys(uint[] n, in WirePosition at) => new(
        new WireRawMotion(n[3], forwardCommand: n[0], sidestepCommand: n[1], turnCommand: n[2]), at, Stamps, n[4] % 2 == 1, n[4] > 1);

    private static Jump Jump(float[] n, in WirePosition at) => new(n[0], new Vector3(n[1], n[2], n[3]), at, Stamps);
}
