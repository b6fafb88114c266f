using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>The cells of a world for a body that nobody is to meet: it is listed nowhere, so nothing of the world is written.</summary>
internal sealed class ShadowCells(ICellWorld world) : ICellWorld
{
    public LeftOutList LeftOut { get; } = new();

    public IMoveRestrictions? Restrictions => world.Restrictions;

    public ObjCell? GetVisible(uint cellId) => world.GetVisible(cellId);

    public void FindCellList(CellArray array, in Position position, ReadOnlySpan<Sphere> spheres, bool wantHome, ref ObjCell? home) =>
        world.FindCellList(array, position, spheres, wantHome, ref home);

    public bool AdjustPosition(ref Position position, in Vector3 center, out ObjCell? cell) =>
        world.AdjustPosition(ref position, center, out cell);

    public void PlaceShadows(WorldObject item, CellArray cells)
    {
    }

    public void RemoveShadows(WorldObject item)
    {
    }

    public void CalcCrossCells(WorldObject item)
    {
    }

    public bool AnyOverlaps(WorldObject item) => false;
}
