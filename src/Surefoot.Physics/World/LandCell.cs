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

    /// <summary>The triangle under a point of the block, −1 when the point is over another cell.</summary>
    internal int FindTriangle(in Vector3 point) => block.Terrain.FindTriangle(index, point);

    /// <inheritdoc/>
    /// <remarks>Retail: CLandCell::point_in_cell @0x00532D40.</remarks>
    internal override bool PointInCell(in Vector3 point) => FindTriangle(point) >= 0;

    /// <inheritdoc/>
    /// <remarks>Retail: CLandCell::find_collisions @0x00532D60, CSortCell::find_collisions @0x005340A0.</remarks>
    internal override TransitionState FindCollisions(Transition transition)
    {
        TransitionState state = FindEnvCollisions(transition);
        return state == TransitionState.OK ? FindThings(transition) : state;
    }

    /// <inheritdoc/>
    internal override TransitionState FindOverlap(Transition transition)
    {
        TransitionState state = FindGround(transition, mayBeWater: true);
        return state == TransitionState.OK ? FindThings(transition) : state;
    }

    /// <remarks>Retail: CLandCell::find_transit_cells @0x00533800.</remarks>
    internal override void FindTransitCells(
        ICellWorld world, in Position position, ReadOnlySpan<Sphere> spheres, CellArray array, SpherePath? path)
    {
        OutdoorCells.AddAll(world, position, spheres, array);
        Building?.FindTransitCells(world, spheres, array, path);
    }

    /// <remarks>Retail: CLandCell::find_transit_cells @0x00533840.</remarks>
    internal override void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        OutdoorCells.AddAll(world, parts, array);
        Building?.FindTransitCells(world, parts, array);
    }

    /// <summary>Pushes a refused mover back out over the side of the cell that it came from; y is looked at first.</summary>
    /// <remarks>Retail: CLandCell::handle_move_restriction @0x00533070.</remarks>
    internal override void HandleMoveRestriction(Transition transition)
    {
        const float half = CellIds.CellSize / 2;
        Vector3 offset = Position.OffsetTo(transition.Path.CurrPos);
        Vector3 normal;
        if (offset.Y < -half) normal = -Vector3.UnitY;
        else if (offset.Y > half) normal = Vector3.UnitY;
        else normal = offset.X < -half ? -Vector3.UnitX : Vector3.UnitX;
        transition.Collision.SetCollisionNormal(normal);
    }

    private TransitionState FindThings(Transition transition)
    {
        TransitionState state = Building is null ? TransitionState.OK : Building.FindBuildingCollisions(transition);
        return state == TransitionState.OK ? FindObjCollisions(transition) : state;
    }

    /// <summary>The terrain's answer: the triangle is chosen by the foot's lowest point. A sphere over another cell is tested there only.</summary>
    /// <remarks>Retail: CLandCell::find_env_collisions @0x00532F20.</remarks>
    private TransitionState FindEnvCollisions(Transition transition)
    {
        TransitionState allowed = CheckEntryRestrictions(transition);
        return allowed == TransitionState.OK ? FindGround(transition, mayBeWater: false) : allowed;
    }

    private TransitionState FindGround(Transition transition, bool mayBeWater)
    {
        SpherePath path = transition.Path;
        TerrainSurface terrain = block.Terrain;
        Vector3 offset = CellIds.BlockOffset(path.CheckPos.CellId, Id);
        Vector3 low = path.GlobalLowPoint - offset;
        int triangle = terrain.FindTriangle(index, low);
        if (triangle < 0) return TransitionState.OK;
        transition.Trace?.AsksTriangle(triangle);
        if (!mayBeWater && terrain.BlockWaterType == WaterType.Entirely && IsStoppedByOpenWater(transition.Object))
        {
            transition.Trace?.Responded(transition, TransitionResponse.Stop, Vector3.Zero, false, TraceReason.OpenWater);
            return TransitionState.Collided;
        }

        Sphere foot = path.GlobalSpheres[0];
        foot.Center -= offset;
        return transition.ValidateWalkable(
            foot, terrain.PlaneOf(triangle), Water != WaterType.None, terrain.WaterDepth(index, low), Id);
    }

    /// <summary>A block that is water all over stops everything but the camera and missiles.</summary>
    private static bool IsStoppedByOpenWater(ObjectInfo mover) =>
        !mover.Has(MoverFlags.IsViewer) && mover.Mover is not null && !mover.State.Has(PhysicsState.Missile);
}
