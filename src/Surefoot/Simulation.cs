using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot;

/// <summary>
/// A world over a folder of dat files, in which players walk: it loads what is around them, and forgets what is far from all of them. One
/// thread at a time.
/// </summary>
public sealed class Simulation : IDisposable
{
    private const uint HumanSetup = 0x02000001;
    private const uint FirstPlayer = 0x50000001;
    private const int LoadRadius = 1;
    private const int KeepRadius = 3;

    private readonly List<Player> players = [];
    private readonly List<uint> leaving = [];

    /// <summary>A world over open files, which it takes over.</summary>
    /// <param name="dats">The files; disposed with the simulation.</param>
    /// <exception cref="DatFolderException">The region, the human setup or its motion table is not there; the message says
    /// which.</exception>
    /// <exception cref="InvalidDataException">The human setup names no motion table.</exception>
    /// <exception cref="DatFormatException">One of them is malformed.</exception>
    public Simulation(DatSet dats)
    {
        ArgumentNullException.ThrowIfNull(dats);
        Dats = dats;
        Assets = new PhysicsDataCache(dats);
        try
        {
            Engine = new PhysicsEngine(Assets);
            Human = Assets.GetSetup(HumanSetup);
            HumanMotions = MotionTableLoader.LoadFor(dats, Human, leftOut: World.LeftOut);
        }
        catch (DatRecordMissingException e)
        {
            throw new DatFolderException(dats.Folder, $"'{dats.Folder}' has no {e.Type} 0x{e.Id:X8}");
        }
    }

    /// <summary>The files.</summary>
    public DatSet Dats { get; }

    /// <summary>What is built from the files, to be shared with other worlds.</summary>
    public PhysicsDataCache Assets { get; }

    /// <summary>The engine's world: the landblocks that are loaded.</summary>
    public PhysicsWorld World => Engine.World;

    /// <summary>The engine: other bodies are made here, and asked about.</summary>
    public PhysicsEngine Engine { get; }

    /// <summary>Shape of a human.</summary>
    public SetupAsset Human { get; }

    /// <summary>Motions of a human.</summary>
    public MotionTableAsset HumanMotions { get; }

    /// <summary>The players.</summary>
    public IReadOnlyList<Player> Players => players;

    /// <summary>Opens a folder.</summary>
    /// <param name="folder">It holds client_portal.dat and client_cell_1.dat.</param>
    /// <exception cref="DatFolderException">The folder, or something in it that is needed, is missing; the message says what to
    /// do.</exception>
    /// <exception cref="DatFormatException">A file or a record is malformed; the message says which and where.</exception>
    public static Simulation Open(string folder)
    {
        DatSet dats = DatSet.Open(folder);
        try
        {
            return new Simulation(dats);
        }
        catch
        {
            dats.Dispose();
            throw;
        }
    }

    /// <summary>Puts a human player into the world, with a server of its own.</summary>
    /// <param name="place">Where.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="id">Id of the player, that no body has; null for the next free one.</param>
    /// <param name="latency">Seconds until the server's answers arrive, 0 or more.</param>
    /// <param name="options">Rules, observer.</param>
    /// <exception cref="PlaceException">No player can be there; the message says why and what to do.</exception>
    /// <exception cref="ArgumentException">A number is out of range or the id is taken; nothing has changed.</exception>
    public Player SpawnPlayer(Place place, CharacterStats stats, uint? id = null, double latency = 0, LocalPlayerOptions? options = null)
    {
        options ??= new LocalPlayerOptions();
        uint playerId = id ?? NextId();
        LoopbackServer server = new(playerId, stats, Engine.Now, latency, options.TopSpeedRule);
        Position position = Find(place);
        LocalPlayer local = LocalPlayer.Spawn(Engine, playerId, Human, HumanMotions, position, server, options) ?? throw NoRoom(place);
        if (!local.Body.HasCell)
        {
            Engine.RemoveBody(local.Body);
            throw new PlaceException($"{place} is in no room: the metres lie outside the rooms around 0x{position.CellId:X8}.");
        }

        Player player = new(this, local, server);
        players.Add(player);
        Follow(player);
        return player;
    }

    /// <summary>Takes a player out of the world. Nothing happens for one who is not in it.</summary>
    public void Remove(Player player)
    {
        ArgumentNullException.ThrowIfNull(player);
        if (players.Remove(player)) Engine.RemoveBody(player.Body);
    }

    /// <summary>
    /// Lets time pass: what the players' servers say arrives, their keys act, all bodies are brought to <paramref name="now"/>, and what
    /// the players come near to is loaded.
    /// </summary>
    /// <param name="now">Seconds, of a clock that starts anywhere and does not run backwards.</param>
    /// <returns>True when bodies moved; less than 1/30 s after they did last they wait, and no time is lost.</returns>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public bool Tick(double now)
    {
        foreach (Player player in players) player.Local.Update(player.Keys, now);
        if (!Engine.Tick(now)) return false;
        foreach (Player player in players) Follow(player);
        return true;
    }

    /// <summary>Loads what is around a place, and finds the position that it stands for: in the right cell, on the ground when it lies
    /// there.</summary>
    /// <exception cref="PlaceException">There is no such place in these files.</exception>
    public Position Find(Place place)
    {
        Position position = place.Position;
        bool isFinite = position.Frame.IsValid && float.IsFinite(position.Frame.Origin.LengthSquared());
        if (!isFinite || !CellIds.HasValidIndex(position.CellId))
            throw new PlaceException($"{place}: the id names no cell, or a number is not finite.");
        bool outdoors = CellIds.IsOutdoor(position.CellId);
        if (outdoors && !position.AdjustToOutside()) throw new PlaceException($"{place} is outside the map, which ends at landblock FEFE.");
        World.EnsureLoadedAround(position, LoadRadius);
        if (World.GetVisible(position.CellId) is null)
        {
            string cell = $"cell 0x{position.CellId:X8}; that {(outdoors ? "land" : "room")} does not exist there";
            throw new PlaceException($"{place}: {Dats.Folder} has no {cell}. 'surefoot dats list' shows what does.");
        }

        if (place.OnGround && World.FindLandblock(position.CellId) is { } block &&
            block.Terrain.TryGetHeight(position.Frame.Origin.X, position.Frame.Origin.Y, out float height))
            position.Frame.Origin.Z = height;
        return position;
    }

    /// <summary>Closes the files. The world is of no use after that.</summary>
    public void Dispose() => Dats.Dispose();

    /// <summary>Keeps what is around a player loaded, and forgets what is far from all players.</summary>
    internal void Follow(Player player)
    {
        uint block = CellIds.BlockOf(player.Position.CellId);
        if (block == player.LoadedBlock) return;
        player.LoadedBlock = block;
        World.EnsureLoadedAround(player.Position, LoadRadius);
        leaving.Clear();
        foreach (Landblock loaded in World.Landblocks)
            if (!players.Exists(one => IsNear(loaded.Id, one.Position.CellId))) leaving.Add(loaded.Id);
        foreach (uint id in leaving) World.UnloadLandblock(id);
    }

    internal static PlaceException NoRoom(Place place) =>
        new($"There is no room for a player at {place}: something is in the way. Give a place a little beside or above it.");

    private static bool IsNear(uint block, uint cell) =>
        Math.Abs((int)(block >> 24) - (int)(cell >> 24)) <= KeepRadius &&
        Math.Abs((int)((block >> 16) & 0xFF) - (int)((cell >> 16) & 0xFF)) <= KeepRadius;

    private uint NextId()
    {
        uint id = FirstPlayer;
        while (Engine.Find(id) is not null) id++;
        return id;
    }
}
