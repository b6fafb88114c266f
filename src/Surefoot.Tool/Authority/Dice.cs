namespace Surefoot.Tool.Authority;

/// <summary>Chance from a seed alone: the same on every machine.</summary>
/// <remarks>SplitMix64 (Steele, Lea and Flood, 2014).</remarks>
internal sealed class Dice(ulong seed)
{
    private ulong state = seed;

    /// <summary>A number from 0 up to 1.</summary>
    internal double Roll() => (Next() >> 11) * (1.0 / (1UL << 53));

    /// <summary>A number between two.</summary>
    internal double Roll(double least, double most) => least + ((most - least) * Roll());

    /// <summary>True in a share of cases.</summary>
    internal bool Is(double share) => Roll() < share;

    /// <summary>A seed for something else.</summary>
    internal ulong Next()
    {
        state += 0x9E3779B97F4A7C15;
        ulong z = state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
}
