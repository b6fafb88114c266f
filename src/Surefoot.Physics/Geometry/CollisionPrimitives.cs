using System.Numerics;
using System.Runtime.CompilerServices;

namespace Surefoot.Physics.Geometry;

/// <summary>Pure tests between spheres, cylinders and rays, in retail's arithmetic (specification 04, 4.5, 4.8, 4.9).</summary>
internal static class CollisionPrimitives
{
    /// <summary>
    /// The early-out of bounding spheres. The tolerance is compared with a squared length, so spheres that touch, and some that just do
    /// not, intersect.
    /// </summary>
    /// <remarks>Retail: CSphere::intersects @0x005344A0.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool SpheresIntersect(in Sphere a, in Sphere b)
    {
        double x = (double)a.Center.X - b.Center.X, y = (double)a.Center.Y - b.Center.Y, z = (double)a.Center.Z - b.Center.Z;
        double sum = (double)b.Radius + a.Radius;
        return (x * x) + (y * y) + (z * z) - (sum * sum) < RetailMath.Epsilon;
    }

    /// <summary>
    /// Do two spheres, <paramref name="offset"/> apart and with <paramref name="radiusSum"/> together, overlap? Touching counts.
    /// </summary>
    /// <remarks>Retail: CSphere::collides_with_sphere @0x005369E0.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool SphereCollidesWithSphere(in Vector3 offset, float radiusSum) =>
        (double)radiusSum * radiusSum >= RetailMath.LengthSquared(offset);

    /// <summary>
    /// Does a sphere overlap an upright cylinder? The rim is square: inside the radius and within the height is enough.
    /// </summary>
    /// <param name="radius">The sphere's own radius, which decides the height.</param>
    /// <param name="offset">From the cylinder's low point to the sphere's centre.</param>
    /// <param name="radiusSum">Radii together, less the tolerance.</param>
    /// <param name="height">The cylinder's height.</param>
    /// <remarks>Retail: CCylSphere::collides_with_sphere @0x0053A880.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool CylinderCollidesWithSphere(float radius, in Vector3 offset, float radiusSum, float height) =>
        (double)radiusSum * radiusSum >= ((double)offset.X * offset.X) + ((double)offset.Y * offset.Y) &&
        IsLevelWith(radius, offset.Z, height);

    /// <summary>
    /// Is a sphere whose centre is <paramref name="z"/> above a cylinder's low point beside the cylinder, not above or below it?
    /// </summary>
    internal static bool IsLevelWith(float radius, double z, float height)
    {
        double half = height * 0.5;
        return ((double)radius - RetailMath.Epsilon) + half >= Math.Abs(half - z);
    }

    /// <summary>
    /// The share of <paramref name="movement"/> after which a point <paramref name="offset"/> away from a sphere's centre is
    /// <paramref name="radiusSum"/> away; −1 when it begins inside, does not move, or never gets there.
    /// </summary>
    /// <remarks>Retail: CSphere::find_time_of_collision @0x005368F0.</remarks>
    public static double TimeOfCollision(in Vector3 movement, in Vector3 offset, float radiusSum)
    {
        double a = RetailMath.LengthSquared(movement), b = -RetailMath.Dot(offset, movement);
        double c = RetailMath.LengthSquared(offset) - ((double)radiusSum * radiusSum);
        if (c < RetailMath.Epsilon) return -1;
        double discriminant = (b * b) - (c * a);
        if (a < RetailMath.Epsilon || discriminant < 0) return -1;
        double root = Math.Sqrt(discriminant);
        return b - root < 0 ? (root + b) / a : (b - root) / a;
    }
}
