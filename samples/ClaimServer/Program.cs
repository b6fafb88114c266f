// A server that lets players say where they are, and judges it. One line a message, over TCP on this machine:
//     enter RUN JUMP PLACE  ->  at PLACE                                   (run and jump skill)
//     claim SECONDS PLACE   ->  accepted | corrected PLACE: why            (seconds since the one before)
// and "refused: why" where a line makes no sense.      dotnet run --project samples/ClaimServer -- DIR [PORT]
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Surefoot;
using Surefoot.Dats;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

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
            // The player is gone.
        }
    }
}

/// <summary>What one player claims.</summary>
internal sealed class Claims(Simulation world)
{
    private const double SpeedTolerance = 1.05, Slack = 0.1, Apart = 0.25;

    private readonly WorldQuery query = world.Engine.CreateQuery();
    private readonly Mover human = Mover.OfBody(world.Human, weenie: WeenieTraits.Present | WeenieTraits.Player | WeenieTraits.Creature);
    private PlaceResult at;
    private double speed, jump;

    /// <summary>Answers a line.</summary>
    public string Answer(string line)
    {
        try
        {
            // Finding a place may load what is around it, and a world is changed by one at a time.
            lock (world)
            {
                return line.Split(' ', 4) switch
                {
                    ["enter", string run, string jump, string place] => Enter(int.Parse(run), int.Parse(jump), Place.Parse(place)),
                    ["claim", string seconds, string place] when at.Found => Claim(double.Parse(seconds), Place.Parse(place)),
                    ["claim", ..] => "refused: enter first",
                    _ => "refused: say 'enter RUN JUMP PLACE' or 'claim SECONDS PLACE'",
                };
            }
        }
        catch (Exception e) when (e is FormatException or OverflowException or PlaceException or ArgumentException)
        {
            return $"refused: {e.Message}";
        }
    }

    private string Enter(int runSkill, int jumpSkill, Place place)
    {
        PlaceResult found = query.Place(new PlaceInput(human, world.Find(place)));
        if (!found.Found) return "refused: there is no room";
        at = found;
        speed = MovementFormulas.RunSpeed * MovementFormulas.RunRate(0, Math.Max(0, runSkill));
        jump = MovementFormulas.JumpHeight(0, Math.Max(0, jumpSkill), 1);
        return $"at {new Place(at.Position)}";
    }

    private string Claim(double seconds, Place place)
    {
        if (!(seconds > 0) || seconds > 10) return "refused: a claim is due every ten seconds, and time does not run backwards";
        Position to = world.Find(place);
        double far = at.Position.HorizontalDistanceTo(to), high = at.Position.OffsetTo(to).Z;
        if (far > (speed * seconds * SpeedTolerance) + Slack) return Correct($"{far / seconds:0.0} m/s, where {speed:0.0} m/s can be run");
        if (high > jump + human.Setup.StepUpHeight) return Correct($"{high:0.0} m up, where {jump:0.0} m can be jumped");

        // Who is on the ground keeps to it on the way; who is in the air does not.
        bool grounded = query.ProbeDown(new ProbeDownInput(human, to, (float)Slack)).Found;
        SweepResult way = query.Sweep(new SweepInput(human, at.Position, to) { Contact = grounded ? at.Contact : null });
        if (way.Found) at = at with { Position = way.Position, Contact = way.Contact };
        return way.Found && way.Position.DistanceTo(to) <= Apart ? "accepted" : Correct("something is in the way");
    }

    private string Correct(string why) => $"corrected {new Place(at.Position)}: {why}";
}
