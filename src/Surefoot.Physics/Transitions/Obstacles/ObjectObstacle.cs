using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Bodies;

/// <content>The target's side of a collision: who stops whom.</content>
public partial class WorldObject
{
    /// <summary>Tests the spheres of a transition against this object. The caller skips attached objects and the mover itself.</summary>
    /// <remarks>Retail: CPhysicsObj::FindObjCollisions @0x0050F050; specification 02, 4.21.</remarks>
    internal TransitionState FindObjCollisions(Transition transition)
    {
        ObjectInfo mover = transition.Object;
        SpherePath path = transition.Path;
        bool ethereal = State.Has(PhysicsState.Ethereal), isStatic = State.Has(PhysicsState.Static);
        if (ethereal && State.Has(PhysicsState.IgnoreCollisions)) return TransitionState.OK;
        if (mover.Has(MoverFlags.IsViewer) && (Weenie & WeenieTraits.Creature) != 0) return TransitionState.OK;

        bool soft = ethereal || (mover.Ethereal && !isStatic);
        if (soft && path.StepDown) return TransitionState.OK;
        path.ObstructionEthereal = soft;
        bool creature = State.Has(PhysicsState.Missile) || (Weenie & WeenieTraits.Creature) != 0;
        TransitionState state = PassesPlayer(mover) || mover.MissileIgnores(this)
            ? TransitionState.OK
            : FindShapeCollisions(transition, creature);

        if (state != TransitionState.OK && !path.StepDown)
        {
            if (isStatic)
            {
                if (!mover.Has(MoverFlags.Contact)) transition.Collision.CollidedWithEnvironment = true;
            }
            else
            {
                if (soft || (creature && mover.Has(MoverFlags.IgnoreCreatures)))
                {
                    state = TransitionState.OK;
                    transition.Collision.CollisionNormalValid = false;
                }

                transition.Collision.AddObject(this, state);
            }
        }

        path.ObstructionEthereal = false;
        return state;
    }

    /// <summary>Ordinary players pass through each other; killers of the same kind do not, nor do the impenetrable.</summary>
    private bool PassesPlayer(ObjectInfo mover) =>
        (Weenie & WeenieTraits.Player) != 0 && (Weenie & WeenieTraits.Impenetrable) == 0 &&
        mover.Has(MoverFlags.IsPlayer) && !mover.Has(MoverFlags.IsImpenetrable) &&
        !(mover.Has(MoverFlags.IsPK) && (Weenie & WeenieTraits.PK) != 0) &&
        !(mover.Has(MoverFlags.IsPKLite) && (Weenie & WeenieTraits.PKLite) != 0);

    /// <summary>Exactly one set of shapes is tested: the parts' trees, else cylinders, else spheres.</summary>
    private TransitionState FindShapeCollisions(Transition transition, bool creature) =>
        Setup is null ? TransitionState.OK : Setup.FindCollisions(transition, this, creature);
}
