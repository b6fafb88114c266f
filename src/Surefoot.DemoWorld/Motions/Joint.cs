using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Motions;

/// <summary>A place and a rotation in double precision, so that poses come out the same on every machine.</summary>
/// <remarks>The vector types of the platform may fuse multiplications and additions, differently from machine to machine.</remarks>
internal readonly record struct Joint(double X, double Y, double Z, double Qw, double Qx, double Qy, double Qz)
{
    /// <summary>A place without a turn.</summary>
    public static Joint At(double x, double y, double z) => new(x, y, z, 1, 0, 0, 0);

    /// <summary>This joint, turned about its own x axis: positive swings what hangs down forward (+y).</summary>
    /// <param name="degrees">Angle.</param>
    public Joint Pitch(double degrees)
    {
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 360.0);
        return Turn(cos, sin, 0, 0);
    }

    /// <summary>This joint, turned about its own y axis: positive moves what hangs down to the left (-x).</summary>
    public Joint Roll(double degrees)
    {
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 360.0);
        return Turn(cos, 0, sin, 0);
    }

    /// <summary>This joint, turned about its own z axis: positive turns to the left.</summary>
    public Joint Yaw(double degrees)
    {
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 360.0);
        return Turn(cos, 0, 0, sin);
    }

    /// <summary>The joint at an offset in this joint's axes.</summary>
    public Joint Move(double x, double y, double z)
    {
        // v + 2w(q × v) + 2 q × (q × v)
        double cx = (Qy * z) - (Qz * y), cy = (Qz * x) - (Qx * z), cz = (Qx * y) - (Qy * x);
        double ccx = (Qy * cz) - (Qz * cy), ccy = (Qz * cx) - (Qx * cz), ccz = (Qx * cy) - (Qy * cx);
        return this with
        {
            X = X + x + (2 * ((Qw * cx) + ccx)),
            Y = Y + y + (2 * ((Qw * cy) + ccy)),
            Z = Z + z + (2 * ((Qw * cz) + ccz)),
        };
    }

    /// <summary>As a record's frame.</summary>
    public DatFrame ToFrame()
    {
        double length = Math.Sqrt((Qw * Qw) + (Qx * Qx) + (Qy * Qy) + (Qz * Qz));
        return new(
            new Vector3((float)X, (float)Y, (float)Z),
            new Quaternion((float)(Qx / length), (float)(Qy / length), (float)(Qz / length), (float)(Qw / length)));
    }

    private Joint Turn(double w, double x, double y, double z) => this with
    {
        Qw = (Qw * w) - (Qx * x) - (Qy * y) - (Qz * z),
        Qx = (Qw * x) + (Qx * w) + (Qy * z) - (Qz * y),
        Qy = (Qw * y) - (Qx * z) + (Qy * w) + (Qz * x),
        Qz = (Qw * z) + (Qx * y) - (Qy * x) + (Qz * w),
    };
}
