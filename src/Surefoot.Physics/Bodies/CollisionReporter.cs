using System.Numerics;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>What a body touches, and who is told when that begins and ends.</summary>
/// <remarks>Retail: the collision table of CPhysicsObj; specification 02, 4.15.</remarks>
internal sealed class CollisionReporter(PhysicsBody body)
{
    private const double CollisionRecordLife = 1.0;

    /// <summary>Who stands in a crowd touches as many: room for them at once, so that no record is allocated in a step.</summary>
    private const int Room = 8;

    private const PhysicsState MissileBits = PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped;

    private Dictionary<uint, CollisionRecord>? touching;
    private List<uint>? ended;
    private Vector3 normal;

    private readonly record struct CollisionRecord(double TouchedTime, bool Ethereal);

    /// <summary>A collision with the environment was reported and has not ended.</summary>
    internal bool TouchesEnvironment { get; set; }

    /// <summary>Reports what a transition met, and the end of what it no longer did.</summary>
    /// <param name="met">What it met.</param>
    /// <param name="hadContact">The body touched a plane before it.</param>
    /// <param name="landed">The body did not stand before it, and does now.</param>
    /// <param name="simulatedTime">Seconds.</param>
    /// <returns>True when something was reported.</returns>
    internal bool Report(CollisionInfo met, bool hadContact, bool landed, double simulatedTime)
    {
        bool reported = false;
        normal = met.CollisionNormalValid ? met.CollisionNormal : landed ? body.ContactPlane.Normal : Vector3.Zero;
        foreach (WorldObject other in met.Objects) reported |= Track(other, hadContact, simulatedTime);
        ReportEnd(simulatedTime, force: false);

        if (TouchesEnvironment) TouchesEnvironment = met.CollidedWithEnvironment;
        else if (met.CollidedWithEnvironment || landed) reported |= ReportEnvironment(hadContact);
        normal = Vector3.Zero;
        return reported;
    }

    private Impact Impact => new(body.Position, normal);

    /// <remarks>Retail: CPhysicsObj::track_object_collision @0x00513F10.</remarks>
    private bool Track(WorldObject other, bool hadContact, double simulatedTime)
    {
        if (other.State.Has(PhysicsState.Static)) return ReportEnvironment(hadContact);
        touching ??= new Dictionary<uint, CollisionRecord>(Room);
        bool known = touching.ContainsKey(other.Id);
        touching[other.Id] = new CollisionRecord(simulatedTime, other.State.Has(PhysicsState.Ethereal));
        return !known && ReportObject(other, hadContact);
    }

    /// <remarks>Retail: CPhysicsObj::report_object_collision @0x00513060.</remarks>
    private bool ReportObject(WorldObject other, bool hadContact)
    {
        if (other.State.Has(PhysicsState.ReportCollisionsAsEnvironment)) return ReportEnvironment(hadContact);
        Vector3 relative = body.Velocity - other.Velocity;
        bool wasMissile = body.State.Has(PhysicsState.Missile), otherIsMissile = other.State.Has(PhysicsState.Missile);
        bool reported = false;
        if (!other.State.Has(PhysicsState.IgnoreCollisions))
        {
            if (body.State.Has(PhysicsState.ReportCollisions) && body.Weenie != WeenieTraits.None)
            {
                if (wasMissile)
                {
                    body.Listener?.OnAttackCollision(body,
                        new AttackCollision(other.Id, other.Position.QuadrantOf(body.Position, other.Height), Impact));
                }
                else body.Listener?.OnObjectCollision(body, ProfileOf(other, relative, hadContact, otherIsMissile, other.HasContact));
                reported = true;
            }

            if (wasMissile) body.State &= ~MissileBits;
        }

        if (other.State.Has(PhysicsState.ReportCollisions) && !body.State.Has(PhysicsState.IgnoreCollisions) &&
            other.Weenie != WeenieTraits.None)
        {
            ICollisionListener? listener = (other as PhysicsBody)?.Listener;
            if (otherIsMissile)
                listener?.OnAttackCollision(other,
                    new AttackCollision(body.Id, body.Position.QuadrantOf(other.Position, body.Height), Impact));
            // Retail hands over the missile and contact flags the wrong way round; so do we.
            else listener?.OnObjectCollision(other, ProfileOf(body, relative, other.HasContact, hadContact, wasMissile));
            reported = true;
        }

        return reported;
    }

    /// <remarks>Retail: CPhysicsObj::report_environment_collision @0x00512FC0.</remarks>
    private bool ReportEnvironment(bool hadContact)
    {
        if (TouchesEnvironment) return false;
        bool reported = body.State.Has(PhysicsState.ReportCollisions) && body.Weenie != WeenieTraits.None;
        if (reported) body.Listener?.OnEnvironmentCollision(body, new EnvironmentCollision(body.Velocity, hadContact, Impact));
        TouchesEnvironment = true;
        if (body.State.Has(PhysicsState.Missile)) body.State &= ~MissileBits;
        return reported;
    }

    /// <summary>Reports again whatever the body touches.</summary>
    /// <remarks>Retail: CPhysicsObj::report_collision_start @0x00513FD0.</remarks>
    internal void ReportStart()
    {
        if (touching is null) return;
        foreach (uint id in touching.Keys)
        {
            if (body.Population.Find(id) is { } other) ReportObject(other, body.HasContact);
        }
    }

    /// <summary>Ends the records of objects not touched for a second, of ethereal ones at once.</summary>
    /// <remarks>Retail: CPhysicsObj::report_collision_end @0x00514620.</remarks>
    internal void ReportEnd(double simulatedTime, bool force)
    {
        if (touching is null || touching.Count == 0) return;
        ended ??= new List<uint>(Room);
        // Whoever is told of an end may hide or remove the body, which ends the rest from within: each call does its own part of the list.
        int first = ended.Count;
        foreach ((uint id, CollisionRecord record) in touching)
        {
            double age = simulatedTime - record.TouchedTime;
            if (force || age > CollisionRecordLife || (record.Ethereal && age > 0))
            {
                touching.Remove(id);
                ended.Add(id);
            }
        }

        int last = ended.Count;
        for (int i = first; i < last; i++) ReportObjectEnd(ended[i]);
        ended.RemoveRange(first, last - first);
    }

    /// <remarks>Retail: CPhysicsObj::report_object_collision_end @0x00510A90.</remarks>
    private void ReportObjectEnd(uint id)
    {
        PhysicsBody? other = body.Population.Find(id);
        if (other is not null && other.State.Has(PhysicsState.ReportCollisionsAsEnvironment)) return;
        if (body.State.Has(PhysicsState.ReportCollisions) && body.Weenie != WeenieTraits.None) body.Listener?.OnCollisionEnd(body, id);
        if (other is not null && other.State.Has(PhysicsState.ReportCollisions) && other.Weenie != WeenieTraits.None)
            other.Listener?.OnCollisionEnd(other, body.Id);
    }

    private ObjectCollision ProfileOf(WorldObject other, Vector3 relative, bool meInContact, bool isMissile, bool inContact) =>
        other.Weenie == WeenieTraits.None
            ? new ObjectCollision { Impact = Impact }
            : new ObjectCollision(other.Id, relative, other.Weenie, meInContact, isMissile, inContact, Impact);
}
