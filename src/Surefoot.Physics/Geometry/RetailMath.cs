using System.Numerics;
using System.Runtime.CompilerServices;

namespace Surefoot.Physics.Geometry;

/// <summary>
/// The arithmetic of the retail client: operands are float, intermediates are double, and a value is rounded to float
/// where it is stored (specification 03, section 3.1). Every vector formula of the engine goes through here.
/// </summary>
internal static class RetailMath
{
    /// <summary>The tolerance of nearly every comparison, 0.0002 (0x3951B717), in the unit of what is compared.</summary>
    public const float Epsilon = 0.0002f;

    /// <summary>The binary64 square of <see cref="Epsilon"/>.</summary>
    public const double EpsilonSquared = (double)Epsilon * Epsilon;

    /// <summary>Smallest z of a unit normal that can be walked on, 0x3F2A0751: cos of 48.381 degrees.</summary>
    public const float FloorZ = 0.66417414f;

    /// <summary>Smallest z of a unit normal accepted while landing or being placed, 0x3DB27EB0: cos of 85 degrees.</summary>
    public const float LandingZ = 0.0871557f;

    /// <summary>Dot product, unrounded; summed from z to x as in retail, where the sign of a sum near zero decides.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Dot(in Vector3 a, in Vector3 b) =>
        ((double)a.Z * b.Z) + ((double)a.Y * b.Y) + ((double)a.X * b.X);

    /// <summary>Cross product, each component rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Cross(in Vector3 a, in Vector3 b) => new(
        (float)(((double)a.Y * b.Z) - ((double)a.Z * b.Y)),
        (float)(((double)a.Z * b.X) - ((double)a.X * b.Z)),
        (float)(((double)a.X * b.Y) - ((double)a.Y * b.X)));

    /// <summary>Length, unrounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Length(in Vector3 v) => Math.Sqrt(Dot(v, v));

    /// <summary>Squared length, unrounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double LengthSquared(in Vector3 v) => Dot(v, v);

    /// <summary>v times k, each component rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Scale(in Vector3 v, double k) => new((float)(v.X * k), (float)(v.Y * k), (float)(v.Z * k));

    /// <summary>a + k·b, each component rounded once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 AddScaled(in Vector3 a, double k, in Vector3 b) =>
        new((float)(a.X + (k * b.X)), (float)(a.Y + (k * b.Y)), (float)(a.Z + (k * b.Z)));

    /// <summary>Divides by the length without any check: a zero vector gives NaN, as in retail.</summary>
    /// <remarks>Retail: AC1Legacy::Vector3::normalize @0x00452400.</remarks>
    public static Vector3 Normalize(in Vector3 v) => Scale(v, 1.0 / Length(v));

    /// <summary>
    /// Normalises <paramref name="v"/> unless it is shorter than <see cref="Epsilon"/>, or NaN; true when it was left as it is.
    /// </summary>
    /// <remarks>Retail: AC1Legacy::Vector3::normalize_check_small @0x00452460.</remarks>
    public static bool NormalizeCheckSmall(ref Vector3 v)
    {
        double length = Length(v);
        if (!(length >= Epsilon)) return true;
        v = Scale(v, 1.0 / length);
        return false;
    }

    /// <summary>Every component smaller than <see cref="Epsilon"/> in size.</summary>
    /// <remarks>Retail: is_zero @0x0050E7B0.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsZero(in Vector3 v) => Math.Abs(v.X) < Epsilon && Math.Abs(v.Y) < Epsilon && Math.Abs(v.Z) < Epsilon;

    /// <summary>Every component of the difference at most <see cref="Epsilon"/> in size.</summary>
    /// <remarks>Retail: operator== @0x00509F10.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool NearlyEqual(in Vector3 a, in Vector3 b) =>
        Math.Abs((double)a.X - b.X) <= Epsilon && Math.Abs((double)a.Y - b.Y) <= Epsilon && Math.Abs((double)a.Z - b.Z) <= Epsilon;

    /// <summary>True when no component is NaN or infinite.</summary>
    public static bool IsFinite(in Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);

    /// <summary>The vector, or zero when a component is NaN or infinite: such a number would poison every position from then on.</summary>
    internal static Vector3 FiniteOrZero(in Vector3 v) => IsFinite(v) ? v : Vector3.Zero;

    /// <summary>N·p + d, unrounded: the signed distance of a point from a plane with a unit normal, in metres.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Distance(in Plane plane, in Vector3 point) => Dot(plane.Normal, point) + plane.D;

    /// <summary>The plane with this normal through this point.</summary>
    /// <remarks>Retail: Plane::Plane @0x00536A20.</remarks>
    public static Plane PlaneThrough(in Vector3 normal, in Vector3 point) => new(normal, (float)-Dot(normal, point));

    /// <summary>
    /// Keeps x and y of a displacement and replaces z so that it runs along the plane; unchanged when the plane is vertical.
    /// </summary>
    /// <remarks>
    /// Retail: Plane::snap_to_plane @0x00509C50. The constant of the plane cancels out algebraically but not numerically, so it
    /// takes part here as it does there.
    /// </remarks>
    public static void SnapToPlane(in Plane plane, ref Vector3 offset)
    {
        Vector3 n = plane.Normal;
        if (Math.Abs(n.Z) <= Epsilon) return;
        double inverse = 1.0 / n.Z;
        offset.Z = (float)((-(((double)offset.Y * n.Y) + ((double)offset.X * n.X) + plane.D) * inverse) - (inverse * -plane.D));
    }
}
