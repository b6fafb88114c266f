using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>What every cell has in a mover's way: a guard, and the objects that are listed in it.</summary>
internal static class CellObstacle
{
    /// <summary>House barriers: a player may not enter a cell that an object guards unless the object lets it.</summary>
    /// <remarks>Retail: CObjCell::check_entry_restrictions @0x0052B6D0.</remarks>
    internal static TransitionState CheckEntryRestrictions(this ObjCell cell, Transition transition)
    {
        WorldObject? mover = transition.Object.Mover;
        if (mover is null) return TransitionState.Collided;
        bool guarded = cell.RestrictionObject != 0 && transition.Object.Weenie != WeenieTraits.None &&
            transition.Object.Has(MoverFlags.IsPlayer);
        if (!guarded) return TransitionState.OK;
        IMoveRestrictions? restrictions = transition.World.Restrictions;
        if (restrictions is not null && restrictions.CanBypass(mover)) return TransitionState.OK;
        switch (restrictions?.CanMoveInto(cell.RestrictionObject, mover))
        {
            case true:
                return TransitionState.OK;
            case false:
                if (cell is LandCell land) PushBack(land, transition);
                transition.Trace?.Responded(transition, TransitionResponse.Stop, transition.Collision.CollisionNormal, false,
                    TraceReason.Guarded);
                return TransitionState.Collided;
            default:
                transition.Trace?.Responded(transition, TransitionResponse.Stop, Vector3.Zero, false, TraceReason.Guarded);
                return TransitionState.Collided;
        }
    }

    /// <summary>Tests the objects in a cell; the first one that is in the way ends it.</summary>
    /// <remarks>Retail: CObjCell::find_obj_collisions @0x0052B750.</remarks>
    internal static TransitionState FindObjCollisions(this ObjCell cell, Transition transition)
    {
        if (transition.Path.InsertType == InsertType.InitialPlacement) return TransitionState.OK;
        WorldObject? mover = transition.Object.Mover;
        for (int i = 0; i < cell.ShadowCount; i++)
        {
            WorldObject target = cell.ShadowAt(i);
            if (target.Parent is not null || ReferenceEquals(target, mover))
            {
                transition.Trace?.Skipped(transition, target, target.Parent is not null ? TraceReason.IsAttached : TraceReason.IsTheMover);
                continue;
            }

            TransitionState state = target.FindObjCollisions(transition);
            if (state != TransitionState.OK) return state;
        }

        return TransitionState.OK;
    }

    /// <summary>A refused mover is pushed back out over the side of the square of land that it came from; y is looked at first.</summary>
    /// <remarks>Retail: CLandCell::handle_move_restriction @0x00533070; rooms do nothing.</remarks>
    internal static void PushBack(LandCell land, Transition transition)
    {
        const float half = CellIds.CellSize / 2;
        Vector3 offset = land.Position.OffsetTo(transition.Path.CurrPos);
        Vector3 normal;
        if (offset.Y < -half) normal = -Vector3.UnitY;
        else if (offset.Y > half) normal = Vector3.UnitY;
        else normal = offset.X < -half ? -Vector3.UnitX : Vector3.UnitX;
        transition.Collision.SetCollisionNormal(normal);
    }
}
