using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>The shell of a building as an obstacle.</summary>
internal static class BuildingObstacle
{
    /// <summary>
    /// Tests the first part of a shell, the only one that can be hit. A body that reaches into a room may have its centre inside the
    /// shell's solid.
    /// </summary>
    /// <remarks>Retail: CBuildingObj::find_building_collisions @0x006B5300.</remarks>
    internal static TransitionState FindBuildingCollisions(this BuildingObject building, Transition transition)
    {
        StaticObject shell = building.Shell;
        if (shell.PlacedPartCount == 0) return TransitionState.OK;
        SetupPart part = shell.Setup!.Parts[0];
        transition.Trace?.AsksBuilding(shell);
        transition.Path.BuildingCheck = true;
        TransitionState state = part.Mesh.FindCollisions(transition, new Position(shell.Position.CellId, shell.PartFrame(0)),
            part.DefaultScale.Z);
        transition.Path.BuildingCheck = false;
        if (state != TransitionState.OK && !transition.Object.Has(MoverFlags.Contact)) transition.Collision.CollidedWithEnvironment = true;
        return state;
    }
}
