using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.World;

/// <summary>A building: its shell, which stands in one square of land, and the portals through which its rooms are entered from outdoors.</summary>
/// <remarks>Retail: CBuildingObj.</remarks>
public sealed class BuildingObject
{
    private readonly BuildingPortal[] portals;

    internal BuildingObject(StaticObject shell, BuildingPart? part, BuildingPortal[] portals)
    {
        Shell = shell;
        Part = part;
        this.portals = portals;
    }

    /// <summary>Its outside.</summary>
    public StaticObject Shell { get; }

    /// <summary>Its ways in.</summary>
    public ReadOnlySpan<BuildingPortal> Portals => portals;

    /// <summary>The only part that can be hit: the first; null when it has nothing to run into.</summary>
    internal BuildingPart? Part { get; }

    /// <summary>Tests the shell. A body that reaches into a room may have its centre inside the shell's solid.</summary>
    /// <remarks>Retail: CBuildingObj::find_building_collisions @0x006B5300.</remarks>
    internal TransitionState FindBuildingCollisions(Transition transition)
    {
        if (Part is not { } part) return TransitionState.OK;
        SpherePath path = transition.Path;
        path.BuildingCheck = true;
        path.CacheLocalSpaceSpheres(part.Position, part.Scale);
        TransitionState state = part.Bsp.FindCollisions(transition, part.Scale);
        path.BuildingCheck = false;
        if (state != TransitionState.OK && !transition.Object.Has(MoverFlags.Contact)) transition.Collision.CollidedWithEnvironment = true;
        return state;
    }

    /// <remarks>Retail: CBuildingObj::find_building_transit_cells @0x006B5230.</remarks>
    internal void FindTransitCells(ICellWorld world, ReadOnlySpan<Sphere> spheres, CellArray array, SpherePath? path)
    {
        foreach (ref readonly BuildingPortal portal in portals.AsSpan())
            world.GetVisible(portal.OtherCellId)?.CheckBuildingTransit(portal.OtherPortal, spheres, array, path);
    }

    /// <remarks>Retail: CBuildingObj::find_building_transit_cells @0x006B52A0.</remarks>
    internal void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        foreach (ref readonly BuildingPortal portal in portals.AsSpan())
            world.GetVisible(portal.OtherCellId)?.CheckBuildingTransit(world, portal.OtherPortal, parts, array);
    }
}

/// <summary>The part of a building that can be hit.</summary>
/// <param name="Bsp">Its tree.</param>
/// <param name="Position">Where it is.</param>
/// <param name="Scale">Its scale along z, the only one that counts.</param>
internal sealed record BuildingPart(PhysicsBsp Bsp, Position Position, float Scale);

/// <summary>A way into a building.</summary>
/// <param name="OtherCellId">Full id of the room behind it.</param>
/// <param name="OtherPortal">Index of that room's portal; negative lets nobody in.</param>
/// <remarks>Retail: CBldPortal.</remarks>
public readonly record struct BuildingPortal(uint OtherCellId, short OtherPortal);
