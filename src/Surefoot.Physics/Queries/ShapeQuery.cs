using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>What a sphere meets of a shape, in the shape's frame.</summary>
/// <param name="Overlaps">It reaches into what is solid.</param>
/// <param name="Part">Index of the part of a setup that it reaches into; −1 for none, for spheres and for cylinders.</param>
/// <param name="Polygon">Index of the polygon that it overlaps, the last one found; −1 for none, as inside a solid.</param>
/// <param name="RunsInto">Its movement leads against that polygon, not along it and not away.</param>
/// <param name="Point">Where it touches that polygon: the point of the polygon's plane that is nearest to its centre, metres.</param>
/// <param name="Plane">That polygon's plane; its constant in metres.</param>
public readonly record struct ShapeOverlap(bool Overlaps, int Part, int Polygon, bool RunsInto, Vector3 Point, Plane Plane)
{
    internal static ShapeOverlap None { get; } = new(false, -1, -1, false, default, default);
}

/// <summary>
/// Asks shapes that are nowhere in particular: points and spheres against a mesh or a setup at scale 1, in its own frame, metres. Pure
/// functions of immutable assets. A setup is its parts' collision trees where it has any, in the pose in which objects are made; else its
/// cylinders, which stand upright; else its spheres.
/// </summary>
public static class ShapeQuery
{
    /// <summary>Is a point inside what is solid of a mesh?</summary>
    /// <exception cref="ArgumentException">The point is not finite.</exception>
    /// <remarks>Retail: BSPTREE::point_intersects_solid.</remarks>
    public static bool Contains(GfxObjAsset mesh, in Vector3 point)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ThrowIfBad(point);
        return mesh.Physics is { } tree && tree.PointIntersectsSolid(point);
    }

    /// <summary>Is a point inside what is solid of a setup?</summary>
    /// <exception cref="ArgumentException">The point is not finite.</exception>
    public static bool Contains(SetupAsset setup, in Vector3 point)
    {
        ArgumentNullException.ThrowIfNull(setup);
        ThrowIfBad(point);
        if (!setup.HasPhysicsBsp) return ContainsRound(setup, new Placed(Frame.Identity, 1f), point);
        for (int i = 0; i < PartCount(setup); i++)
        {
            if (Contains(setup.Parts[i].Mesh, PlacedPart(setup, i).ToLocal(point))) return true;
        }

        return false;
    }

    /// <summary>What a sphere meets of a mesh.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="sphere">The sphere.</param>
    /// <param name="movement">How it came there, metres; zero for a sphere at rest, which runs into nothing.</param>
    /// <exception cref="ArgumentException">The sphere or the movement is not finite, or the radius is not positive.</exception>
    /// <remarks>Retail: BSPTREE::sphere_intersects_solid and sphere_intersects_poly; specification 04, 4.5.</remarks>
    public static ShapeOverlap Overlap(GfxObjAsset mesh, in Sphere sphere, in Vector3 movement = default)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        ThrowIfBad(sphere, movement);
        return Overlap(mesh, new Placed(Frame.Identity, 1f), sphere, movement, -1);
    }

    /// <summary>What a sphere meets of a setup; of several parts that it reaches into, the first.</summary>
    /// <param name="setup">The setup.</param>
    /// <param name="sphere">The sphere.</param>
    /// <param name="movement">How it came there, metres; zero for a sphere at rest, which runs into nothing.</param>
    /// <exception cref="ArgumentException">The sphere or the movement is not finite, or the radius is not positive.</exception>
    public static ShapeOverlap Overlap(SetupAsset setup, in Sphere sphere, in Vector3 movement = default)
    {
        ArgumentNullException.ThrowIfNull(setup);
        ThrowIfBad(sphere, movement);
        if (!setup.HasPhysicsBsp) return ShapeOverlap.None with { Overlaps = OverlapsRound(setup, sphere) };
        for (int i = 0; i < PartCount(setup); i++)
        {
            ShapeOverlap overlap = Overlap(setup.Parts[i].Mesh, PlacedPart(setup, i), sphere, movement, i);
            if (overlap.Overlaps) return overlap;
        }

        return ShapeOverlap.None;
    }

    /// <summary>Is a point inside what is solid of an object?</summary>
    /// <param name="item">The object.</param>
    /// <param name="point">The point, coordinates of the object's block.</param>
    /// <param name="part">The part that contains it; −1 for none.</param>
    internal static bool Contains(WorldObject item, in Vector3 point, out int part)
    {
        part = -1;
        if (item.Setup is not { } setup) return false;
        if (!item.State.Has(PhysicsState.HasPhysicsBsp)) return ContainsRound(setup, new Placed(item.Position.Frame, item.Scale), point);
        for (int i = 0; i < item.PlacedPartCount; i++)
        {
            if (!PartContains(item, i, (float)((double)setup.Parts[i].DefaultScale.Z * item.Scale), point)) continue;
            part = i;
            return true;
        }

        return false;
    }

    internal static bool PartContains(WorldObject item, int part, float scale, in Vector3 point) =>
        item.Setup!.Parts[part].Mesh.Physics is { } tree &&
        tree.PointIntersectsSolid(new Placed(item.PartFrame(part), scale).ToLocal(point));

    private static int PartCount(SetupAsset setup) => Math.Min(setup.Parts.Length, setup.RestPose.Length);

    private static Placed PlacedPart(SetupAsset setup, int part) => new(setup.RestPose[part], setup.Parts[part].DefaultScale.Z);

    private static ShapeOverlap Overlap(GfxObjAsset mesh, in Placed place, in Sphere sphere, in Vector3 movement, int part)
    {
        if (mesh.Physics is not { } tree) return ShapeOverlap.None;
        Sphere local = new(place.ToLocal(sphere.Center), (float)(sphere.Radius / (double)place.Scale));
        if (!CollisionPrimitives.SpheresIntersect(tree.Bounds, local)) return ShapeOverlap.None;
        PolygonContact contact = default;
        Vector3 localMovement = RetailMath.Scale(place.Frame.GlobalToLocalVector(movement), 1.0 / place.Scale);
        bool runsInto = tree.SphereIntersectsPoly(local, localMovement, ref contact);
        bool overlaps = tree.SphereIntersectsSolid(local, centerCheck: true);
        if (!contact.IsSome) return ShapeOverlap.None with { Overlaps = overlaps, Part = overlaps ? part : -1 };
        Plane plane = tree.Polygons.PlaneOf(contact.Polygon);
        Vector3 normal = place.Frame.LocalToGlobalVector(plane.Normal);
        Vector3 touched = place.ToGlobal(RetailMath.AddScaled(local.Center, -RetailMath.Distance(plane, local.Center), plane.Normal));
        return new ShapeOverlap(overlaps, part, contact.Polygon, runsInto, touched, RetailMath.PlaneThrough(normal, touched));
    }

    /// <summary>
    /// Cylinders where there are any, else spheres. A turn of the object moves a cylinder's foot, but does not tilt the cylinder.
    /// </summary>
    private static bool ContainsRound(SetupAsset setup, in Placed place, in Vector3 point)
    {
        foreach (ref readonly CylSphere cylinder in setup.Cylinders)
        {
            Vector3 way = point - place.ToGlobal(cylinder.LowPoint);
            double radius = (double)cylinder.Radius * place.Scale;
            bool isLevel = way.Z >= 0 && way.Z <= (double)cylinder.Height * place.Scale;
            if (isLevel && ((double)way.X * way.X) + ((double)way.Y * way.Y) <= radius * radius) return true;
        }

        if (setup.Cylinders.Length > 0) return false;
        foreach (ref readonly Sphere ball in setup.Spheres)
        {
            double radius = (double)ball.Radius * place.Scale;
            if (RetailMath.LengthSquared(point - place.ToGlobal(ball.Center)) <= radius * radius) return true;
        }

        return false;
    }

    /// <remarks>Retail: the first test of CCylSphere::intersects_sphere @0x0053B440 and CSphere::intersects_sphere @0x00537A80.</remarks>
    private static bool OverlapsRound(SetupAsset setup, in Sphere sphere)
    {
        foreach (ref readonly CylSphere cylinder in setup.Cylinders)
        {
            float sum = (float)((double)cylinder.Radius - RetailMath.Epsilon + sphere.Radius);
            Vector3 offset = sphere.Center - cylinder.LowPoint;
            if (CollisionPrimitives.CylinderCollidesWithSphere(sphere.Radius, offset, sum, cylinder.Height)) return true;
        }

        if (setup.Cylinders.Length > 0) return false;
        foreach (ref readonly Sphere ball in setup.Spheres)
        {
            float sum = (float)((double)ball.Radius - RetailMath.Epsilon + sphere.Radius);
            if (CollisionPrimitives.SphereCollidesWithSphere(sphere.Center - ball.Center, sum)) return true;
        }

        return false;
    }

    private static void ThrowIfBad(in Vector3 point)
    {
        if (!RetailMath.IsFinite(point)) throw new ArgumentException("The point is not finite.", nameof(point));
    }

    private static void ThrowIfBad(in Sphere sphere, in Vector3 movement)
    {
        sphere.ThrowIfBad(nameof(sphere));
        if (!RetailMath.IsFinite(movement)) throw new ArgumentException("The movement is not finite.", nameof(movement));
    }

    /// <summary>A frame and a scale inside it.</summary>
    private readonly record struct Placed(Frame Frame, float Scale)
    {
        public Vector3 ToLocal(in Vector3 point) => RetailMath.Scale(Frame.GlobalToLocal(point), 1.0 / Scale);

        public Vector3 ToGlobal(in Vector3 point) => Frame.LocalToGlobal(RetailMath.Scale(point, Scale));
    }
}
