using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Tool.Walking;

/// <summary>Walks a script: hands on the keys, a server that answers, the world ticking at retail's rate.</summary>
internal sealed class WalkRunner : IMovementObserver
{
    /// <summary>Seconds between two looks at the keys: a frame of 60 a second.</summary>
    private const double Frame = 1.0 / 60;

    /// <summary>Seconds given to the body to stand before the script begins.</summary>
    private const double SettleTime = 0.5;

    /// <summary>Moments nearer to each other than this are one, seconds.</summary>
    private const double Rounding = 1e-9;

    private readonly List<WalkSample> samples = [];
    private readonly List<WalkEvent> events = [];
    private double start = double.NaN;
    private bool stood;
    private uint cell;

    /// <summary>Runs the script to its end.</summary>
    /// <param name="scene">The world.</param>
    /// <param name="place">Where it begins.</param>
    /// <param name="stats">The character.</param>
    /// <param name="legs">What the hands do.</param>
    /// <param name="script">The same as text, for the result.</param>
    /// <param name="latency">Seconds until the server answers.</param>
    /// <param name="quantum">
    /// Seconds, from 1/30 on: quanta are of this length, and keys act in the one that their moment falls into. Null for a game's frames,
    /// which quanta and keys wait for.
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

    /// <summary>Walks again what was walked on a server: the same keys at the same times, from the same place.</summary>
    /// <param name="scene">The world.</param>
    /// <param name="times">The frames.</param>
    /// <param name="different">The first frame in which the body was not where it was then; null when there is none.</param>
    /// <exception cref="UsageException">No player can be where it begins.</exception>
    internal static WalkResult Replay(WalkScene scene, WalkTimes times, out int? different)
    {
        WalkRunner runner = new();
        different = runner.WalkTimed(scene, times);
        return new WalkResult("recorded", "", times.Stats.RunSkill, times.Stats.JumpSkill, runner.samples, runner.events);
    }

    /// <summary>Frames as a client on a server has them: bodies move, and then the keys act.</summary>
    private int? WalkTimed(WalkScene scene, WalkTimes times)
    {
        TimedFrame first = times.Frames[0];
        start = first.Now;
        scene.Simulation.Tick(start);
        Player player = Spawn(scene.Simulation, new ScenePlace("recorded", first.Position), times.Stats, latency: 0);
        scene.Simulation.Engine.Player = player.Body;
        player.Local.Update(first.Keys, start);
        Record(player, start);
        (stood, cell) = (player.Body.OnWalkable, player.Body.Position.CellId);
        int? different = null;
        for (int i = 1; i < times.Frames.Count; i++)
        {
            TimedFrame frame = times.Frames[i];
            Advance(player, frame.Now);
            player.Keys = frame.Keys;
            player.Local.Update(frame.Keys, frame.Now);
            if (different is null && player.Body.Position != frame.Position) different = i;
        }

        scene.Simulation.Remove(player);
        return different;
    }

    private void RunLegs(
        WalkScene scene, ScenePlace place, CharacterStats stats, IReadOnlyList<WalkLeg> legs, double latency, double? quantum)
    {
        double now = scene.Simulation.Engine.Now + 1;
        scene.Simulation.Tick(now);
        Player player = Spawn(scene.Simulation, place, stats, latency);
        scene.Simulation.Engine.Player = player.Body;
        double step = quantum ?? Frame;
        for (int i = 0; i < SettleTime / step; i++) player.Update(MovementKeys.None, now += step);
        start = now;
        Record(player, now);
        (stood, cell) = (player.Body.OnWalkable, player.Body.Position.CellId);
        if (quantum is { } length) WalkQuanta(player, legs, length);
        else WalkFrames(player, legs);
        scene.Simulation.Remove(player);
    }

    /// <summary>Frames of a game: keys are looked at once in each, and a quantum is as many of them as it takes.</summary>
    private void WalkFrames(Player player, IReadOnlyList<WalkLeg> legs)
    {
        double now = start;
        foreach (WalkLeg leg in legs)
        {
            player.Keys = leg.Keys;
            player.Local.Controller.SetAutoRun(leg.AutoRun, now);
            for (int i = Math.Max(1, (int)Math.Round(leg.Seconds / Frame)); i > 0; i--) Advance(player, now += Frame);
        }
    }

    /// <summary>Quanta of one length. A key acts at its own moment, as a jump's charge is measured, and moves the body a quantum
    /// later.</summary>
    private void WalkQuanta(Player player, IReadOnlyList<WalkLeg> legs, double quantum)
    {
        long quanta = 0;
        double at = 0;
        foreach (WalkLeg leg in legs)
        {
            for (; (quanta + 1) * quantum <= at + Rounding; quanta++) Advance(player, start + ((quanta + 1) * quantum));
            Press(player, leg, start + at);
            at += OnGrid(leg.Seconds, quantum);
        }

        for (; quanta * quantum < at - Rounding; quanta++) Advance(player, start + ((quanta + 1) * quantum));
    }

    /// <summary>
    /// The page's times count in 1/512 s and are written with three digits: with quanta that do as well, the moment meant is the nearest.
    /// </summary>
    private static double OnGrid(double seconds, double quantum) =>
        double.IsInteger(quantum * WorldTime.UnitsPerSecond)
            ? Math.Round(seconds * WorldTime.UnitsPerSecond) / WorldTime.UnitsPerSecond
            : seconds;

    private void Press(Player player, WalkLeg leg, double now)
    {
        MotionError refusedBefore = player.Local.Controller.LastRefusal;
        player.Keys = leg.Keys;
        player.Local.Update(leg.Keys, now);
        player.Local.Controller.SetAutoRun(leg.AutoRun, now);
        Notice(player, now, refusedBefore);
    }

    private void Advance(Player player, double now)
    {
        MotionError refusedBefore = player.Local.Controller.LastRefusal;
        if (player.Update(player.Keys, now)) Record(player, now);
        Notice(player, now, refusedBefore);
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

    private void Notice(Player player, double now, MotionError refusedBefore)
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
