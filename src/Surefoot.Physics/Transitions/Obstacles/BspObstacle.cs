using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Transitions.Obstacles;

/// <summary>
/// The collision tree of a mesh or room as an obstacle: its answer to a transition. The path's local-space spheres must have been cached
/// for the mesh or room; answers go back in world axes.
/// </summary>
/// <remarks>Retail: BSPTREE; specification 04, 4.6.</remarks>
internal static class BspObstacle
{
    /// <summary>Tests the check position and answers in the way the path's mode asks for. The order of the modes is load-bearing.</summary>
    /// <param name="tree">The tree.</param>
    /// <param name="transition">The transition; it is moved and told what was met.</param>
    /// <param name="scale">The mesh's scale, by which the local-space spheres were divided; 1 for rooms.</param>
    /// <remarks>Retail: BSPTREE::find_collisions @0x0053A440.</remarks>
    internal static TransitionState FindCollisions(this PhysicsBsp tree, Transition transition, float scale)
    {
        SpherePath path = transition.Path;
        Sphere[] spheres = path.LocalSpaceSpheres;
        bool two = path.SphereCount > 1;

        if (path.InsertType == InsertType.Placement || path.ObstructionEthereal)
        {
            bool centerCheck = !path.BuildingCheck || !transition.Cells.HitsInteriorCell;
            bool solid = tree.SphereIntersectsSolid(spheres[0], centerCheck) ||
                (two && tree.SphereIntersectsSolid(spheres[1], centerCheck));
            if (!solid) return TransitionState.OK;
            transition.Trace?.HitTree(transition, TraceReason.Overlaps);
            return TransitionState.Collided;
        }

        if (path.CheckingWalkable)
        {
            if (!tree.HitsWalkable(spheres[0], path.LocalSpaceZ, path.WalkableAllowance)) return TransitionState.OK;
            transition.Trace?.HitTree(transition, TraceReason.Supports);
            return TransitionState.Collided;
        }

        if (path.SteppingDown) return tree.StepSphereDown(transition, scale);

        Vector3 movement = spheres[0].Center - path.LocalSpaceCurrCenters[0];
        if (path.Collide) return tree.RestOnWalkable(transition, movement, scale);
        if (transition.Object.Has(MoverFlags.Contact)) return tree.Walking(transition, movement, two);
        return transition.Object.Has(MoverFlags.PathClipped)
            ? tree.Clipped(transition, movement, scale)
            : tree.Airborne(transition, movement, two);
    }

    /// <summary>
    /// On the ground: the foot steps up or slides, the head slides; what is overlapped but not run into is answered later.
    /// </summary>
    private static TransitionState Walking(this PhysicsBsp tree, Transition transition, in Vector3 movement, bool two)
    {
        SpherePath path = transition.Path;
        PolygonContact foot = default;
        if (tree.SphereIntersectsPoly(path.LocalSpaceSpheres[0], movement, ref foot))
        {
            transition.Trace?.HitPolygon(transition, tree, foot.Polygon, 0, TraceReason.RunInto);
            return tree.StepSphereUp(transition, foot);
        }

        if (!two) return TransitionState.OK;

        // The head is asked with the foot's movement.
        PolygonContact head = default;
        if (tree.SphereIntersectsPoly(path.LocalSpaceSpheres[1], movement, ref head))
        {
            transition.Trace?.HitPolygon(transition, tree, head.Polygon, 1, TraceReason.RunInto);
            return tree.SlideSphere(transition, head);
        }

        if (!head.IsSome && !foot.IsSome) return TransitionState.OK;
        PolygonContact overlapped = head.IsSome ? head : foot;
        path.SetNegPolyHit(!head.IsSome, tree.GlobalNormal(path, overlapped));
        transition.Trace?.HitPolygon(transition, tree, overlapped.Polygon, head.IsSome ? 1 : 0, TraceReason.Deferred);
        return TransitionState.OK;
    }

    /// <summary>A missile or the camera: sphere 0 only, whichever way the polygon faces.</summary>
    private static TransitionState Clipped(this PhysicsBsp tree, Transition transition, in Vector3 movement, float scale)
    {
        PolygonContact hit = default;
        bool met = tree.SphereIntersectsPoly(transition.Path.LocalSpaceSpheres[0], movement, ref hit) || hit.IsSome;
        if (!met) return TransitionState.OK;
        transition.Trace?.HitPolygon(transition, tree, hit.Polygon, 0, TraceReason.RunInto);
        return tree.CollideWithPoint(transition, hit, scale);
    }

    /// <summary>In the air: the foot asks for a landing, the head stops; whichever way the polygon faces.</summary>
    private static TransitionState Airborne(this PhysicsBsp tree, Transition transition, in Vector3 movement, bool two)
    {
        SpherePath path = transition.Path;
        PolygonContact hit = default;
        if (tree.SphereIntersectsPoly(path.LocalSpaceSpheres[0], movement, ref hit) || hit.IsSome)
        {
            transition.Trace?.HitPolygon(transition, tree, hit.Polygon, 0, TraceReason.LandingAsked);
            path.SetCollide(tree.GlobalNormal(path, hit));
            path.WalkableAllowance = RetailMath.LandingZ;
            return TransitionState.Adjusted;
        }

        if (two && (tree.SphereIntersectsPoly(path.LocalSpaceSpheres[1], movement, ref hit) || hit.IsSome))
        {
            Vector3 normal = tree.GlobalNormal(path, hit);
            transition.Trace?.HitPolygon(transition, tree, hit.Polygon, 1, TraceReason.RunInto);
            transition.Trace?.Responded(transition, TransitionResponse.Stop, normal, true);
            transition.Collision.SetCollisionNormal(normal);
            return TransitionState.Collided;
        }

        return TransitionState.OK;
    }

    /// <summary>Lifts the foot onto what the downward probe reaches.</summary>
    /// <remarks>Retail: BSPTREE::step_sphere_down @0x0053A210.</remarks>
    internal static TransitionState StepSphereDown(this PhysicsBsp tree, Transition transition, float scale)
    {
        SpherePath path = transition.Path;
        Vector3 up = path.LocalSpaceZ;
        double down = -((double)path.StepDownAmount * path.WalkInterp), inverse = 1.0 / scale;
        float inverseStored = (float)inverse;
        Vector3 movement = new(
            (float)(inverse * (float)(down * up.X)),
            (float)((double)(float)(down * up.Y) * inverseStored),
            (float)(down * up.Z * inverseStored));
        return tree.RestOnWalkable(transition, movement, scale);
    }

    /// <summary>
    /// Rests the foot on walkable polygons that <paramref name="movement"/> runs into; the last one becomes contact plane and walkable.
    /// </summary>
    private static TransitionState RestOnWalkable(this PhysicsBsp tree, Transition transition, in Vector3 movement, float scale)
    {
        SpherePath path = transition.Path;
        WalkableSearch search = new()
        {
            Sphere = path.LocalSpaceSpheres[0],
            Movement = movement,
            Up = path.LocalSpaceZ,
            Allowance = path.WalkableAllowance,
            WalkInterp = path.WalkInterp,
        };
        tree.FindWalkable(ref search);
        if (!search.Found) return TransitionState.OK;

        transition.Trace?.HitPolygon(transition, tree, search.Polygon, 0, TraceReason.None);
        path.WalkInterp = search.WalkInterp;
        path.AddOffsetToCheckPos(GlobalOffset(path, search.Sphere.Center - path.LocalSpaceSpheres[0].Center, scale));
        Plane plane = path.CheckPos.LocalToGlobal(path.LocalSpacePos, tree.Polygons.PlaneOf(search.Polygon));
        // The constant was carried over as if unscaled and is scaled now: right only for a part at the origin, and retail's.
        plane.D = (float)((double)plane.D * scale);
        transition.Collision.SetContactPlane(plane, false, path.CheckPos.CellId);
        transition.Trace?.ContactTaken(transition);
        path.SetWalkable(search.Sphere, new PolygonRef(tree.Polygons, search.Polygon), path.LocalSpaceZ, path.LocalSpacePos, scale);
        return TransitionState.Adjusted;
    }

    /// <summary>Onto the obstacle, or along it.</summary>
    /// <remarks>Retail: BSPTREE::step_sphere_up @0x00539F20.</remarks>
    internal static TransitionState StepSphereUp(this PhysicsBsp tree, Transition transition, in PolygonContact hit) =>
        transition.StepUp(tree.GlobalNormal(transition.Path, hit)) ? TransitionState.OK : transition.StepUpSlide();

    /// <summary>Along the obstacle: sphere 0 slides, also when it was sphere 1 that met it.</summary>
    /// <remarks>Retail: BSPTREE::slide_sphere @0x00539E50.</remarks>
    internal static TransitionState SlideSphere(this PhysicsBsp tree, Transition transition, in PolygonContact hit)
    {
        Vector3 normal = tree.GlobalNormal(transition.Path, hit);
        return transition.SlideSphere(0, ref normal, transition.Path.GlobalCurrCenters[0]);
    }

    /// <summary>Stops a clipped mover; one that clips perfectly is put where it touches.</summary>
    /// <remarks>Retail: BSPTREE::collide_with_pt @0x0053A090.</remarks>
    internal static TransitionState CollideWithPoint(this PhysicsBsp tree, Transition transition, in PolygonContact hit, float scale)
    {
        SpherePath path = transition.Path;
        Vector3 normal = tree.GlobalNormal(path, hit);
        transition.Trace?.Responded(transition, TransitionResponse.Stop, normal, true);
        if (!transition.Object.Has(MoverFlags.PerfectClip))
        {
            transition.Collision.SetCollisionNormal(normal);
            return TransitionState.Collided;
        }

        Sphere touching = path.LocalSpaceSpheres[0];
        if (!tree.AdjustToPlane(ref touching, path.LocalSpaceCurrCenters[0], hit)) return TransitionState.Collided;
        transition.Collision.SetCollisionNormal(normal);
        path.AddOffsetToCheckPos(GlobalOffset(path, touching.Center - path.LocalSpaceSpheres[0].Center, scale));
        return TransitionState.Adjusted;
    }

    /// <summary>
    /// Finds the last place free of hits on the way from <paramref name="curr"/> to the sphere: first the times at which planes are
    /// touched, then by halving. Both share 15 tries.
    /// </summary>
    /// <remarks>Retail: BSPTREE::adjust_to_plane @0x00539BF0.</remarks>
    internal static bool AdjustToPlane(this PhysicsBsp tree, ref Sphere sphere, in Vector3 curr, PolygonContact hit)
    {
        const int Tries = 15;
        const double Close = 0.02;
        Vector3 movement = sphere.Center - curr;
        double low = 0, high = 1;
        int i = 0;
        while (true)
        {
            double t = tree.Polygons[hit.Polygon].TimeOfTouch(sphere.Radius, curr, movement);
            if (t == 1.0) break;
            sphere.Center = Along(curr, movement, t);
            if (!tree.SphereIntersectsPoly(sphere, movement, ref hit))
            {
                low = t;
                break;
            }

            i++;
            high = t;
            if (i >= Tries) return false;
        }

        while (true)
        {
            double middle = (low + high) * 0.5;
            sphere.Center = Along(curr, movement, middle);
            if (tree.SphereIntersectsPoly(sphere, movement, ref hit)) high = middle;
            else low = middle;
            if (high - low < Close || ++i >= Tries) break;
        }

        sphere.Center = Along(curr, movement, low);
        return true;
    }

    /// <summary>Pushes a body that is placed out of the polygons it overlaps.</summary>
    /// <returns>OK when it was free, Adjusted when it was pushed, Collided, unmoved, when 20 tries did not free it.</returns>
    /// <remarks>Retail: BSPTREE::placement_insert @0x00539960.</remarks>
    internal static TransitionState PlacementInsert(this PhysicsBsp tree, Transition transition)
    {
        const int Tries = 20;
        SpherePath path = transition.Path;
        Sphere foot = path.LocalSpaceSpheres[0], head = path.LocalSpaceSpheres[1];
        bool two = path.SphereCount > 1, solidCheck = !path.BuildingCheck || !transition.Cells.HitsInteriorCell;
        float radius = foot.Radius;
        PolygonContact hit = default;
        for (int i = 0; i < Tries; i++)
        {
            // The head's question starts with what the foot's left behind.
            bool centerSolid = false, isFoot = tree.SphereIntersectsSolidPoly(foot, radius, ref centerSolid, ref hit, solidCheck);
            if (!isFoot && !(two && tree.SphereIntersectsSolidPoly(head, radius, ref centerSolid, ref hit, solidCheck)))
            {
                if (i == 0) return TransitionState.OK;
                // Not multiplied by the scale, as in retail.
                path.AddOffsetToCheckPos(path.LocalSpacePos.Frame.LocalToGlobalVector(foot.Center - path.LocalSpaceSpheres[0].Center));
                return TransitionState.Adjusted;
            }

            if (hit.IsSome)
            {
                transition.Trace?.HitPolygon(transition, tree, hit.Polygon, isFoot ? 0 : 1, TraceReason.Overlaps);
                ConvexPolygon polygon = tree.Polygons[hit.Polygon];
                if (isFoot) polygon.PushOut(ref foot, ref head, radius, centerSolid, solidCheck);
                else polygon.PushOut(ref head, ref foot, radius, centerSolid, solidCheck);
                hit = default;
                radius = foot.Radius;
            }
            else
            {
                radius += radius;
            }
        }

        return TransitionState.Collided;
    }

    private static Vector3 Along(in Vector3 curr, in Vector3 movement, double t) => new(
        (float)(movement.X * t) + curr.X, (float)(movement.Y * t) + curr.Y, (float)((movement.Z * t) + curr.Z));

    private static Vector3 GlobalNormal(this PhysicsBsp tree, SpherePath path, in PolygonContact hit) =>
        path.LocalSpacePos.Frame.LocalToGlobalVector(tree.Polygons.PlaneOf(hit.Polygon).Normal);

    /// <summary>A displacement of the tree's frame in world axes and metres; stored after turning and again after scaling.</summary>
    private static Vector3 GlobalOffset(SpherePath path, in Vector3 v, float scale) =>
        RetailMath.Scale(path.LocalSpacePos.Frame.LocalToGlobalVector(v), scale);
}
