using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;
using Surefoot.Tool.Authority;

namespace Surefoot.Tool.Serving;

/// <summary>What a player's client tells of some seconds of honest play with keys from a seed, recorded from a real body.</summary>
internal sealed class LoadCourse : IMovementObserver
{
    private const uint PlayerId = 0x50000001;
    private const double Frame = 1.0 / 60, StandFor = 2;

    private readonly List<Told> told = [];
    private double time;

    /// <summary>What was told, in its order.</summary>
    internal IReadOnlyList<Told> Messages => told;

    /// <summary>How long it is, seconds.</summary>
    internal double Length => time;

    /// <summary>Plays and records.</summary>
    /// <param name="cache">Shapes.</param>
    /// <param name="start">Where it begins.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="seed">Seed of the keys.</param>
    /// <param name="seconds">How long keys are held.</param>
    internal static LoadCourse Record(PhysicsDataCache cache, in Position start, CharacterStats stats, ulong seed, double seconds)
    {
        LoadCourse course = new();
        PhysicsEngine engine = new(cache);
        SetupAsset human = cache.GetSetup(new WorldServerOptions { Start = start }.PlayerSetup);
        engine.World.EnsureLoadedAround(start, 1);
        LocalPlayer player = LocalPlayer.Spawn(
            engine, PlayerId, human, MotionTableLoader.LoadFor(cache.Source, human), start, new LoopbackServer(PlayerId, stats, 0),
            new LocalPlayerOptions { Observer = course })
            ?? throw new InvalidDataException($"There is no room for a player at {start}.");
        LoadKeys keys = new(new Dice(seed));
        uint block = CellIds.BlockOf(start.CellId);
        for (; course.time < seconds + StandFor; course.time += Frame)
        {
            if (CellIds.BlockOf(player.Body.Position.CellId) != block) engine.World.EnsureLoadedAround(player.Body.Position, 1);
            block = CellIds.BlockOf(player.Body.Position.CellId);
            player.Update(course.time < seconds ? keys.At(course.time) : MovementKeys.None, course.time);
            engine.Tick(course.time);
        }

        return course;
    }

    void IMovementObserver.OnMoveToState(in MoveToState message, double now) => told.Add(new Told(time, message, null, null));

    void IMovementObserver.OnJump(in Jump message, double now) => told.Add(new Told(time, null, message, null));

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now) =>
        told.Add(new Told(time, null, null, message));

    /// <summary>One message, and when it was told.</summary>
    internal sealed record Told(double At, MoveToState? Move, Jump? Jump, AutonomousPosition? Place);
}
