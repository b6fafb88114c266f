using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Tool;

/// <summary>Bodies of what the demo world has spawned.</summary>
internal static class DemoBodies
{
    /// <summary>Puts one where it belongs; its landblock is to be loaded.</summary>
    internal static PhysicsBody Spawn(PhysicsEngine engine, PhysicsDataCache assets, DemoSpawn spawn, uint id)
    {
        bool isDoor = spawn.Kind == DemoSpawnKind.Door;
        PhysicsBody body = engine.CreateBody(
            id, assets.GetSetup(spawn.SetupId), isDoor ? PhysicsState.ReportCollisions : PhysicsState.Default,
            isDoor ? WeenieTraits.Present : WeenieTraits.Present | WeenieTraits.Creature);
        body.EnterWorld(new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)));
        return body;
    }
}
