using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Network;

/// <summary>What is tried.</summary>
/// <param name="Way">Places to run to and fro between, two at least, all within sight of each other.</param>
/// <param name="Stats">The character.</param>
/// <param name="Quality">How bad the network is.</param>
/// <param name="Seed">Seed of the network and of what the hands do.</param>
/// <param name="Seconds">How long.</param>
internal sealed record NetworkTrial(
    IReadOnlyList<ScenePlace> Way, CharacterStats Stats, NetworkQuality Quality, int Seed, double Seconds)
{
    /// <summary>How much the server tells others of the runner.</summary>
    internal BroadcastDetail Detail { get; init; }

    /// <summary>How many times as often as a calm player's the hands change their mind.</summary>
    internal double Pace { get; init; } = 1;
}

/// <summary>
/// A player in one world, and the same player as an onlooker in a second world sees it, who hears of it over a bad network.
/// </summary>
internal sealed class NetworkRun : IMovementObserver, IAudience, IMessageReceiver
{
    /// <summary>A little more than 1/30 s, so that each frame is a quantum whatever the rounding of the clock.</summary>
    private const double FrameTime = (1.0 / 30) + 1e-9;

    /// <summary>Seconds after its arrival at which a last report is looked at.</summary>
    private const double RestTime = 2;

    /// <summary>The onlooker stays so near that the runner is followed and not put from place to place, metres.</summary>
    private const double Sight = 40;

    private const double SettleTime = 0.5;
    private const int LoadRadius = 1;
    private const uint RunnerId = 0x50000001, OnlookerId = 0x50000002;

    private readonly NetworkTrial trial;
    private readonly Player runner;
    private readonly PhysicsEngine far;
    private readonly PhysicsBody onlooker;
    private readonly RemoteWorld remote;
    private readonly PlayerBroadcast broadcast;
    private readonly SimulatedSession session;
    private readonly WorldQuery query;
    private readonly Mover mover;
    private readonly WanderingHands hands;
    private readonly RecentPath path = new();
    private readonly List<RestDistance> atRest = [];
    private readonly List<double> offPath = [];
    private double start, now, climbed, lastHeight;
    private readonly SolidTest solids;
    private int jumps;
    private long messages, claims, placedClaim, arrivedClaim;
    private ushort placedStamp;
    private (Position Place, double Arrived)? lastReport;

    private NetworkRun(WalkScene scene, NetworkTrial trial)
    {
        this.trial = trial;
        Simulation simulation = scene.Simulation;
        List<Position> way = [.. trial.Way.Select(place => simulation.Find(place.Place))];
        hands = new WanderingHands(way, trial.Seed, trial.Pace);
        now = simulation.Engine.Now + 1;
        simulation.Tick(now);
        runner = simulation.SpawnPlayer(trial.Way[0].Place, trial.Stats, RunnerId, options: new LocalPlayerOptions { Observer = this });
        simulation.Engine.Player = runner.Body;

        far = new PhysicsEngine(simulation.Assets);
        far.World.EnsureLoadedAround(runner.Position, LoadRadius);
        far.Tick(now);
        onlooker = far.CreateBody(
            OnlookerId, simulation.Human, PhysicsState.Default | PhysicsState.Ethereal | PhysicsState.IgnoreCollisions);
        onlooker.EnterWorld(runner.Position);
        far.Player = onlooker;
        remote = new RemoteWorld(
            far, new DatObjectAssets(simulation.Assets, movesHands: false),
            new RemoteWorldOptions { Player = OnlookerId, Commands = CommandTable.Retail });
        query = far.CreateQuery();
        mover = new Mover(simulation.Human, weenie: WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player);
        solids = new SolidTest(far, mover);

        session = new SimulatedSession(trial.Quality, (ulong)trial.Seed, now);
        broadcast = new PlayerBroadcast(RunnerId, WireOf(runner.Position), this, runner.Server.RunRate)
        {
            Detail = trial.Detail,
        };
        Tell(broadcast.Describe(simulation.Human.Id, simulation.HumanMotions.Id, "runner"));
    }

    /// <summary>Tries it.</summary>
    /// <param name="scene">The world.</param>
    /// <param name="trial">What is tried.</param>
    /// <param name="report">Told how many of how many seconds are over.</param>
    /// <exception cref="PlaceException">No player can be at the first place.</exception>
    internal static NetworkFigures Run(WalkScene scene, NetworkTrial trial, Action<int, int>? report = null)
    {
        NetworkRun run = new(scene, trial);
        try
        {
            run.Run(report);
        }
        finally
        {
            scene.Simulation.Remove(run.runner);
        }

        return run.Figures();
    }

    void IMovementObserver.OnMoveToState(in MoveToState message, double now)
    {
        NoteClaim();
        broadcast.Take(message, now);
    }

    void IMovementObserver.OnJump(in Jump message, double now)
    {
        jumps++;
        NoteClaim();
        broadcast.Take(message);
    }

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now)
    {
        NoteClaim();
        broadcast.Take(message, now);
    }

    /// <summary>The server says something of the runner.</summary>
    public void Tell<T>(in T message)
        where T : IMessage<T>
    {
        messages++;
        if (T.Id.Opcode == Opcode.UpdatePosition && placedClaim != claims)
            (placedClaim, placedStamp) = (claims, broadcast.Stamps.Position);
        if (!session.SendToClient(message)) throw new InvalidOperationException($"{T.Id} could not be sent: the session is over.");
    }

    /// <summary>The onlooker's client hears something.</summary>
    void IMessageReceiver.OnMessage(in WireMessage message)
    {
        remote.OnMessage(message);
        if (arrivedClaim == claims || placedClaim != claims || !message.TryRead(out UpdatePosition told) || !told.Pack.Contact ||
            ObjectStamps.IsNewer(told.Pack.PositionStamp, placedStamp))
            return;
        arrivedClaim = claims;
        lastReport = (Of(told.Pack.Position), now);
    }

    /// <summary>The runner reports something: what it reported before is not the last any more.</summary>
    private void NoteClaim()
    {
        claims++;
        lastReport = null;
    }

    private static WirePosition WireOf(in Position place) => new(place.CellId, place.Frame.Origin, place.Frame.Rotation);

    private static Position Of(in WirePosition place) => new(place.Cell, new Frame(place.Origin, place.Orientation));

    private void Run(Action<int, int>? report)
    {
        for (int i = 0; i < SettleTime / FrameTime; i++) Frame(MovementKeys.None);
        start = now;
        lastHeight = runner.Position.Frame.Origin.Z;
        int said = 0;
        while (now - start < trial.Seconds)
        {
            Frame(hands.KeysAt(runner.Position, now));
            Measure();
            if (now - start < said + 1) continue;
            report?.Invoke(++said, (int)trial.Seconds);
        }
    }

    /// <summary>In each world a frame, in retail's order.</summary>
    private void Frame(MovementKeys keys)
    {
        now += FrameTime;
        runner.Update(keys, now);
        broadcast.Update(now);
        path.Add(runner.Position, now);

        remote.Update(now);
        far.Tick(now);
        session.Update(now, this);
        far.World.EnsureLoadedAround(onlooker.Position, LoadRadius);
    }

    private void Measure()
    {
        if (runner.Body.OnWalkable) climbed += Math.Max(0, runner.Position.Frame.Origin.Z - lastHeight);
        lastHeight = runner.Position.Frame.Origin.Z;
        if (remote.Find(RunnerId)?.Body is not { } drawn) return;
        Position place = drawn.Position;
        offPath.Add(path.DistanceTo(place));
        if (lastReport is { } last && now - last.Arrived >= RestTime)
        {
            atRest.Add(Rest(drawn, last.Place));
            lastReport = null;
        }

        solids.Judge(drawn, BlipsOf(drawn), now - start);
        if (onlooker.Position.DistanceTo(place) > Sight) onlooker.SetPositionSimple(place, sliding: true);
    }

    /// <summary>How far a body is from where it was told to be, and what retail's placement and sweep would make of that.</summary>
    private RestDistance Rest(PhysicsBody drawn, in Position told)
    {
        Position place = drawn.Position;
        PlaceResult put = query.Place(new PlaceInput(mover, told));
        return new RestDistance(
            place.DistanceTo(told), put.Found ? place.DistanceTo(put.Position) : double.MaxValue,
            query.Sweep(drawn, told).Position.DistanceTo(told));
    }

    private static long BlipsOf(PhysicsBody drawn) => SteeredPhysicsBody.Of(drawn).PositionManager?.Interpolation?.BlipCount ?? 0;

    private NetworkFigures Figures()
    {
        double[] sorted = [.. offPath.Order()];
        long blips = remote.Find(RunnerId)?.Body is { } drawn ? BlipsOf(drawn) : 0;
        return new NetworkFigures(
            sorted.Length, atRest, sorted, solids.Judged, solids.InSolid, solids.Swept, blips, hands.Reached, jumps, climbed, messages,
            session.ServerStatistics.Resent, now - start);
    }
}
