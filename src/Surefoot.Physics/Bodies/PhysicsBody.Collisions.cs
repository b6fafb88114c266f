using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>What a body does about its collisions: reports, bounce, stop.</content>
public sealed partial class PhysicsBody
{
    private const double CollisionRecordLife = 1.0;
    private const PhysicsState MissileBits = PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped;

    private Dictionary<uint, CollisionRecord>? touching;
    private List<uint>? ended;
    private bool collidingWithEnvironment;

    private readonly record struct CollisionRecord(double TouchedTime, bool Ethereal);

    /// <summary>Reports, then bounces or stops, then keeps count of failed moves.</summary>
    /// <returns>True when something was reported.</returns>
    /// <remarks>Retail: CPhysicsObj::handle_all_collisions @0x00514780. Reports see the velocity before the bounce.</remarks>
    internal bool HandleAllCollisions(CollisionInfo info, bool hadContact, bool hadWalkable, double simulatedTime)
    {
        bool nowWalkable = OnWalkable;
        bool mayBounce = !hadWalkable || !nowWalkable || State.Has(PhysicsState.Sledding);
        bool reported = false;
        foreach (WorldObject other in info.Objects) reported |= TrackObjectCollision(other, hadContact, simulatedTime);
        ReportCollisionEnd(simulatedTime, force: false);

        if (collidingWithEnvironment) collidingWithEnvironment = info.CollidedWithEnvironment;
        else if (info.CollidedWithEnvironment || (!hadWalkable && nowWalkable)) reported |= ReportEnvironmentCollision(hadContact);

        int stationary = info.FramesStationaryFall;
        if (stationary >= 2) velocity = Vector3.Zero;
        else if (mayBounce && info.CollisionNormalValid) Bounce(info.CollisionNormal);

        if (stationary is 0 or 3) Transient &= ~TransientState.StationaryMask;
        else if (stationary == 1) Transient |= TransientState.StationaryFall;
        else if (stationary == 2) Transient |= TransientState.StationaryStop;
        return reported;
    }

    /// <summary>Reflects the velocity into the obstacle, nearly all of it lost.</summary>
    internal void Bounce(in Vector3 normal)
    {
        if (State.Has(PhysicsState.Inelastic))
        {
            velocity = Vector3.Zero;
            return;
        }

        double dot = RetailMath.Dot(velocity, normal);
        if (dot >= 0) return;
        double k = -(dot * ((double)Elasticity + 1.0));
        velocity = new Vector3(
            (float)((k * normal.X) + velocity.X), (float)((float)(k * normal.Y) + (double)velocity.Y), (float)((float)(k * normal.Z) + (double)velocity.Z));
    }

    /// <remarks>Retail: CPhysicsObj::track_object_collision @0x00513F10.</remarks>
    private bool TrackObjectCollision(WorldObject other, bool hadContact, double simulatedTime)
    {
        if (other.State.Has(PhysicsState.Static)) return ReportEnvironmentCollision(hadContact);
        touching ??= [];
        bool known = touching.ContainsKey(other.Id);
        touching[other.Id] = new CollisionRecord(simulatedTime, other.State.Has(PhysicsState.Ethereal));
        return !known && ReportObjectCollision(other, hadContact);
    }

    /// <remarks>Retail: CPhysicsObj::report_object_collision @0x00513060.</remarks>
    private bool ReportObjectCollision(WorldObject other, bool hadContact)
    {
        if (other.State.Has(PhysicsState.ReportCollisionsAsEnvironment)) return ReportEnvironmentCollision(hadContact);
        Vector3 relative = velocity - other.Velocity;
        bool wasMissile = State.Has(PhysicsState.Missile), otherIsMissile = other.State.Has(PhysicsState.Missile);
        bool reported = false;
        if (!other.State.Has(PhysicsState.IgnoreCollisions))
        {
            if (State.Has(PhysicsState.ReportCollisions) && Weenie != WeenieTraits.None)
            {
                if (wasMissile) Listener?.OnAttackCollision(this, new AttackCollision(other.Id, other.Position.QuadrantOf(PositionField, other.Height)));
                else Listener?.OnObjectCollision(this, ProfileOf(other, relative, hadContact, otherIsMissile, other.HasContact));
                reported = true;
            }

            if (wasMissile) State &= ~MissileBits;
        }

        if (other.State.Has(PhysicsState.ReportCollisions) && !State.Has(PhysicsState.IgnoreCollisions) && other.Weenie != WeenieTraits.None)
        {
            ICollisionListener? listener = (other as PhysicsBody)?.Listener;
            if (otherIsMissile) listener?.OnAttackCollision(other, new AttackCollision(Id, PositionField.QuadrantOf(other.Position, Height)));
            // Retail hands over the missile and contact flags the wrong way round; so do we.
            else listener?.OnObjectCollision(other, ProfileOf(this, relative, other.HasContact, hadContact, wasMissile));
            reported = true;
        }

        return reported;
    }

    /// <remarks>Retail: CPhysicsObj::report_environment_collision @0x00512FC0.</remarks>
    private bool ReportEnvironmentCollision(bool hadContact)
    {
        if (collidingWithEnvironment) return false;
        bool reported = State.Has(PhysicsState.ReportCollisions) && Weenie != WeenieTraits.None;
        if (reported) Listener?.OnEnvironmentCollision(this, new EnvironmentCollision(velocity, hadContact));
        collidingWithEnvironment = true;
        if (State.Has(PhysicsState.Missile)) State &= ~MissileBits;
        return reported;
    }

    /// <summary>Reports again whatever the body touches.</summary>
    /// <remarks>Retail: CPhysicsObj::report_collision_start @0x00513FD0.</remarks>
    private void ReportCollisionStart()
    {
        if (touching is null) return;
        foreach (uint id in touching.Keys)
        {
            if (engine.Find(id) is { } other) ReportObjectCollision(other, HasContact);
        }
    }

    /// <summary>Ends the records of objects not touched for a second, of ethereal ones at once.</summary>
    /// <remarks>Retail: CPhysicsObj::report_collision_end @0x00514620.</remarks>
    private void ReportCollisionEnd(double simulatedTime, bool force)
    {
        if (touching is null || touching.Count == 0) return;
        ended ??= [];
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
        for (int i = first; i < last; i++) ReportObjectCollisionEnd(ended[i]);
        ended.RemoveRange(first, last - first);
    }

    /// <remarks>Retail: CPhysicsObj::report_object_collision_end @0x00510A90.</remarks>
    private void ReportObjectCollisionEnd(uint id)
    {
        PhysicsBody? other = engine.Find(id);
        if (other is not null && other.State.Has(PhysicsState.ReportCollisionsAsEnvironment)) return;
        if (State.Has(PhysicsState.ReportCollisions) && Weenie != WeenieTraits.None) Listener?.OnCollisionEnd(this, id);
        if (other is not null && other.State.Has(PhysicsState.ReportCollisions) && other.Weenie != WeenieTraits.None)
            other.Listener?.OnCollisionEnd(other, Id);
    }

    private static ObjectCollision ProfileOf(WorldObject other, Vector3 relative, bool meInContact, bool isMissile, bool inContact) =>
        other.Weenie == WeenieTraits.None ? default : new ObjectCollision(other.Id, relative, other.Weenie, meInContact, isMissile, inContact);
}
