using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>The one world of a server: its land, its creatures and doors, and the players in it.</summary>
internal sealed class WorldStage
{
    private const uint FirstSpawnId = 0x80000001;
    private const int LoadRadius = 1, KeepRadius = 3, LongestMessage = 1 << 16;
    private const double StepInterval = 1.0 / 60;

    private readonly WorldServer server;
    private readonly List<WorldItem> items = [];
    private readonly List<CreatureItem> creatures = [];
    private readonly List<DoorItem> doors = [];
    private readonly List<PlayerItem> players = [];
    private readonly List<PlayerItem> goingOut = [];
    private readonly List<uint> leaving = [];
    private double nextStep = double.NegativeInfinity;

    /// <summary>A world with everything that the options spawn; it comes with its landblocks.</summary>
    /// <exception cref="Surefoot.Dats.DatRecordMissingException">The region, a setup or a motion table is missing.</exception>
    /// <exception cref="Surefoot.Dats.DatFormatException">One of them is malformed.</exception>
    public WorldStage(WorldServer server, PhysicsDataCache cache)
    {
        this.server = server;
        WorldServerOptions options = server.Options;
        Engine = new PhysicsEngine(cache);
        Human = cache.GetSetup(options.PlayerSetup);
        Motions = MotionTableLoader.LoadFor(cache.Source, Human, leftOut: Engine.World.LeftOut);
        Dictionary<(uint Id, bool WithParts), MotionTableAsset> tables = [];
        for (int i = 0; i < options.Spawns.Count; i++)
        {
            WorldSpawn spawn = options.Spawns[i];
            SetupAsset setup = cache.GetSetup(spawn.SetupId);
            (uint Id, bool WithParts) key = (setup.DefaultMotionTableId, setup.HasPhysicsBsp);
            if (key.Id != 0 && !tables.ContainsKey(key)) tables[key] = MotionTableLoader.Load(cache.Source, key.Id, key.WithParts);
            Spawn(FirstSpawnId + (uint)i, spawn, setup, tables.GetValueOrDefault(key), options.Seed + (ulong)i);
        }
    }

    public PhysicsEngine Engine { get; }

    public WorldServer Server => server;

    /// <summary>Shape and motions of players.</summary>
    public SetupAsset Human { get; }

    public MotionTableAsset Motions { get; }

    public IReadOnlyList<PlayerItem> Players => players;

    public List<WorldItem> Items => items;

    /// <summary>Memory for the message that is told to many.</summary>
    public byte[] Scratch { get; } = new byte[LongestMessage];

    /// <summary>Lets a character into the world.</summary>
    /// <returns>False when there is no place for it.</returns>
    public bool TryEnter(ClientConnection client, Character character)
    {
        MovementAuthority authority = new(Engine, Human, Motions, character.Stats, server.Options.Authority);
        if (!TryPlace(authority, character.Place) && !TryPlace(authority, server.Options.Start)) return false;
        PlayerItem player = new(this, client, character, authority);
        players.Add(player);
        items.Add(player);
        player.Enter();
        server.Figures.Entered++;
        server.Say($"{character.Name} entered the world at {authority.Position}");
        return true;
    }

    /// <summary>Puts a player's authority to a place, around which everything is loaded.</summary>
    /// <returns>False when nobody can be there; it is where it was then.</returns>
    public bool TryPlace(MovementAuthority authority, Position place)
    {
        if (!place.IsValid || !float.IsFinite(place.Frame.Origin.LengthSquared())) return false;
        if (CellIds.IsOutdoor(place.CellId) && !place.AdjustToOutside()) return false;
        LoadAround(place);
        return IsLoaded(place) && authority.TryPlace(place, server.Now);
    }

    /// <summary>There is ground, or a room, at a place.</summary>
    public bool IsLoaded(in Position place) => Engine.World.GetVisible(place.CellId) is not null;

    /// <summary>Loads what a player at a place may reach.</summary>
    public void LoadAround(in Position place) => Engine.World.EnsureLoadedAround(new Position(place.CellId, Vector3.Zero), LoadRadius);

    /// <summary>A player leaves the world: who knows it is told. Its client is with it a while longer.</summary>
    public void Remove(PlayerItem player)
    {
        goingOut.Add(player);
        players.Remove(player);
        items.Remove(player);
        foreach (PlayerItem other in players) other.Awareness.Forget(player);
        Engine.RemoveBody(player.Body);
    }

    /// <summary>A player's client is without it from now on.</summary>
    public void LetGo(PlayerItem player) => goingOut.Remove(player);

    /// <summary>The object with this id, or null.</summary>
    public WorldItem? Find(uint id)
    {
        foreach (WorldItem item in items)
            if (item.Id == id) return item;
        return null;
    }

    /// <summary>Lets the time pass; at most sixty times a second.</summary>
    public void Step(double now)
    {
        if (now < nextStep) return;
        nextStep = Math.Max(nextStep + StepInterval, now);
        foreach (CreatureItem creature in creatures) creature.Act(now);
        if (Engine.Tick(now))
        {
            foreach (CreatureItem creature in creatures) creature.LookOn();
        }

        foreach (DoorItem door in doors) door.Update(now);
        Follow(now);
    }

    /// <summary>Loads the land around a player that has come into another landblock, and drops what is near nobody.</summary>
    public void Settle(in Position place)
    {
        LoadAround(place);
        leaving.Clear();
        foreach (Landblock block in Engine.World.Landblocks)
        {
            bool isNear = false;
            foreach (PlayerItem player in players) isNear |= IsNear(block.Id, player.Place.CellId);
            if (!isNear && !IsNear(block.Id, place.CellId)) leaving.Add(block.Id);
        }

        foreach (uint block in leaving) Engine.World.UnloadLandblock(block);
    }

    private void Spawn(uint id, WorldSpawn spawn, SetupAsset setup, MotionTableAsset? motions, ulong seed)
    {
        WorldItem item;
        if (spawn.Kind == WorldSpawnKind.Door)
        {
            DoorItem door = new(this, id, spawn, setup);
            doors.Add(door);
            item = door;
        }
        else
        {
            CreatureItem creature = new(this, id, spawn, setup, motions, seed);
            creatures.Add(creature);
            item = creature;
        }

        items.Add(item);
        item.Body.EnterWorld(spawn.Place);
    }

    /// <summary>Who has come into another cell is looked at by all, and looks around.</summary>
    private void Follow(double now)
    {
        foreach (WorldItem item in items)
        {
            uint cell = item.IsThere ? item.Place.CellId : 0;
            if (cell == item.SeenIn) continue;
            item.SeenIn = cell;
            foreach (PlayerItem player in players) player.Awareness.Look(item, now);
            if (item is PlayerItem { IsLeaving: false } own) own.Awareness.LookAround(now);
        }

        for (int i = players.Count - 1; i >= 0; i--) players[i].Update(now);
        for (int i = goingOut.Count - 1; i >= 0; i--)
        {
            if (now < goingOut[i].OutAt) continue;
            goingOut[i].EndLeaving(tells: true);
        }
    }

    private static bool IsNear(uint one, uint other) =>
        Math.Abs((int)(one >> 24) - (int)(other >> 24)) <= KeepRadius &&
        Math.Abs((int)((one >> 16) & 0xFF) - (int)((other >> 16) & 0xFF)) <= KeepRadius;
}
