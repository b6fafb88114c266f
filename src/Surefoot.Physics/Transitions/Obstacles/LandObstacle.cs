using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>A square of land as an obstacle: its ground, then its building, then its objects.</summary>
internal static class LandObstacle
{
    /// <summary>Tests the check position against everything in a square of land.</summary>
    /// <remarks>Retail: CLandCell::find_collisions @0x00532D60, CSortCell::find_collisions @0x005340A0.</remarks>
    internal static TransitionState FindCollisions(LandCell land, Transition transition)
    {
        TransitionState state = land.CheckEntryRestrictions(transition);
        if (state == TransitionState.OK) state = AskGround(land, transition, mayBeWater: false);
        return state == TransitionState.OK ? AskThings(land, transition) : state;
    }

    /// <summary>The same of spheres that are nobody's: whether they may be here is not asked, and open water is no obstacle.</summary>
    internal static TransitionState FindOverlap(LandCell land, Transition transition)
    {
        TransitionState state = AskGround(land, transition, mayBeWater: true);
        return state == TransitionState.OK ? AskThings(land, transition) : state;
    }

    /// <summary>
    /// The terrain's answer: the triangle is chosen by the foot's lowest point. A sphere over another cell is tested there only.
    /// </summary>
    /// <remarks>Retail: CLandCell::find_env_collisions @0x00532F20.</remarks>
    private static TransitionState AskGround(LandCell land, Transition transition, bool mayBeWater)
    {
        SpherePath path = transition.Path;
        TerrainSurface terrain = land.Landblock.Terrain;
        Vector3 offset = CellIds.BlockOffset(path.CheckPos.CellId, land.Id);
        Vector3 low = path.GlobalLowPoint - offset;
        int triangle = land.FindTriangle(low);
        if (triangle < 0) return TransitionState.OK;
        transition.Trace?.AsksTriangle(triangle);
        if (!mayBeWater && terrain.BlockWaterType == WaterType.Entirely && IsStoppedByOpenWater(transition.Object))
        {
            transition.Trace?.Responded(transition, TransitionResponse.Stop, Vector3.Zero, false, TraceReason.OpenWater);
            return TransitionState.Collided;
        }

        Sphere foot = path.GlobalSpheres[0];
        foot.Center -= offset;
        return transition.ValidateWalkable(foot, terrain.PlaneOf(triangle), land.Water != WaterType.None, land.WaterDepth(low), land.Id);
    }

    private static TransitionState AskThings(LandCell land, Transition transition)
    {
        TransitionState state = land.Building is { } building ? building.FindBuildingCollisions(transition) : TransitionState.OK;
        return state == TransitionState.OK ? land.FindObjCollisions(transition) : state;
    }

    /// <summary>A block that is water all over stops everything but the camera and missiles.</summary>
    private static bool IsStoppedByOpenWater(ObjectInfo mover) =>
        !mover.Has(MoverFlags.IsViewer) && mover.Mover is not null && !mover.State.Has(PhysicsState.Missile);
}
