using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Creatures;

/// <summary>A driven creature at a place of the demo world, which ticks 30 times a second, and a note of all it says.</summary>
internal sealed class CreatureFixture : ICreatureListener
{
    internal const uint CreatureId = 0x80000001, TargetId = 0x80000002, DoorId = 0x80000003, ByStander = 0x80000004;
    private const double FrameTime = (1.0 / 30) + 1e-9;

    private readonly DemoGround ground;
    private int frames;

    internal CreatureFixture(DemoGround ground, string place, float right = 0, float ahead = 0, CreatureDriverOptions? options = null)
    {
        this.ground = ground;
        Engine = ground.EngineAt(place);
        Body = ground.Spawn(Engine, CreatureId, DemoGround.At(place, right, ahead));
        for (int i = 0; i < 10; i++) Frame();
        Driver = new CreatureDriver(Engine, Body, this, options);
    }

    internal PhysicsEngine Engine { get; }

    internal PhysicsBody Body { get; }

    internal CreatureDriver? Driver { get; }

    internal List<string> Told { get; } = [];

    internal List<(double Time, UpdateMotion Message)> Motions { get; } = [];

    internal List<(double Time, UpdatePosition Message)> Positions { get; } = [];

    internal double Now => frames * FrameTime;

    internal MovementType LastOrder => Motions[^1].Message.Movement.Type;

    internal PhysicsBody SpawnTarget(in Position place) => ground.Spawn(Engine, TargetId, place);

    internal PhysicsBody Spawn(uint id, in Position place) => ground.Spawn(Engine, id, place);

    internal PhysicsBody SpawnDoor() => ground.SpawnDoor(Engine, DoorId);

    internal void Run(double seconds)
    {
        for (double end = Now + seconds; Now < end;) Frame();
    }

    /// <summary>Seconds until something is so; fails when it is not in time.</summary>
    internal double RunUntil(Func<bool> reached, double limit)
    {
        double begin = Now;
        while (!reached())
        {
            Assert.True(Now - begin < limit, $"not in {limit} s; at {Body.Position}, {Driver!.Progress}, told {string.Join(", ", Told)}");
            Frame();
        }

        return Now - begin;
    }

    /// <summary>Decisions of the creature's sweeps in a time; 0 when there was no sweep.</summary>
    internal int CountDecisions(double seconds)
    {
        TraceBuffer trace = new();
        Body.Trace = trace;
        Run(seconds);
        Body.Trace = null;
        return trace.Count;
    }

    internal double GapTo(PhysicsBody other) => Body.Position.DistanceTo(other.Position) - Body.Radius - other.Radius;

    public void OnMotion(CreatureDriver creature, in UpdateMotion message) => Motions.Add((Now, message));

    public void OnPosition(CreatureDriver creature, in UpdatePosition message) => Positions.Add((Now, message));

    public void OnArrived(CreatureDriver creature) => Told.Add("arrived");

    public void OnGivenUp(CreatureDriver creature, MotionError error) => Told.Add($"gave up: {error}");

    public void OnStuck(CreatureDriver creature) => Told.Add("stuck");

    public void OnTriesAgain(CreatureDriver creature) => Told.Add("tries again");

    private void Frame()
    {
        frames++;
        Engine.Tick(Now);
        Driver?.Update();
    }
}
