using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>A mesh that is part of something as an obstacle.</summary>
internal static class MeshObstacle
{
    /// <summary>Tests the check position against a mesh as a part of an object or building.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="transition">The transition.</param>
    /// <param name="part">Where the part is.</param>
    /// <param name="scale">The part's scale along z, the only one that counts.</param>
    /// <remarks>Retail: CPhysicsPart::find_obj_collisions @0x0050D8D0, CGfxObj::find_obj_collisions @0x00534700.</remarks>
    internal static TransitionState FindCollisions(this GfxObjAsset mesh, Transition transition, in Position part, float scale)
    {
        if (mesh.Physics is not { } tree) return TransitionState.OK;
        SpherePath path = transition.Path;
        path.CacheLocalSpaceSpheres(part, scale);
        for (int i = 0; i < path.SphereCount; i++)
        {
            if (!CollisionPrimitives.SpheresIntersect(tree.Bounds, path.LocalSpaceSpheres[i])) continue;
            return path.InsertType == InsertType.InitialPlacement
                ? tree.PlacementInsert(transition)
                : tree.FindCollisions(transition, scale);
        }

        return TransitionState.OK;
    }
}
