using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;

namespace Surefoot.Physics.World;

/// <summary>A room: its shape, where it stands, and the portals that lead out of it.</summary>
/// <remarks>Retail: CEnvCell.</remarks>
public sealed class EnvCell : ObjCell
{
    private readonly Position position;
    private readonly PortalPlane[] portals;
    private readonly uint[] stabList;
    private readonly bool seenOutside;

    internal EnvCell(EnvCellContent content)
        : base(content.Id)
    {
        position = new Position(content.Id, content.Frame);
        Shape = content.Shape;
        portals = content.Portals;
        stabList = content.StabList;
        seenOutside = content.SeenOutside;
        RestrictionObject = content.RestrictionObject;
    }

    /// <inheritdoc/>
    public override Position Position => position;

    /// <inheritdoc/>
    public override bool SeenOutside => seenOutside;

    /// <inheritdoc/>
    internal override ReadOnlySpan<uint> StabList => stabList;

    /// <summary>Its ways out.</summary>
    internal ReadOnlySpan<PortalPlane> Portals => portals;

    /// <summary>Its walls, floors and ceilings, in its own frame. Shared.</summary>
    public PolygonSet Polygons => Shape.Physics.Polygons;

    /// <summary>Its shape, in its own frame: the space it contains, its walls and floors. Shared.</summary>
    internal CellStructAsset Shape { get; }

    /// <summary>A sealed room, without any portal, contains nothing.</summary>
    /// <inheritdoc/>
    /// <remarks>Retail: CEnvCell::point_in_cell @0x0052C300.</remarks>
    internal override bool PointInCell(in Vector3 point) =>
        portals.Length > 0 && Shape.Cell.PointInside(position.Frame.GlobalToLocal(point));

    /// <inheritdoc/>
    internal override TransitionState FindCollisions(Transition transition) => RoomObstacle.FindCollisions(this, transition);

    /// <inheritdoc/>
    internal override TransitionState FindOverlap(Transition transition) => RoomObstacle.FindOverlap(this, transition);

    /// <summary>The first room that contains a point: this one, or one of those seen from here (or behind its portals).</summary>
    /// <param name="world">Where cells are looked up.</param>
    /// <param name="point">The point, block coordinates.</param>
    /// <param name="searchVisible">True searches the cells that are seen from here, false those behind the portals.</param>
    /// <remarks>Retail: CEnvCell::find_visible_child_cell @0x0052DC50.</remarks>
    internal EnvCell? FindVisibleChildCell(ICellWorld world, in Vector3 point, bool searchVisible)
    {
        if (PointInCell(point)) return this;
        int count = searchVisible ? stabList.Length : portals.Length;
        for (int i = 0; i < count; i++)
        {
            // A list that names a square of land, which no file should, finds nothing: retail looks among the rooms only.
            if (world.GetVisible(searchVisible ? stabList[i] : portals[i].OtherCellId) is EnvCell room && room.PointInCell(point))
                return room;
        }

        return null;
    }

    /// <inheritdoc/>
    /// <remarks>
    /// Retail: CEnvCell::find_transit_cells @0x0052C820. The spheres are taken as they come, without any offset between blocks: an interior
    /// is only found while the mover's position is expressed in the interior's block.
    /// </remarks>
    internal override void FindTransitCells(ICellWorld world, in Position owner, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
        bool outside = false;
        foreach (ref readonly PortalPlane portal in portals.AsSpan())
        {
            if (portal.IsExit)
            {
                outside |= AnyTouches(portal, spheres);
            }
            else if (world.GetVisible(portal.OtherCellId) is EnvCell other)
            {
                if (other.IsReachedByAny(spheres)) array.Add(other.Id, other);
            }
            else if (AnyReaches(portal, spheres))
            {
                array.Add(portal.OtherCellId, null);
            }
        }

        if (outside) OutdoorCells.AddAll(world, owner, spheres, array);
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CEnvCell::find_transit_cells @0x0052CAE0.</remarks>
    internal override void FindTransitCells(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        bool outside = false;
        foreach (ref readonly PortalPlane portal in portals.AsSpan())
        {
            foreach (ref readonly PartExtent part in parts)
            {
                if (!part.HasSphere || !MayCross(portal, part)) continue;
                if (PlaneQueries.IntersectBox(portal.Plane, part.BoxIn(position)) == portal.Side) continue;
                if (portal.IsExit)
                {
                    outside = true;
                    break;
                }

                if (world.GetVisible(portal.OtherCellId) is not EnvCell other)
                {
                    array.Add(portal.OtherCellId, null);
                    break;
                }

                if (other.Shape.Cell.BoxIntersects(part.BoxIn(other.position)))
                {
                    array.Add(other.Id, other);
                    break;
                }
            }
        }

        if (outside) OutdoorCells.AddAll(world, parts, array);
    }

    /// <inheritdoc/>
    internal override void CheckBuildingTransit(int portal, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
        if (portal < 0 || !IsReachedByAny(spheres)) return;
        array.HitsInteriorCell = true;
        array.Add(Id, this);
    }

    /// <inheritdoc/>
    internal override void CheckBuildingTransit(ICellWorld world, int portal, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        // Retail reads past the list when the building names a portal that the room lacks.
        if ((uint)portal >= (uint)portals.Length) return;
        ref readonly PortalPlane way = ref portals[portal];
        PlaneSide side = way.Side;
        foreach (ref readonly PartExtent part in parts)
        {
            if (!part.HasSphere || !MayEnter(way, part)) continue;
            BoundingBox box = part.BoxIn(position);
            PlaneSide where = PlaneQueries.IntersectBox(way.Plane, box);
            if ((where != PlaneSide.Crossing && where != side) || !Shape.Cell.BoxIntersects(box)) continue;
            array.Add(Id, this);
            FindTransitCells(world, parts, array);
            return;
        }
    }

    private bool IsReachedByAny(ReadOnlySpan<Sphere> spheres)
    {
        foreach (ref readonly Sphere sphere in spheres)
        {
            Sphere local = new(position.Frame.GlobalToLocal(sphere.Center), sphere.Radius);
            if (Shape.Cell.SphereIntersects(local) != CellOverlap.Outside) return true;
        }

        return false;
    }

    private bool AnyTouches(in PortalPlane portal, ReadOnlySpan<Sphere> spheres)
    {
        Frame frame = position.Frame;
        foreach (ref readonly Sphere sphere in spheres)
        {
            // Differences and z unrounded: retail's.
            double x = (double)sphere.Center.X - frame.Origin.X, y = (double)sphere.Center.Y - frame.Origin.Y,
                z = (double)sphere.Center.Z - frame.Origin.Z;
            float localX = (float)((frame.XAxis.X * x) + (frame.XAxis.Y * y) + (frame.XAxis.Z * z));
            float localY = (float)((frame.YAxis.X * x) + (frame.YAxis.Y * y) + (frame.YAxis.Z * z));
            double localZ = (frame.ZAxis.X * x) + (frame.ZAxis.Y * y) + (frame.ZAxis.Z * z);
            if (portal.Touches(localX, localY, localZ, sphere.Radius)) return true;
        }

        return false;
    }

    private bool AnyReaches(in PortalPlane portal, ReadOnlySpan<Sphere> spheres)
    {
        foreach (ref readonly Sphere sphere in spheres)
        {
            if (portal.IsReachedBy(position.Frame.GlobalToLocal(sphere.Center), sphere.Radius)) return true;
        }

        return false;
    }

    /// <summary>Not wholly on the inner side of a portal, as far as the part's sphere can tell.</summary>
    private bool MayCross(in PortalPlane portal, in PartExtent part)
    {
        double distance = SphereDistance(portal, part, out float reach);
        return portal.NormalPointsOut ? !(distance < -reach) : !(distance > reach);
    }

    /// <summary>Not wholly on the outer side of a portal, as far as the part's sphere can tell.</summary>
    private bool MayEnter(in PortalPlane portal, in PartExtent part)
    {
        double distance = SphereDistance(portal, part, out float reach);
        return portal.NormalPointsOut ? !(distance > reach) : !(distance < -reach);
    }

    private double SphereDistance(in PortalPlane portal, in PartExtent part, out float reach)
    {
        reach = (float)((double)part.Sphere.Radius + RetailMath.Epsilon);
        return RetailMath.Distance(portal.Plane, position.LocalToLocal(part.Position, part.Sphere.Center));
    }
}

/// <summary>What a room is made from.</summary>
internal sealed record EnvCellContent
{
    public required uint Id { get; init; }

    public required Frame Frame { get; init; }

    public required CellStructAsset Shape { get; init; }

    public PortalPlane[] Portals { get; init; } = [];

    public uint[] StabList { get; init; } = [];

    public bool SeenOutside { get; init; }

    public uint RestrictionObject { get; init; }
}
