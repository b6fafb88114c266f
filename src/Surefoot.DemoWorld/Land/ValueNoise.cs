namespace Surefoot.DemoWorld.Land;

/// <summary>Smooth noise from integer hashes: the same everywhere, whatever the machine's mathematics library does.</summary>
/// <remarks>Only additions, multiplications and floors of doubles, so every platform gives the same bits.</remarks>
/// <param name="seed">Chooses the landscape.</param>
internal readonly struct ValueNoise(uint seed)
{
    /// <summary>Noise in [-1, 1] with features about one unit wide; the salt separates noises of different purpose.</summary>
    public double At(double x, double y, uint salt)
    {
        double floorX = Math.Floor(x), floorY = Math.Floor(y);
        int column = (int)floorX, row = (int)floorY;
        double fx = Smooth(x - floorX), fy = Smooth(y - floorY);
        double south = Lerp(Lattice(column, row, salt), Lattice(column + 1, row, salt), fx);
        double north = Lerp(Lattice(column, row + 1, salt), Lattice(column + 1, row + 1, salt), fx);
        return Lerp(south, north, fy);
    }

    /// <summary>Three octaves, each half as wide and half as strong, in [-1, 1].</summary>
    public double Fractal(double x, double y, uint salt)
        => ((4.0 * At(x, y, salt)) + (2.0 * At(2.0 * x, 2.0 * y, salt + 1)) + At(4.0 * x, 4.0 * y, salt + 2)) / 7.0;

    /// <summary>0 below <paramref name="low"/>, 1 above <paramref name="high"/>, smooth between.</summary>
    public static double Step(double low, double high, double value)
        => Smooth(Math.Clamp((value - low) / (high - low), 0.0, 1.0));

    /// <summary>From <paramref name="a"/> (share 0) to <paramref name="b"/> (share 1).</summary>
    public static double Lerp(double a, double b, double share) => a + ((b - a) * share);

    private static double Smooth(double t) => t * t * (3.0 - (2.0 * t));

    private double Lattice(int column, int row, uint salt)
    {
        uint h = seed ^ (salt * 0x9E3779B9u);
        h = Mix(h + ((uint)column * 0x85EBCA6Bu));
        h = Mix(h + ((uint)row * 0xC2B2AE35u));
        return (h * (2.0 / uint.MaxValue)) - 1.0;
    }

    private static uint Mix(uint h)
    {
        h ^= h >> 16;
        h *= 0x7FEB352Du;
        h ^= h >> 15;
        h *= 0x846CA68Bu;
        return h ^ (h >> 16);
    }
}
