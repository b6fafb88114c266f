using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;

namespace Surefoot.Physics.World;

/// <summary>A square of land, 24 m by 24 m.</summary>
/// <remarks>Retail: CLandCell, CSortCell.</remarks>
internal sealed class LandCell : ObjCell
{
    private readonly Landblock block;
    private readonly int index;

    internal LandCell(Landblock block, int index)
        : base(block.Id | (uint)(index + 1))
    {
        this.block = block;
        this.index = index;
    }

    /// <summary>The landblock it is part of.</summary>
    public Landblock Landblock => block;

    /// <inheritdoc/>
    public override Position Position => new(
        Id, new Vector3((CellIds.CellSize / 2) * ((2 * (index >> 3)) + 1), (CellIds.CellSize / 2) * ((2 * (index & 7)) + 1), 0));

    /// <inheritdoc/>
    public override WaterType Water => block.Terrain.WaterTypeOf(index);

    /// <summary>The building whose origin is over this cell; only the first one of a cell can be hit and entered.</summary>
    public BuildingObject? Building { get; internal set; }

    /// <summary>How deep a body sinks in at a point of the block, metres.</summary>
    internal float WaterDepth(in Vector3 point) => block.Terrain.WaterDepth(index, point);

    /// <summary>The triangle under a point of the block, −1 when the point is over another cell.</summary>
    internal int FindTriangle(in Vector3 point) => block.Terrain.FindTriangle(index, point);

    /// <inheritdoc/>
    /// <remarks>Retail: CLandCell::point_in_cell @0x00532D40.</remarks>
    internal override bool PointInCell(in Vector3 point) => FindTriangle(point) >= 0;

    /// <inheritdoc/>
    internal override TransitionState FindCollisions(Transition transition) => LandObstacle.FindCollisions(this, transition);

    /// <inheritdoc/>
    internal override TransitionState FindOverlap(Transition transition) => LandObstacle.FindOverlap(this, transition);

    /// <remarks>Retail: CLandCell::find_transit_cells @0x00533800.</remarks>
    internal override void FindTransitCells(ICellWorld world, in Position position, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
        OutdoorCells.AddAll(world, position, spheres, array);
        Building?.FindTransitCells(world, spheres, array);
    }

    /// <remarks>Retail: CLandCell::find_transit_cells @0x00533840.</remarks>
    internal override void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        OutdoorCells.AddAll(world, parts, array);
        Building?.FindTransitCells(world, parts, array);
    }
}
