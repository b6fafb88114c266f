namespace Surefoot.Server;

/// <summary>What a message does not say of the way to it.</summary>
internal readonly partial record struct Guess()
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

    /// <summary>When it turns that back, seconds: it comes out a hand's breadth beside, and no farther however long the way.</summary>
    public const double TurnsBackAfter = 0.35;

    /// <summary>It begins so far to the right, metres.</summary>
    public float Aside { get; init; }

    /// <summary>It begins so much higher, metres: whether a jump clears an edge may hang on that.</summary>
    public float Raised { get; init; }

    /// <summary>
    /// Every so-manieth quantum is half as long again, as at 60 frames a second, two or three of which make a quantum; 0 for none.
    /// </summary>
    public int LongEvery { get; init; }

    /// <summary>
    /// Its motions are those of its keys and nothing else: what the shadow has of earlier ones, after a wrong guess, is forgotten.
    /// </summary>
    public bool Afresh { get; init; }

    /// <summary>It turns as the headings of both ends say, whatever the keys say: the pointer turned it.</summary>
    public bool Steers { get; init; }

    /// <summary>It does not meet what moved lately, nor a mill's sails: where they were at the time nobody knows.</summary>
    public bool PassesMovers { get; init; }

    /// <summary>It begins beside where the player is: it must come nearer.</summary>
    public bool Strays => Turned != 0 || Aside != 0 || Raised != 0;

    /// <summary>The walk key is part of it.</summary>
    public bool Toggles => double.IsFinite(TogglesAt);
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
