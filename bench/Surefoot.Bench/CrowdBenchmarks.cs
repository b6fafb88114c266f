using System.Numerics;
using BenchmarkDotNet.Attributes;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Bench;

/// <summary>A crowd of 200 humans in the meadow who run in circles and into each other: what a tick costs one of them.</summary>
[MemoryDiagnoser]
public class CrowdBenchmarks
{
    private const int Side = 20, Rows = 10;
    private const float Quantum = 1f / 30;
    private DatSet dats = null!;
    private PhysicsEngine engine = null!;
    private double now;

    /// <summary>Metres from one to the next; a body is 0.96 m wide.</summary>
    [Params(1.3f, 4f)]
    public float Spacing { get; set; } = 1.3f;

    /// <summary>Spawns them.</summary>
    [GlobalSetup]
    public void Setup()
    {
        dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        PhysicsDataCache cache = new(dats);
        PhysicsWorld world = new(cache);
        if (!DemoPlaces.TryFind("meadow", out NamedPlace meadow)) throw new InvalidOperationException("There is no meadow.");
        world.EnsureLoadedAround(new Position(meadow.CellId, meadow.Origin), 2);
        engine = new PhysicsEngine(world);
        SetupAsset human = cache.GetSetup(0x02000001);
        MotionTableAsset motions = MotionTableLoader.Load(dats, human.DefaultMotionTableId);
        for (int i = 0; i < Side * Rows; i++)
        {
            PhysicsBody body = engine.CreateBody((uint)(i + 1), human, weenie: WeenieTraits.Present | WeenieTraits.Creature);
            MovementManager movement = new(body, motions, new PlayerWeenie(new CharacterStats(100, 100)));
            body.AttachMovement(movement);
            Vector3 aside = new(Spacing * ((i % Side) - (Side / 2)), Spacing * ((i / Side) - (Rows / 2)), 0);
            Position position = new(meadow.CellId, new Frame(meadow.Origin + aside, meadow.Orientation));
            position.AdjustToOutside();
            if (!body.EnterWorld(position)) throw new InvalidOperationException($"There is no room for body {i + 1}.");
            movement.DoMotion(MotionCommand.WalkForward, new MovementParameters());
            movement.DoMotion(i % 2 == 0 ? MotionCommand.TurnRight : MotionCommand.TurnLeft, new MovementParameters());
        }

        for (int i = 0; i < 60; i++) Tick();
    }

    /// <summary>Closes the files.</summary>
    [GlobalCleanup]
    public void Cleanup() => dats.Dispose();

    /// <summary>One tick of all, divided by their number.</summary>
    [Benchmark(OperationsPerInvoke = Side * Rows)]
    public void Tick() => engine.Tick(now += Quantum + 1e-9);
}
