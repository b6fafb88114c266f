using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <content>How the way to a place is judged.</content>
public sealed partial class MovementAuthority
{
    /// <summary>How much longer than allowed a course is followed, to tell the fast from the lost, seconds.</summary>
    private const double Overtime = 2;

    /// <summary>No course is followed for longer, seconds: the longest fall.</summary>
    private const double LongestCourse = 30;

    /// <summary>A place that is farther than the running speed leads by this factor, and this much, is reached by no motion.</summary>
    private const double TeleportFactor = 2, TeleportLeast = 10;

    /// <summary>What a second that a course takes too long or too short is worth, and a round of guesses, metres.</summary>
    private const double CostOfTime = 0.05, CostOfRound = 0.01, CostOfQuantum = 0.02;

    /// <summary>The rounds of guesses that are looked at for every belief; the others for the likeliest two.</summary>
    private const int CheapRounds = 2, BeliefsInLaterRounds = 2;

    /// <summary>A message that took so much longer than the last one came late, seconds.</summary>
    private const double Late = 0.3;

    /// <summary>The beliefs that a second opinion looks at, and how near is near enough for it, metres.</summary>
    private const int BeliefsInSecondOpinion = 4;

    private const double Sure = 0.1;

    /// <summary>A course that misses by no more was the player's, metres.</summary>
    private const double Exact = 0.05;

    /// <summary>Second opinions had in a row, and how long it takes until one is there again, seconds: each costs a lot.</summary>
    private const double MostOpinions = 8, OpinionEvery = 2;

    private readonly RawMotionState keys = new();

    private ClaimVerdict JudgeWay(in Position to, bool stands, double now)
    {
        double available = Available(now), elapsed = Math.Max(0, now - lastTime), away = Position.HorizontalDistanceTo(to);
        double fastest = FastestOn(Position.OffsetTo(to));
        if (away > (TeleportFactor * fastest * Math.Min(available, LongestCourse)) + TeleportLeast)
            return Deny(ClaimReason.Teleport, now, away);
        if (engine.World.GetVisible(to.CellId) is null) return Deny(ClaimReason.NotLoaded, now, away);

        beliefs.BeginClaim();
        soft.Object.PassesChangedSince = engine.Now - options.MoversLag;
        foreach (ShadowBody shadow in shadows) shadow.MovedSince = engine.Now - options.MoversLag;
        Approach nearest = new(double.PositiveInfinity, 0, 0, beliefs.First.Seat, false, false);
        RefillDoubts(now);
        Way way = new(to, available, elapsed, away / fastest, now);
        bool isSlow = true;
        for (int k = 0; k < (HasFormerStats(now) ? 2 : 1) && beliefs.ExplanationCount == 0; k++)
        {
            weenie.SetStats(k == 0 ? stats : formerStats);
            isSlow &= Explain(way, ref nearest);
        }

        if (beliefs.ExplanationCount == 0 && opinions >= 1)
        {
            opinions--;
            isSlow &= ExplainFiner(way, ref nearest);
        }

        ClaimVerdict verdict = beliefs.ExplanationCount > 0
            ? Accept(to, stands, elapsed, available, now)
            : Doubt(way, stands) ?? DoubtNear(way, stands, nearest) ?? Object(to, stands, nearest, isSlow, now);
        weenie.SetStats(stats);
        return verdict;
    }

    /// <summary>Looks for courses that lead to a place in the time that there is.</summary>
    /// <returns>False when one leads there that takes longer.</returns>
    private bool Explain(in Way way, ref Approach nearest)
    {
        bool isSlow = true, isTouchy = false;
        for (int round = 0; round < Guess.Rounds.Length; round++)
        {
            (Guess[] guesses, float enough) = Guess.Rounds[round];
            bool isOpen = round < CheapRounds && (round == 0 || beliefs.ExplanationCount == 0);
            int count = isOpen ? beliefs.Count : Math.Min(beliefs.Count, BeliefsInLaterRounds);
            for (int i = 0; i < count; i++)
            {
                foreach (Guess guess in guesses)
                {
                    if (round == 0 && guess.Toggles && !beliefs[i].Walks) continue;
                    isSlow &= Try(way, i, guess, round, ref nearest, ref isTouchy);
                }
            }

            bool isEnough = beliefs.ExplanationCount > 0 && beliefs.Best.Approach.Miss <= enough;
            if (isEnough && !(round == 0 && isTouchy)) return isSlow;
        }

        return isSlow;
    }

    /// <summary>A second opinion: many more guesses, drawn by chance, for the likeliest beliefs; the first good one is enough.</summary>
    private bool ExplainFiner(in Way way, ref Approach nearest)
    {
        bool isSlow = true, isTouchy = false;
        int count = Math.Min(beliefs.Count, BeliefsInSecondOpinion);
        foreach (Guess guess in Guess.Finer)
        {
            for (int i = 0; i < count; i++) isSlow &= Try(way, i, guess, Guess.Rounds.Length, ref nearest, ref isTouchy);
            if (beliefs.ExplanationCount > 0 && beliefs.Best.Approach.Miss <= Sure) break;
        }

        return isSlow;
    }

    /// <summary>Follows a course, and keeps it when it leads there in time.</summary>
    /// <returns>False when it leads there, but takes longer.</returns>
    private bool Try(in Way way, int belief, Guess guess, int round, ref Approach nearest, ref bool isTouchy)
    {
        ShadowBody body = beliefs[belief];
        if ((guess.Toggles && !body.Moves) || (guess.Late && body.OnWalkable)) return true;
        if (guess.Drift is { } drift && way.Now > (drift.Side == SideDrift.None ? turnedAt : steppedAt) + options.DriftFor) return true;
        if (guess.Quantum == 0) guess = guess with { Quantum = beliefs.QuantumOf(belief) };
        CourseCount++;
        double longest = Math.Min(way.Available + Overtime, LongestCourse);
        Approach approach = course.Follow(body, way.To, longest, guess, TopSpeed, way.Elapsed);
        if (approach.Miss < nearest.Miss) nearest = approach;
        if (approach.Miss > (guess.Strays ? options.Tolerance / 2 : options.Tolerance)) return true;
        isTouchy |= approach.IsTouchy;

        // A way that was only guessed at may have been another one, at most as fast as the straight one: that is a doubt.
        double time = approach.Time;
        bool isCertain = round < CheapRounds && !guess.Toggles && approach.Miss <= Exact && !approach.Bounced;
        if (!isCertain && (time <= way.Available || doubts >= 1)) time = Math.Min(time, way.Shortest);
        if (time > way.Available) return false;
        double cost = CostOf(approach, way.Elapsed) + CostOf(guess, round, belief);
        beliefs.Add(new Explanation(cost, belief, guess, approach, time));
        return true;
    }

    private double CostOf(in Guess guess, int round, int belief) =>
        (round * CostOfRound) + (guess.Quantum == beliefs.QuantumOf(belief) ? 0 : CostOfQuantum);

    private static double CostOf(in Approach approach, double elapsed)
    {
        double off = approach.Time > elapsed ? approach.Time - elapsed : Math.Max(0, elapsed - approach.Until);
        return approach.Miss + (CostOfTime * off);
    }

    private ClaimVerdict Accept(in Position to, bool stands, double elapsed, double available, double now)
    {
        Approach best = beliefs.Best.Approach;
        Contact? ground = stands ? FootingOf(best.Seat, to) ?? FootingAt(to) ?? FootingSoon(to) ?? FootingInDoubt(to) : null;
        if (stands && ground is null) return Deny(ClaimReason.InTheAir, now, best.Miss);

        // Who is in the air cannot take his time: the shadow has fallen by now, and he with it.
        double time = beliefs.ShortestTime;
        airLag = stands ? 0 : airLag + elapsed - best.Time;
        if (airLag > options.Slack + options.Burst)
        {
            double gap = course.After(beliefs.First, airLag - options.Slack - options.Burst).DistanceTo(to);
            if (gap > options.CorrectWithin) return Deny(ClaimReason.InTheAir, now, gap);
        }

        if (best.Time > available) doubts = Math.Max(0, doubts - 1);
        Pay(time, elapsed, available, now);
        beliefs.Settle(to, ground, elapsed, TopSpeed);
        return new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, to, (float)best.Miss);
    }

    private void RefillDoubts(double now)
    {
        double passed = Math.Max(0, now - doubtTime);
        doubts = Math.Min(options.MostDoubts, doubts + (passed / options.DoubtEvery));
        opinions = Math.Min(MostOpinions, opinions + (passed / OpinionEvery));
        doubtTime = Math.Max(doubtTime, now);
    }

    private ClaimVerdict Object(in Position to, bool stands, in Approach nearest, bool isSlow, double now)
    {
        BodySeat begin = beliefs.First.Seat;
        bool hasFooting = stands && FootingAt(to) is not null;
        bool isFree = IsFree(begin.Position, to, hasFooting ? ContactOf(begin) : null);
        if (stands && !hasFooting && isFree) return Deny(ClaimReason.InTheAir, now, nearest.Miss);
        if (!isSlow) return Deny(ClaimReason.TooFast, now, nearest.Miss);
        bool isHigh = !stands && (nearest.Seat.Position.OffsetTo(to).Z > nearest.Miss / 2 || (!OnWalkable && IsHigh(to)));
        ClaimReason reason = !isFree ? ClaimReason.ThroughWall : isHigh ? ClaimReason.TooHigh : ClaimReason.OffCourse;
        if (nearest.Miss > options.CorrectWithin) return Deny(reason, now, nearest.Miss);
        PassTime(now);
        beliefs.Collapse();
        beliefs.First.SeatAt(nearest.Seat);
        return new ClaimVerdict(ClaimOutcome.Corrected, reason, Position, (float)nearest.Miss);
    }

    private bool IsHigh(in Position to)
    {
        Vector3 gap = Position.OffsetTo(to);
        double away = new Vector2(gap.X, gap.Y).Length();
        for (int i = 0; i < beliefs.Count; i++)
            if (gap.Z <= HighestOn(beliefs[i], away, bySlope: false) + options.Tolerance) return false;
        return true;
    }

    private ClaimVerdict Deny(ClaimReason reason, double now, double miss)
    {
        PassTime(now);
        return new ClaimVerdict(ClaimOutcome.Refused, reason, Position, (float)miss);
    }

    /// <summary>
    /// How much time of movement may have passed at the player's: what passed here, and what is to its credit. Credit above the slack, as
    /// a pause or a stop of the network leaves it, is good for the messages that come in a bunch after that, and melts away.
    /// </summary>
    private double Available(double now)
    {
        double elapsed = Math.Max(0, now - lastTime);
        double melts = Math.Max(0, now - Math.Max(lastTime, lateAt + options.BurstHolds));
        double melting = Math.Min(melts, Math.Max(0, credit - options.Slack));
        return credit - melting + (elapsed * (1 + options.ClockDrift));
    }

    /// <summary>The time of a movement is paid from what there is.</summary>
    private void Pay(double time, double elapsed, double available, double now)
    {
        credit = Math.Min(options.Slack + options.Burst, Math.Max(0, available - time));
        lastTime = Math.Max(lastTime, now);
        if (elapsed - time > Late) lateAt = now;
    }

    private void PassTime(double now)
    {
        credit = Math.Min(options.Slack + options.Burst, Available(now));
        lastTime = Math.Max(lastTime, now);
    }

    private double TopSpeed => MovementFormulas.RunSpeed * (double)Math.Max(
        stats.RunRate(options.TopSpeedRule), formerStats.RunRate(options.TopSpeedRule));

    /// <summary>That of who steps sideways while running.</summary>
    private double FastestSpeed => double.Hypot(TopSpeed, ShadowBody.FastestSidestep);

    /// <summary>What nobody is faster than on a way: slopes turn a fall into speed.</summary>
    private double FastestOn(Vector3 gap)
    {
        double speed = Math.Max(FastestSpeed, beliefs.First.Seat.Velocity.Length());
        return Math.Sqrt((speed * speed) + Math.Max(0, 2 * (double)PhysicsBody.Gravity * gap.Z));
    }

    private bool HasFormerStats(double now) => statsChanged + options.StatsGrace >= now;

    /// <summary>A way that is claimed.</summary>
    /// <param name="To">Where to.</param>
    /// <param name="Available">Time that it may have taken, seconds.</param>
    /// <param name="Elapsed">Time since the last claim, seconds.</param>
    /// <param name="Shortest">The least time in which anyone gets so far, seconds.</param>
    /// <param name="Now">When it is heard of, seconds.</param>
    private readonly record struct Way(Position To, double Available, double Elapsed, double Shortest, double Now);
}
