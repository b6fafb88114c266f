namespace Surefoot.Server;

/// <summary>What a creature is driven to do.</summary>
public enum CreatureGoal
{
    /// <summary>Nothing: it stands.</summary>
    None,

    /// <summary>To come to an object, once.</summary>
    Object,

    /// <summary>To come to a place, once.</summary>
    Place,

    /// <summary>To come home, and to face as it did there.</summary>
    Home,

    /// <summary>To face an object, once.</summary>
    FaceObject,

    /// <summary>To face a heading, once.</summary>
    FaceHeading,

    /// <summary>To stay near an object, wherever that goes.</summary>
    Follow,

    /// <summary>To stay right next to an object, facing it.</summary>
    Stick,

    /// <summary>To stay away from an object.</summary>
    Flee,
}

/// <summary>How far a <see cref="CreatureDriver"/> is with its goal.</summary>
public enum CreatureProgress
{
    /// <summary>There is nothing to do.</summary>
    Idle,

    /// <summary>It is on its way.</summary>
    Moving,

    /// <summary>It is where it should be, and looks whether that stays so.</summary>
    Watching,

    /// <summary>It could not get on, and waits for something near it to change.</summary>
    Stuck,
}

/// <summary>How a creature goes about its goals.</summary>
public sealed record CreatureDriverOptions
{
    /// <summary>Factor on the running speed of its motions, more than 0.</summary>
    public float RunRate { get; init; } = 1f;

    /// <summary>How near it comes to an object or a place, metres from surface to surface.</summary>
    public float Reach { get; init; } = 0.6f;

    /// <summary>
    /// Distance below which it walks, metres; 0 for one that always runs. Who flees runs in any case, and so does one that is outrun: its
    /// target is farther by <see cref="FollowSlack"/> than when the walk began.
    /// </summary>
    public float WalkWithin { get; init; } = 15f;

    /// <summary>How much farther than its reach what it follows, or sticks to, may get before it goes after it, metres.</summary>
    public float FollowSlack { get; init; } = 1f;

    /// <summary>How far it flees, metres.</summary>
    public float FleeDistance { get; init; } = 15f;

    /// <summary>Share of that distance within which it flees again.</summary>
    public float FleeAgainWithin { get; init; } = 0.8f;

    /// <summary>How long it may get nowhere before it counts as stuck, seconds.</summary>
    public double StuckAfter { get; init; } = 1.5;

    /// <summary>What counts as nowhere: less than this way in that time, metres.</summary>
    public float StuckWithin { get; init; } = 0.25f;

    /// <summary>How far around one that is stuck a change wakes it, metres from surface to surface.</summary>
    public float WakeRadius { get; init; } = 2f;

    /// <summary>
    /// Least time that one that is stuck stands, seconds. It doubles each time it gets stuck again without having got anywhere, up to
    /// <see cref="LongestWait"/>: creatures that jostle each other do not wake each other for ever.
    /// </summary>
    public double ShortestWait { get; init; } = 0.5;

    /// <summary>The longest such time, seconds.</summary>
    public double LongestWait { get; init; } = 8;

    /// <summary>How often its place is told on the way, seconds.</summary>
    public double TellEvery { get; init; } = 0.2;

    /// <summary>Stamps of the object, as its CreateObject told them.</summary>
    public Protocol.Messages.ObjectStamps Stamps { get; init; } = new(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1);

    internal void ThrowIfBad()
    {
        bool lengths = RunRate > 0 && Reach >= 0 && WalkWithin >= 0 && FollowSlack > 0 && FleeDistance > 0 &&
            FleeAgainWithin is > 0 and <= 1 && StuckWithin > 0 && WakeRadius >= 0 &&
            float.IsFinite(RunRate + Reach + WalkWithin + FollowSlack + FleeDistance + StuckWithin + WakeRadius);
        bool times = StuckAfter > 0 && ShortestWait > 0 && LongestWait >= ShortestWait && TellEvery > 0 &&
            double.IsFinite(StuckAfter + LongestWait + TellEvery);
        if (!lengths || !times)
            throw new ArgumentException("A length or time is not finite, or less than its least value.", "options");
    }
}
