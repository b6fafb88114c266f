using Surefoot.Physics.World;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// What a player did last: keys, and from which moment on, from where. It begins anew when the player sets off after a rest, and at each
/// new place. The ticks are those of <see cref="WorldTime"/>.
/// </summary>
/// <param name="settings">The skills that hold at first.</param>
internal sealed class WalkRecorder(PlayerSettings settings)
{
    /// <summary>Standing still without a key for so long is a rest, seconds.</summary>
    public const double RestAfter = 1.5;

    /// <summary>Changes of keys that are kept of one walk.</summary>
    public const int MostLegs = 4000;

    /// <summary>How long a walk may last, seconds: what the command takes, less what its rounded legs may add.</summary>
    public const double Longest = 3590;

    private const string WhatTheMouseDid = "what the mouse did";

    // A body that stands is watched so long for its last quantum, seconds.
    private const double Settle = 0.25;

    private readonly List<Leg> legs = [];
    private readonly SortedSet<string> missing = new(StringComparer.Ordinal);
    private PlayerSettings current = settings, settings = settings;
    private (PlayerKeys Keys, bool AutoRun) held;
    private bool steers, isFull;
    private Position here, start;
    private double tick, endedAt, stillSince = double.NegativeInfinity;

    /// <summary>Counts walks begun, modulo 256.</summary>
    public byte Count { get; private set; }

    /// <summary>What was done that no script of keys can say, in words.</summary>
    public string LeftOut => string.Join(" and ", missing);

    private bool IsResting => legs.Count == 0 || tick - stillSince >= RestAfter;

    /// <summary>The command line that does the same.</summary>
    /// <param name="datFolder">Folder of the files; null for the demo world.</param>
    public string Command(string? datFolder)
    {
        IEnumerable<double> ends = legs.Skip(1).Select(leg => leg.From).Append(endedAt);
        IEnumerable<WalkStretch> stretches = legs.Zip(ends, (leg, end) => new WalkStretch(leg.Keys, leg.AutoRun, end - leg.From));
        return WalkCommandLine.Write(start, settings, [.. stretches], datFolder);
    }

    /// <summary>
    /// Keys are held from now on. They act from the tick before on, as its quantum is yet to come; only a jump's charge counts the moment.
    /// </summary>
    /// <param name="keys">The keys.</param>
    /// <param name="autoRun">The player runs ahead without a key.</param>
    /// <param name="now">Seconds.</param>
    public void Act(PlayerKeys keys, bool autoRun, double now)
    {
        (PlayerKeys before, bool ranBefore) = legs.Count == 0 ? default : held;
        held = (keys, autoRun);
        if (keys == before && autoRun == ranBefore) return;
        bool rests = keys == PlayerKeys.None && !autoRun;
        if (IsResting)
        {
            if (rests) return;
            Begin();
        }
        else if (isFull || legs.Count >= MostLegs)
        {
            Fill();
            return;
        }

        bool jumps = ((keys ^ before) & PlayerKeys.Jump) != 0;
        double from = Math.Max(jumps ? now : tick, legs.Count == 0 ? tick : legs[^1].From);
        if (legs.Count == 0 && from > tick) legs.Add(new Leg(PlayerKeys.None, false, tick));
        legs.Add(new Leg(keys, autoRun, from));
        endedAt = from;
        stillSince = double.PositiveInfinity;
    }

    /// <summary>The mouse button that steers is held from now on, or no longer; what it leads to is no matter of keys.</summary>
    public void Steer(bool isHeld)
    {
        steers = isHeld;
        if (!isHeld) return;
        if (IsResting)
        {
            Begin();
            legs.Add(new Leg(PlayerKeys.None, false, tick));
            stillSince = double.PositiveInfinity;
        }

        missing.Add(WhatTheMouseDid);
    }

    /// <summary>Something was done that no script of keys can say.</summary>
    public void Miss(string what)
    {
        if (!IsResting) missing.Add(what);
    }

    /// <summary>Other skills hold from now on.</summary>
    public void Configure(PlayerSettings changed)
    {
        current = changed;
        Miss("the change of skills on the way");
    }

    /// <summary>The player was put somewhere.</summary>
    public void Place(in Position place)
    {
        here = place;
        stillSince = double.PositiveInfinity;
        legs.Clear();
        Begin();
    }

    /// <summary>The world has ticked.</summary>
    /// <param name="position">Where the player is.</param>
    /// <param name="pose">The same as the page is told it, and how the player moves.</param>
    /// <param name="touches">What it touches.</param>
    /// <param name="now">Seconds.</param>
    public void Observe(in Position position, in PlayerPose pose, IReadOnlyList<Touch> touches, double now)
    {
        here = position;
        tick = now;
        bool still = held is { Keys: PlayerKeys.None, AutoRun: false } && !steers && pose.Speed < 0.01 && pose.TurnSpeed == 0 &&
            (pose.Flags & PoseFlags.Contact) != 0 && Math.Abs(pose.Velocity.Z) < 0.01;
        if (!still) stillSince = double.PositiveInfinity;
        else if (double.IsPositiveInfinity(stillSince)) stillSince = now;
        if (legs.Count > 0 && (!still || now - stillSince < Settle))
        {
            if (now - legs[0].From > Longest) Fill();
            if (!isFull) endedAt = now;
        }

        foreach (Touch touch in touches)
            if (touch.Kind is TouchKind.Body or TouchKind.Player) Miss("who was in the way");
    }

    private void Fill()
    {
        isFull = true;
        missing.Add($"what came after {MostLegs} changes of keys or an hour");
    }

    private void Begin()
    {
        legs.Clear();
        missing.Clear();
        isFull = false;
        if (double.IsPositiveInfinity(stillSince)) missing.Add("what moved the player before");
        if (steers) missing.Add(WhatTheMouseDid);
        start = here;
        settings = current;
        endedAt = tick;
        Count++;
    }

    /// <summary>Keys held from a moment on, seconds.</summary>
    private readonly record struct Leg(PlayerKeys Keys, bool AutoRun, double From);
}
