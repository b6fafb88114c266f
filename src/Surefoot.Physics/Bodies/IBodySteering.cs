using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>
/// What moves a body that does not move by itself: corrections of a server, sticking to an object, a leash, tracking a target. The body
/// makes it when the
/// first of these is asked for and calls it in each quantum.
/// </summary>
/// <remarks>Retail: PositionManager and TargetManager as CPhysicsObj calls them.</remarks>
internal interface IBodySteering
{
    /// <summary>Follows positions that a server told.</summary>
    bool IsInterpolating { get; }

    /// <summary>The leash is nearly used up: the body may not jump.</summary>
    bool IsFullyConstrained { get; }

    /// <summary>Id of the object the body sticks to, 0 for none.</summary>
    uint StickyObjectId { get; }

    /// <summary>May replace or scale the motion of one quantum, in the body's own frame.</summary>
    /// <param name="offset">The motion: metres and an orientation.</param>
    /// <param name="quantum">Seconds.</param>
    void AdjustOffset(ref Frame offset, float quantum);

    /// <summary>First at the end of a quantum, before the motions: what is tracked, and who tracks.</summary>
    /// <param name="physicsTime">Simulated time of the body, seconds.</param>
    void HandleTargetting(double physicsTime);

    /// <summary>Last at the end of a quantum: blips, and the end of sticking.</summary>
    void UseTime();

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

    /// <summary>The body was teleported: whatever was pending ends, and whoever tracks it is told.</summary>
    void HandleTeleport();

    /// <summary>The body leaves the world: it lets go, and whoever tracks it is told.</summary>
    void HandleExitWorld();

    /// <summary>Adds what decides over the body's future to a hash.</summary>
    void AddTo(ref StateHash hash);
}

/// <summary>What a body did about a position of a server.</summary>
public enum PositionUpdate
{
    /// <summary>Nothing: it falls, and the server's body did not stand.</summary>
    Ignored,

    /// <summary>Follows it.</summary>
    Interpolated,

    /// <summary>Was put there, being far from the local player.</summary>
    Placed,

    /// <summary>Was teleported there.</summary>
    Teleported,
}
