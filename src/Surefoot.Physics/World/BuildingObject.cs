using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// A building: its shell, which stands in one square of land, and the portals through which its rooms are entered from outdoors.
/// </summary>
/// <remarks>Retail: CBuildingObj.</remarks>
public sealed class BuildingObject
{
    private readonly BuildingPortal[] portals;

    internal BuildingObject(StaticObject shell, BuildingPortal[] portals)
    {
        Shell = shell;
        this.portals = portals;
    }

    /// <summary>Its outside.</summary>
    public StaticObject Shell { get; }

    /// <summary>Its ways in.</summary>
    internal ReadOnlySpan<BuildingPortal> Portals => portals;

    /// <remarks>Retail: CBuildingObj::find_building_transit_cells @0x006B5230.</remarks>
    internal void FindTransitCells(ICellWorld world, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
        foreach (ref readonly BuildingPortal portal in portals.AsSpan())
            world.GetVisible(portal.OtherCellId)?.CheckBuildingTransit(portal.OtherPortal, spheres, array);
    }

    /// <remarks>Retail: CBuildingObj::find_building_transit_cells @0x006B52A0.</remarks>
    internal void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        foreach (ref readonly BuildingPortal portal in portals.AsSpan())
            world.GetVisible(portal.OtherCellId)?.CheckBuildingTransit(world, portal.OtherPortal, parts, array);
    }
}

/// <summary>A way into a building.</summary>
/// <param name="OtherCellId">Full id of the room behind it.</param>
/// <param name="OtherPortal">Index of that room's portal; negative lets nobody in.</param>
/// <remarks>Retail: CBldPortal.</remarks>
internal readonly record struct BuildingPortal(uint OtherCellId, short OtherPortal);
