using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Steering;

/// <content>What the body tells and asks in each quantum, and when it comes, goes, lands and takes off.</content>
public sealed partial class MovementManager : IBodyMovement
{
    ReadOnlySpan<Frame> IBodyMovement.PartFrames => Animation is null ? [] : Animation.Sequence.PartFrames;

    void IBodyMovement.AccumulateRootMotion(float quantum, ref Frame offset) => Animation?.Update(quantum, ref offset);

    void IBodyMovement.ProcessHooks(PhysicsBody owner) => Animation?.ProcessHooks(owner);

    /// <remarks>Retail: MovementManager::HitGround @0x00524300.</remarks>
    void IBodyMovement.HitGround()
    {
        interpreter?.HitGround();
        MoveTo?.HitGround();
    }

    /// <remarks>Retail: MovementManager::LeaveGround @0x00524320. A move-to goes on when the body is back on the ground.</remarks>
    void IBodyMovement.LeaveGround() => interpreter?.LeaveGround();

    /// <remarks>Retail: MovementManager::UseTime @0x005242F0, then CPartArray::HandleMovement.</remarks>
    void IBodyMovement.UseTime()
    {
        MoveTo?.UseTime();
        Animation?.CheckForCompletedMotions();
    }

    void IBodyMovement.HandleEnterWorld() => Animation?.HandleEnterWorld();

    /// <remarks>Retail: MovementManager::HandleExitWorld @0x00524350, after that of the part array.</remarks>
    void IBodyMovement.HandleExitWorld()
    {
        Animation?.HandleExitWorld();
        interpreter?.HandleExitWorld();
    }
}
