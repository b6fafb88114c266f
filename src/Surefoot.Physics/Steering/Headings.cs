using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Steering;

/// <summary>Arithmetic of compass headings in degrees: 0 north, 90 east.</summary>
/// <remarks>Specification 09b, 5. The comparisons decide which way a body turns and are kept as they are, ties included.</remarks>
internal static class Headings
{
    private const double Full = 360.0;
    private const double Half = 180.0;

    /// <summary>Half the window within which a body that moves does not turn.</summary>
    private const double Window = 20.0;

    /// <summary>
    /// How far <paramref name="motion"/> leads from <paramref name="y"/> to <paramref name="x"/>: clockwise for a right turn, else the
    /// other way.
    /// </summary>
    /// <remarks>Retail: heading_diff @0x00528FB0.</remarks>
    internal static double Difference(float x, float y, MotionCommand motion)
    {
        double r = Positive((double)x - y);
        return r > RetailMath.Epsilon && motion != MotionCommand.TurnRight ? Full - r : r;
    }

    /// <summary>Has a turn taken <paramref name="x"/> past <paramref name="y"/>? Equality counts for left turns only.</summary>
    /// <remarks>
    /// Retail: heading_greater @0x00528F60. A turn of exactly half a circle that begins at the greater heading is past at once.
    /// </remarks>
    internal static bool IsPast(float x, float y, MotionCommand motion)
    {
        bool greater = Math.Abs((double)x - y) <= Half ? x > y : y > x;
        return motion == MotionCommand.TurnRight ? greater : !greater;
    }

    /// <summary>The turn that leads from one heading to another the short way; none when it is there. Half a circle goes right.</summary>
    internal static MotionCommand TurnTo(float goal, float own, out float difference)
    {
        double r = Difference(goal, own, MotionCommand.TurnRight);
        difference = (float)r;
        if (r <= Half) return r > RetailMath.Epsilon ? MotionCommand.TurnRight : MotionCommand.None;
        return r + RetailMath.Epsilon >= Full ? MotionCommand.None : MotionCommand.TurnLeft;
    }

    /// <summary>The turn that a body makes while it moves; none within twenty degrees. Half a circle goes left.</summary>
    /// <param name="wanted">Where it should face, degrees.</param>
    /// <param name="own">Where it faces, not rounded: retail subtracts what its function returns.</param>
    internal static MotionCommand TurnWhileMoving(float wanted, double own)
    {
        double r = Positive(wanted - own);
        if (r is <= Window or >= Full - Window) return MotionCommand.None;
        return r >= Half ? MotionCommand.TurnLeft : MotionCommand.TurnRight;
    }

    /// <summary>The sum of two headings, brought back below a full circle once.</summary>
    internal static float Add(float heading, float offset)
    {
        float sum = (float)((double)heading + offset);
        return sum >= Full ? (float)(sum - Full) : sum;
    }

    private static double Positive(double r)
    {
        if (Math.Abs(r) < RetailMath.Epsilon) return 0;
        return r < -RetailMath.Epsilon ? r + Full : r;
    }
}
