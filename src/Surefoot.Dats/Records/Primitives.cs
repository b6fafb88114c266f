using System.Numerics;

namespace Surefoot.Dats.Records;

/// <summary>A place and a rotation (spec 07, section 2). Metres; x east, y north, z up.</summary>
/// <param name="Origin">Where it is, in the frame that the record names.</param>
/// <param name="Rotation">Rotation, of length 1 in valid records; kept as stored.</param>
public readonly record struct DatFrame(Vector3 Origin, Quaternion Rotation)
{
    /// <summary>No move, no turn.</summary>
    public static DatFrame Identity { get; } = new(Vector3.Zero, Quaternion.Identity);

    /// <summary>True when one of the seven numbers is NaN.</summary>
    internal bool HasNaN
        => float.IsNaN(Origin.X) || float.IsNaN(Origin.Y) || float.IsNaN(Origin.Z)
        || float.IsNaN(Rotation.W) || float.IsNaN(Rotation.X) || float.IsNaN(Rotation.Y) || float.IsNaN(Rotation.Z);

    /// <summary>Whether retail takes the frame: no NaN, and the rotation's squared length within 0.001 of 1.</summary>
    /// <remarks>Retail: Frame::IsValid @0x00534ED0.</remarks>
    internal bool IsValid
    {
        get
        {
            // Five times the float nearest to 0.0002; the sum is taken in this order and rounded once.
            const double limit = 5.0 * 0.0002f;
            double z = Rotation.Z, y = Rotation.Y, x = Rotation.X, w = Rotation.W;
            float square = (float)((z * z) + (y * y) + (x * x) + (w * w));
            return !HasNaN && Math.Abs((double)square - 1.0) <= limit;
        }
    }

    /// <summary>A frame whose rotation is normalised in double and rounded once, as records should be written.</summary>
    public static DatFrame Create(Vector3 origin, Quaternion rotation)
    {
        double w = rotation.W, x = rotation.X, y = rotation.Y, z = rotation.Z;
        double length = Math.Sqrt((w * w) + (x * x) + (y * y) + (z * z));
        return new(origin, new Quaternion((float)(x / length), (float)(y / length), (float)(z / length), (float)(w / length)));
    }
}

/// <summary>A sphere, in metres.</summary>
/// <param name="Centre">Its centre.</param>
/// <param name="Radius">Its radius.</param>
public readonly record struct DatSphere(Vector3 Centre, float Radius);

/// <summary>An upright cylinder, in metres.</summary>
/// <param name="LowPoint">Centre of the bottom disc.</param>
/// <param name="Radius">Its radius.</param>
/// <param name="Height">Height above the low point.</param>
public readonly record struct DatCylSphere(Vector3 LowPoint, float Radius, float Height);

/// <summary>A colour, stored as blue, green, red, alpha.</summary>
/// <param name="Red">0 to 255.</param>
/// <param name="Green">0 to 255.</param>
/// <param name="Blue">0 to 255.</param>
/// <param name="Alpha">0 to 255.</param>
public readonly record struct DatColor(byte Red, byte Green, byte Blue, byte Alpha);
