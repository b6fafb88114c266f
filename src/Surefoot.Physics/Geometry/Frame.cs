using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>
/// An origin (metres) and an orientation, with the rotation matrix that belongs to it. Copying a frame copies the matrix.
/// </summary>
/// <remarks>Retail: Frame. The columns of the matrix are the images of the local axes (specification 03, 4.1.4).</remarks>
public struct Frame : IEquatable<Frame>
{
    private const double DegreesPerRadian = 180.0 / Math.PI;

    private Quaternion rotation;

    /// <summary>
    /// A frame at <paramref name="origin"/> with the orientation <paramref name="rotation"/>, which should be of unit length.
    /// </summary>
    public Frame(Vector3 origin, Quaternion rotation)
    {
        Origin = origin;
        this.rotation = rotation;
        CacheMatrix();
    }

    /// <summary>The frame that changes nothing.</summary>
    public static Frame Identity => new(Vector3.Zero, Quaternion.Identity);

    /// <summary>Origin, metres.</summary>
    public Vector3 Origin;

    /// <summary>Orientation; a unit quaternion.</summary>
    public readonly Quaternion Rotation => rotation;

    /// <summary>Image of the local +x axis (m0, m1, m2).</summary>
    public Vector3 XAxis { readonly get; private set; }

    /// <summary>Image of the local +y axis, the way the body faces (m3, m4, m5).</summary>
    public Vector3 YAxis { readonly get; private set; }

    /// <summary>Image of the local +z axis (m6, m7, m8).</summary>
    public Vector3 ZAxis { readonly get; private set; }

    /// <summary>World up seen from inside the frame (m2, m5, m8).</summary>
    internal readonly Vector3 LocalUp => new(XAxis.Z, YAxis.Z, ZAxis.Z);

    /// <summary>A point of the frame in the coordinates around it, each component rounded once.</summary>
    /// <remarks>Retail: Frame::localtoglobal @0x00452620.</remarks>
    public readonly Vector3 LocalToGlobal(in Vector3 v) => new(
        (float)(((double)XAxis.X * v.X) + ((double)YAxis.X * v.Y) + ((double)ZAxis.X * v.Z) + Origin.X),
        (float)(((double)XAxis.Y * v.X) + ((double)YAxis.Y * v.Y) + ((double)ZAxis.Y * v.Z) + Origin.Y),
        (float)(((double)XAxis.Z * v.X) + ((double)YAxis.Z * v.Y) + ((double)ZAxis.Z * v.Z) + Origin.Z));

    /// <summary>A direction of the frame in the coordinates around it.</summary>
    /// <remarks>Retail: Frame::localtoglobalvec @0x004524F0.</remarks>
    public readonly Vector3 LocalToGlobalVector(in Vector3 v) => new(
        (float)(((double)XAxis.X * v.X) + ((double)YAxis.X * v.Y) + ((double)ZAxis.X * v.Z)),
        (float)(((double)XAxis.Y * v.X) + ((double)YAxis.Y * v.Y) + ((double)ZAxis.Y * v.Z)),
        (float)(((double)XAxis.Z * v.X) + ((double)YAxis.Z * v.Y) + ((double)ZAxis.Z * v.Z)));

    /// <summary>A point of the coordinates around the frame, seen from inside it.</summary>
    /// <remarks>
    /// Retail: Frame::globaltolocal @0x00452680. The way from the origin is stored first, but for its z where that makes the local z.
    /// </remarks>
    public readonly Vector3 GlobalToLocal(in Vector3 point)
    {
        Vector3 d = point - Origin;
        double z = (double)point.Z - Origin.Z;
        return new Vector3(
            (float)RetailMath.Dot(XAxis, d), (float)RetailMath.Dot(YAxis, d),
            (float)(((double)ZAxis.X * d.X) + ((double)ZAxis.Y * d.Y) + (ZAxis.Z * z)));
    }

    /// <summary>A direction of the coordinates around the frame, seen from inside it.</summary>
    /// <remarks>Retail: Frame::globaltolocalvec @0x00452550.</remarks>
    public readonly Vector3 GlobalToLocalVector(in Vector3 v) => new(
        (float)RetailMath.Dot(XAxis, v), (float)RetailMath.Dot(YAxis, v), (float)RetailMath.Dot(ZAxis, v));

    /// <summary>
    /// Takes the orientation, made a unit quaternion; a result with NaN or too far from unit length is refused and the old one stays.
    /// </summary>
    /// <remarks>Retail: Frame::set_rotate @0x00535080.</remarks>
    /// <returns>False when the orientation was refused.</returns>
    public bool SetRotation(Quaternion q)
    {
        double inverse = 1.0 / Math.Sqrt(((double)q.W * q.W) + ((double)q.X * q.X) + ((double)q.Y * q.Y) + ((double)q.Z * q.Z));
        Quaternion unit = new((float)(q.X * inverse), (float)(q.Y * inverse), (float)(q.Z * inverse), (float)(q.W * inverse));
        Quaternion before = rotation;
        rotation = unit;
        if (!IsValid)
        {
            rotation = before;
            return false;
        }

        CacheMatrix();
        return true;
    }

    /// <summary>No NaN, and a quaternion whose squared length is within 0.001 of 1.</summary>
    /// <remarks>Retail: Frame::IsValid @0x00534ED0.</remarks>
    public readonly bool IsValid
    {
        get
        {
            if (float.IsNaN(Origin.X) || float.IsNaN(Origin.Y) || float.IsNaN(Origin.Z)) return false;
            float norm = (float)(((double)rotation.Z * rotation.Z) + ((double)rotation.Y * rotation.Y) +
                                 ((double)rotation.X * rotation.X) + ((double)rotation.W * rotation.W));
            return Math.Abs((double)norm - 1.0) <= 5.0 * RetailMath.Epsilon;
        }
    }

    /// <summary>
    /// This frame carried by <paramref name="outer"/>: the origin goes through the outer frame, the orientations multiply and the product
    /// is made a unit quaternion again.
    /// </summary>
    /// <remarks>Retail: Frame::combine.</remarks>
    public static Frame Combine(in Frame outer, in Frame inner)
    {
        Frame result = outer;
        result.Origin = outer.LocalToGlobal(inner.Origin);
        result.SetRotation(Multiply(outer.rotation, inner.rotation));
        return result;
    }

    /// <summary>
    /// The inverse of <see cref="Combine"/> on the right: the frame that, followed by <paramref name="inner"/>, gives
    /// <paramref name="whole"/>.
    /// </summary>
    /// <remarks>Retail: Frame::subtract1.</remarks>
    internal static Frame Subtract(in Frame whole, in Frame inner)
    {
        Frame result = whole;
        Quaternion conjugate = new(-inner.rotation.X, -inner.rotation.Y, -inner.rotation.Z, inner.rotation.W);
        result.SetRotation(Multiply(whole.rotation, conjugate));
        result.Origin = whole.Origin - result.LocalToGlobalVector(inner.Origin);
        return result;
    }

    /// <summary>The orientation of <paramref name="other"/> seen from inside this frame.</summary>
    /// <remarks>Retail: Frame::subtract2 @0x00535650.</remarks>
    internal readonly Quaternion RelativeRotation(in Frame other) =>
        Multiply(new Quaternion(-rotation.X, -rotation.Y, -rotation.Z, rotation.W), other.rotation);

    /// <summary>
    /// Turns by a rotation vector (radians) given in the axes around the frame; nothing when it is shorter than the tolerance.
    /// </summary>
    /// <remarks>Retail: Frame::grotate.</remarks>
    public void RotateGlobal(in Vector3 radians)
    {
        if (TryRotation(radians, out Quaternion q)) SetRotation(Multiply(q, rotation));
    }

    /// <summary>
    /// Turns by a rotation vector (radians) given in the frame's own axes; nothing when it is shorter than the tolerance.
    /// </summary>
    /// <remarks>Retail: Frame::rotate.</remarks>
    public void RotateLocal(in Vector3 radians)
    {
        if (TryRotation(radians, out Quaternion q)) SetRotation(Multiply(rotation, q));
    }

    /// <summary>Orientation a fraction <paramref name="t"/> of the way between two frames; the origin is left alone.</summary>
    /// <remarks>Retail: Frame::interpolate_rotation @0x00535390.</remarks>
    internal void InterpolateRotation(in Frame from, in Frame to, float t)
    {
        Quaternion a = from.rotation, b = to.rotation;
        double cosine = ((double)a.W * b.W) + ((double)a.X * b.X) + ((double)a.Y * b.Y) + ((double)a.Z * b.Z);
        if (cosine < 0)
        {
            cosine = -cosine;
            b = new Quaternion(-b.X, -b.Y, -b.Z, -b.W);
        }

        double wa = 1.0 - t, wb = t;
        if (1.0 - cosine > RetailMath.Epsilon)
        {
            double angle = Math.Acos(cosine), sine = Math.Sin(angle);
            double sa = Math.Sin(angle * (1.0 - t)) / sine, sb = Math.Sin(angle * t) / sine;
            if (sa is >= 0 and <= 1 && sb is >= 0 and <= 1) (wa, wb) = (sa, sb);
        }

        SetRotation(new Quaternion(
            (float)((wa * a.X) + (wb * b.X)), (float)((wa * a.Y) + (wb * b.Y)),
            (float)((wa * a.Z) + (wb * b.Z)), (float)((wa * a.W) + (wb * b.W))));
    }

    /// <summary>Compass direction in degrees: 0 faces +y (north), 90 faces +x (east).</summary>
    /// <remarks>Retail: Frame::get_heading @0x00535760.</remarks>
    public readonly double Heading => HeadingOf(YAxis);

    /// <summary>Compass direction in degrees of the horizontal part of a vector.</summary>
    public static double HeadingOf(in Vector3 direction) => (450.0 - (Math.Atan2(direction.Y, direction.X) * DegreesPerRadian)) % 360.0;

    /// <summary>Faces the compass direction (degrees), keeping the vertical part of the present facing.</summary>
    /// <remarks>Retail: Frame::set_heading @0x00535E40.</remarks>
    public void SetHeading(float degrees)
    {
        double radians = degrees * Math.PI / 180.0;
        SetVectorHeading(new Vector3((float)Math.Sin(radians), (float)Math.Cos(radians), YAxis.Z));
    }

    /// <summary>Faces along <paramref name="direction"/>; a vector too small to have a direction changes nothing.</summary>
    /// <remarks>Retail: Frame::set_vector_heading @0x00535DB0.</remarks>
    internal void SetVectorHeading(Vector3 direction)
    {
        if (RetailMath.NormalizeCheckSmall(ref direction)) return;
        // The angles pass as a vector, which holds floats.
        float yaw = (float)(-HeadingOf(direction) * Math.PI / 180.0), pitch = (float)Math.Asin(direction.Z);
        Quaternion aboutZ = new(0, 0, (float)Math.Sin(yaw / 2.0), (float)Math.Cos(yaw / 2.0));
        Quaternion aboutX = new((float)Math.Sin(pitch / 2.0), 0, 0, (float)Math.Cos(pitch / 2.0));
        SetRotation(Multiply(aboutZ, aboutX));
    }

    /// <summary>Origins within the tolerance on each axis and quaternions strictly within it; q and -q count as different.</summary>
    /// <remarks>Retail: Frame::is_equal @0x00424C30.</remarks>
    internal static bool NearlyEqual(in Frame a, in Frame b) =>
        RetailMath.NearlyEqual(a.Origin, b.Origin) &&
        Math.Abs((double)a.rotation.W - b.rotation.W) < RetailMath.Epsilon &&
        Math.Abs((double)a.rotation.X - b.rotation.X) < RetailMath.Epsilon &&
        Math.Abs((double)a.rotation.Y - b.rotation.Y) < RetailMath.Epsilon &&
        Math.Abs((double)a.rotation.Z - b.rotation.Z) < RetailMath.Epsilon;

    /// <inheritdoc/>
    public readonly bool Equals(Frame other) => Origin == other.Origin && rotation == other.rotation;

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is Frame other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode() => HashCode.Combine(Origin, rotation);

    /// <summary>Same origin and same quaternion, bit for bit.</summary>
    public static bool operator ==(Frame left, Frame right) => left.Equals(right);

    /// <summary>Another origin or another quaternion.</summary>
    public static bool operator !=(Frame left, Frame right) => !left.Equals(right);

    /// <summary>Hamilton product: <paramref name="b"/> is applied first.</summary>
    private static Quaternion Multiply(in Quaternion a, in Quaternion b) => new(
        (float)(((double)a.W * b.X) + ((double)a.X * b.W) + ((double)a.Y * b.Z) - ((double)a.Z * b.Y)),
        (float)(((double)a.W * b.Y) - ((double)a.X * b.Z) + ((double)a.Y * b.W) + ((double)a.Z * b.X)),
        (float)(((double)a.W * b.Z) + ((double)a.X * b.Y) - ((double)a.Y * b.X) + ((double)a.Z * b.W)),
        (float)(((double)a.W * b.W) - ((double)a.X * b.X) - ((double)a.Y * b.Y) - ((double)a.Z * b.Z)));

    private static bool TryRotation(in Vector3 radians, out Quaternion q)
    {
        double squared = RetailMath.LengthSquared(radians);
        if (squared < RetailMath.EpsilonSquared)
        {
            q = Quaternion.Identity;
            return false;
        }

        // The inverse length is kept in a float.
        double angle = Math.Sqrt(squared), k = (float)(1.0 / angle) * Math.Sin(angle / 2);
        q = new Quaternion((float)(radians.X * k), (float)(radians.Y * k), (float)(radians.Z * k), (float)Math.Cos(angle / 2));
        return true;
    }

    private void CacheMatrix()
    {
        double w = rotation.W, x = rotation.X, y = rotation.Y, z = rotation.Z;
        XAxis = new Vector3((float)(1 - (2 * y * y) - (2 * z * z)), (float)((2 * x * y) + (2 * w * z)), (float)((2 * x * z) - (2 * w * y)));
        YAxis = new Vector3((float)((2 * x * y) - (2 * w * z)), (float)(1 - (2 * x * x) - (2 * z * z)), (float)((2 * y * z) + (2 * w * x)));
        ZAxis = new Vector3((float)((2 * x * z) + (2 * w * y)), (float)((2 * y * z) - (2 * w * x)), (float)(1 - (2 * x * x) - (2 * y * y)));
    }
}
