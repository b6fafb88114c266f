using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Steering;

/// <content>What the body calls: its motion side first, then the managers.</content>
internal sealed partial class SteeredPhysicsBody : IBodyDriver
{
    /// <inheritdoc/>
    public bool HasMotions => Movement is not null;

    /// <inheritdoc/>
    public bool IsMovingTo => Movement is { IsMovingTo: true };

    /// <inheritdoc/>
    public ReadOnlySpan<Frame> PartFrames => Movement is null ? [] : Movement.PartFrames;

    /// <summary>Gives the body a motion side instead of what it had, and wakes it.</summary>
    internal void Attach(IBodyMovement movement)
    {
        Movement = movement;
        body.SetActive(true);
    }

    /// <inheritdoc/>
    public void HitGround() => Movement?.HitGround();

    /// <inheritdoc/>
    public void LeaveGround() => Movement?.LeaveGround();

    /// <inheritdoc/>
    public void AccumulateRootMotion(float quantum, ref Frame offset) => Movement?.AccumulateRootMotion(quantum, ref offset);

    /// <inheritdoc/>
    public void ProcessHooks() => Movement?.ProcessHooks(body);

    /// <inheritdoc/>
    public void EndQuantum(double physicsTime)
    {
        HandleTargetting(physicsTime);
        Movement?.UseTime();
        UseTime();
    }

    /// <inheritdoc/>
    void IBodyDriver.CancelMoveTo() => Movement?.CancelMoveTo();

    /// <inheritdoc/>
    public void HandleEnterWorld() => Movement?.HandleEnterWorld();

    /// <inheritdoc/>
    void IBodyDriver.HandleExitWorld()
    {
        Movement?.HandleExitWorld();
        HandleExitWorld();
    }
}
