// A player in a world, walked from the terminal. Each key is held for a quarter of a second; keys may also come from a file or a pipe:
//     echo "wwwwdd w" | dotnet run --project samples/Walker -- DIR [PLACE]
using System.Numerics;
using Surefoot;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

const double Frame = 1.0 / 60, Held = 0.25;
const int Columns = 39, Rows = 17;

if (args.Length is < 1 or > 2)
{
    Console.Error.WriteLine("usage: walker DIR [PLACE]   where DIR has client_portal.dat and client_cell_1.dat");
    return 2;
}

try
{
    using Simulation world = Simulation.Open(args[0]);
    Place place = Place.Parse(args.ElementAtOrDefault(1) ?? "0xA9B50032,156,24");           // a meadow of the demo world
    Player player = world.SpawnPlayer(place, new CharacterStats(RunSkill: 300, JumpSkill: 250));
    WorldQuery query = world.Engine.CreateQuery();
    double now = 0;
    Show();
    while (NextKey() is { } key && key != 'x')
    {
        for (double end = now + Held; now < end; now += Frame) player.Update(KeysOf(key), now);
        Show();
    }

    return 0;

    void Show()
    {
        string footing = player.Body.OnWalkable ? "on the ground" : "in the air";
        string line = $"{now,6:0.00} s  {player.Position}  {player.Body.AchievedVelocity.Length(),5:0.0} m/s  {footing}";
        if (!Console.IsInputRedirected)
        {
            Console.Clear();
            Draw();
            Console.WriteLine("w s forward, back   a d turn   q e sidestep   space jump (hold it: press it more than once)   x ends");
        }

        Console.WriteLine(line);
    }

    // From above, north up: what somebody would stand on here, a metre a character.
    void Draw()
    {
        Mover dot = new([new Surefoot.Physics.Geometry.Sphere(new Vector3(0, 0, 0.2f), 0.2f)], 0.6f, 1.5f);
        Position here = player.Position;
        for (int row = Rows / 2; row >= -Rows / 2; row--)
        {
            char[] text = new char[Columns];
            for (int column = 0; column < Columns; column++)
            {
                Position above = here;
                above.Frame.Origin += new Vector3(column - (Columns / 2), row, 1);
                text[column] = SymbolOf(query.ProbeDown(new ProbeDownInput(dot, above, 4)), here.Frame.Origin.Z);
            }

            if (row == 0) text[Columns / 2] = ArrowOf((float)here.Frame.Heading);
            Console.WriteLine(text);
        }
    }
}
catch (Exception e) when (e is FormatException or PlaceException or DatFolderException or DatFormatException or IOException)
{
    Console.Error.WriteLine(e.Message);
    return 1;
}

static char SymbolOf(in ProbeDownResult below, float height) => below switch
{
    { IsLoaded: false } => ' ',
    { Found: false } => ':',
    { Contact.IsWater: true } => '~',
    { Contact.IsWalkable: true } => (below.Position.Frame.Origin.Z - height) switch { > 0.6f => '+', < -0.6f => '-', _ => '.' },
    _ => '#',
};

static char ArrowOf(float heading) => "^>v<"[(int)Math.Round(heading / 90) % 4];

static MovementKeys KeysOf(char key) => key switch
{
    'w' => MovementKeys.Forward,
    's' => MovementKeys.Back,
    'a' => MovementKeys.TurnLeft,
    'd' => MovementKeys.TurnRight,
    'q' => MovementKeys.SidestepLeft,
    'e' => MovementKeys.SidestepRight,
    ' ' => MovementKeys.Jump,
    _ => MovementKeys.None,
};

static char? NextKey()
{
    if (!Console.IsInputRedirected) return Console.ReadKey(intercept: true).KeyChar;
    int read;
    do
    {
        read = Console.Read();
    }
    while (read is '\r' or '\n');
    return read < 0 ? null : (char)read;
}
