using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <content>What is at a place.</content>
public sealed partial class WorldQuery
{
    /// <summary>Nobody in particular: no player, no creature, nothing that anybody lets through.</summary>
    private readonly WorldObject nobody = new(0, null, PhysicsState.None);

    /// <summary>
    /// What a sphere reaches into: the ground, a room's walls, a building, an object, another body; by the question that a body is placed
    /// with. The ethereal count for nothing.
    /// </summary>
    /// <param name="input">The sphere.</param>
    /// <exception cref="ArgumentException">
    /// The sphere is not finite, its radius is not positive, or the id names no cell of the map.
    /// </exception>
    public SphereOverlap Overlap(in SphereInput input)
    {
        input.Sphere.ThrowIfBad(nameof(input));
        Position place = new(input.CellId, input.Sphere.Center);
        ThrowIfNowhere(place, nameof(input));
        population.Cells.AdjustPosition(ref place, Vector3.Zero, out ObjCell? cell);
        if (cell is null) return new SphereOverlap(false, false, 0, TraceSubject.None);

        heard.Clear();
        Transition transition = Rent(heard);
        try
        {
            transition.Object.Init(nobody, MoverFlags.None, identity: input.Except);
            transition.Path.InitSpheres([new Sphere(Vector3.Zero, input.Sphere.Radius)], 1f);
            transition.Path.InitPath(cell, hasBegin: false, default, place);
            bool overlaps = transition.Overlaps(out bool loaded);
            return new SphereOverlap(overlaps, loaded, cell.Id, overlaps ? LastHit(heard) : TraceSubject.None);
        }
        finally
        {
            work.Return();
        }
    }

    /// <summary>Which cell a point is in, and whether it is inside something solid there: the ground, walls, an object, a body.</summary>
    /// <param name="input">The point.</param>
    /// <exception cref="ArgumentException">The point is not finite, or the id names no cell of the map.</exception>
    public PointOverlap Overlap(in PointInput input)
    {
        Position place = new(input.CellId, input.Point);
        ThrowIfNowhere(place, nameof(input));
        population.Cells.AdjustPosition(ref place, Vector3.Zero, out ObjCell? cell);
        if (cell is null) return new PointOverlap(false, false, 0, TraceSubject.None);
        TraceSubject subject = SolidAt(cell, place.Frame.Origin, input.Except);
        return new PointOverlap(subject.Kind != TraceSubjectKind.None, true, cell.Id, subject);
    }

    /// <summary>What of a cell is solid at a point of its block; none when nothing is.</summary>
    private static TraceSubject SolidAt(ObjCell cell, in Vector3 point, PhysicsBody? except)
    {
        TraceSubject own = TransitionTrace.SubjectOf(cell);
        if (cell is EnvCell room)
        {
            if (room.Shape.Physics.PointIntersectsSolid(room.Position.Frame.GlobalToLocal(point))) return own;
        }
        else if (cell is LandCell land)
        {
            int triangle = land.FindTriangle(point);
            if (triangle >= 0 && RetailMath.Distance(land.Landblock.Terrain.PlaneOf(triangle), point) < 0)
                return own with { Polygon = triangle };
            if (land.Building?.Shell is { PlacedPartCount: > 0 } shell &&
                ShapeQuery.PartContains(shell, 0, shell.Setup!.Parts[0].DefaultScale.Z, point))
                return TransitionTrace.SubjectOf(shell, cell.Id) with { Kind = TraceSubjectKind.Building, Part = 0 };
        }

        for (int i = 0; i < cell.ShadowCount; i++)
        {
            WorldObject item = cell.ShadowAt(i);
            if (item.Parent is not null || ReferenceEquals(item, except) || item.State.Has(PhysicsState.Ethereal)) continue;
            Vector3 there = point - CellIds.BlockOffset(cell.Id, item.Position.CellId);
            if (ShapeQuery.Contains(item, there, out int part)) return TransitionTrace.SubjectOf(item, cell.Id) with { Part = (short)part };
        }

        return TraceSubject.None;
    }
}
