using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>Where a body met something, and how what it met was turned.</summary>
/// <param name="Place">
/// Where the body was when its sweep ended. A missile is not moved up to what it hits: its sphere ends less than its radius before it.
/// </param>
/// <param name="Normal">
/// Unit normal of what was met, towards the body, world axes; zero for what let the body through, and when nothing is met but a touch that
/// lasts is told again.
/// </param>
public readonly record struct Impact(Position Place, Vector3 Normal);

/// <summary>A collision with terrain, a building, a room or a static object.</summary>
/// <param name="Velocity">Own velocity before any bounce, m/s, world axes.</param>
/// <param name="HadContact">The body touched a plane before the sweep.</param>
/// <param name="Impact">Where and against what.</param>
public readonly record struct EnvironmentCollision(Vector3 Velocity, bool HadContact, Impact Impact);

/// <summary>A collision with another object.</summary>
/// <param name="ObjectId">The other object; 0 when it has no weenie to describe it.</param>
/// <param name="Velocity">Velocity relative to the other object, m/s.</param>
/// <param name="Traits">What the other object is.</param>
/// <param name="MeInContact">The one told was in contact.</param>
/// <param name="OtherIsMissile">The other is a missile.</param>
/// <param name="OtherInContact">The other is in contact.</param>
/// <param name="Impact">Where the one that moved was, and the normal towards it, also when the other one is told.</param>
public readonly record struct ObjectCollision(
    uint ObjectId, Vector3 Velocity, WeenieTraits Traits, bool MeInContact, bool OtherIsMissile, bool OtherInContact, Impact Impact);

/// <summary>A missile's hit.</summary>
/// <param name="ObjectId">The object that was hit, or the missile when its target is told.</param>
/// <param name="Quadrant">Where: 8 left or 16 right, 32 front or 64 back, 1 high, 2 medium or 4 low.</param>
/// <param name="Impact">Where the one that moved was, and the normal towards it, also when the target is told.</param>
public readonly record struct AttackCollision(uint ObjectId, int Quadrant, Impact Impact);

/// <summary>Is told of a body's collisions. Called inside a quantum: it may set velocities but must not move bodies.</summary>
/// <remarks>Retail: the DoCollision family of the weenie.</remarks>
public interface ICollisionListener
{
    /// <summary>The body began to touch the environment.</summary>
    void OnEnvironmentCollision(PhysicsBody body, in EnvironmentCollision collision);

    /// <summary>The body began to touch an object.</summary>
    void OnObjectCollision(WorldObject body, in ObjectCollision collision);

    /// <summary>A missile hit.</summary>
    void OnAttackCollision(WorldObject body, in AttackCollision collision);

    /// <summary>The body no longer touches an object.</summary>
    void OnCollisionEnd(WorldObject body, uint objectId);
}
