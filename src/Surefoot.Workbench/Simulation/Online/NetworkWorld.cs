using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// A server's world: each page is a client of its own there, and what it shows of others is what that server says of them. The land comes
/// from dat files, which must be the server's own.
/// </summary>
internal sealed class NetworkWorld : IWorkbenchWorld
{
    private readonly DatSet dats;
    private readonly PhysicsDataCache cache;
    private readonly LandView view;
    private readonly OnlineOptions options;
    private readonly TimeProvider clock;
    private readonly List<NetworkPlayer> players = [];
    private volatile LeftOutNotice leftOut = LeftOutNotice.Nothing;

    /// <summary>A world over an open folder, which it takes over.</summary>
    /// <param name="dats">The files; disposed with the world.</param>
    /// <param name="places">Places to go to; those in cells that the files lack, or that cannot be read, are left out.</param>
    /// <param name="options">The server, and who logs in.</param>
    /// <param name="clock">Measures time; the system's by default.</param>
    /// <exception cref="DatRecordMissingException">The region is missing.</exception>
    /// <exception cref="DatFormatException">It is malformed.</exception>
    /// <exception cref="DatFolderException">There is no landblock that can be read.</exception>
    public NetworkWorld(DatSet dats, IReadOnlyList<WorkbenchPlace> places, OnlineOptions options, TimeProvider? clock = null)
    {
        this.dats = dats;
        this.options = options;
        this.clock = clock ?? TimeProvider.System;
        cache = new PhysicsDataCache(dats);
        view = new LandView(dats, cache, new Physics.PhysicsEngine(cache).World.Region);
        Places = view.PlacesOf(places);
    }

    /// <inheritdoc/>
    public string Name => options.Server.ToString();

    /// <inheritdoc/>
    public IReadOnlyList<WorkbenchPlace> Places { get; }

    /// <inheritdoc/>
    public LeftOutNotice LeftOut => leftOut;

    /// <inheritdoc/>
    public int BurdenCapacity => MovementFormulas.Capacity(SimulatedPlayer.Strength, 0);

    /// <summary>Is told in a sentence what becomes of sessions.</summary>
    public Action<string>? Notice { get; init; }

    /// <inheritdoc/>
    public IWorkbenchPlayer Join(uint id, PlayerSettings settings, WorkbenchPlace place, double now)
    {
        NetworkPlayer player = new(cache, options, players.Count, place, now, clock) { Notice = Notice };
        players.Add(player);
        return player;
    }

    /// <inheritdoc/>
    public void Leave(IWorkbenchPlayer player)
    {
        NetworkPlayer gone = (NetworkPlayer)player;
        if (players.Remove(gone)) gone.Dispose();
    }

    /// <inheritdoc/>
    public bool Advance(double now)
    {
        foreach (NetworkPlayer player in players)
        {
            player.Advance(now);
            if (player.World is { } land && land.LeftOut.Total > leftOut.Total) leftOut = LeftOutNotice.Of(land.LeftOut);
        }

        return true;
    }

    /// <inheritdoc/>
    public void LookAtPlayers(IWorkbenchPlayer player, List<(uint Id, PlayerPose Pose)> near) =>
        NetworkSight.Players(((NetworkPlayer)player).Game, near);

    /// <inheritdoc/>
    /// <remarks>A server tells what it tells: where others are in truth, nobody knows here.</remarks>
    public void LookAtTruth(IWorkbenchPlayer player, List<TruePlace> near) => near.Clear();

    /// <inheritdoc/>
    public void Look(IWorkbenchPlayer player, List<BodyPose> near) => NetworkSight.Bodies(((NetworkPlayer)player).Game, near);

    /// <inheritdoc/>
    public void LookAtParts(IWorkbenchPlayer player, List<MovingPart> near)
    {
        near.Clear();
        if (((NetworkPlayer)player).Game is { Player: { } local } game)
            LandView.LookAtParts(game.Engine.World, local.Body.Position, near);
    }

    /// <inheritdoc/>
    public TerrainBlock? ReadTerrain(ushort block) => view.ReadTerrain(block);

    /// <inheritdoc/>
    public BlockShapes? ReadShapes(ushort block) => view.ReadShapes(block);

    /// <inheritdoc/>
    public void Dispose()
    {
        foreach (NetworkPlayer player in players) player.Dispose();
        players.Clear();
        dats.Dispose();
    }
}
