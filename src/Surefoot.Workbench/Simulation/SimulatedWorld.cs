using System.Numerics;
using Microsoft.Extensions.Logging;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Workbench.Simulation;

/// <summary>The physics over a folder of dat files, with a player for each page.</summary>
internal sealed partial class SimulatedWorld : IWorkbenchWorld
{
    private const uint HumanSetup = 0x02000001;
    private const int KeepRadius = 3;
    private const ulong WandererSeed = 1;

    /// <summary>How long the server in this process takes to answer, seconds: enough to see that a new skill waits for it.</summary>
    private const double ServerLatency = 0.1;

    private readonly DatSet dats;
    private readonly PhysicsDataCache cache;
    private readonly PhysicsWorld land;
    private readonly LandView view;
    private readonly PhysicsEngine engine;
    private readonly SetupAsset human;
    private readonly MotionTableAsset humanMotions;
    private readonly Inhabitants inhabitants;
    private readonly Arrival arrival;
    private readonly ILogger logger;
    private readonly List<SimulatedPlayer> players = [];
    private readonly List<ISeenObject> seen;
    private readonly DatObjectAssets seenAssets;
    private readonly List<uint> leaving = [];
    private volatile LeftOutNotice leftOut = LeftOutNotice.Nothing;

    /// <summary>A world over an open folder, which it takes over.</summary>
    /// <param name="name">Name shown on the page.</param>
    /// <param name="dats">The files; disposed with the world.</param>
    /// <param name="places">Places to go to; those in cells that the files lack, or that cannot be read, are left out.</param>
    /// <param name="logger">Is told of what is left out because it cannot be read.</param>
    /// <param name="spawns">Whom and what to spawn.</param>
    /// <exception cref="DatRecordMissingException">
    /// The region, the human setup or its motion table is missing, or those of a spawn.
    /// </exception>
    /// <exception cref="DatFormatException">One of them is malformed.</exception>
    /// <exception cref="InvalidDataException">The human setup names no motion table.</exception>
    /// <exception cref="DatFolderException">There is no landblock that can be read.</exception>
    public SimulatedWorld(string name, DatSet dats, IReadOnlyList<WorkbenchPlace> places, ILogger logger, IReadOnlyList<DemoSpawn> spawns)
    {
        this.dats = dats;
        this.logger = logger;
        Name = name;
        cache = new PhysicsDataCache(dats);
        engine = new PhysicsEngine(cache);
        land = engine.World;
        human = cache.GetSetup(HumanSetup);
        humanMotions = MotionTableLoader.LoadFor(dats, human, leftOut: land.LeftOut);
        inhabitants = new Inhabitants(engine, cache, spawns, WandererSeed);
        seen = [.. inhabitants.All.Select(one => one.Seen).OfType<ISeenObject>()];
        seenAssets = new DatObjectAssets(cache, land.LeftOut, movesHands: false);
        arrival = new Arrival(engine, land, human, cellId => LoadAround(cellId, 1));
        view = new LandView(dats, cache, land.Region);
        Places = view.PlacesOf(places);
    }

    /// <inheritdoc/>
    public string Name { get; }

    /// <inheritdoc/>
    public IReadOnlyList<WorkbenchPlace> Places { get; }

    /// <inheritdoc/>
    public LeftOutNotice LeftOut => leftOut;

    /// <summary>Folder of the dat files, for a command that is to use the same; null for the demo world.</summary>
    public string? DatFolder { get; init; }

    /// <summary>Is told once, in words, when something is left out.</summary>
    public Action<string>? Notice { get; init; }

    /// <inheritdoc/>
    public int BurdenCapacity => MovementFormulas.Capacity(SimulatedPlayer.Strength, 0);

    /// <inheritdoc/>
    public IWorkbenchPlayer Join(uint id, PlayerSettings settings, WorkbenchPlace place, double now)
    {
        PlaceRefusal refusal = FindPlace(place, null, out Position position);
        if (refusal != PlaceRefusal.None) throw new InvalidOperationException($"A player cannot be at {place.Name}: {refusal}.");
        LoopbackServer server = new(id, SimulatedPlayer.StatsOf(settings), engine.Now, ServerLatency);
        SimulatedPlayer player = new(server, settings, NameOf);
        LocalPlayer? spawned = LocalPlayer.Spawn(
            engine, id, human, humanMotions, position, server, new LocalPlayerOptions { Observer = player, Trace = player.Trace });
        if (spawned is null) throw new InvalidOperationException($"There is no room for a player at {place.Name}.");
        player.Enter(spawned, this, human, new Viewer(id, cache, land.Region, seenAssets, human, engine.Now), now);
        players.Add(player);
        seen.Add(player.Seen);
        return player;
    }

    /// <inheritdoc/>
    public void Leave(IWorkbenchPlayer player)
    {
        SimulatedPlayer gone = (SimulatedPlayer)player;
        if (!players.Remove(gone)) return;
        gone.Viewer.ForgetAll();
        seen.Remove(gone.Seen);
        foreach (SimulatedPlayer other in players) other.Viewer.Forget(gone.Seen.Id);
        engine.RemoveBody(gone.Player.Body);
    }

    /// <inheritdoc/>
    public bool Advance(double now)
    {
        foreach (SimulatedPlayer player in players) player.BeforeTick(now);
        inhabitants.Act(now);
        if (!engine.Tick(now)) return false;
        inhabitants.LookOn();
        foreach (SimulatedPlayer player in players)
        {
            player.AfterTick(now);
            if (player.EnteredBlock(out uint cellId)) Resettle(cellId);
        }

        foreach (SimulatedPlayer player in players) player.Viewer.Tick(player.Player.Body.Position, seen, now);
        return true;
    }

    /// <inheritdoc/>
    public void Look(IWorkbenchPlayer player, List<BodyPose> near) =>
        Sight.Bodies((SimulatedPlayer)player, inhabitants.All, near);

    /// <inheritdoc/>
    public void LookAtPlayers(IWorkbenchPlayer player, List<(uint Id, PlayerPose Pose)> near) =>
        Sight.Players((SimulatedPlayer)player, players, near);

    /// <inheritdoc/>
    public void LookAtTruth(IWorkbenchPlayer player, List<TruePlace> near) => Sight.Truth((SimulatedPlayer)player, seen, near);

    /// <inheritdoc/>
    public void LookAtParts(IWorkbenchPlayer player, List<MovingPart> near) =>
        LandView.LookAtParts(land, ((SimulatedPlayer)player).Player.Body.Position, near);

    /// <inheritdoc/>
    public TerrainBlock? ReadTerrain(ushort block) => view.ReadTerrain(block);

    /// <inheritdoc/>
    public BlockShapes? ReadShapes(ushort block) => view.ReadShapes(block);

    /// <inheritdoc/>
    public void Dispose() => dats.Dispose();

    /// <summary>Where a player is put who asks for a place: beside the other players.</summary>
    /// <param name="place">What is asked for.</param>
    /// <param name="player">Who asks; null for one who is not in the world yet.</param>
    /// <param name="position">Where that is.</param>
    /// <returns>None, or why nobody can be there.</returns>
    internal PlaceRefusal FindPlace(WorkbenchPlace place, SimulatedPlayer? player, out Position position)
    {
        PlaceRefusal refusal = arrival.Find(place, out position);
        if (refusal == PlaceRefusal.None)
            position = arrival.Beside(position, [.. players.Where(other => other != player).Select(other => other.Player.Body)]);
        return refusal;
    }

    /// <summary>A player wants a creature to do something.</summary>
    internal void Ask(SimulatedPlayer player, uint creature, CreatureWish wish) => inhabitants.Ask(creature, wish, player.Seen.Id);

    /// <summary>The nearest door within a player's reach opens, or closes.</summary>
    internal void UseDoor(SimulatedPlayer player, double now) => inhabitants.UseDoor(player.Player.Body.Position, now);

    /// <summary>Is a cell a room from which the land is not seen?</summary>
    internal bool IsEnclosed(uint cellId) => LandView.IsEnclosed(land, cellId);

    /// <summary>Loads what a player in this cell may reach; before it is put there.</summary>
    internal void LoadAround(uint cellId, int radius)
    {
        land.EnsureLoadedAround(new Position(cellId, Vector3.Zero), radius);
        if (land.LeftOut.Total == leftOut.Total) return;
        if (leftOut.Total == 0)
            Notice?.Invoke(
                $"the world does without what is missing or cannot be read; the page lists it all. The first: {land.LeftOut[0]}");
        LogLeftOut(logger, land.LeftOut.Total, land.LeftOut[^1]);
        leftOut = LeftOutNotice.Of(land.LeftOut);
    }

    private void Resettle(uint cellId)
    {
        LoadAround(cellId, 1);
        leaving.Clear();
        foreach (Landblock block in land.Landblocks)
        {
            if (!players.Exists(player => IsNear(block.Id, player.Pose.CellId))) leaving.Add(block.Id);
        }

        foreach (uint blockId in leaving) land.UnloadLandblock(blockId);
    }

    private (TouchKind Kind, string Name) NameOf(uint bodyId) =>
        inhabitants.Find(bodyId) is { } one ? (TouchKind.Body, one.Name) : (TouchKind.Player, $"player {bodyId}");

    private static bool IsNear(uint blockId, uint cellId) =>
        Math.Abs((int)(blockId >> 24) - (int)(cellId >> 24)) <= KeepRadius &&
        Math.Abs((int)((blockId >> 16) & 0xFF) - (int)((cellId >> 16) & 0xFF)) <= KeepRadius;

    [LoggerMessage(Level = LogLevel.Warning, Message = "{Total} things of the files are left out by now, such as {Item}")]
    private static partial void LogLeftOut(ILogger logger, long total, LeftOutItem item);
}
