// Asks a world of dat files where a human lands, what blocks the way, and where in a landblock one can stand.
//     surveyor DIR land PLACE                       surveyor DIR block PLACE HEADING METRES
//     surveyor DIR map LANDBLOCK FILE.svg           such as 0xA9B5
using System.Globalization;
using System.Numerics;
using System.Text;
using Surefoot;
using Surefoot.Dats;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

const int Points = 96;                   // of a map, along each side: every two metres
const string Walkable = "#8fbf6a", Steep = "#b0643c", Water = "#5b8fd0", Occupied = "#555555";
const float Drop = 100, Stride = 0.25f;  // metres

CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
try
{
    using Simulation world = Simulation.Open(args.Length > 0 ? args[0] : throw new FormatException("no folder is given"));
    WorldQuery query = world.Engine.CreateQuery();
    Mover human = Mover.OfBody(world.Human, weenie: WeenieTraits.Present | WeenieTraits.Player | WeenieTraits.Creature);
    return args[1..] switch
    {
        ["land", string place] => Land(Find(place)),
        ["block", string place, string heading, string metres] => Block(Find(place), float.Parse(heading), float.Parse(metres)),
        ["map", string block, string file] => Map(Convert.ToUInt32(block, 16) << 16, file),
        _ => throw new FormatException("usage: surveyor DIR land PLACE | block PLACE HEADING METRES | map LANDBLOCK FILE.svg"),
    };

    Position Find(string place) => world.Find(Place.Parse(place));

    int Land(Position from)
    {
        ProbeDownResult below = query.ProbeDown(new ProbeDownInput(human, from, Drop));
        Console.WriteLine(below.Found
            ? $"lands {below.Depth:0.###} m below, at {below.Position}, on {NameOf(below.Subject)}, {SlopeOf(below.Contact)}"
            : $"lands nowhere within {Drop} m");
        return below.Found ? 0 : 1;
    }

    // Walks in short sweeps, each from where the last one ended.
    int Block(Position from, float heading, float metres)
    {
        PlaceResult stand = query.Place(new PlaceInput(human, from, Slides: false));
        if (!stand.Found) throw new FormatException($"a human has no room at {from}");
        Vector3 ahead = new((float)Math.Sin(heading * Math.PI / 180), (float)Math.Cos(heading * Math.PI / 180), 0);
        SweepInput next = new(human, stand.Position, stand.Position) { Contact = stand.Contact };
        TraceBuffer trace = new();
        for (float gone = 0; gone < metres && next.Contact is not null;)
        {
            Position to = next.From;
            to.Frame.Origin += ahead * Stride;
            trace.Clear();
            SweepResult way = query.Sweep(next with { To = to }, trace);
            float progress = Vector3.Dot(next.From.OffsetTo(way.Position), ahead);
            next = next with { From = way.Position, Contact = way.Contact, SlidingNormal = way.SlidingNormal };
            gone += progress;
            if (progress > Stride / 10 && way.Contact is not { IsWalkable: false }) continue;
            TraceEntry met = default;
            foreach (TraceEntry entry in trace.Entries)
                if (entry.Kind == TraceKind.Hit && entry.Reason != TraceReason.Supports) met = entry;
            Contact face = new(met.Plane, met.PlaneCellId);
            string what = $"{(face.IsWalkable ? "the edge of " : "")}{NameOf(met.Subject)}, {SlopeOf(face)}";
            Console.WriteLine($"blocked after {gone:0.#} of {metres:0.#} m, at {way.Position}, by {what}");
            return 1;
        }

        Console.WriteLine(next.Contact is null ? $"leaves the ground at {next.From}" : $"walks all {metres:0.#} m, to {next.From}");
        return 0;
    }

    int Map(uint block, string file)
    {
        StringBuilder svg = new();
        svg.AppendLine($"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {Points} {Points}' width='960' height='960'>");
        int walkable = 0;
        for (int y = 0; y < Points; y++)
        {
            string[] row = [.. Enumerable.Range(0, Points).Select(x => ColourAt(block, x, y))];
            walkable += row.Count(colour => colour == Walkable);
            for (int x = 0, width; x < Points; x += width)
            {
                width = row.Skip(x).TakeWhile(colour => colour == row[x]).Count();
                svg.AppendLine($"<rect x='{x}' y='{Points - 1 - y}' width='{width}' height='1' fill='{row[x]}'/>");
            }
        }

        File.WriteAllText(file, svg.AppendLine("</svg>").ToString());
        Console.WriteLine($"{100.0 * walkable / (Points * Points):0.0} % of 0x{block >> 16:X4} is walkable; {file}");
        return 0;
    }

    string ColourAt(uint block, int x, int y)
    {
        Vector3 middle = new Vector3(x + 0.5f, y + 0.5f, 0) * (CellIds.BlockSize / Points);
        Position ground = world.Find(new Place(new Position(block | 1, middle), OnGround: true));
        return query.Place(new PlaceInput(human, ground, Slides: false)) switch
        {
            { Found: false } => Occupied,
            { Contact.IsWater: true } => Water,
            { Contact.IsWalkable: true } => Walkable,
            _ => Steep,
        };
    }
}
catch (Exception e) when (
    e is FormatException or ArgumentException or PlaceException or DatFolderException or DatFormatException or IOException)
{
    Console.Error.WriteLine($"surveyor: {e.Message}");
    return 1;
}

static string NameOf(in TraceSubject subject) =>
    subject.SetupId == 0 ? $"{subject.Kind} of 0x{subject.CellId:X8}" : $"{subject.Kind} 0x{subject.SetupId:X8}";

static string SlopeOf(Contact? contact) => contact is not { } face ? "where nobody stands"
    : $"{Math.Acos(face.Plane.Normal.Z) * 180 / Math.PI:0.0}°{(face.IsWalkable ? face.IsWater ? " under water" : "" : " (too steep)")}";
