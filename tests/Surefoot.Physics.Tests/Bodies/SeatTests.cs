using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>A body put into a state from outside: what it takes, and what it refuses with nothing changed.</summary>
public sealed class SeatTests
{
    private static readonly BodySeat Standing = new(
        new Position(StubWorld.CellId, new Vector3(5, 5, 0)), Vector3.Zero, BodyFixture.Standing, new Plane(0, 0, 1, 0), StubWorld.CellId,
        Vector3.Zero);

    public static TheoryData<string, BodySeat> Impossible => new()
    {
        { "stands on nothing", Standing with { Transient = TransientState.OnWalkable } },
        { "stands on half a plane of an unknown block", Standing with { ContactPlane = new(0, 0, 0.5f, 0), ContactPlaneCellId = 0 } },
        { "stands on no plane", Standing with { ContactPlane = default } },
        { "touches a plane in no block", Standing with { ContactPlaneCellId = 0xA9B40041 } },
        { "touches a plane twice as long", Standing with { ContactPlane = new Plane(0, 0, 2, 0) } },
        { "slides along a normal that is not finite", Standing with { SlidingNormal = new Vector3(float.PositiveInfinity, 0, 0) } },
        { "has no number for a velocity", Standing with { Velocity = new Vector3(float.NaN, 0, 0) } },
        { "is in no cell", Standing with { Position = new Position(0, Vector3.Zero) } },
    };

    [Theory, Behaviour("body.seat.impossible-states", "design, decision 7")]
    [MemberData(nameof(Impossible), DisableDiscoveryEnumeration = true)]
    public void A_state_that_no_body_can_be_in_is_refused_and_nothing_changes(string which, BodySeat seat)
    {
        BodyFixture f = new();
        f.Seat(Vector3.One, new Vector3(1, 2, 3), BodyFixture.Standing);
        BodySeat before = f.Body.CurrentSeat;
        Assert.True(Throws(), which);
        Assert.Equal(before, f.Body.CurrentSeat);

        bool Throws()
        {
            try
            {
                f.Body.Seat(seat);
                return false;
            }
            catch (ArgumentException)
            {
                return true;
            }
        }
    }

    [Fact, Behaviour("body.seat.velocity-is-cut-down", "spec/02, 4.6")]
    public void A_velocity_beyond_the_greatest_is_cut_down_to_it_by_the_next_quantum()
    {
        BodyFixture f = new();
        f.Seat(new Vector3(5, 5, 500), new Vector3(1e30f, 0, 0), TransientState.None);
        f.Body.AdvanceQuantum(0.1f);
        // 50 m/s along x, and gravity's 0.98 m/s of a tenth of a second.
        Assert.Equal(50, f.Body.Velocity.X, 1e-4f);
        Assert.Equal(-0.98, f.Body.Velocity.Z, 1e-2f);
    }
}
