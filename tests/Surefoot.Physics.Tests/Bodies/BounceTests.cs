using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Specification 02, 6.9, 6.10 and 6.15.</summary>
public class BounceTests
{
    [Theory, Behaviour("body.quanta.too-small", "spec/02, 6.9")]
    [InlineData(30, 5.105443f)]
    [InlineData(40, 9.88057232f)]
    [InlineData(60, 9.9197073f)]
    [InlineData(120, 9.95948505f)]
    public void Quanta_below_the_gate_keep_gravity_from_building_up(int quanta, float z)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 10), Vector3.Zero, TransientState.None);
        for (int i = 0; i < quanta; i++) f.Body.AdvanceQuantum(1f / quanta);
        Assert.Equal(z, f.Z, 5);
    }

    [Fact, Behaviour("body.jump.too-slow-stays", "spec/02, 6.10")]
    public void A_velocity_below_one_quantum_of_gravity_leaves_contact_and_loses_the_walkable_bit()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 0), Vector3.Zero, BodyFixture.Standing);
        f.Body.SetOnWalkable(false);
        f.Body.SetVelocity(new Vector3(0, 0, 0.3f));
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0f, f.Z);
        Assert.Equal(-0.026666671f, f.Body.Velocity.Z, 7);
        Assert.Equal(TransientState.Contact, f.Body.Transient & ~TransientState.Active);
    }

    [Fact, Behaviour("placement.public.lands-a-body", "spec/02, 4.16")]
    public void A_body_that_enters_the_world_near_the_ground_stands_on_it()
    {
        BodyFixture f = new();
        Assert.True(f.Body.EnterWorld(new Position(StubWorld.CellId, new Vector3(12, 12, 0.1f))));
        Assert.True(f.Body.OnWalkable);
        Assert.True(f.Body.IsActive);
        f.Body.LeaveWorld();
        Assert.False(f.Body.HasContact);
        Assert.False(f.Body.HasCell);
    }
}
