using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>A quantum in steady state allocates nothing: neither the keys, nor the motions, nor the body, nor its transition.</summary>
public sealed class AllocationTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const int Quanta = 200;

    [Theory]
    [Behaviour("performance.quantum-allocates-nothing", "design.md, decision 4")]
    [InlineData("runway", MovementKeys.Forward)]
    [InlineData("hills", MovementKeys.Forward | MovementKeys.TurnRight)]
    [InlineData("slope-50", MovementKeys.Forward)]
    [InlineData("meadow", MovementKeys.SidestepLeft | MovementKeys.Walk)]
    public void A_walking_player_allocates_nothing(string place, MovementKeys keys)
    {
        DemoWalk walk = new(files, place, new CharacterStats(300, 300));
        walk.Hold(keys, Quanta);
        Assert.Equal(0, Allocated(() => Advance(walk)));
    }

    [Theory]
    [Behaviour("performance.quantum-among-obstacles-allocates-nothing", "design.md, decision 4")]
    [InlineData("forest", MovementKeys.Forward)]
    [InlineData("town", MovementKeys.Forward)]
    [InlineData("long-stair", MovementKeys.Forward)]
    [InlineData("dungeon-corridor", MovementKeys.Forward)]
    [InlineData("dungeon-pillars", MovementKeys.Forward | MovementKeys.TurnRight)]
    [InlineData("house-stairs", MovementKeys.Forward)]
    public void A_player_among_obstacles_allocates_nothing(string place, MovementKeys keys)
    {
        DemoWalk walk = new(files, place, new CharacterStats(300, 300));
        BodySeat start = SeatOf(walk.Body, walk.Position, Vector3.Zero, walk.Body.Transient);
        walk.Hold(keys, 2);
        Assert.Equal(0, Allocated(Repeated(walk, start, 50)));
    }

    [Fact]
    [Behaviour("performance.crowd-allocates-nothing", "design.md, decision 4")]
    public void A_crowd_whose_members_run_into_each_other_allocate_nothing()
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(100, 100));
        IReadOnlyList<PhysicsBody> crowd = walk.SpawnRunners(40, spacing: 1.3f);
        Assert.Equal(40, crowd.Count);
        // The lists of who is in a cell, and of who touches whom, first grow to their greatest length.
        for (int i = 0; i < 600; i++) walk.Tick();
        Assert.Equal(0, Allocated(walk.Tick));
    }

    [Fact]
    [Behaviour("performance.fall-allocates-nothing", "design.md, decision 4")]
    public void A_falling_body_allocates_nothing()
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(300, 300));
        Position high = walk.Position;
        high.Frame.Origin += new Vector3(0, 0, 40);
        Assert.Equal(0, Allocated(Repeated(walk, SeatOf(walk.Body, high, Vector3.Zero, TransientState.None), 100)));
    }

    [Fact]
    [Behaviour("performance.jump-through-a-doorway-allocates-nothing", "design.md, decision 4")]
    public void A_jump_through_a_doorway_allocates_nothing()
    {
        // From 2 m before the door into the hall: the body changes from the land to a building's room and back.
        DemoWalk walk = new(files, "house-door", new CharacterStats(300, 300));
        Position before = walk.Position;
        before.Frame.Origin += new Vector3(0, 2, 0.05f);
        HashSet<uint> cells = [];
        Action jump = Repeated(walk, SeatOf(walk.Body, before, new Vector3(0, 9, 1.5f), TransientState.None), 20);
        for (int i = 0; i < 20; i++)
        {
            jump();
            cells.Add(walk.Position.CellId & 0xFFFF);
        }

        Assert.Contains(0x100u, cells);
        Assert.Equal(0, Allocated(jump));
    }

    [Fact]
    [Behaviour("performance.probe-allocates-nothing", "design.md, decision 4")]
    public void Asking_a_world_allocates_nothing()
    {
        DemoWalk walk = new(files, "forest", new CharacterStats(300, 300));
        Position place = walk.Position;
        place.Frame.Origin += new Vector3(3, 4, 0);
        WorldQuery query = walk.Engine.CreateQuery();
        Mover mover = new(walk.Body.Setup!);
        Assert.Equal(0, Allocated(() => query.Sweep(walk.Body, place)));
        Assert.Equal(0, Allocated(() => query.Sweep(new SweepInput(mover, walk.Position, place))));
        Assert.Equal(0, Allocated(() => query.Place(new PlaceInput(mover, place))));
        Assert.Equal(0, Allocated(() => query.ProbeDown(new ProbeDownInput(mover, place, 3))));
        Assert.Equal(0, Allocated(() => query.Overlap(new SphereInput(place.CellId, new Sphere(place.Frame.Origin, 2)))));
        Assert.Equal(0, Allocated(() => query.Overlap(new PointInput(place.CellId, place.Frame.Origin))));
    }

    [Theory]
    [Behaviour("performance.trace-allocates-nothing", "design.md, decisions 4 and 6")]
    [InlineData("forest")]
    [InlineData("long-stair")]
    public void Telling_decisions_allocates_nothing_once_the_buffer_has_grown(string place)
    {
        DemoWalk walk = new(files, place, new CharacterStats(300, 300));
        TraceBuffer trace = walk.Body.Trace = new TraceBuffer();
        Action advance = Repeated(walk, SeatOf(walk.Body, walk.Position, Vector3.Zero, walk.Body.Transient), 50);
        walk.Hold(MovementKeys.Forward, 2);
        int most = 0;
        Assert.Equal(0, Allocated(() =>
        {
            trace.Clear();
            advance();
            most = Math.Max(most, trace.Count);
        }));
        Assert.True(most > 10);
    }

    /// <summary>Quanta that begin again from a seat every so often.</summary>
    private static Action Repeated(DemoWalk walk, BodySeat seat, int period)
    {
        int count = 0;
        return () =>
        {
            if (count++ % period == 0) walk.Body.Seat(seat);
            walk.Body.SetActive(true);
            walk.Body.AdvanceQuantum(1f / 30);
        };
    }

    private static BodySeat SeatOf(PhysicsBody body, in Position position, Vector3 velocity, TransientState bits) =>
        new(position, velocity, bits, body.ContactPlane, body.ContactPlaneCellId, Vector3.Zero);

    private static void Advance(DemoWalk walk) => walk.Body.AdvanceQuantum(1f / 30);

    private static long Allocated(Action advance)
    {
        for (int i = 0; i < Quanta; i++) advance();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < Quanta; i++) advance();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
