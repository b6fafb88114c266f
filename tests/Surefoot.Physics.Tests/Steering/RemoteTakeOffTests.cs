using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Bodies;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>A server gives a standing and a running body the velocity (0, 3, 6): specification 09, 4.4 and 6.8.</summary>
public class RemoteTakeOffTests
{
    private const float Tolerance = 1e-6f;

    [Fact]
    [Behaviour("remote.take-off.standing", "spec/09, 6.8; CMotionInterp::LeaveGround @0x00528B00")]
    public void A_standing_body_keeps_the_velocity_that_a_server_gave_it()
    {
        (BodyFixture f, _) = Create();
        f.Body.SetVelocity(new Vector3(0, 3, 6));
        (float Y, float Z)[] expected =
        [
            (0.100000009f, 0.200000018f), (0.200000018f, 0.394555569f), (0.300000012f, 0.578222215f), (0.400000006f, 0.750999987f),
            (0.5f, 0.912888885f),
        ];
        for (int quantum = 0; quantum < expected.Length; quantum++)
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(expected[quantum].Y, f.Y, Tolerance);
            Assert.Equal(expected[quantum].Z, f.Z, Tolerance);
            if (quantum == 0) Assert.Equal((new Vector3(0, 3, 6), TransientState.None), (f.Body.Velocity, f.Bits()));
            if (quantum == 1) Assert.Equal(5.67333317f, f.Body.Velocity.Z);
        }
    }

    [Fact]
    [Behaviour("remote.take-off.running", "spec/09, 6.8 and 4.4; CMotionInterp::LeaveGround @0x00528B00")]
    public void A_running_body_only_hops_for_its_motion_replaces_the_velocity()
    {
        (BodyFixture f, MovementManager movement) = Create();
        movement.ApplyUpdate(
            new InterpretedMotionState { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = 2.65f }, autonomous: false);
        f.Body.SetVelocity(new Vector3(0, 3, 6));
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0.453333348f, f.Y, Tolerance);
        Assert.Equal(0.200000018f, f.Z, Tolerance);
        Assert.Equal((new Vector3(0, 10.6000004f, 0), TransientState.None), (f.Body.Velocity, f.Bits()));
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0.806666732f, f.Y, Tolerance);
        Assert.Equal(0.194555566f, f.Z, Tolerance);
        Assert.Equal(-0.326666683f, f.Body.Velocity.Z);
        foreach (float z in (float[])[0.178222224f, 0.150999993f, 0.11288888f, 0.0638888776f, 0.00399998203f])
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(z, f.Z, Tolerance);
            Assert.False(f.Body.HasContact);
        }

        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.True(f.Body.OnWalkable);
        Assert.Equal(0, f.Z, Tolerance);
    }

    /// <summary>A creature that stands at y = 0, with motions that are velocities.</summary>
    private static (BodyFixture Fixture, MovementManager Movement) Create()
    {
        BodyFixture f = new();
        f.Body.SetWeenie(WeenieTraits.Present | WeenieTraits.Creature);
        f.Seat(Vector3.Zero, Vector3.Zero, BodyFixture.Standing);
        MovementManager movement = new(f.Body, HumanoidTable.Create(smooth: true), new OtherWeenie());
        SteeredPhysicsBody.Of(f.Body).Attach(movement);
        return (f, movement);
    }
}

/// <summary>Shorthand of these tests.</summary>
internal static class TakeOffBits
{
    /// <summary>How the body touches the ground.</summary>
    internal static TransientState Bits(this BodyFixture fixture) => fixture.Body.Transient & BodyFixture.Standing;
}
