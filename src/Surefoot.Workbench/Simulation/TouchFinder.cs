using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// Names what a body touches and stands on. The physics answers with planes and normals and forgets whose they were, as retail does, so this looks again at
/// what the cells of the body list: whose surface lies at the spheres, and whose carries the contact plane.
/// </summary>
/// <param name="nameOf">Names a body.</param>
internal sealed class TouchFinder(Func<WorldObject, (TouchKind Kind, string Name)> nameOf)
{
    // Metres between a sphere and a surface that count as touching; a body rests a fraction of a millimetre off a wall.
    private const float TouchGap = 0.02f;

    // A step that is refused ends where it began: up to a substep before the obstacle.
    private const float HeldBackGap = 0.5f;
    private const float SamePlane = 0.03f;
    private const float SameDirection = 0.999f, RoughlySameDirection = 0.7f;

    // On an edge the sphere hangs over it: the plane is touched beside the polygon, by up to a radius, which leaves (sqrt(2) - 1) radii to the edge itself.
    private const float FootingGap = 0.43f;

    private readonly HashSet<object> seen = [];
    private readonly List<Candidate> touched = [];
    private Sphere[] spheres = [];
    private uint cellId;
    private Plane? footing;
    private Vector3? obstacle;
    private Candidate? carrier;
    private Candidate? holder;

    /// <summary>Lists what a body stands on, first, and what it touches.</summary>
    /// <param name="body">A body in a cell.</param>
    /// <param name="into">Is filled anew.</param>
    public void Find(PhysicsBody body, List<Touch> into)
    {
        into.Clear();
        seen.Clear();
        touched.Clear();
        carrier = holder = null;
        if (!body.HasCell || body.Setup is not { } setup) return;
        cellId = body.Position.CellId;
        spheres = new Sphere[setup.Spheres.Length];
        for (int i = 0; i < spheres.Length; i++)
            spheres[i] = new Sphere(body.Position.Frame.LocalToGlobal(setup.Spheres[i].Center * body.Scale), setup.Spheres[i].Radius * body.Scale);
        footing = body.HasContact ? InOwnBlock(body.ContactPlane, body.ContactPlaneCellId) : null;
        obstacle = body.LastCollisionNormal ?? ((body.Transient & TransientState.Sliding) != 0 ? body.SlidingNormal : null);

        for (int i = 0; i < body.ShadowCount; i++)
        {
            if (body.ShadowAt(i).Cell is not { } cell || !seen.Add(cell)) continue;
            LookAtCell(cell);
            for (int k = 0; k < cell.ShadowCount; k++)
            {
                WorldObject other = cell.ShadowAt(k);
                if (!ReferenceEquals(other, body) && seen.Add(other)) LookAtObject(other, new Thing(KindOf(other, out string name), IdOf(other), name));
            }
        }

        if (carrier is { } under) into.Add(under.Thing.ToTouch(isFooting: true, footing!.Value.Normal));
        if (touched.Count == 0 && holder is { } before) touched.Add(before);
        foreach (Candidate one in touched) into.Add(one.Thing.ToTouch(isFooting: false, one.Normal));
    }

    private void LookAtCell(ObjCell cell)
    {
        Vector3 offset = CellIds.BlockOffset(cellId, cell.Id);
        if (cell is EnvCell room)
        {
            Frame frame = room.Position.Frame;
            frame.Origin += offset;
            LookAtPolygons(room.Shape.Physics.Polygons, frame, 1f, new Thing(TouchKind.Room, room.Id, ""));
        }
        else if (cell is LandCell land)
        {
            LookAtGround(land, offset);
            if (land.Building is { } building) LookAtObject(building.Shell, new Thing(TouchKind.Building, IdOf(building.Shell), ""));
        }
    }

    private void LookAtGround(LandCell land, Vector3 offset)
    {
        if (spheres.Length == 0) return;
        Sphere foot = spheres[0];
        int triangle = land.Landblock.Terrain.FindTriangle(CellIds.LandIndex(land.Id), foot.Center - offset);
        if (triangle < 0) return;
        Plane plane = InOwnBlock(land.Landblock.Terrain.PlaneOf(triangle), land.Id);
        float gap = (float)RetailMath.Distance(plane, foot.Center) - foot.Radius;
        Consider(new Candidate(new Thing(TouchKind.Ground, land.Id, ""), gap, plane.Normal), Carries(plane.Normal, foot.Center - (plane.Normal * (gap + foot.Radius)), gap / foot.Radius));
    }

    private void LookAtObject(WorldObject item, Thing thing)
    {
        if (item.Setup is not { } setup || (item.State & PhysicsState.Ethereal) != 0) return;
        Position place = item.Position;
        Vector3 offset = CellIds.BlockOffset(cellId, place.CellId);
        if ((item.State & PhysicsState.HasPhysicsBsp) != 0)
        {
            foreach (SolidPart part in SolidParts.Of(item))
            {
                Frame frame = part.Frame;
                frame.Origin += offset;
                LookAtPolygons(part.Polygons, frame, part.Scale, thing);
            }

            return;
        }

        Candidate best = new(thing, float.PositiveInfinity, default);
        foreach (Sphere own in spheres)
        {
            foreach (CylSphere cylinder in setup.Cylinders)
            {
                Vector3 low = place.Frame.LocalToGlobal(cylinder.LowPoint * item.Scale) + offset;
                float z = Math.Clamp(own.Center.Z, low.Z, low.Z + (cylinder.Height * item.Scale));
                Vector3 flat = new(own.Center.X - low.X, own.Center.Y - low.Y, 0);
                float radius = cylinder.Radius * item.Scale;
                Vector3 near = flat.Length() <= radius ? flat : flat * (radius / flat.Length());
                Nearer(own, new Vector3(low.X + near.X, low.Y + near.Y, z));
            }

            if (setup.Cylinders.Length > 0) continue;
            foreach (Sphere sphere in setup.Spheres)
            {
                Vector3 center = place.Frame.LocalToGlobal(sphere.Center * item.Scale) + offset, way = own.Center - center;
                Nearer(own, way.Length() > 0 ? center + (way * (sphere.Radius * item.Scale / way.Length())) : center);
            }
        }

        if (float.IsFinite(best.Gap)) Consider(best, Carries(best.Normal, null, best.Gap / spheres[0].Radius));

        void Nearer(in Sphere own, Vector3 point)
        {
            Vector3 way = own.Center - point;
            float distance = way.Length();
            if (distance - own.Radius < best.Gap) best = new Candidate(thing, distance - own.Radius, distance > 0 ? way / distance : Vector3.UnitZ);
        }
    }

    private void LookAtPolygons(PolygonSet polygons, in Frame frame, float scale, Thing thing)
    {
        if (!(scale > 0)) return;
        Candidate best = new(thing, float.PositiveInfinity, default), against = best;
        bool carries = false;
        for (int i = 0; i < polygons.Count; i++)
        {
            ConvexPolygon polygon = polygons[i];
            Vector3 normal = frame.LocalToGlobalVector(polygon.Plane.Normal);
            for (int k = 0; k < spheres.Length; k++)
            {
                Vector3 local = frame.GlobalToLocal(spheres[k].Center) / scale;
                float above = (float)RetailMath.Distance(polygon.Plane, local) * scale;
                if (!(above >= 0) || above > spheres[k].Radius + HeldBackGap) continue;
                Vector3 point = SurfacePoints.Nearest(polygon, local);
                float gap = (Vector3.Distance(local, point) * scale) - spheres[k].Radius;
                if (Carries(normal, frame.LocalToGlobal(point * scale), gap / spheres[k].Radius))
                {
                    carries |= k == 0;
                    continue;
                }

                if (gap < best.Gap) best = new Candidate(thing, gap, normal);
                if (gap < against.Gap && IsHeldBackAlong(normal)) against = new Candidate(thing, gap, normal);
            }
        }

        if (carries) Consider(best with { Gap = float.PositiveInfinity }, carries: true);
        Consider(best.Gap < TouchGap ? best : against, carries: false);
    }

    private bool IsHeldBackAlong(in Vector3 normal) => obstacle is { } held && Vector3.Dot(normal, held) > RoughlySameDirection;

    /// <summary>Is a surface here the one that the body stands on?</summary>
    /// <param name="normal">Of the surface.</param>
    /// <param name="point">Its point nearest to the sphere; null when the sphere rests on something round.</param>
    /// <param name="radii">From the sphere to it, in radii.</param>
    private bool Carries(in Vector3 normal, Vector3? point, float radii) =>
        footing is { } plane && radii < FootingGap && Vector3.Dot(normal, plane.Normal) > SameDirection &&
        (point is not { } on || Math.Abs(RetailMath.Distance(plane, on)) < SamePlane);

    private void Consider(in Candidate one, bool carries)
    {
        if (carries)
        {
            // What moves about lies on what stands, and that on the ground: the later kind is on top. Two cells may share a border and a plane.
            if (carrier is not { } present || one.Thing.Kind > present.Thing.Kind || (one.Thing.Kind == present.Thing.Kind && one.Thing.Id == cellId)) carrier = one;
        }
        else if (one.Gap < TouchGap)
        {
            touched.Add(one);
        }
        else if (one.Gap < HeldBackGap && IsHeldBackAlong(one.Normal) && (holder is not { } held || one.Gap < held.Gap))
        {
            holder = one;
        }
    }

    private Plane InOwnBlock(in Plane plane, uint planeCell)
    {
        Vector3 offset = CellIds.BlockOffset(cellId, planeCell);
        return new Plane(plane.Normal, (float)(plane.D - RetailMath.Dot(plane.Normal, offset)));
    }

    private TouchKind KindOf(WorldObject item, out string name)
    {
        name = "";
        if (item is StaticObject thing) return thing.IsScenery ? TouchKind.Scenery : TouchKind.Object;
        (TouchKind kind, name) = nameOf(item);
        return kind;
    }

    private static uint IdOf(WorldObject item) => item is StaticObject ? item.Setup?.Id ?? 0 : item.Id;

    private readonly record struct Thing(TouchKind Kind, uint Id, string Name)
    {
        public Touch ToTouch(bool isFooting, Vector3 normal) => new(isFooting, Kind, Id, normal, Name);
    }

    private readonly record struct Candidate(Thing Thing, float Gap, Vector3 Normal);
}
