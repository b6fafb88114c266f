namespace Surefoot.Workbench.Simulation;

/// <summary>
/// The world's time counts in 1/512 s, and its ticks are all of one length: sums and differences of such times are exact, so that the same
/// keys at the same ticks give the same way to the last bit, whenever they are pressed.
/// </summary>
internal static class WorldTime
{
    /// <summary>Ticks of time in a second.</summary>
    public const int UnitsPerSecond = 512;

    /// <summary>Seconds of a quantum: the shortest whole number of units that the physics takes for one (1/30 s).</summary>
    public const double Quantum = 18.0 / UnitsPerSecond;

    /// <summary>The last moment of the world's time that is not after this one, seconds.</summary>
    public static double Floor(double seconds) => Math.Floor(seconds * UnitsPerSecond) / UnitsPerSecond;
}
