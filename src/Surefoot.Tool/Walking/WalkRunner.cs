using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

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
    /// <param name="quantum">
    /// Seconds, from 1/30 on: each leg is divided into quanta of this length, as near as may be, and takes exactly its time. Null for a
    /// game's frames, which quanta and keys wait for.
    /// </param>
    /// <exception cref="UsageException">No player can be at the place.</exception>
    internal static WalkResult Run(
        WalkScene scene, ScenePlace place, CharacterStats stats, IReadOnlyList<WalkLeg> legs, string script, double latency,
        double? quantum = null)
    {
        WalkRunner runner = new();
        runner.RunLegs(scene, place, stats, legs, latency, quantum);
        return new WalkResult(place.Name, script, stats.RunSkill, stats.JumpSkill, runner.samples, runner.events);
    }

    private void RunLegs(
        WalkScene scene, ScenePlace place, CharacterStats stats, IReadOnlyList<WalkLeg> legs, double latency, double? quantum)
    {
        double now = scene.Simulation.Engine.Now + 1;
        scene.Simulation.Tick(now);
        Player player = Spawn(scene.Simulation, place, stats, latency);
        scene.Simulation.Engine.Player = player.Body;
        for (int i = 0; i < SettleTime / Frame; i++) player.Update(MovementKeys.None, now += Frame);
        start = now;
        Record(player, now);
        bool stood = player.Body.OnWalkable;
        uint cell = player.Body.Position.CellId;
        foreach (WalkLeg leg in legs)
        {
            (int updates, double each) = Divide(leg.Seconds, quantum);
            if (quantum is not null) player.Update(leg.Keys, now);
            for (int i = 0; i < updates; i++)
            {
                MotionError refusedBefore = player.Local.Controller.LastRefusal;
                if (player.Update(leg.Keys, now += each)) Record(player, now);
                Notice(player, now, ref stood, ref cell, refusedBefore);
            }
        }

        scene.Simulation.Remove(player);
    }

    /// <summary>How often the keys of a leg are looked at, and how many seconds apart.</summary>
    private static (int Updates, double Each) Divide(double seconds, double? quantum)
    {
        if (quantum is not { } wanted) return (Math.Max(1, (int)Math.Round(seconds / Frame)), Frame);
        // A quantum that lacks the last bit of its least time would wait for the next update.
        int most = (int)(seconds / (PhysicsBody.MinQuantum + 1e-9));
        int quanta = Math.Max(1, Math.Min(most, (int)Math.Round(seconds / wanted)));
        return (quanta, seconds / quanta);
    }

    private Player Spawn(Simulation simulation, ScenePlace place, CharacterStats stats, double latency)
    {
        try
        {
            return simulation.SpawnPlayer(place.Place, stats, latency: latency, options: new LocalPlayerOptions { Observer = this });
        }
        catch (PlaceException e)
        {
            throw new UsageException($"--at {e.Message}");
        }
    }

    private void Record(Player player, double now)
    {
        Position p = player.Body.Position;
        Vector3 origin = p.Frame.Origin, v = player.Body.AchievedVelocity;
        Vector3 map = CellIds.BlockOffset(0x00000001, p.CellId) + origin;
        samples.Add(new WalkSample(
            now - start, p.CellId, origin, map, Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y)), p.Frame.Heading,
            player.Body.OnWalkable, player.Body.HasContact, player.Local.Controller.JumpLevel(now)));
    }

    private void Notice(Player player, double now, ref bool stood, ref uint cell, MotionError refusedBefore)
    {
        if (player.Body.OnWalkable != stood)
        {
            stood = player.Body.OnWalkable;
            Say(now,
                stood ? FormattableString.Invariant($"stands at z {player.Body.Position.Frame.Origin.Z:0.00} m") : "leaves the ground");
        }

        if (CellIds.BlockOf(player.Body.Position.CellId) != CellIds.BlockOf(cell))
            Say(now, $"enters landblock 0x{player.Body.Position.CellId >> 16:X4}");
        cell = player.Body.Position.CellId;
        if (player.Local.Controller.LastRefusal != refusedBefore && player.Local.Controller.LastRefusal != MotionError.None)
            Say(now, $"may not jump: {player.Local.Controller.LastRefusal}");
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
        HoldKey key = (HoldKey)asked.CurrentHoldKey;
        Say(now, FormattableString.Invariant(
            $"sends MoveToState: {(MotionCommand)asked.ForwardCommand} at {asked.ForwardSpeed:0.##}, hold key {key}"));
    }

    void IMovementObserver.OnJump(in Jump message, double now)
    {
        Vector3 v = message.Velocity;
        Say(now,
            FormattableString.Invariant($"sends Jump: extent {message.Extent:0.000}, velocity ({v.X:0.00}, {v.Y:0.00}, {v.Z:0.00}) m/s"));
    }

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now)
    {
        WirePosition place = message.Position;
        Say(now, $"sends AutonomousPosition: {new Position(place.Cell, new Frame(place.Origin, place.Orientation))}");
    }
}
