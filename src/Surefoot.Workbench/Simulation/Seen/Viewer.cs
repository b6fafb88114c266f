using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// The other bodies as one page sees them: a world of its own, in which they are moved by what a server says of them, over a network that
/// may be bad. What is in it is never looked up in the true world.
/// </summary>
internal sealed class Viewer : IRemoteObserver
{
    /// <summary>How far away objects become known, and are forgotten, metres.</summary>
    public const double KnownWithin = 160, ForgottenBeyond = 192;

    /// <summary>Nobody goes so far in a quantum, metres.</summary>
    private const double Leap = 4;

    private const int LoadRadius = 1, KeepRadius = 2;

    private readonly uint player;
    private readonly IObjectAssets assets;
    private readonly PhysicsEngine engine;
    private readonly PhysicsBody self;
    private readonly Dictionary<uint, ISeenObject> known = [];
    private readonly Dictionary<uint, (Position Place, byte Count)> leaps = [];
    private readonly List<uint> leaving = [];
    private RemoteWorld others;
    private SimulatedSession session;
    private NetworkQuality quality;
    private uint settled;

    /// <summary>A page's view, in which nobody is known yet.</summary>
    /// <param name="player">Id of the page's player.</param>
    /// <param name="cache">Shapes.</param>
    /// <param name="region">The region.</param>
    /// <param name="assets">The same, as objects name them.</param>
    /// <param name="shape">The player's shape.</param>
    /// <param name="now">Seconds.</param>
    public Viewer(uint player, PhysicsDataCache cache, RegionAsset region, IObjectAssets assets, SetupAsset shape, double now)
    {
        this.player = player;
        this.assets = assets;
        engine = new PhysicsEngine(cache, new PhysicsEngineOptions { Region = region });
        engine.Tick(now);
        self = engine.CreateBody(
            player, shape, PhysicsState.ReportCollisions, WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player);
        engine.Player = self;
        (others, session) = Open(now);
    }

    /// <summary>How bad the network is from now on.</summary>
    public NetworkQuality Quality
    {
        get => quality;
        set => session.Quality = quality = value;
    }

    /// <summary>The server says something to this page.</summary>
    public void Tell<T>(in T message)
        where T : IMessage<T> => session.SendToClient(message);

    /// <summary>The body by which an object is seen here; null while it is unknown, nowhere or hidden.</summary>
    public PhysicsBody? Find(uint id) =>
        others.Find(id)?.Body is { HasCell: true } body && (body.State & PhysicsState.Hidden) == 0 ? body : null;

    /// <summary>What a body found here does.</summary>
    public MotionSummary MotionsOf(PhysicsBody body) => engine.MovementOf(body)?.Motions ?? default;

    /// <summary>How often a body found here was not moved but put somewhere else, modulo 256.</summary>
    public byte LeapsOf(PhysicsBody body) => leaps.GetValueOrDefault(body.Id).Count;

    /// <summary>What is near becomes known, what is far is forgotten; then the time passes here. After the true world's tick.</summary>
    /// <param name="place">Where the page's player is.</param>
    /// <param name="objects">Everything there is but the page's player.</param>
    /// <param name="now">Seconds.</param>
    public void Tick(in Position place, IReadOnlyList<ISeenObject> objects, double now)
    {
        if (!session.IsAlive)
        {
            ForgetAll();
            (others, session) = Open(now);
        }

        Settle(place);
        foreach (ISeenObject one in objects)
        {
            if (one.Id == player) continue;
            double distance = one.IsThere ? one.Place.DistanceTo(place) : double.PositiveInfinity;
            if (distance <= KnownWithin && !known.ContainsKey(one.Id)) Meet(one);
            else if (distance > ForgottenBeyond) Forget(one.Id);
        }

        others.Update(now);
        engine.Tick(now);
        session.Update(now, others);
        foreach (RemoteBody one in others.Objects) CountLeaps(one.Body);
    }

    /// <summary>An object is gone for good.</summary>
    public void Forget(uint id)
    {
        if (!known.Remove(id, out ISeenObject? one)) return;
        one.Audience.Remove(this);
        Tell(new DeleteObject(id, Instance: 1));
    }

    /// <summary>The page is gone: nobody tells it anything any more.</summary>
    public void ForgetAll()
    {
        foreach (ISeenObject one in known.Values) one.Audience.Remove(this);
        known.Clear();
        leaps.Clear();
        foreach (RemoteBody one in others.Objects) engine.RemoveBody(one.Body);
    }

    private void CountLeaps(PhysicsBody body)
    {
        if (!leaps.TryGetValue(body.Id, out (Position Place, byte Count) before)) before = (body.Position, 0);
        leaps[body.Id] = (body.Position, (byte)(before.Count + (before.Place.DistanceTo(body.Position) > Leap ? 1 : 0)));
    }

    /// <summary>One that nobody saw for a while is told again when it comes near.</summary>
    void IRemoteObserver.OnDeleting(RemoteBody item)
    {
        leaps.Remove(item.Id);
        if (known.Remove(item.Id, out ISeenObject? one)) one.Audience.Remove(this);
    }

    private (RemoteWorld Others, SimulatedSession Session) Open(double now) => (
        new RemoteWorld(engine, assets, new RemoteWorldOptions { Player = player, Observer = this }),
        new SimulatedSession(quality, player, now));

    private void Meet(ISeenObject one)
    {
        known.Add(one.Id, one);
        Tell(one.Describe());
        one.Audience.Add(this);
    }

    /// <summary>The page's own player stands in the way here as it does there, and the land around it is loaded.</summary>
    private void Settle(in Position place)
    {
        uint block = CellIds.BlockOf(place.CellId);
        if (block != settled)
        {
            settled = block;
            engine.World.EnsureLoadedAround(place, LoadRadius);
            leaving.Clear();
            foreach (Landblock loaded in engine.World.Landblocks)
                if (!IsNear(loaded.Id, block)) leaving.Add(loaded.Id);
            foreach (uint far in leaving) engine.World.UnloadLandblock(far);
        }

        if (engine.World.GetVisible(place.CellId) is null) return;
        if (self.HasCell) self.Seat(new BodySeat(place, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
        else self.EnterWorld(place);
    }

    private static bool IsNear(uint one, uint other) =>
        Math.Abs((int)(one >> 24) - (int)(other >> 24)) <= KeepRadius &&
        Math.Abs((int)((one >> 16) & 0xFF) - (int)((other >> 16) & 0xFF)) <= KeepRadius;
}
