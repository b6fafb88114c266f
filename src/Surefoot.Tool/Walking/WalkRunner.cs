using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Tool.Walking;

/// <summary>Walks a script: hands on the keys, a server that answers, the world ticking at retail's rate.</summary>
internal sealed class WalkRunner : IMovementObserver
{
    /// <summary>Seconds between two looks at the keys: a frame of 60 a second.</summary>
    private const double Frame = 1.0 / 60;

    /// <summary>Seconds given to the body to stand before the script begins.</summary>
    private const double SettleTime = 0.5;

    private readonly List<WalkSample> samples = [];
    private readonly List<WalkEvent> events = [];
    private double start = double.NaN;

    /// <summary>Runs the script to its end.</summary>
    /// <param name="scene">The world.</param>
    /// <param name="place">Where it begins.</param>
    /// <param name="stats">The character.</param>
    /// <param name="legs">What the hands do.</param>
    /// <param name="script">The same as text, for the result.</param>
    /// <param name="latency">Seconds until the server answers.</param>
    /// <exception cref="UsageException">There is no room for a body at the place.</exception>
    internal static WalkResult Run(
        WalkScene scene, ScenePlace place, CharacterStats stats, IReadOnlyList<WalkLeg> legs, string script, double latency)
    {
        WalkRunner runner = new();
        runner.RunLegs(scene, place, stats, legs, latency);
        return new WalkResult(place.Name, script, stats.RunSkill, stats.JumpSkill, runner.samples, runner.events);
    }

    private void RunLegs(WalkScene scene, ScenePlace place, CharacterStats stats, IReadOnlyList<WalkLeg> legs, double latency)
    {
        scene.Follow(place.Position);
        PhysicsEngine engine = new(scene.World);
        engine.Tick(1.0);
        LocalPlayer player = LocalPlayer.Spawn(
            engine, WalkScene.PlayerId, scene.PlayerSetup, scene.PlayerMotions, place.Position,
            new LoopbackServer(WalkScene.PlayerId, stats, engine.Now, latency), new LocalPlayerOptions { Observer = this })
            ?? throw new UsageException($"There is no room for a body at {place.Name}.");
        if (!player.Body.HasCell)
            throw new UsageException($"{place.Name} is in no room: the metres lie outside the rooms around 0x{place.Position.CellId:X8}.");
        engine.Player = player.Body;

        double now = 1.0;
        for (int i = 0; i < SettleTime / Frame; i++) Advance(scene, engine, player, MovementKeys.None, now += Frame);
        start = now;
        Record(player, now);
        bool stood = player.Body.OnWalkable;
        uint cell = player.Body.Position.CellId;
        foreach (WalkLeg leg in legs)
        {
            int frames = Math.Max(1, (int)Math.Round(leg.Seconds / Frame));
            for (int i = 0; i < frames; i++)
            {
                MotionError refusedBefore = player.Controller.LastRefusal;
                if (Advance(scene, engine, player, leg.Keys, now += Frame)) Record(player, now);
                Notice(player, now, ref stood, ref cell, refusedBefore);
            }
        }
    }

    private static bool Advance(WalkScene scene, PhysicsEngine engine, LocalPlayer player, MovementKeys keys, double now)
    {
        player.Update(keys, now);
        bool ticked = engine.Tick(now);
        if (ticked) scene.Follow(player.Body.Position);
        return ticked;
    }

    private void Record(LocalPlayer player, double now)
    {
        Position p = player.Body.Position;
        Vector3 origin = p.Frame.Origin, v = player.Body.AchievedVelocity;
        Vector3 map = CellIds.BlockOffset(0x00000001, p.CellId) + origin;
        samples.Add(new WalkSample(
            now - start, p.CellId, origin, map, Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y)), p.Frame.Heading,
            player.Body.OnWalkable, player.Body.HasContact, player.Controller.JumpLevel(now)));
    }

    private void Notice(LocalPlayer player, double now, ref bool stood, ref uint cell, MotionError refusedBefore)
    {
        if (player.Body.OnWalkable != stood)
        {
            stood = player.Body.OnWalkable;
            Say(now, stood ? FormattableString.Invariant($"stands at z {player.Body.Position.Frame.Origin.Z:0.00} m") : "leaves the ground");
        }

        if (CellIds.BlockOf(player.Body.Position.CellId) != CellIds.BlockOf(cell))
            Say(now, $"enters landblock 0x{player.Body.Position.CellId >> 16:X4}");
        cell = player.Body.Position.CellId;
        if (player.Controller.LastRefusal != refusedBefore && player.Controller.LastRefusal != MotionError.None)
            Say(now, $"may not jump: {player.Controller.LastRefusal}");
        if (player.Body.IsLost) Say(now, "left what is loaded");
    }

    private void Say(double now, string what)
    {
        double time = now - start;
        if (time >= 0 && (events.Count == 0 || events[^1].What != what)) events.Add(new WalkEvent(time, what));
    }

    void IMovementObserver.OnMoveToState(in MoveToState message, double now)
    {
        WireRawMotion asked = message.Motion;
        Say(now, FormattableString.Invariant(
            $"sends MoveToState: {(MotionCommand)asked.ForwardCommand} at {asked.ForwardSpeed:0.##}, hold key {(HoldKey)asked.CurrentHoldKey}"));
    }

    void IMovementObserver.OnJump(in Jump message, double now)
    {
        Vector3 v = message.Velocity;
        Say(now, FormattableString.Invariant($"sends Jump: extent {message.Extent:0.000}, velocity ({v.X:0.00}, {v.Y:0.00}, {v.Z:0.00}) m/s"));
    }

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now)
    {
        WirePosition place = message.Position;
        Say(now, $"sends AutonomousPosition: {new Position(place.Cell, new Frame(place.Origin, place.Orientation))}");
    }
}
