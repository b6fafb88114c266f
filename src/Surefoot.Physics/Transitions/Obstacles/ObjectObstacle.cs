using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>An object as an obstacle: who stops whom.</summary>
internal static class ObjectObstacle
{
    /// <summary>Tests the spheres of a transition against an object. The caller skips attached objects and the mover itself.</summary>
    /// <remarks>Retail: CPhysicsObj::FindObjCollisions @0x0050F050; specification 02, 4.21.</remarks>
    internal static TransitionState FindObjCollisions(this WorldObject target, Transition transition)
    {
        ObjectInfo mover = transition.Object;
        SpherePath path = transition.Path;
        bool ethereal = target.State.Has(PhysicsState.Ethereal), isStatic = target.State.Has(PhysicsState.Static);
        if (ethereal && target.State.Has(PhysicsState.IgnoreCollisions)) return Skip(TraceReason.IgnoresCollisions);
        if (mover.Has(MoverFlags.IsViewer) && (target.Weenie & WeenieTraits.Creature) != 0) return Skip(TraceReason.IgnoredCreature);

        if (target.ChangedAt >= mover.PassesChangedSince) return Skip(TraceReason.IgnoresCollisions);

        bool soft = ethereal || (mover.Ethereal && !isStatic);
        if (soft && path.SteppingDown) return Skip(TraceReason.Ethereal);
        path.ObstructionEthereal = soft;
        bool creature = target.State.Has(PhysicsState.Missile) || (target.Weenie & WeenieTraits.Creature) != 0;
        transition.Trace?.Asks(target);
        TraceReason passed = PassesPlayer(target, mover) ? TraceReason.PassedPlayer
            : mover.MissileIgnores(target) ? TraceReason.PassedByMissile
            : target.Setup is null ? TraceReason.NoShape : TraceReason.None;
        TransitionState state = passed == TraceReason.None
            ? target.Setup!.FindCollisions(transition, target, creature)
            : TransitionState.OK;

        if (state != TransitionState.OK && !path.SteppingDown)
        {
            if (isStatic)
            {
                if (!mover.Has(MoverFlags.Contact)) transition.Collision.CollidedWithEnvironment = true;
            }
            else
            {
                if (soft || (creature && mover.Has(MoverFlags.IgnoreCreatures)))
                {
                    passed = soft ? TraceReason.Ethereal : TraceReason.IgnoredCreature;
                    state = TransitionState.OK;
                    transition.Collision.CollisionNormalValid = false;
                }

                transition.Collision.AddObject(target);
            }
        }

        path.ObstructionEthereal = false;
        transition.Trace?.ObjectAnswered(transition, target, state, passed);
        return state;

        TransitionState Skip(TraceReason reason)
        {
            transition.Trace?.Skipped(transition, target, reason);
            return TransitionState.OK;
        }
    }

    /// <summary>Ordinary players pass through each other; killers of the same kind do not, nor do the impenetrable.</summary>
    private static bool PassesPlayer(WorldObject target, ObjectInfo mover) =>
        (target.Weenie & WeenieTraits.Player) != 0 && (target.Weenie & WeenieTraits.Impenetrable) == 0 &&
        mover.Has(MoverFlags.IsPlayer) && !mover.Has(MoverFlags.IsImpenetrable) &&
        !(mover.Has(MoverFlags.IsPK) && (target.Weenie & WeenieTraits.PK) != 0) &&
        !(mover.Has(MoverFlags.IsPKLite) && (target.Weenie & WeenieTraits.PKLite) != 0);
}
