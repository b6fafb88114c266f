using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Placement;

/// <summary>Where a thing stands and which way it looks, in some frame of metres.</summary>
/// <param name="X">East.</param>
/// <param name="Y">North.</param>
/// <param name="Z">Up.</param>
/// <param name="Heading">Degrees clockwise from north.</param>
internal readonly record struct Spot(double X, double Y, double Z, double Heading)
{
    /// <summary>A spot given in this one's own axes (y ahead, x to the right), in the frame that this one is in.</summary>
    public Spot At(double x, double y, double z, double heading = 0)
    {
        var (sin, cos) = Math.SinCos(Heading * Math.PI / 180.0);
        double turned = (Heading + heading) % 360.0;
        return new(X + (x * cos) + (y * sin), Y - (x * sin) + (y * cos), Z + z, turned < 0 ? turned + 360.0 : turned);
    }

    /// <summary>The frame for records.</summary>
    public DatFrame ToFrame()
    {
        var (sin, cos) = Math.SinCos(Heading * Math.PI / 360.0);
        return new(ToVector(), new Quaternion(0f, 0f, (float)-sin, (float)cos));
    }

    /// <summary>The place without the heading.</summary>
    public Vector3 ToVector() => new((float)X, (float)Y, (float)Z);
}
