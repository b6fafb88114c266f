namespace Surefoot.Protocol.Session;

/// <summary>
/// How bad a simulated network is. The default value is a perfect one. Each datagram is treated by itself, whichever way it goes.
/// </summary>
public readonly record struct NetworkQuality
{
    /// <summary>Longest <see cref="Delay"/> and <see cref="Jitter"/>, seconds: with more, the two ends give each other up.</summary>
    public const double MostDelay = 10;

    private readonly double delay, jitter, loss, duplication;

    /// <summary>A network.</summary>
    /// <param name="delay">See <see cref="Delay"/>.</param>
    /// <param name="jitter">See <see cref="Jitter"/>.</param>
    /// <param name="loss">See <see cref="Loss"/>.</param>
    /// <param name="duplication">See <see cref="Duplication"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// A time is not between 0 and <see cref="MostDelay"/>, or a share not between 0 and 1.
    /// </exception>
    public NetworkQuality(double delay, double jitter = 0, double loss = 0, double duplication = 0)
    {
        Delay = delay;
        Jitter = jitter;
        Loss = loss;
        Duplication = duplication;
    }

    /// <summary>Seconds from one end to the other, 0 to <see cref="MostDelay"/>.</summary>
    public double Delay
    {
        get => delay;
        init => delay = CheckedTime(value, nameof(Delay));
    }

    /// <summary>
    /// Seconds that the delay varies both ways, evenly, 0 to <see cref="MostDelay"/>: datagrams overtake each other. No delay is below 0.
    /// </summary>
    public double Jitter
    {
        get => jitter;
        init => jitter = CheckedTime(value, nameof(Jitter));
    }

    /// <summary>Share of datagrams that are lost, 0 to 1.</summary>
    public double Loss
    {
        get => loss;
        init => loss = CheckedShare(value, nameof(Loss));
    }

    /// <summary>Share of datagrams that are sent twice, 0 to 1; each of the two may be lost, and has a delay of its own.</summary>
    public double Duplication
    {
        get => duplication;
        init => duplication = CheckedShare(value, nameof(Duplication));
    }

    private static double CheckedTime(double value, string name) =>
        value is >= 0 and <= MostDelay
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} is a number of seconds between 0 and {MostDelay}.");

    private static double CheckedShare(double value, string name) =>
        value is >= 0 and <= 1 ? value : throw new ArgumentOutOfRangeException(name, value, $"{name} is a share between 0 and 1.");
}
