using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Steering;

/// <summary>
/// The side of a body that wants to move: its motion interpreter and its animations. The body calls it once per quantum and when
/// the ground is hit or left.
/// </summary>
/// <remarks>Retail: MovementManager together with the motion side of CPartArray.</remarks>
internal interface IBodyMovement
{
    /// <summary>The body now stands; the bit is already written. Must not start a transition.</summary>
    void HitGround();

    /// <summary>The body no longer stands; the bit is already written. Must not start a transition.</summary>
    void LeaveGround();

    /// <summary>Adds the motion of one quantum, in the body's own frame, metres and radians.</summary>
    /// <param name="quantum">Seconds.</param>
    /// <param name="offset">Starts as the identity.</param>
    void AccumulateRootMotion(float quantum, ref Frame offset);

    /// <summary>
    /// Does what the animations passed in this quantum: called after the velocity was integrated and before the body is moved.
    /// </summary>
    /// <param name="owner">The body.</param>
    /// <remarks>Retail: the animation hooks of CPhysicsObj::process_hooks @0x00511550.</remarks>
    void ProcessHooks(PhysicsBody owner)
    {
    }

    /// <summary>
    /// Frames of the body's parts as they are animated now, in the body's frame at scale 1, metres; empty when nothing animates them: they
    /// are then where they were put down.
    /// </summary>
    ReadOnlySpan<Frame> PartFrames => [];

    /// <summary>Called after the quantum was committed: a move-to goes on, then pending motions and animations are looked at.</summary>
    void UseTime();

    /// <summary>Moves or turns to a place or an object by itself.</summary>
    bool IsMovingTo => false;

    /// <summary>Ends a move-to or turn-to under way.</summary>
    void CancelMoveTo()
    {
    }

    /// <summary>The body came into the world: links are dropped.</summary>
    void HandleEnterWorld();

    /// <summary>The body leaves the world: everything pending ends.</summary>
    void HandleExitWorld();
}
