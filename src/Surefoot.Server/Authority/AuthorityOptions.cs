using Surefoot.Physics.Motion;

namespace Surefoot.Server;

/// <summary>
/// Thresholds of a <see cref="MovementAuthority"/>. The defaults are for clients that are 200 ± 100 ms away and lose one message in twenty;
/// how often an honest one is not believed with them is measured in <c>docs/authority.md</c>.
/// </summary>
public sealed record AuthorityOptions
{
    /// <summary>
    /// How much later than they were sent messages may arrive all at once, seconds: the variation of the delay, one resending included. A
    /// player who is too fast by a share s is caught when it has gained so much, after about this time divided by s.
    /// </summary>
    public double Slack { get; init; } = 1.5;

    /// <summary>
    /// How much more may be made up for at once when nothing was heard for so long, seconds: messages that wait for a lost one come in a
    /// bunch when that has been sent again.
    /// </summary>
    public double Burst { get; init; } = 5.5;

    /// <summary>
    /// How long that holds after a message that came late, seconds: the next one may be late as well. Then it melts away by a second a
    /// second.
    /// </summary>
    public double BurstHolds { get; init; } = 3;

    /// <summary>How much faster than the server's a client's clock may run, as a share.</summary>
    public double ClockDrift { get; init; } = 0.005;

    /// <summary>How far from where the motions told lead a claim may be, metres.</summary>
    public float Tolerance { get; init; } = 0.5f;

    /// <summary>
    /// How often in a row a claim that the motions told do not lead to gets the benefit of the doubt, when the way there is free, goes
    /// somewhat ahead, and is neither too long nor too high for the time. At corners and edges it hangs on a hair where a body goes.
    /// </summary>
    public int MostDoubts { get; init; } = 4;

    /// <summary>How long it takes until one of these is there again, seconds.</summary>
    public double DoubtEvery { get; init; } = 4;

    /// <summary>
    /// How long after its key came up a sidestep or a turn may go on, seconds: a walk key pressed meanwhile leaves a part of it.
    /// </summary>
    public double DriftFor { get; init; } = 20;

    /// <summary>
    /// How long what moved or opened or closed may be elsewhere, or be as it was, for the player, seconds: the way of messages both ways.
    /// What stands for longer is an obstacle like a wall.
    /// </summary>
    public double MoversLag { get; init; } = 9;

    /// <summary>A claim that misses by no more than this is put right, one that misses by more is refused, metres.</summary>
    public float CorrectWithin { get; init; } = 1f;

    /// <summary>How far above the ground one may say to stand, metres.</summary>
    public float StandWithin { get; init; } = 0.1f;

    /// <summary>How much a jump may be faster than the formulas say, m/s.</summary>
    public float JumpTolerance { get; init; } = 0.1f;

    /// <summary>How long the character's last numbers hold beside the new ones, seconds: a client hears of them late.</summary>
    public double StatsGrace { get; init; } = 3;

    /// <summary>From which run skill on the top speed holds.</summary>
    public TopSpeedRule TopSpeedRule { get; init; }

    internal void ThrowIfBad()
    {
        bool good = Slack > 0 && Burst >= 0 && BurstHolds >= 0 && MoversLag >= 0 && ClockDrift >= 0 && Tolerance > 0 && MostDoubts >= 0 &&
            DoubtEvery > 0 && DriftFor >= 0 && CorrectWithin >= 0 && StandWithin > 0 && JumpTolerance >= 0 && StatsGrace >= 0 &&
            double.IsFinite(Slack + Burst + BurstHolds + MoversLag + ClockDrift + DoubtEvery + DriftFor + StatsGrace) &&
            float.IsFinite(Tolerance + CorrectWithin + StandWithin + JumpTolerance);
        if (!good) throw new ArgumentException("A threshold is not finite, or less than its least value.", "options");
    }
}
