using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>One way in which a claim may have come about.</summary>
/// <param name="Cost">The less, the likelier.</param>
/// <param name="Belief">From which belief.</param>
/// <param name="Guess">By which guess, with the quantum that it has.</param>
/// <param name="Approach">How near it came.</param>
/// <param name="Time">The least time that the player needed for it, seconds.</param>
internal readonly record struct Explanation(double Cost, int Belief, Guess Guess, Approach Approach, double Time);

/// <summary>
/// What a player's body may be doing: usually one belief, more where the claims so far allow several, because a client does not tell how it
/// divides time, nor of its walk key, nor whether a jump is still rising. All are at the same place, the likeliest first.
/// </summary>
internal sealed class Beliefs
{
    /// <summary>Most beliefs kept.</summary>
    private const int Most = 12;

    /// <summary>Most explanations kept of one kind: with and without the walk key, rising and falling.</summary>
    private const int MostOfAKind = 6;

    /// <summary>A speed upwards that lifts a body off the ground for its next quantum, m/s.</summary>
    internal const float Hop = 0.3f;

    private const float FirstQuantum = 1f / 30;

    private readonly Explanation[] explanations = new Explanation[Most];
    private (ShadowBody Body, float Quantum)[] now, next;

    private readonly ShadowBody probe;

    internal Beliefs(Func<ShadowBody> make, ShadowBody probe)
    {
        this.probe = probe;
        now = [.. Enumerable.Range(0, Most).Select(_ => (make(), FirstQuantum))];
        next = [.. Enumerable.Range(0, Most).Select(_ => (make(), FirstQuantum))];
        Count = 1;
    }

    /// <summary>Number of beliefs.</summary>
    internal int Count { get; private set; }

    /// <summary>The likeliest one.</summary>
    internal ShadowBody First => now[0].Body;

    /// <summary>Number of explanations of the claim that is looked at.</summary>
    internal int ExplanationCount { get; private set; }

    /// <summary>The likeliest explanation; only when there is one.</summary>
    internal Explanation Best => explanations[0];

    internal Explanation ExplanationAt(int index) => explanations[index];

    internal ShadowBody this[int index] => now[index].Body;

    /// <summary>Length of the client's quantum by a belief, seconds.</summary>
    internal float QuantumOf(int index) => now[index].Quantum;

    /// <summary>Forgets all but the first.</summary>
    internal void Collapse() => Count = 1;

    /// <summary>Another claim is looked at.</summary>
    internal void BeginClaim() => ExplanationCount = 0;

    /// <summary>The shortest time that any likely explanation takes, seconds.</summary>
    internal double ShortestTime
    {
        get
        {
            double time = explanations[0].Time;
            for (int i = 1; i < ExplanationCount; i++) time = Math.Min(time, explanations[i].Time);
            return time;
        }
    }

    /// <summary>
    /// The place claimed is believed although no explanation leads there: it stands there, or is in the air with one of some velocities.
    /// </summary>
    internal void Guess(in Position to, in Contact? ground, ReadOnlySpan<Vector3> velocities)
    {
        probe.CopyFrom(now[0].Body, passesMovers: false);
        float quantum = now[0].Quantum;
        probe.Put(to, ground, Landing.Still);
        int count = 0;
        foreach (Vector3 velocity in velocities)
        {
            for (int afresh = 0; afresh < 2 && count < Most; afresh++)
            {
                ShadowBody body = next[count].Body;
                body.CopyFrom(probe, passesMovers: false);
                if (afresh == 1) body.Refresh();
                body.SeatAt(body.Seat with { Velocity = velocity });
                next[count].Quantum = quantum;
                if (!IsKnown(body, count)) count++;
            }
        }

        (now, next, Count) = (next, now, count);
    }

    /// <summary>
    /// A jump against a wall hangs on whether the body was sliding along that in its last quantum, which no message says: all of it is
    /// believed.
    /// </summary>
    /// <param name="walls">Normals of the walls, on the level.</param>
    internal void ForkByWalls(ReadOnlySpan<Vector3> walls)
    {
        int count = Count;
        for (int i = 0; i < count; i++)
        {
            BodySeat seat = now[i].Body.Seat;
            if (seat.SlidingNormal != Vector3.Zero) Fork(i, seat with { Transient = seat.Transient ^ TransientState.Sliding });
            Fork(i, seat with { Transient = seat.Transient & ~TransientState.Sliding, SlidingNormal = Vector3.Zero });
            foreach (Vector3 wall in walls)
                Fork(i, seat with { Transient = seat.Transient | TransientState.Sliding, SlidingNormal = wall });
        }
    }

    private void Fork(int index, in BodySeat seat)
    {
        if (Count == Most) return;
        ShadowBody body = now[Count].Body;
        body.CopyFrom(now[index].Body, passesMovers: false);
        body.SeatAt(seat);
        now[Count].Quantum = now[index].Quantum;
        for (int i = 0; i < Count; i++)
            if (body.IsLike(now[i].Body)) return;
        Count++;
    }

    /// <summary>Keeps an explanation when it is among the likeliest.</summary>
    internal void Add(in Explanation one)
    {
        int worst = -1, ofThisKind = 0;
        for (int i = 0; i < ExplanationCount; i++)
        {
            if (KindOf(explanations[i].Guess) != KindOf(one.Guess)) continue;
            (worst, ofThisKind) = (i, ofThisKind + 1);
        }

        bool isFull = ofThisKind == MostOfAKind;
        if (!isFull && ExplanationCount == Most) (worst, isFull) = (Most - 1, true);
        if (isFull && explanations[worst].Cost <= one.Cost) return;
        int at = isFull ? worst : ExplanationCount++;
        for (; at > 0 && one.Cost < explanations[at - 1].Cost; at--) explanations[at] = explanations[at - 1];
        explanations[at] = one;
    }

    private static int KindOf(in Guess guess) => (guess.Late ? 1 : 0) + (guess.Toggles ? 2 : 0);

    /// <summary>The claim is believed: each explanation becomes a belief, but for those that come out the same.</summary>
    /// <param name="to">The place claimed.</param>
    /// <param name="ground">What is stood on there; null in the air.</param>
    /// <param name="elapsed">Time since the last claim, seconds.</param>
    /// <param name="speed">Running speed, m/s.</param>
    internal void Settle(in Position to, in Contact? ground, double elapsed, double speed)
    {
        int count = 0;
        for (int i = 0; i < ExplanationCount; i++)
        {
            count = Settle(explanations[i], to, ground, elapsed, speed, whole: false, count);
            if (ground is null && count < Most) count = Settle(explanations[i], to, ground, elapsed, speed, whole: true, count);
            if (count == Most) break;
        }

        if (ground is not null && explanations[0].Approach.IsTouchy) count = AddHop(count);
        (now, next, Count) = (next, now, count);
    }

    private int Settle(
        in Explanation one, in Position to, in Contact? ground, double elapsed, double speed, bool whole, int count)
    {
        ShadowBody body = next[count].Body;
        body.CopyFrom(now[one.Belief].Body, one.Guess.PassesMovers);
        Course.Take(body, to, Math.Max(one.Approach.Time, Math.Min(elapsed, one.Approach.Until)), one.Guess, speed, whole);
        if (!body.HasCell) body.CopyFrom(now[one.Belief].Body, passesMovers: false);
        bool lands = ground is not null && !body.OnWalkable;
        if (lands) probe.CopyFrom(body, passesMovers: false);
        Landing last = !lands ? Landing.Bounced : body.Seat.Velocity.Z > 0 ? Landing.Whole : Landing.Still;
        for (Landing landing = Landing.Bounced; landing <= last && count < Most; landing++)
        {
            body = next[count].Body;
            if (landing != Landing.Bounced) body.CopyFrom(probe, passesMovers: false);
            body.Put(to, ground, landing);
            next[count].Quantum = one.Guess.Quantum;
            if (!IsKnown(body, count)) count++;
        }

        return count;
    }

    /// <summary>Who stands there may just have landed, and hop once more: as fast as the keys want, whatever it was before.</summary>
    private int AddHop(int count)
    {
        if (count == Most) return count;
        ShadowBody body = next[count].Body;
        body.CopyFrom(next[0].Body, passesMovers: false);
        body.SeatAt(body.Seat with { Velocity = new Vector3(0, 0, Hop) });
        next[count].Quantum = next[0].Quantum;
        return IsKnown(body, count) ? count : count + 1;
    }

    private bool IsKnown(ShadowBody body, int count)
    {
        for (int i = 0; i < count; i++)
            if (body.IsLike(next[i].Body)) return true;
        return false;
    }
}
