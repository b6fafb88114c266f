using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Orders that the body cannot begin.</summary>
public class RefusedMoveTests
{
    [Fact, Behaviour("move-to.refused-motion", "spec/09b, 6; MoveToManager::BeginMoveForward @0x00529A00")]
    public void An_order_whose_first_motion_is_refused_ends_with_the_reason()
    {
        FakeSteeredWorld world = new();
        FakeSteeredBody body = new(world, 1, Vector3.Zero) { Refusal = MotionError.NotOnGround };
        body.Order().MoveToPosition(FakeSteeredBody.At(0, 10), new MovementParameters());
        Assert.Equal([MotionError.NotOnGround], body.Ended);
        Assert.False(body.Mover!.IsMovingTo);
    }
}
