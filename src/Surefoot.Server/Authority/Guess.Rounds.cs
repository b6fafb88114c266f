namespace Surefoot.Server;

/// <content>The guesses that are looked at, in their order.</content>
internal readonly partial record struct Guess
{
    /// <summary>How many guesses are drawn for a second opinion.</summary>
    private const int FinerCount = 360;

    /// <summary>Lengths of a client's quantum, seconds: that of its frames, at least 1/30.</summary>
    private static readonly float[] Quanta = [1f / 30, 0.0365f, 0.04f, 0.045f, 0.05f, 0.055f, 0.06f, 1f / 15, 0.07f, 0.08f, 0.09f, 0.1f];

    /// <summary>
    /// What may have happened on the way, round by round, each with how near a claim must come to the course of one of its guesses to make
    /// the next rounds superfluous. Most claims are decided by the first. The next: the client's quanta have another length. Then: the walk
    /// key, of which nothing is told, was pressed meanwhile. Then: the pointer turned the body, it passed a corner by a hand's breadth on
    /// the other side, or it passed those who may have stood elsewhere. Last: the walk key was tapped, or more of this at once.
    /// </summary>
    internal static readonly (Guess[] Guesses, float Enough)[] Rounds =
    [
        ([new(), new() { Late = true }, new() { TogglesAt = 0 }], 0.05f),
        (
        [
            .. Quanta.Select(quantum => new Guess { Quantum = quantum }),
            .. Quanta.Select(quantum => new Guess { Quantum = quantum, Late = true }),
        ], 0.05f),
        ([.. Moments(0, 1.3, 0.1).Select(at => new Guess { TogglesAt = at })], 0.1f),
        (
        [
            new() { Steers = true },
            new() { Afresh = true },
            new() { Afresh = true, TogglesAt = 0 },
            new() { Turned = 1.5f },
            new() { Turned = -1.5f },
            new() { Aside = 0.05f },
            new() { Aside = -0.05f },
            new() { PassesMovers = true },
            new() { TogglesAt = 0, Steers = true },
            new() { TogglesAt = 0, PassesMovers = true },
            new() { Afresh = true, Turned = 2 },
            new() { Afresh = true, Turned = -2 },
        ], 0.3f),
        (
        [
            .. from runs in (bool[])[true, false]
               from side in Enum.GetValues<SideDrift>()
               from left in (bool[])[true, false]
               where side != SideDrift.None || left
               select new Guess { Drift = new Drift(runs, side, left) },
        ], 0.3f),
        (
        [
            .. from at in Moments(0, 0.9, 0.15)
               from back in Moments(at + 0.15, 1.2, 0.15)
               select new Guess { TogglesAt = at, TogglesBackAt = back },
            .. from at in Moments(0, 1, 0.2)
               from quantum in Quanta
               select new Guess { TogglesAt = at, Quantum = quantum },
            .. from turned in (float[])[-3, -2, -0.7f, 0.7f, 2, 3]
               from quantum in (float[])[0, 1f / 30, 0.05f, 0.07f]
               select new Guess { Turned = turned, Quantum = quantum },
            .. from aside in (float[])[-0.1f, -0.02f, 0.02f, 0.1f]
               from quantum in (float[])[0, 1f / 30, 0.05f, 0.07f]
               select new Guess { Aside = aside, Quantum = quantum },
            .. from at in Moments(0, 1, 0.25)
               from turned in (float[])[-2, 2]
               select new Guess { TogglesAt = at, Turned = turned },
            .. from at in Moments(0, 1, 0.25)
               select new Guess { TogglesAt = at, Afresh = true, PassesMovers = true },
        ], 0.5f),
    ];

    private static IEnumerable<double> Moments(double first, double last, double every)
    {
        for (double moment = first; moment < last; moment += every) yield return moment;
    }

    /// <summary>
    /// A second opinion before a claim is refused: all of this at once, by chance, finer and further. The same guesses each time.
    /// </summary>
    internal static readonly Guess[] Finer = Draw();

    private static Guess[] Draw()
    {
        Guess[] drawn = new Guess[FinerCount];
        ulong state = 1;
        for (int i = 0; i < drawn.Length; i++)
        {
            double at = Is(0.4) ? Roll(0, 1.5) : double.PositiveInfinity;
            drawn[i] = new Guess
            {
                Quantum = Quanta[(int)Roll(0, Quanta.Length)],
                LongEvery = Is(0.3) ? (int)Roll(2, 6) : 0,
                Late = Is(0.3),
                TogglesAt = at,
                TogglesBackAt = Is(0.5) ? at + Roll(0.1, 1) : double.PositiveInfinity,
                Turned = Is(0.5) ? (float)Roll(-3, 3) : 0,
                Aside = Is(0.5) ? (float)Roll(-0.1, 0.1) : 0,
                Raised = Is(0.3) ? (float)Roll(0, 0.06) : 0,
                PassesMovers = Is(0.2),
                Afresh = Is(0.2),
            };
        }

        return drawn;

        // SplitMix64 (Steele, Lea and Flood, 2014).
        double Roll(double least, double most)
        {
            state += 0x9E3779B97F4A7C15;
            ulong z = state;
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
            return least + ((most - least) * ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53)));
        }

        bool Is(double share) => Roll(0, 1) < share;
    }
}
