using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>A room as an obstacle: its walls, floors and ceilings, then its objects.</summary>
internal static class RoomObstacle
{
    /// <summary>Tests the check position against everything in a room.</summary>
    /// <remarks>Retail: CEnvCell::find_collisions @0x0052C100.</remarks>
    internal static TransitionState FindCollisions(EnvCell room, Transition transition)
    {
        TransitionState state = AskShape(room, transition);
        return state == TransitionState.OK ? room.FindObjCollisions(transition) : state;
    }

    /// <summary>The same of spheres that are nobody's: whether they may be here is not asked.</summary>
    internal static TransitionState FindOverlap(EnvCell room, Transition transition)
    {
        TransitionState state = AskWalls(room, transition);
        return state == TransitionState.OK ? room.FindObjCollisions(transition) : state;
    }

    /// <remarks>Retail: CEnvCell::find_env_collisions @0x0052C130.</remarks>
    private static TransitionState AskShape(EnvCell room, Transition transition)
    {
        TransitionState state = room.CheckEntryRestrictions(transition);
        return state == TransitionState.OK ? AskWalls(room, transition) : state;
    }

    /// <summary>The answer of the walls; a body that is put there is pushed out of them.</summary>
    private static TransitionState AskWalls(EnvCell room, Transition transition)
    {
        SpherePath path = transition.Path;
        path.ObstructionEthereal = false;
        path.CacheLocalSpaceSpheres(room.Position, 1f);
        PhysicsBsp walls = room.Shape.Physics;
        TransitionState state =
            path.InsertType == InsertType.InitialPlacement ? walls.PlacementInsert(transition) : walls.FindCollisions(transition, 1f);
        if (state != TransitionState.OK && !transition.Object.Has(MoverFlags.Contact)) transition.Collision.CollidedWithEnvironment = true;
        return state;
    }
}
