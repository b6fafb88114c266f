using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>How near a course came to a place.</summary>
/// <param name="Miss">By how much it missed it, metres.</param>
/// <param name="Time">When it came there, seconds from its begin.</param>
/// <param name="Until">How long it stayed there, seconds from its begin; infinite for one that rests there.</param>
/// <param name="Seat">The body's state when it was nearest.</param>
/// <param name="IsTouchy">The course went through the air or over a slope: what comes after it hangs on how time is divided.</param>
/// <param name="Bounced">Until then something had thrown the body back, or it had landed: small differences have grown large there.</param>
internal readonly record struct Approach(double Miss, double Time, double Until, BodySeat Seat, bool IsTouchy, bool Bounced);

/// <summary>Courses that a body may take from where it is, and how near to a place they lead. The body itself stays where it is.</summary>
/// <param name="probe">What is sent ahead in its place.</param>
internal sealed class Course(ShadowBody probe)
{
    /// <summary>Nearer than this is there, metres.</summary>
    internal const double There = 0.02;

    /// <summary>So much nearer is worth more time, metres.</summary>
    private const double Nearer = 0.01;

    /// <summary>What comes nearer only a second later, as a body that turns in circles does, must come nearer by this, metres.</summary>
    private const double Patience = 0.1;

    /// <summary>A place that is passed closely at first is not waited for again for longer, seconds.</summary>
    private const double LongestSearch = 1;

    /// <summary>A body on the ground that goes straight ahead and has got so much farther again does not come back, metres.</summary>
    private const double GoneBy = 3;

    /// <summary>So many quanta without a move are the end of a course.</summary>
    private const int QuantaAtRest = 4;

    /// <summary>In the air a velocity that changes across by so much was changed by something, m/s.</summary>
    private const float Thrown = 0.01f;

    private const float LeastTime = 1f / 30;

    /// <summary>Follows a course.</summary>
    /// <param name="body">Whose course.</param>
    /// <param name="to">The place.</param>
    /// <param name="seconds">How long.</param>
    /// <param name="guess">What is not known of it.</param>
    /// <param name="speed">About how fast the body goes, m/s: when it turns as the headings say.</param>
    /// <param name="patience">How long to look whether the body stays there, seconds.</param>
    internal Approach Follow(ShadowBody body, in Position to, double seconds, in Guess guess, double speed, double patience)
    {
        probe.CopyFrom(body, guess.PassesMovers);
        Walk walk = Begin(probe, to, guess, speed);
        Vector3 before = probe.Position.OffsetTo(to);
        double best = before.Length(), bestTime = 0, until = 0;
        BodySeat seat = probe.Seat;
        bool touchy = probe.IsTouchy, bounces = false, bounced = false;
        int rest = 0;
        while (walk.Time < seconds)
        {
            bool there = best <= There;
            if (there && !guess.Late && !(walk.Time < patience && until == walk.Time)) break;
            double time = walk.Time;
            Vector3 velocity = probe.Seat.Velocity;
            bool flew = !probe.OnWalkable;
            walk.Step(guess.Quantum);
            if (!probe.HasCell) break;
            touchy |= probe.IsTouchy;
            bounces |= flew && Math.Abs(probe.Seat.Velocity.X - velocity.X) + Math.Abs(probe.Seat.Velocity.Y - velocity.Y) > Thrown;
            bounces |= flew && probe.OnWalkable;
            Vector3 after = probe.Position.OffsetTo(to), moved = before - after;
            double share = Nearest(before, moved), miss = (before - ((float)share * moved)).Length();
            bool again = guess.Late && miss <= Math.Max(best, There) + Nearer && until < time;
            bool better = miss + (Patience * (time - bestTime)) < best - Nearer;
            if (again || better || (!there && miss <= There && time - bestTime < LongestSearch))
            {
                (best, bestTime, seat, bounced) = (miss, time + (share * (walk.Time - time)), probe.Seat, bounces);
                until = share == 1 ? walk.Time : bestTime;
            }
            else if (until == time && after.Length() <= best + Nearer)
            {
                until = walk.Time;
            }

            bool turns = guess.Steers || probe.Turns || guess.Toggles;
            rest = moved.LengthSquared() < 1e-8f && probe.OnWalkable && !turns ? rest + 1 : 0;
            if (rest == QuantaAtRest)
            {
                if (until == walk.Time) until = double.PositiveInfinity;
                break;
            }

            if (probe.OnWalkable && !turns && miss > best + GoneBy) break;
            before = after;
        }

        return new Approach(best, bestTime, until, seat, touchy, bounced);
    }

    /// <summary>
    /// A body takes a course itself for a time, in whole quanta on the ground: what is claimed is so between two of them. In the air its
    /// velocity follows from the time itself.
    /// </summary>
    /// <param name="body">The body.</param>
    /// <param name="to">Where it is to be in the end.</param>
    /// <param name="seconds">How long it takes.</param>
    /// <param name="guess">What is not known of it.</param>
    /// <param name="speed">About how fast it goes, m/s.</param>
    /// <param name="whole">In whole quanta in the air as well: what it touches in the last one throws it back.</param>
    internal static void Take(ShadowBody body, in Position to, double seconds, in Guess guess, double speed, bool whole = false)
    {
        Walk walk = Begin(body, to, guess, speed);
        while (body.HasCell && seconds - walk.Time > guess.Quantum / (whole || body.OnWalkable ? 2 : 1)) walk.Step(guess.Quantum);
        double rest = seconds - walk.Time;
        if (rest > 0 && body is { HasCell: true, OnWalkable: false }) body.Fall(rest);
    }

    /// <summary>Where a body would be after a time.</summary>
    internal Position After(ShadowBody body, double seconds)
    {
        probe.CopyFrom(body, passesMovers: false);
        for (double time = 0; time < seconds && probe.HasCell; time += LeastTime) probe.Step(LeastTime);
        return probe.Position;
    }

    private static Walk Begin(ShadowBody who, in Position to, in Guess guess, double speed)
    {
        Position place = who.Position;
        double heading = place.Frame.Heading;
        if (guess.Strays)
        {
            place.Frame.Origin = place.Frame.LocalToGlobal(new Vector3(guess.Aside, 0, guess.Raised));
            place.Frame.SetHeading((float)((heading + guess.Turned + 360) % 360));
            who.SeatAt(who.Seat with { Position = place });
        }

        if (guess.Afresh) who.Refresh();
        double turn = guess.Steers || guess.Drift is not null ? TurnTo(who, to, nearer: guess.Drift is not null) : 0;
        double duration = Math.Max(who.Position.DistanceTo(to) / speed, LeastTime);
        if (guess.Drift is { } drift)
        {
            // Twice: how long it takes hangs on how fast the body goes.
            who.Set(drift, 0);
            double own = who.Going.Length();
            if (own > 0) duration = Math.Max(who.Position.DistanceTo(to) / own, LeastTime);
            who.Set(drift, -turn * Math.PI / 180 / duration);
        }

        return new Walk(who, guess, heading, turn, duration);
    }

    /// <summary>Degrees to the right from the heading of the begin to that of the place, the way the keys turn, or the short way.</summary>
    private static double TurnTo(ShadowBody who, in Position to, bool nearer)
    {
        double turn = (to.Frame.Heading - who.Position.Frame.Heading + 720) % 360;
        if (nearer) return turn > 180 ? turn - 360 : turn;
        return who.TurnKey switch
        {
            MotionCommand.TurnRight => turn,
            MotionCommand.TurnLeft => turn - 360,
            _ => turn > 180 ? turn - 360 : turn,
        };
    }

    /// <summary>The share of a move at which it is nearest to a place.</summary>
    /// <param name="gap">From the move's begin to the place.</param>
    /// <param name="move">The move.</param>
    private static double Nearest(Vector3 gap, Vector3 move)
    {
        double length = move.LengthSquared();
        return length > 0 ? Math.Clamp(Vector3.Dot(gap, move) / length, 0, 1) : 0;
    }

    /// <summary>A course under way.</summary>
    private struct Walk(ShadowBody who, Guess guess, double heading, double turn, double duration)
    {
        private int toggles, steps;
        private bool turnedBack = guess.Turned == 0;

        internal double Time { get; private set; }

        internal void Step(float quantum)
        {
            if (Time >= (toggles == 0 ? guess.TogglesAt : toggles == 1 ? guess.TogglesBackAt : double.PositiveInfinity))
            {
                who.ToggleRun();
                toggles++;
            }

            if (!turnedBack && Time >= Guess.TurnsBackAfter)
            {
                turnedBack = true;
                who.SetHeading((float)((who.Position.Frame.Heading - guess.Turned + 720) % 360));
            }

            if (guess.Steers) who.SetHeading((float)((heading + (turn * Math.Min(1, Time / duration)) + 720) % 360));
            if (guess.LongEvery > 0 && ++steps % guess.LongEvery == 0) quantum *= 1.5f;
            who.Step(quantum);
            Time += quantum;
        }
    }
}
