using Surefoot.Client;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Network;

/// <summary>
/// Hands that run a body to and fro along a way as a player does: every half second they look where they are going and turn there, and by
/// chance they stop, jump, turn aside, walk, step sideways or back.
/// </summary>
/// <param name="way">Places to run to one after the other in straight lines, and back.</param>
/// <param name="seed">Seed of everything that is left to chance.</param>
/// <param name="pace">How many times as often they change their mind.</param>
internal sealed class WanderingHands(IReadOnlyList<Position> way, int seed, double pace = 1)
{
    /// <summary>Metres from a place, over ground and in height, at which it is reached.</summary>
    private const double Near = 1.5, NearHeight = 1.0;

    /// <summary>Degrees off the way that are turned away, and at which the hands stand still to turn.</summary>
    private const double Aside = 5, Away = 75;

    /// <summary>Seconds between two looks at where to go, and degrees turned in a second by a running player.</summary>
    private const double LookTime = 0.5, TurnRate = 1.5 * 1.5 * 180 / Math.PI;

    /// <summary>
    /// Seconds after which a place that is not reached is given up, and the time in which the body has to get on by so many metres.
    /// </summary>
    private const double Patience = 15, StuckTime = 2, StuckWay = 1;

    private readonly Random random = new(seed);
    private int goal = 1;
    private bool goesBack;
    private double whimUntil, headedSince, lookAt, turnUntil, movedSince;
    private MovementKeys whim, turn;
    private bool steers = true, runs;
    private Position movedFrom;

    /// <summary>How often a place of the way was reached.</summary>
    internal int Reached { get; private set; }

    /// <summary>The keys held now.</summary>
    /// <param name="here">Where the body is.</param>
    /// <param name="now">Seconds.</param>
    internal MovementKeys KeysAt(in Position here, double now)
    {
        Position there = way[goal];
        bool isThere = here.HorizontalDistanceTo(there) < Near && Math.Abs(here.OffsetTo(there).Z) < NearHeight;
        if (isThere) Reached++;
        if (isThere || now - headedSince > Patience || IsStuck(here, now)) GoOn(now);
        if (now >= whimUntil) Choose(now);
        if (!steers) return whim;
        if (now >= lookAt) Look(here, now);
        return whim | (now < turnUntil ? turn : MovementKeys.None) | (runs ? MovementKeys.Forward : MovementKeys.None);
    }

    private bool IsStuck(in Position here, double now)
    {
        if (!steers || !runs || here.DistanceTo(movedFrom) > StuckWay) (movedFrom, movedSince) = (here, now);
        return now - movedSince > StuckTime;
    }

    private void GoOn(double now)
    {
        headedSince = movedSince = now;
        lookAt = now;
        if (goal == way.Count - 1) goesBack = true;
        else if (goal == 0) goesBack = false;
        goal += goesBack ? -1 : 1;
    }

    private void Choose(double now)
    {
        const MovementKeys forward = MovementKeys.Forward;
        (steers, whim, double seconds) = random.Next(20) switch
        {
            < 9 => (true, MovementKeys.None, Between(3, 8)),
            < 11 => (true, MovementKeys.Jump, Between(0.1, 1)),
            < 15 => (false, MovementKeys.None, Between(3, 8)),
            15 => (false, forward | MovementKeys.TurnLeft, Between(0.3, 1)),
            16 => (false, forward | MovementKeys.TurnRight, Between(0.3, 1)),
            17 => (true, MovementKeys.Walk, Between(2, 4)),
            18 => (false, MovementKeys.SidestepLeft, Between(0.5, 1)),
            _ => (false, MovementKeys.Back, Between(0.5, 1)),
        };
        whimUntil = now + (seconds / pace);
        lookAt = now;
    }

    /// <summary>Turns to where it goes, for as long as that takes, and runs unless it is far aside.</summary>
    private void Look(in Position here, double now)
    {
        lookAt = now + LookTime;
        double aside = ((here.HeadingTo(way[goal]) - here.Frame.Heading + 540) % 360) - 180;
        turn = aside < 0 ? MovementKeys.TurnLeft : MovementKeys.TurnRight;
        turnUntil = Math.Abs(aside) > Aside ? now + (Math.Abs(aside) / TurnRate) : now;
        runs = Math.Abs(aside) < Away;
    }

    private double Between(double least, double most) => least + ((most - least) * random.NextDouble());
}
