using System.Numerics;
using CsCheck;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>The same inputs give the same bits, whatever else differs.</summary>
public sealed class DeterminismProperties(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint HumanSetup = 0x02000001;
    private readonly Grounds grounds = new(files);

    [Fact]
    [Behaviour("properties.same-inputs-same-bits", "design, decision 5")]
    public void The_same_trip_gives_the_same_bits_each_time() =>
        Trip.Any.Sample(
            trip =>
            {
                // The second time the world has been used by others in between, and maybe another one is taken.
                ulong[] first = Hashes(trip), second = Hashes(trip);
                Assert.Equal(first, second);
            },
            iter: Fuzz.Cases(1500));

    [Fact]
    [Behaviour("properties.loading-order-same-bits", "design.md, decision 1; spec/05, 4.7, 4.11, 4.17")]
    public void The_order_in_which_landblocks_were_loaded_changes_no_bit() =>
        Gen.Select(Trip.From([.. Enumerable.Range(0, DemoPlaces.All.Length)], 6), Gen.Shuffle(Enumerable.Range(0, 9).ToArray())).Sample(
            (trip, order) =>
            {
                uint middle = DemoPlaces.All[trip.Place].CellId;
                uint[] blocks = [.. Enumerable.Range(0, 9).Select(i => CellIds.BlockOf(middle) + (uint)(((i / 3) - 1) << 24) + (uint)(((i % 3) - 1) << 16))];
                ulong[] inOrder = Hashes(trip, Load(blocks)), shuffled = Hashes(trip, Load([.. order.Select(i => blocks[i])]));
                Assert.Equal(inOrder, shuffled);
            },
            iter: Fuzz.Cases(300));

    [Fact]
    [Behaviour("properties.creation-order-same-bits", "design, decision 5; spec/02, 4.2")]
    public void The_order_in_which_bodies_that_never_meet_were_created_changes_no_bit() =>
        Gen.Select(Gen.Shuffle(Enumerable.Range(0, Apart.Length).ToArray()), Trip.Ways.Array[Apart.Length], Gen.Int[0, 5]).Sample(
            (order, pushes, gap) =>
            {
                ulong[] one = Throw([.. Enumerable.Range(0, Apart.Length)], pushes, gap), other = Throw(order, pushes, gap);
                Assert.Equal(one, other);
            },
            iter: Fuzz.Cases(150));

    [Fact]
    [Behaviour("properties.questions-from-threads-same-bits", "design.md, decisions 5 and 6")]
    public void Threads_that_ask_at_once_get_the_answers_that_one_alone_gets_and_change_no_bit()
    {
        DemoWalk walk = new(files, "forest", new CharacterStats(300, 300));
        PhysicsBody[] bodies = [walk.Body, .. walk.SpawnRunners(20, spacing: 1.3f)];
        for (int i = 0; i < 60; i++) walk.Tick();
        Position[] wishes = [.. Enumerable.Range(0, 400).Select(i => Ahead(bodies[i % bodies.Length], (float)(i * 0.7), 0.2f + (i % 7)))];
        ulong before = walk.Body.Engine.HashState();
        ResolveResult[] alone = [.. wishes.Select((wish, i) => bodies[i % bodies.Length].Probe(wish))];
        for (int round = 0; round < 5; round++)
        {
            ResolveResult[] together = new ResolveResult[wishes.Length];
            Parallel.For(0, wishes.Length, new ParallelOptions { MaxDegreeOfParallelism = 4 }, i => together[i] = bodies[i % bodies.Length].Probe(wishes[i]));
            Assert.Equal(alone, together);
        }

        Assert.Contains(alone, answer => answer.LosesVelocity);
        Assert.Equal(before, walk.Body.Engine.HashState());
    }

    [Fact]
    [Behaviour("properties.trace-same-bits", "design.md, decision 6")]
    public void Whoever_listens_changes_no_bit() =>
        Trip.Any.Sample(
            trip =>
            {
                ulong[] silent = Hashes(trip), told = [];
                grounds.Visit(trip, journey =>
                {
                    foreach (PhysicsBody body in journey.Engine.Bodies) body.Trace = new TraceBuffer(limit: 64);
                    told = Hashes(journey);
                });
                Assert.Equal(silent, told);
            },
            iter: Fuzz.Cases(300));

    private static Position Ahead(PhysicsBody body, float direction, float way)
    {
        Position place = body.Position;
        place.Frame.Origin += way * new Vector3(MathF.Cos(direction), MathF.Sin(direction), 0);
        return place;
    }

    /// <summary>Places outdoors that are too far from each other for bodies to meet.</summary>
    private static NamedPlace[] Apart { get; } = FindApart();

    private static NamedPlace[] FindApart()
    {
        List<NamedPlace> apart = [];
        foreach (NamedPlace place in DemoPlaces.All)
        {
            Position here = new(place.CellId, place.Origin);
            bool isFar = apart.TrueForAll(other => here.DistanceTo(new Position(other.CellId, other.Origin)) > 250);
            if (CellIds.IsOutdoor(place.CellId) && isFar && apart.Count < 8) apart.Add(place);
        }

        return [.. apart];
    }

    private ulong[] Hashes(Trip trip)
    {
        ulong[] hashes = [];
        grounds.Visit(trip, journey => hashes = Hashes(journey));
        return hashes;
    }

    private ulong[] Hashes(Trip trip, PhysicsWorld world) => Journey.Begin(files, world, trip) is { } journey ? Hashes(journey) : [];

    private static ulong[] Hashes(Journey journey)
    {
        List<ulong> hashes = [HashBodies(journey.Engine)];
        journey.Go(() => hashes.Add(HashBodies(journey.Engine)));
        return [.. hashes];
    }

    /// <summary>The engine's own hash would contain every animated static of whatever is loaded, and a world that was used before has more
    /// loaded.</summary>
    private static ulong HashBodies(PhysicsEngine engine)
    {
        StateHash hash = new();
        foreach (PhysicsBody body in engine.Bodies) body.AddTo(ref hash);
        return hash.Value;
    }

    private PhysicsWorld Load(uint[] blocks)
    {
        PhysicsWorld world = new(files.Cache);
        foreach (uint block in blocks) world.LoadLandblock(block);
        return world;
    }

    /// <summary>A hash of each body after a few seconds; the engine's own hash would contain the order of the table.</summary>
    private ulong[] Throw(int[] order, Vector3[] pushes, int gap)
    {
        ulong[] hashes = new ulong[Apart.Length];
        grounds.Borrow(world =>
        {
            foreach (NamedPlace place in Apart) world.EnsureLoadedAround(new Position(place.CellId, place.Origin), 1);
            PhysicsEngine engine = new(world);
            SetupAsset human = files.Cache.GetSetup(HumanSetup);
            // With a gap of 0x10000 all bodies share a bucket of the engine's table, in which the newest is first.
            uint IdOf(int i) => 0x70000001 + (uint)(i * (gap == 0 ? 0x10000 : gap));
            foreach (int i in order)
            {
                Frame frame = new(Apart[i].Origin + new Vector3(0, 0, 2), Apart[i].Orientation);
                PhysicsBody body = engine.CreateBody(IdOf(i), human, weenie: WeenieTraits.Present | WeenieTraits.Creature);
                Assert.True(body.EnterWorld(new Position(Apart[i].CellId, frame)));
                body.SetVelocity(pushes[i]);
            }

            for (int tick = 1; tick <= 90; tick++) engine.Tick(tick * ((1.0 / 30) + 1e-9));
            for (int i = 0; i < hashes.Length; i++)
            {
                StateHash hash = new();
                engine.Find(IdOf(i))!.AddTo(ref hash);
                hashes[i] = hash.Value;
            }

            foreach (PhysicsBody body in engine.Bodies.ToArray()) engine.RemoveBody(body);
        });
        return hashes;
    }
}
