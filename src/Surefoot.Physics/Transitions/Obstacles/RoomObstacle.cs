using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>The walls, floors and ceilings of a room as an obstacle.</summary>
internal static class RoomObstacle
{
    /// <summary>Tests the check position against a room, or pushes a body out of its walls when it is put there.</summary>
    /// <param name="shape">Its shape.</param>
    /// <param name="transition">The transition.</param>
    /// <param name="cell">Where the room is.</param>
    /// <remarks>Retail: the tree's part of CEnvCell::find_env_collisions @0x0052C130.</remarks>
    internal static TransitionState FindCollisions(this CellStructAsset shape, Transition transition, in Position cell)
    {
        transition.Path.CacheLocalSpaceSpheres(cell, 1f);
        return transition.Path.InsertType == InsertType.InitialPlacement ? shape.Physics.PlacementInsert(transition) : shape.Physics.FindCollisions(transition, 1f);
    }
}
