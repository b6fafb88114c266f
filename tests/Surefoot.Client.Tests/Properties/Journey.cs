using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Client.Tests.Properties;

/// <summary>A player on a trip among whoever is spawned near its beginning; the others stand still.</summary>
internal sealed class Journey
{
    /// <summary>A little more than 1/30 s, so that each frame is a quantum whatever the rounding of the clock.</summary>
    private const double Frame = (1.0 / 30) + 1e-9;

    private const uint HumanSetup = 0x02000001, Id = 0x50000001, FirstOther = 0x60000000;
    private const uint SmallCreatureSetup = 0x02000100;
    private const float Company = 40;

    private static readonly SetupAsset Ball =
        new() { Id = 0x02FF0001, Spheres = [new Sphere(Vector3.Zero, 0.25f)], StepUpHeight = 0.3f, StepDownHeight = 0.3f };
    private static readonly SetupAsset Arrow = new() { Id = 0x02FF0002, Spheres = [new Sphere(Vector3.Zero, 0.1f)] };

    private readonly Trip trip;
    private readonly LocalPlayer? player;
    private readonly Strides strides = new();
    private readonly double frameTime;
    private uint block;
    private int frames;

    private Journey(Trip trip, PhysicsEngine engine, PhysicsBody body, LocalPlayer? player)
    {
        this.trip = trip;
        this.player = player;
        Engine = engine;
        Body = body;
        if (player is null) SteeredPhysicsBody.Of(body).Attach(strides);
        frameTime = trip.FrameTime == 1 ? Frame : trip.FrameTime / 30.0;
    }

    internal PhysicsWorld World => Engine.World;

    internal PhysicsEngine Engine { get; }

    internal PhysicsBody Body { get; }

    /// <summary>Begins a trip in a world of its own, if its place is free by retail's placement without sliding.</summary>
    /// <param name="files">The demo world.</param>
    /// <param name="trip">The trip.</param>
    /// <param name="loaded">Blocks that are loaded first, in this order.</param>
    internal static Journey? Begin(DemoFiles files, Trip trip, params ReadOnlySpan<uint> loaded)
    {
        PhysicsEngine engine = files.CreateEngine();
        foreach (uint block in loaded) engine.World.LoadLandblock(block);
        Position start = StartOf(engine.World, DemoPlaces.All[trip.Place], trip);
        SpawnOthers(files, engine, start);
        PhysicsBody body = Create(files, engine, trip.Who);
        if (!body.EnterWorld(start, slide: false) || body.IsLost) return null;

        if (trip.Who != Traveller.Player) return new Journey(trip, engine, body, null);
        // A player comes into the world by itself, to the same place.
        engine.RemoveBody(body);
        LoopbackServer server = new(Id, new CharacterStats(trip.RunSkill, trip.JumpSkill), engine.Now);
        LocalPlayer player = LocalPlayer.Spawn(engine, Id, body.Setup!, files.Motions, start, server)!;
        engine.Player = player.Body;
        return new Journey(trip, engine, player.Body, player);
    }

    /// <summary>Makes a trip.</summary>
    /// <param name="files">The demo world.</param>
    /// <param name="trip">The trip.</param>
    /// <param name="visit">Is given the journey before its first quantum, unless its place is taken.</param>
    internal static void Visit(DemoFiles files, Trip trip, Action<Journey> visit)
    {
        if (Begin(files, trip) is { } journey) visit(journey);
    }

    /// <summary>Does all deeds of the trip, as long as the body is somewhere.</summary>
    /// <param name="each">Called after each frame.</param>
    internal void Go(Action? each = null)
    {
        foreach (Deed deed in trip.Deeds)
        {
            if (deed.Push != Vector3.Zero) Body.SetVelocity(deed.Push);
            for (int i = 0; i < deed.Frames && !Body.IsLost; i++)
            {
                Advance(deed.Keys);
                each?.Invoke();
            }
        }
    }

    private void Advance(MovementKeys keys)
    {
        if (CellIds.BlockOf(Body.Position.CellId) != block)
        {
            block = CellIds.BlockOf(Body.Position.CellId);
            World.EnsureLoadedAround(Body.Position, 1);
        }

        frames++;
        player?.Update(keys, frames * frameTime);
        strides.Next = StrideOf(keys);
        Body.SetActive(true);
        Engine.Tick(frames * frameTime);
    }

    /// <summary>What the keys mean to those who have none: a stride of a quantum, metres.</summary>
    private Vector3 StrideOf(MovementKeys keys)
    {
        float length = trip.RunSkill / 1600f;
        Vector3 stride = Vector3.Zero;
        if ((keys & MovementKeys.Forward) != 0) stride.Y += length;
        if ((keys & MovementKeys.Back) != 0) stride.Y -= length;
        if ((keys & (MovementKeys.SidestepRight | MovementKeys.TurnRight)) != 0) stride.X += length;
        if ((keys & (MovementKeys.SidestepLeft | MovementKeys.TurnLeft)) != 0) stride.X -= length;
        return stride;
    }

    private static PhysicsBody Create(DemoFiles files, PhysicsEngine engine, Traveller who)
    {
        SetupAsset human = files.Cache.GetSetup(HumanSetup), creature = files.Cache.GetSetup(SmallCreatureSetup);
        const PhysicsState plain = PhysicsState.Gravity | PhysicsState.ReportCollisions;
        const PhysicsState missile = plain | PhysicsState.Missile | PhysicsState.PathClipped | PhysicsState.AlignPath;
        const WeenieTraits player = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;
        const WeenieTraits beast = WeenieTraits.Present | WeenieTraits.Creature;
        return who switch
        {
            Traveller.Player => engine.CreateBody(Id, human, weenie: player),
            Traveller.Careless => engine.CreateBody(Id, human, plain, beast),
            Traveller.Creature => engine.CreateBody(Id, creature, PhysicsState.Default, beast),
            Traveller.Ball => engine.CreateBody(Id, Ball, plain, WeenieTraits.Present),
            Traveller.Missile => engine.CreateBody(Id, Arrow, missile, WeenieTraits.Present),
            _ => engine.CreateBody(Id, human, PhysicsState.Default, beast, 1.5f),
        };
    }

    private static Position StartOf(PhysicsWorld world, NamedPlace named, Trip trip)
    {
        Frame frame = new(named.Origin + trip.Offset, Quaternion.Identity);
        frame.SetHeading(trip.Heading);
        Position start = new(named.CellId, frame);
        if (!CellIds.IsOutdoor(start.CellId))
        {
            world.EnsureLoadedAround(start, 1);
            return start;
        }

        start.AdjustToOutside();
        world.EnsureLoadedAround(start, 1);
        // On the ground, unless the place itself is on something that stands there.
        if (world.GetVisible(named.CellId) is LandCell land &&
            land.Landblock.Terrain.TryGetHeight(named.Origin.X, named.Origin.Y, out float below) &&
            named.Origin.Z - below < 1 && world.GetVisible(start.CellId) is LandCell cell &&
            cell.Landblock.Terrain.TryGetHeight(start.Frame.Origin.X, start.Frame.Origin.Y, out float height))
        {
            start.Frame.Origin.Z = height + 0.005f + trip.Offset.Z;
        }

        return start;
    }

    private static void SpawnOthers(DemoFiles files, PhysicsEngine engine, in Position start)
    {
        uint id = FirstOther;
        foreach (DemoSpawn spawn in DemoSpawns.All)
        {
            id++;
            Position place = DemoFiles.PlaceOf(spawn);
            if (start.DistanceTo(place) > Company) continue;
            PhysicsBody body = files.CreateBody(engine, id, spawn);
            if (!body.EnterWorld(place, slide: false)) engine.RemoveBody(body);
        }
    }
}
