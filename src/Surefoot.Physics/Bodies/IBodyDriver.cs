using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>
/// What drives a body: its motions, and what a server makes of it (corrections, sticking, a leash, tracking). The only way in which bodies
/// call what is built on them.
/// </summary>
/// <remarks>
/// Retail: MovementManager, PositionManager and TargetManager as CPhysicsObj calls them, and the motion side of CPartArray.
/// </remarks>
internal interface IBodyDriver
{
    /// <summary>The body has a motion side: it stays awake while it stands.</summary>
    bool HasMotions { get; }

    /// <summary>Moves or turns to a place or an object by itself.</summary>
    bool IsMovingTo { get; }

    /// <summary>Follows positions that a server told.</summary>
    bool IsInterpolating { get; }

    /// <summary>The leash is nearly used up: the body may not jump.</summary>
    bool IsFullyConstrained { get; }

    /// <summary>Id of the object the body sticks to, 0 for none.</summary>
    uint StickyObjectId { get; }

    /// <summary>
    /// Frames of the body's parts as they are animated now, in the body's frame at scale 1, metres; empty when nothing animates them: they
    /// are then where they were put down.
    /// </summary>
    ReadOnlySpan<Frame> PartFrames { get; }

    /// <summary>The body now stands; the bit is already written. Must not start a transition.</summary>
    void HitGround();

    /// <summary>The body no longer stands; the bit is already written. Must not start a transition.</summary>
    void LeaveGround();

    /// <summary>Adds the motion of one quantum, in the body's own frame, metres and radians.</summary>
    /// <param name="quantum">Seconds.</param>
    /// <param name="offset">Starts as the identity.</param>
    void AccumulateRootMotion(float quantum, ref Frame offset);

    /// <summary>May replace or scale the motion of one quantum, in the body's own frame.</summary>
    /// <param name="offset">The motion: metres and an orientation.</param>
    /// <param name="quantum">Seconds.</param>
    void AdjustOffset(ref Frame offset, float quantum);

    /// <summary>
    /// Does what the animations passed in this quantum: called after the velocity was integrated and before the body is moved.
    /// </summary>
    /// <remarks>Retail: the animation hooks of CPhysicsObj::process_hooks @0x00511550.</remarks>
    void ProcessHooks();

    /// <summary>
    /// The quantum was committed. The order is retail's: targets, move-to and pending motions, then blips and the end of sticking.
    /// </summary>
    /// <param name="physicsTime">Simulated time of the body, seconds.</param>
    void EndQuantum(double physicsTime);

    /// <summary>Ends a move-to or turn-to under way.</summary>
    void CancelMoveTo();

    /// <summary>Follows a position that a server told.</summary>
    /// <param name="place">Where the body is to be.</param>
    /// <param name="keepHeading">Keeps the body's own heading on the way and there.</param>
    void InterpolateTo(in Position place, bool keepHeading);

    /// <summary>Forgets the positions to follow.</summary>
    void StopInterpolating();

    /// <summary>Ties a leash.</summary>
    /// <param name="place">Where it is tied.</param>
    /// <param name="start">Metres of path from which on it brakes.</param>
    /// <param name="max">Metres of path after which it holds.</param>
    void ConstrainTo(in Position place, float start, float max);

    /// <summary>Unties the leash.</summary>
    void Unconstrain();

    /// <summary>Sticks to an object for a second; nothing when it is not known.</summary>
    void StickToObject(uint id);

    /// <summary>Lets go of what the body sticks to.</summary>
    void Unstick();

    /// <summary>Does what a server's position says.</summary>
    /// <param name="place">Where the body is to be.</param>
    /// <param name="teleported">Its teleport stamp is newer.</param>
    /// <param name="contact">The body touches the ground there.</param>
    PositionUpdate MoveOrTeleport(in Position place, bool teleported, bool contact);

    /// <summary>The body came into the world: links are dropped.</summary>
    void HandleEnterWorld();

    /// <summary>The body was teleported: whatever was pending ends, and whoever tracks it is told.</summary>
    void HandleTeleport();

    /// <summary>The body leaves the world: everything pending ends, it lets go, and whoever tracks it is told.</summary>
    void HandleExitWorld();

    /// <summary>Adds what decides over the body's future to a hash.</summary>
    void AddTo(ref StateHash hash);
}
