using System.Numerics;
using CsCheck;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>The same inputs give the same bits, whatever else differs.</summary>
public sealed class DeterminismProperties(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint HumanSetup = 0x02000001;

    [Fact]
    [Behaviour("properties.same-inputs-same-bits", "design, decision 5")]
    public void The_same_trip_gives_the_same_bits_each_time() =>
        Trip.Any.Sample(
            trip =>
            {
                ulong[] first = Hashes(trip), second = Hashes(trip);
                Assert.Equal(first, second);
            },
            iter: Fuzz.Cases(1500));

    [Fact]
    [Behaviour("properties.same-inputs-same-bits.statics", "design, decision 5; spec/02, 4.19")]
    public void The_same_trip_moves_the_parts_of_statics_to_the_same_bits() =>
        Trip.From([Enumerable.Range(0, DemoPlaces.All.Length).First(i => DemoPlaces.All[i].Name == "windmill")], 6).Sample(
            trip =>
            {
                if (Journey.Begin(files, trip) is not { } journey) return;
                StaticObject mill = Assert.Single(journey.World.Landblocks.SelectMany(block => block.AnimatedStatics));
                int sail = mill.PlacedPartCount - 1;
                HashSet<Frame> poses = [mill.PartFrame(sail)];
                ulong[] first = Hashes(journey, () => poses.Add(mill.PartFrame(sail))), second = Hashes(trip);
                Assert.True(poses.Count > 1);
                Assert.Equal(first, second);
            },
            iter: Fuzz.Cases(150));

    [Fact]
    [Behaviour("engine.hash.poses-of-statics", "design, decision 5; spec/02, 4.19")]
    public void A_part_of_a_static_that_stands_elsewhere_is_another_state()
    {
        PhysicsEngine engine = files.CreateEngine();
        Assert.True(DemoPlaces.TryFind("windmill", out NamedPlace place));
        engine.World.EnsureLoadedAround(new Position(place.CellId, place.Origin), 1);
        StaticObject mill = Assert.Single(engine.World.Landblocks.SelectMany(block => block.AnimatedStatics));
        ulong still = engine.HashState();
        mill.Pose(mill.Animation!.PartFrames(mill.Animation.FrameCount / 3));
        Assert.NotEqual(still, engine.HashState());
        mill.Pose(mill.Animation.PartFrames(0));
        Assert.Equal(still, engine.HashState());
    }

    [Fact]
    [Behaviour("properties.loading-order-same-bits", "design.md, decision 1; spec/05, 4.7, 4.11, 4.17")]
    public void The_order_in_which_landblocks_were_loaded_changes_no_bit() =>
        Gen.Select(Trip.From([.. Enumerable.Range(0, DemoPlaces.All.Length)], 6), Gen.Shuffle(Enumerable.Range(0, 9).ToArray())).Sample(
            (trip, order) =>
            {
                uint middle = DemoPlaces.All[trip.Place].CellId;
                uint[] blocks = [
                    .. Enumerable.Range(0, 9)
                        .Select(i => CellIds.BlockOf(middle) + (uint)(((i / 3) - 1) << 24) + (uint)(((i % 3) - 1) << 16))];
                ulong[] inOrder = Hashes(trip, blocks), shuffled = Hashes(trip, [.. order.Select(i => blocks[i])]);
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
        ulong before = walk.Engine.HashState();
        WorldQuery query = walk.Engine.CreateQuery();
        SweepResult[] alone = [.. wishes.Select((wish, i) => query.Sweep(bodies[i % bodies.Length], wish))];
        for (int round = 0; round < 5; round++)
        {
            SweepResult[] together = new SweepResult[wishes.Length];
            Parallel.For(
                0, wishes.Length, new ParallelOptions { MaxDegreeOfParallelism = 4 }, walk.Engine.CreateQuery,
                (i, _, own) =>
                {
                    together[i] = own.Sweep(bodies[i % bodies.Length], wishes[i]);
                    return own;
                },
                static _ => { });
            Assert.Equal(alone, together);
        }

        Assert.Contains(alone, answer => answer.LosesVelocity);
        Assert.Equal(before, walk.Engine.HashState());
    }

    [Fact]
    [Behaviour("properties.questions-change-nothing", "design.md, decision 6")]
    public void No_question_changes_a_bit_of_any_state_or_of_what_comes_after() =>
        Gen.Select(Trip.Any, Trip.Ways.Array[1, 6]).Sample(
            (trip, ways) =>
            {
                ulong[] unasked = Hashes(trip);
                if (Journey.Begin(files, trip) is not { } journey) return;
                WorldQuery query = journey.Engine.CreateQuery();
                Mover mover = new(journey.Body.Setup!, journey.Body.State, journey.Body.Weenie, journey.Body.Scale);
                int turn = 0;
                ulong[] asked = Hashes(journey, () =>
                {
                    ulong before = journey.Engine.HashState();
                    AskAll(query, mover, journey.Body, ways[turn++ % ways.Length]);
                    Assert.Equal(before, journey.Engine.HashState());
                });
                Assert.Equal(unasked, asked);
            },
            iter: Fuzz.Cases(200));

    [Fact]
    [Behaviour("properties.trace-same-bits", "design.md, decision 6")]
    public void Whoever_listens_changes_no_bit() =>
        Trip.Any.Sample(
            trip =>
            {
                ulong[] silent = Hashes(trip), told = [];
                Journey.Visit(files, trip, journey =>
                {
                    foreach (PhysicsBody body in journey.Engine.Bodies) body.Trace = new TraceBuffer(limit: 64);
                    told = Hashes(journey);
                });
                Assert.Equal(silent, told);
            },
            iter: Fuzz.Cases(300));

    private static void AskAll(WorldQuery query, Mover mover, PhysicsBody body, Vector3 way)
    {
        Position from = body.Position, to = from;
        to.Frame.Origin += way;
        if (!CellIds.HasValidIndex(from.CellId)) return;
        query.Sweep(body, to);
        query.Sweep(body, body.CurrentSeat with { Velocity = way }, to);
        query.Sweep(new SweepInput(mover, from, to));
        query.Place(new PlaceInput(mover, to));
        query.ProbeDown(new ProbeDownInput(mover, to, 5));
        query.Overlap(new SphereInput(to.CellId, new Sphere(to.Frame.Origin, 1)));
        query.Overlap(new PointInput(to.CellId, to.Frame.Origin));
    }

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

    private ulong[] Hashes(Trip trip, params ReadOnlySpan<uint> loaded) =>
        Journey.Begin(files, trip, loaded) is { } journey ? Hashes(journey) : [];

    private static ulong[] Hashes(Journey journey, Action? each = null)
    {
        List<ulong> hashes = [journey.Engine.HashState()];
        journey.Go(() =>
        {
            hashes.Add(journey.Engine.HashState());
            each?.Invoke();
        });
        return [.. hashes];
    }

    /// <summary>A hash of each body after a few seconds; the engine's own hash would contain the order of the table.</summary>
    private ulong[] Throw(int[] order, Vector3[] pushes, int gap)
    {
        PhysicsEngine engine = files.CreateEngine();
        foreach (NamedPlace place in Apart) engine.World.EnsureLoadedAround(new Position(place.CellId, place.Origin), 1);
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
        ulong[] hashes = new ulong[Apart.Length];
        for (int i = 0; i < hashes.Length; i++)
        {
            StateHash hash = new();
            engine.Find(IdOf(i))!.AddTo(ref hash);
            hashes[i] = hash.Value;
        }

        return hashes;
    }
}
