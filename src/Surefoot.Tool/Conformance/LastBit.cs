using System.Numerics;

namespace Surefoot.Tool.Conformance;

/// <summary>
/// Tells a result that hangs on the last bit of a float from one that is wrong. Recorders that compute in binary32 and an engine that
/// rounds where retail rounds take the other branch where a body touches exactly: from one of the places that differ by rounding alone, the
/// recorded result then comes out.
/// </summary>
internal static class LastBit
{
    /// <summary>How far a coordinate is off by rounding, units in its last place.</summary>
    private const int Units = 2;

    /// <summary>Does any place that differs by rounding alone lead to the recorded result?</summary>
    /// <param name="place">The recorded place.</param>
    /// <param name="isEqual">Replays from a place.</param>
    internal static bool Decides(Vector3 place, Func<Vector3, bool> isEqual)
    {
        for (int x = -Units; x <= Units; x++)
            for (int y = -Units; y <= Units; y++)
                for (int z = -Units; z <= Units; z++)
                    if ((x | y | z) != 0 && isEqual(new Vector3(Moved(place.X, x), Moved(place.Y, y), Moved(place.Z, z)))) return true;
        return false;
    }

    private static float Moved(float number, int units)
    {
        for (; units > 0; units--) number = MathF.BitIncrement(number);
        for (; units < 0; units++) number = MathF.BitDecrement(number);
        return number;
    }
}
