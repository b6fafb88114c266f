using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>What the motion side needs to know of a body and may do to it. The other direction is <c>IBodyDriver</c>.</summary>
/// <remarks>Retail: the members of CPhysicsObj that CMotionInterp uses; specification 01 and 02, 4.10.</remarks>
internal interface IMotionBody
{
    /// <summary>Touches a plane.</summary>
    bool HasContact { get; }

    /// <summary>Stands on a plane that can be walked on.</summary>
    bool OnWalkable { get; }

    /// <summary>Falls when nothing holds it.</summary>
    bool HasGravity { get; }

    /// <summary>Is in a cell.</summary>
    bool HasCell { get; }

    /// <summary>A server's correction holds it in place: it may not jump.</summary>
    bool IsFullyConstrained { get; }

    /// <summary>The last motion was asked for by the local player and not by a server.</summary>
    bool LastMoveWasAutonomous { get; set; }

    /// <summary>Where it is.</summary>
    Position Position { get; }

    /// <summary>The plane touched last, in the coordinates of its landblock; it holds while <see cref="HasContact"/>.</summary>
    Plane ContactPlane { get; }

    /// <summary>Velocity in the body's own axes, m/s: x right, y ahead, z up.</summary>
    Vector3 LocalVelocity { get; }

    /// <summary>Sets the velocity from the body's own axes.</summary>
    /// <param name="velocity">m/s; x right, y ahead, z up.</param>
    void SetLocalVelocity(Vector3 velocity);

    /// <summary>
    /// Writes the on-walkable bit, calls <c>HitGround</c> or <c>LeaveGround</c> of the motion side, renews the acceleration.
    /// </summary>
    void SetOnWalkable(bool on);

    /// <summary>Ends a move-to or turn-to under way.</summary>
    void CancelMoveTo()
    {
    }

    /// <summary>Lets go of what the body sticks to.</summary>
    void Unstick()
    {
    }

    /// <summary>Ends following the places that a server told.</summary>
    void StopInterpolating()
    {
    }
}
