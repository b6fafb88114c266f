using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.World;

/// <summary>A cell of the world that bodies can be in: a square of land or a room.</summary>
/// <remarks>Retail: CObjCell. <c>ObjCell.Shadows.cs</c> has the objects listed in it.</remarks>
public abstract partial class ObjCell
{
    /// <summary>A cell with this id.</summary>
    private protected ObjCell(uint id) => Id = id;

    /// <summary>Cell id.</summary>
    public uint Id { get; }

    /// <summary>Where the cell is, in its landblock's coordinates: the centre of a square of land, the placement of a room.</summary>
    public virtual Position Position => new(Id, Vector3.Zero);

    /// <summary>Water of the cell; rooms have none.</summary>
    public virtual WaterType Water => WaterType.None;

    /// <summary>The outdoors may be seen from here.</summary>
    public virtual bool SeenOutside => false;

    /// <summary>Full ids of the cells that may be seen from here.</summary>
    internal virtual ReadOnlySpan<uint> StabList => [];

    /// <summary>Id of the object that decides who enters; 0 when anybody may.</summary>
    public uint RestrictionObject { get; internal set; }

    /// <summary>Tests the spheres of the transition's check position against everything in this cell.</summary>
    internal abstract TransitionState FindCollisions(Transition transition);

    /// <summary>The same of spheres that are nobody's: whether they may be here is not asked, and open water is no obstacle.</summary>
    internal virtual TransitionState FindOverlap(Transition transition) => FindCollisions(transition);

    /// <summary>True when a point, in this cell's block frame, belongs to the cell.</summary>
    internal abstract bool PointInCell(in Vector3 point);

    /// <summary>Adds the cells that spheres reach from this one.</summary>
    /// <param name="world">Where cells are looked up.</param>
    /// <param name="position">Cell and frame of the spheres' owner; its block is the one the spheres are in.</param>
    /// <param name="spheres">Spheres, block coordinates.</param>
    /// <param name="array">The list that grows.</param>
    internal virtual void FindTransitCells(ICellWorld world, in Position position, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
    }

    /// <summary>Adds the cells that the parts of an object reach from this one.</summary>
    internal virtual void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
    }

    /// <summary>A building's portal leads here: adds this room when a sphere reaches into it.</summary>
    /// <remarks>Retail: CEnvCell::check_building_transit @0x0052C680; other cells are never behind a portal.</remarks>
    internal virtual void CheckBuildingTransit(int portal, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
    }

    /// <summary>A building's portal leads here: adds this room when a part reaches into it.</summary>
    /// <remarks>Retail: CEnvCell::check_building_transit @0x0052C5D0.</remarks>
    internal virtual void CheckBuildingTransit(ICellWorld world, int portal, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
    }
}

/// <summary>Who may enter cells that are guarded. Only players are asked about.</summary>
/// <remarks>Retail: CWeenieObject::CanBypassMoveRestrictions and CanMoveInto.</remarks>
public interface IMoveRestrictions
{
    /// <summary>May this body go anywhere?</summary>
    bool CanBypass(WorldObject mover);

    /// <summary>Does the guarding object let this body in? Null when there is no such object; nobody passes then.</summary>
    bool? CanMoveInto(uint restrictionObject, WorldObject mover);
}
