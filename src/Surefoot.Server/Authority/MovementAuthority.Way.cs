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

    /// <summary>A floor that a body may have sunk into by a rounding, metres.</summary>
    private const float Rounding = 0.02f;

    /// <summary>A body that is where it lands has landed after so many quanta.</summary>
    private const int QuantaToLand = 4;

    /// <summary>Where the shadow stands there is ground for one who is a stair higher or lower, metres.</summary>
    private const float AboutAStep = 0.35f;

    /// <summary>Time owed that may be forgiven at once, seconds, and how many doubts that costs.</summary>
    private const double TimeForgiven = 1.5, DoubtsForTime = 2;

    /// <summary>How far ahead a wall is looked for, metres.</summary>
    private const float WallReach = 0.3f;

    /// <summary>How far back a wall may push a body that runs into it, metres.</summary>
    private const double Back = 0.3;

    /// <summary>Who stands on an edge has something so far below, metres.</summary>
    private const float OverAnEdge = 0.5f;

    private readonly RawMotionState keys = new();

    private ClaimVerdict JudgeWay(in Position to, bool stands, double now)
    {
        double available = Available(now), elapsed = Math.Max(0, now - lastTime), away = Position.HorizontalDistanceTo(to);
        if (away > (TeleportFactor * TopSpeed * Math.Min(available, LongestCourse)) + TeleportLeast)
            return Deny(ClaimReason.Teleport, now, away);
        if (engine.World.GetVisible(to.CellId) is null) return Deny(ClaimReason.NotLoaded, now, away);

        beliefs.BeginClaim();
        Approach nearest = new(double.PositiveInfinity, 0, 0, beliefs.First.Seat, false);
        bool isSlow = true;
        for (int k = 0; k < (HasFormerStats(now) ? 2 : 1) && beliefs.ExplanationCount == 0; k++)
        {
            weenie.SetStats(k == 0 ? stats : formerStats);
            isSlow &= Explain(to, available, elapsed, now, ref nearest);
        }

        // What was taken for a walk may have been a run: some time that is owed is forgiven, now and then.
        RefillDoubts(now);
        if (beliefs.ExplanationCount == 0 && !isSlow && doubts >= DoubtsForTime)
        {
            Explain(to, available + TimeForgiven, elapsed, now, ref nearest);
            if (beliefs.ExplanationCount > 0) doubts -= DoubtsForTime;
        }

        ClaimVerdict verdict = beliefs.ExplanationCount > 0
            ? Accept(to, stands, elapsed, available, now)
            : Doubt(to, stands, available, now) ?? Object(to, stands, nearest, isSlow, now);
        weenie.SetStats(stats);
        return verdict;
    }

    /// <summary>Looks for courses that lead to a place in the time that there is.</summary>
    /// <returns>False when one leads there that takes longer.</returns>
    private bool Explain(in Position to, double available, double elapsed, double now, ref Approach nearest)
    {
        bool isSlow = true, isTouchy = false;
        for (int round = 0; round < Guess.Rounds.Length; round++)
        {
            (Guess[] guesses, float enough) = Guess.Rounds[round];
            int count = round < CheapRounds ? beliefs.Count : Math.Min(beliefs.Count, BeliefsInLaterRounds);
            for (int i = 0; i < count; i++)
            {
                ShadowBody body = beliefs[i];
                foreach (Guess one in guesses)
                {
                    if ((one.Toggles && !body.Moves) || (one.Late && body.OnWalkable)) continue;
                    if (round == 0 && one.Toggles && !body.Walks) continue;
                    if (one.Drift is { } drift && now > (drift.Side == SideDrift.None ? turnedAt : steppedAt) + options.DriftFor) continue;
                    Guess guess = one.Quantum == 0 ? one with { Quantum = beliefs.QuantumOf(i) } : one;
                    CourseCount++;
                    Approach approach = course.Follow(body, to, Math.Min(available + Overtime, LongestCourse), guess, TopSpeed, elapsed);
                    if (approach.Miss < nearest.Miss) nearest = approach;
                    if (approach.Miss > (guess.Strays ? options.Tolerance / 2 : options.Tolerance)) continue;
                    isTouchy |= approach.IsTouchy;
                    if (approach.Time > available) isSlow = false;
                    else beliefs.Add(new Explanation(CostOf(approach, elapsed) + CostOf(guess, round, i), i, guess, approach));
                }
            }

            bool isEnough = beliefs.ExplanationCount > 0 && beliefs.Best.Approach.Miss <= enough;
            if (isEnough && !(round == 0 && isTouchy)) break;
        }

        return isSlow;
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
        if (airLag > options.Burst)
        {
            double gap = course.After(beliefs.First, airLag - options.Burst).DistanceTo(to);
            if (gap > options.CorrectWithin) return Deny(ClaimReason.InTheAir, now, gap);
        }

        credit = Math.Min(options.Slack + options.Burst, Math.Max(0, available - time));
        lastTime = Math.Max(lastTime, now);
        beliefs.Settle(to, ground, elapsed, TopSpeed);
        return new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, to, (float)best.Miss);
    }

    /// <summary>
    /// A claim that no course leads to is believed now and then: when one can go straight there, at most across where the body was going,
    /// in the time that there is, and no higher than it flies.
    /// </summary>
    private ClaimVerdict? Doubt(in Position to, bool stands, double available, double now)
    {
        if (doubts < 1) return null;
        ShadowBody body = beliefs.First;
        BodySeat begin = body.Seat;
        Vector3 way = begin.Position.OffsetTo(to), across = way with { Z = 0 };
        double time = across.Length() / TopSpeed;
        if (time > available || Vector3.Dot(across, body.Going) < -Back * body.Going.Length()) return null;
        Contact? ground = stands ? FootingAt(to) : null;
        if (stands && ground is null) return null;
        Vector3 velocity = begin.Velocity;
        bool flies = !body.OnWalkable;
        if (flies || !stands)
        {
            // As high as it is on its flight after the least time, or at the top of it when that comes later.
            double at = Math.Max(time, velocity.Z / -PhysicsBody.Gravity), rise = (velocity.Z * at) + (PhysicsBody.Gravity * at * at / 2);
            if (way.Z > rise + options.Tolerance) return null;
        }

        Contact? contact = flies || !stands ? null : ContactOf(begin);
        if (!IsFree(begin.Position, to, contact) && (stands || !IsFreeAbove(begin.Position, to))) return null;
        doubts--;
        credit = Math.Min(options.Slack + options.Burst, available - time);
        lastTime = Math.Max(lastTime, now);
        double fall = velocity.Z + (PhysicsBody.Gravity * time);
        beliefs.Guess(to, ground, stands
            ? [Vector3.Zero]
            : [velocity with { Z = (float)fall }, new Vector3(0, 0, (float)fall), Vector3.Zero, velocity]);
        return new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, to, options.Tolerance);
    }

    /// <summary>Normal of the wall that the player would slide along next, or null.</summary>
    private Vector3? WallAhead()
    {
        ShadowBody body = beliefs.First;
        Vector3 way = body.Going with { Z = 0 };
        if (way.LengthSquared() < WallReach) return null;
        Position to = body.Position;
        to.Frame.Origin += WallReach * Vector3.Normalize(way);
        SweepResult ahead = query.Sweep(new SweepInput(soft, body.Position, to) { Contact = ContactOf(body.Seat) });
        return ahead.SlidingNormal ?? (ahead.CollisionNormal is { } met && met.Z < WallReach ? met : null);
    }

    private bool IsFree(in Position begin, in Position to, in Contact? contact)
    {
        SweepResult way = query.Sweep(new SweepInput(soft, begin, to) { Contact = contact });
        return way.Found && way.Position.DistanceTo(to) <= options.Tolerance;
    }

    /// <summary>First up, then across: a body that jumps against a wall rises along it.</summary>
    private bool IsFreeAbove(in Position begin, in Position to)
    {
        Position above = begin;
        above.Frame.Origin.Z = to.Frame.Origin.Z;
        return IsFree(begin, above, null) && IsFree(above, to, null);
    }

    private void RefillDoubts(double now)
    {
        doubts = Math.Min(options.MostDoubts, doubts + (Math.Max(0, now - doubtTime) / options.DoubtEvery));
        doubtTime = Math.Max(doubtTime, now);
    }

    private ClaimVerdict Object(in Position to, bool stands, in Approach nearest, bool isSlow, double now)
    {
        if (stands && FootingAt(to) is null) return Deny(ClaimReason.InTheAir, now, nearest.Miss);
        if (!isSlow) return Deny(ClaimReason.TooFast, now, nearest.Miss);
        ClaimReason reason = ReasonOf(to, stands, nearest);
        if (nearest.Miss > options.CorrectWithin) return Deny(reason, now, nearest.Miss);
        PassTime(now);
        beliefs.Collapse();
        beliefs.First.SeatAt(nearest.Seat);
        return new ClaimVerdict(ClaimOutcome.Corrected, reason, Position, (float)nearest.Miss);
    }

    private ClaimVerdict Deny(ClaimReason reason, double now, double miss)
    {
        PassTime(now);
        return new ClaimVerdict(ClaimOutcome.Refused, reason, Position, (float)miss);
    }

    private ClaimReason ReasonOf(in Position to, bool stands, in Approach nearest)
    {
        BodySeat begin = beliefs.First.Seat;
        if (!IsFree(begin.Position, to, ContactOf(begin))) return ClaimReason.ThroughWall;
        return !stands && nearest.Seat.Position.OffsetTo(to).Z > options.Tolerance ? ClaimReason.TooHigh : ClaimReason.OffCourse;
    }

    /// <summary>
    /// How much time of movement may have passed at the player's: what passed here, and what is to its credit. Credit above the slack, as
    /// a pause or a stop of the network leaves it, is good for the messages that come in a bunch after that, and melts away.
    /// </summary>
    private double Available(double now)
    {
        double elapsed = Math.Max(0, now - lastTime);
        double melting = Math.Min(elapsed, Math.Max(0, credit - options.Slack));
        return credit - melting + (elapsed * (1 + options.ClockDrift));
    }

    private void PassTime(double now)
    {
        credit = Math.Min(options.Slack + options.Burst, Available(now));
        lastTime = Math.Max(lastTime, now);
    }

    private double TopSpeed => MovementFormulas.RunSpeed * (double)Math.Max(
        stats.RunRate(options.TopSpeedRule), formerStats.RunRate(options.TopSpeedRule));

    private bool HasFormerStats(double now) => statsChanged + options.StatsGrace >= now;

    /// <summary>What one can stand on at a place: where the shadow stands there is ground, and where a body falls onto it.</summary>
    private Contact? FootingAt(in Position place)
    {
        Position raised = place;
        raised.Frame.Origin.Z += Rounding;
        return FootingOf(soft, place) ?? FootingOf(soft, raised) ?? FootingOf(solid, place);
    }

    private static Contact? FootingOf(in BodySeat seat, in Position place) =>
        (seat.Transient & TransientState.OnWalkable) != 0 && Math.Abs(seat.Position.OffsetTo(place).Z) <= AboutAStep
            ? ContactOf(seat)
            : null;

    /// <summary>
    /// One may stand on the edge of something that nobody falls onto; now and then that is believed where something is near.
    /// </summary>
    private Contact? FootingInDoubt(in Position place)
    {
        if (doubts < 1 || !query.ProbeDown(new ProbeDownInput(soft, place, OverAnEdge)).Found) return null;
        doubts--;
        return new Contact(new Plane(0, 0, 1, -place.Frame.Origin.Z), place.CellId);
    }

    /// <summary>A shadow that is about to land there finds what it lands on: an edge that no body falls onto from straight above.</summary>
    private Contact? FootingSoon(in Position place)
    {
        for (int i = 0; i < beliefs.ExplanationCount; i++)
        {
            Explanation one = beliefs.ExplanationAt(i);
            probe.CopyFrom(beliefs[one.Belief], one.Guess.PassesBodies);
            Course.Take(probe, place, one.Approach.Time, one.Guess, TopSpeed);
            for (int quantum = 0; quantum < QuantaToLand && probe.HasCell; quantum++)
            {
                if (FootingOf(probe.Seat, place) is { } found) return found;
                probe.Step(one.Guess.Quantum);
            }
        }

        return null;
    }

    private Contact? FootingOf(Mover mover, in Position place)
    {
        ProbeDownResult below = query.ProbeDown(new ProbeDownInput(mover, place, options.StandWithin));
        if (below is { Found: true, Contact: { IsWalkable: true } contact }) return contact;
        PlaceResult placed = query.Place(new PlaceInput(mover, place, Slides: false));
        return placed is { Found: true, Contact: { IsWalkable: true } floor } && placed.Position.DistanceTo(place) <= options.StandWithin
            ? floor
            : null;
    }

    private static Contact? ContactOf(in BodySeat seat) => (seat.Transient & TransientState.Contact) != 0 && seat.ContactPlaneCellId != 0
        ? new Contact(seat.ContactPlane, seat.ContactPlaneCellId, (seat.Transient & TransientState.WaterContact) != 0)
        : null;
}
