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

/// <summary>A player in the demo world who holds some keys, and goes back to where it began now and then.</summary>
internal sealed class DemoScene : IDisposable
{
    private const int StepsBeforeReturn = 60;
    private const float Quantum = 1f / 30;

    private readonly DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
    private readonly LocalPlayer player;
    private readonly BodySeat seat;
    private int steps;

    internal DemoScene(string place, MovementKeys keys, float height = 0)
    {
        if (!DemoPlaces.TryFind(place, out NamedPlace named)) throw new ArgumentException($"There is no place {place}.", nameof(place));
        PhysicsDataCache cache = new(dats);
        PhysicsWorld world = new(cache);
        world.EnsureLoadedAround(new Position(named.CellId, named.Origin), 2);
        Engine = new PhysicsEngine(world);
        SetupAsset setup = cache.GetSetup(0x02000001);
        player = LocalPlayer.Spawn(
            Engine, 0x50000001, setup, MotionTableLoader.Load(dats, setup.DefaultMotionTableId),
            new Position(named.CellId, new Frame(named.Origin, named.Orientation)), new CharacterStats(300, 300))
            ?? throw new InvalidOperationException($"There is no room at {place}.");
        double now = 0;
        for (int i = 0; i < 60; i++)
        {
            player.Update(i < 10 ? MovementKeys.None : keys, now += Quantum);
            Engine.Tick(now);
        }

        Position start = player.Body.Position;
        start.Frame.Origin += new Vector3(0, 0, height);
        TransientState bits = height > 0 ? TransientState.None : player.Body.Transient;
        seat = new BodySeat(start, height > 0 ? Vector3.Zero : player.Body.Velocity, bits, player.Body.ContactPlane, player.Body.ContactPlaneCellId, player.Body.SlidingNormal);
    }

    internal PhysicsEngine Engine { get; }

    internal void Step()
    {
        if (++steps >= StepsBeforeReturn)
        {
            steps = 0;
            player.Body.Seat(seat);
            player.Body.SetActive(true);
        }

        player.Body.Step(Quantum);
    }

    public void Dispose() => dats.Dispose();
}
