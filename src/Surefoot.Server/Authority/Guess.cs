namespace Surefoot.Server;

/// <summary>What a message does not say of the way to it.</summary>
internal readonly record struct Guess()
{
    /// <summary>Length of a quantum, seconds; 0 for that of last time.</summary>
    public float Quantum { get; init; }

    /// <summary>The place is passed twice, as by a jump up and down, and the last time counts.</summary>
    public bool Late { get; init; }

    /// <summary>When the walk key, which is not told, went down or came up, seconds; infinite for never.</summary>
    public double TogglesAt { get; init; } = double.PositiveInfinity;

    /// <summary>When it came up or went down again, seconds; infinite for never.</summary>
    public double TogglesBackAt { get; init; } = double.PositiveInfinity;

    /// <summary>
    /// It moves as its keys do, but for what earlier motions left of theirs, and turns as the headings say: a walk key pressed while the
    /// body turns or steps sideways leaves a part of that.
    /// </summary>
    public Drift? Drift { get; init; }

    /// <summary>It begins turned by so much, degrees: which side of an obstacle a body passes may hang on that.</summary>
    public float Turned { get; init; }

    /// <summary>It begins so far to the right, metres.</summary>
    public float Aside { get; init; }

    /// <summary>
    /// Its motions are those of its keys and nothing else: what the shadow has of earlier ones, after a wrong guess, is forgotten.
    /// </summary>
    public bool Afresh { get; init; }

    /// <summary>It turns as the headings of both ends say, whatever the keys say: the pointer turned it.</summary>
    public bool Steers { get; init; }

    /// <summary>It meets only what cannot move: where creatures and doors were at the time nobody knows.</summary>
    public bool PassesBodies { get; init; }

    /// <summary>It begins beside where the player is: it must come nearer.</summary>
    public bool Strays => Turned != 0 || Aside != 0;

    /// <summary>The walk key is part of it.</summary>
    public bool Toggles => double.IsFinite(TogglesAt);

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
            new() { PassesBodies = true },
            new() { TogglesAt = 0, Steers = true },
            new() { TogglesAt = 0, PassesBodies = true },
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
               select new Guess { TogglesAt = at, Afresh = true, PassesBodies = true },
        ], 0.5f),
    ];

    private static IEnumerable<double> Moments(double first, double last, double every)
    {
        for (double moment = first; moment < last; moment += every) yield return moment;
    }
}

/// <summary>Which sidestep a body does, whatever its keys say.</summary>
internal enum SideDrift
{
    /// <summary>None.</summary>
    None,

    /// <summary>That of a walk.</summary>
    Walk,

    /// <summary>That of a run.</summary>
    Run,

    /// <summary>What is left when the one was begun and the other ended.</summary>
    Rest,
}

/// <summary>A motion that is not that of the keys.</summary>
/// <param name="Runs">It goes ahead, or back, at the speed of a run.</param>
/// <param name="Side">Its sidestep.</param>
/// <param name="Left">To the left.</param>
internal readonly record struct Drift(bool Runs, SideDrift Side, bool Left);
