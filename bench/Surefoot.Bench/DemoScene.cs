using System.Numerics;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Bench;

/// <summary>What a player in a <see cref="DemoScene"/> does.</summary>
/// <param name="Place">Where it begins.</param>
/// <param name="Keys">The keys it holds.</param>
internal sealed record DemoAct(string Place, MovementKeys Keys)
{
    /// <summary>Metres to the north and upwards from where the player came to be with its keys.</summary>
    public Vector2 Offset { get; init; }

    /// <summary>Velocity it begins with in the air, metres a second; null for a player on the ground.</summary>
    public Vector3? Airborne { get; init; }

    /// <summary>Quanta until it is put back where it began.</summary>
    public int Steps { get; init; } = 60;
}

/// <summary>A player in the demo world who holds some keys, and goes back to where it began now and then.</summary>
internal sealed class DemoScene : IDisposable
{
    private const float Quantum = 1f / 30;

    private readonly DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
    private readonly LocalPlayer player;
    private readonly BodySeat seat;
    private readonly int stepsBeforeReturn;
    private int steps;

    internal DemoScene(DemoAct act)
    {
        if (!DemoPlaces.TryFind(act.Place, out NamedPlace named)) throw new ArgumentException($"There is no place {act.Place}.", nameof(act));
        PhysicsDataCache cache = new(dats);
        PhysicsWorld world = new(cache);
        world.EnsureLoadedAround(new Position(named.CellId, named.Origin), 2);
        Engine = new PhysicsEngine(world);
        SetupAsset setup = cache.GetSetup(0x02000001);
        player = LocalPlayer.Spawn(
            Engine, 0x50000001, setup, MotionTableLoader.Load(dats, setup.DefaultMotionTableId),
            new Position(named.CellId, new Frame(named.Origin, named.Orientation)), new CharacterStats(300, 300))
            ?? throw new InvalidOperationException($"There is no room at {act.Place}.");
        double now = 0;
        for (int i = 0; i < 12; i++)
        {
            player.Update(i < 10 ? MovementKeys.None : act.Keys, now += Quantum);
            Engine.Tick(now);
        }

        stepsBeforeReturn = act.Steps;
        PhysicsBody body = player.Body;
        Position start = body.Position;
        start.Frame.Origin += new Vector3(0, act.Offset.X, act.Offset.Y);
        seat = act.Airborne is { } velocity
            ? new BodySeat(start, velocity, TransientState.None, body.ContactPlane, body.ContactPlaneCellId, Vector3.Zero)
            : new BodySeat(start, body.Velocity, body.Transient, body.ContactPlane, body.ContactPlaneCellId, body.SlidingNormal);
    }

    internal PhysicsEngine Engine { get; }

    internal void Step()
    {
        if (++steps >= stepsBeforeReturn)
        {
            steps = 0;
            player.Body.Seat(seat);
            player.Body.SetActive(true);
        }

        player.Body.Step(Quantum);
    }

    public void Dispose() => dats.Dispose();
}
