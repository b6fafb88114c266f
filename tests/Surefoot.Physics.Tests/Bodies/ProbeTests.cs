using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Asking where a way leads, and what a sweep decides about the velocity of whoever goes it.</summary>
public class ProbeTests
{
    private static readonly Vector3 Running = new(3, 0, 0);

    [Fact, Behaviour("probe.changes-nothing", "design.md, decision 6")]
    public void Asking_where_a_way_leads_changes_nothing_of_the_body_even_where_going_it_would_stop_the_body()
    {
        BodyFixture f = Blocked();
        f.Body.SetActive(false);
        ulong before = f.Engine.HashState();
        SweepResult answer = f.Query.Sweep(f.Body, Ahead(0.1f));
        Assert.True(answer is { Found: true, LosesVelocity: true });
        Assert.Equal(Vector3.Zero, answer.Position.Frame.Origin);
        Assert.Equal(before, f.Engine.HashState());
        Assert.Equal(Running, f.Body.Velocity);
        Assert.False(f.Body.IsActive);
    }

    [Fact]
    [Behaviour(
        "body.stop.refused-sub-step",
        "spec/02, kill_velocity; spec/03, 4.6 validate_transition: OBJECTINFO::kill_velocity @0x0050CFE0")]
    public void A_body_whose_sub_step_is_taken_back_loses_its_velocity()
    {
        BodyFixture f = Blocked();
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(Vector3.Zero, f.Body.Velocity);
        Assert.True(f.Body.OnWalkable);
    }

    [Fact, Behaviour("body.stop.refused-sweep", "spec/02, kill_velocity: also when the transition then fails")]
    public void It_loses_its_velocity_also_when_the_whole_sweep_is_refused_afterwards()
    {
        // The first of two sub-steps is taken back, the second leads out of what is loaded, where the engine lets nobody go.
        BodyFixture f = new();
        bool first = true;
        f.World.Blocks = _ => first && !(first = false);
        f.World.IsLoaded = place => place.X < 0.3f;
        f.Engine.RefuseLeavingCells = true;
        f.Seat(Vector3.Zero, new Vector3(20, 0, 0), BodyFixture.Standing);
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.False(first);
        Assert.Equal(Vector3.Zero, f.Body.Position.Frame.Origin);
        Assert.Equal(Vector3.Zero, f.Body.Velocity);
        Assert.False(f.Body.IsLost);
    }

    [Fact, Behaviour("probe.claimed-state", "design.md, decision 6")]
    public void A_claimed_movement_is_checked_from_the_state_claimed_and_the_body_stays_in_its_own()
    {
        BodyFixture f = new();
        f.Seat(new Vector3(5, 5, 0), Running, BodyFixture.Standing);
        ulong before = f.Engine.HashState();
        BodySeat falling = new(At(new Vector3(0, 0, 0.1f)), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero);
        SweepResult fall = f.Query.Sweep(f.Body, falling, At(new Vector3(0, 0, -0.1f)));
        Assert.True(fall is { Found: true, Contact: not null });
        Assert.Equal(0, fall.Position.Frame.Origin.Z, 1e-5f);
        Assert.Equal(before, f.Engine.HashState());

        f.Body.Seat(falling);
        Assert.Equal(fall, f.Query.Sweep(f.Body, At(new Vector3(0, 0, -0.1f))));
        Assert.False(f.Query.Sweep(f.Body, falling with { Position = new Position(0x01010009, Vector3.Zero) }, Ahead(1)).Found);
    }

    [Theory, Behaviour("probe.bad-input", "design.md, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Ways_that_are_not_finite_are_refused(float bad)
    {
        BodyFixture f = new();
        f.Seat(Vector3.Zero, Vector3.Zero, BodyFixture.Standing);
        BodySeat seat = new(Ahead(0), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero);
        Assert.Throws<ArgumentException>(() => f.Query.Sweep(f.Body, Ahead(bad)));
        Assert.Throws<ArgumentException>(() => f.Query.Sweep(f.Body, seat, Ahead(bad)));
        Assert.Throws<ArgumentException>(() => f.Query.Sweep(f.Body, seat with { Position = Ahead(bad) }, Ahead(0)));
        Assert.Throws<ArgumentException>(() => f.Query.Sweep(f.Body, seat with { Velocity = new Vector3(bad) }, Ahead(0)));
    }

    private static BodyFixture Blocked()
    {
        BodyFixture f = new();
        f.World.Blocks = _ => true;
        f.Seat(Vector3.Zero, Running, BodyFixture.Standing);
        return f;
    }

    private static Position Ahead(float x) => At(new Vector3(x, 0, 0));

    private static Position At(Vector3 origin) => new(StubWorld.CellId, origin);
}
