using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <content>The benefit of the doubt: what is believed now and then although no course leads there.</content>
public sealed partial class MovementAuthority
{
    /// <summary>Twice what pulls down, m/s².</summary>
    private const double Twice = -2 * (double)PhysicsBody.Gravity;

    /// <summary>How far away a wall is looked for, metres; how far from upright it is, and what speed against it counts, m/s.</summary>
    private const float WallReach = 0.3f, SteepestWall = 0.3f, SameWall = 0.02f, SlowestAgainstWall = 0.5f;

    /// <summary>How far beside a place a slope may be that has thrown a body there, metres, and what is no wall but a slope.</summary>
    private const float SlopeReach = 0.8f, LeastSlope = 0.05f;

    /// <summary>How far back a wall may push a body that runs into it, metres.</summary>
    private const double Back = 0.3;

    /// <summary>The share of a way by which something that throws a body back may lead it astray.</summary>
    private const double ShareLedAstray = 0.2;

    /// <summary>
    /// A claim that no course leads to is believed now and then: when one can go straight there, at most across where the body was going,
    /// in the time that there is, and no higher than it flies.
    /// </summary>
    private ClaimVerdict? Doubt(in Way way, bool stands)
    {
        if (doubts < 1 || way.Shortest > way.Available) return null;
        Contact? ground = stands ? FootingAt(way.To) : null;
        if (stands && ground is null) return null;
        bool bySlope = IsBySlope(Position) || IsBySlope(way.To);
        for (int i = 0; i < beliefs.Count; i++)
        {
            ShadowBody body = beliefs[i];
            BodySeat begin = body.Seat;
            Vector3 gap = begin.Position.OffsetTo(way.To), across = gap with { Z = 0 };
            if (!bySlope && !IsAhead(body, across, way.To)) continue;
            bool mayRise = !body.OnWalkable || !stands;
            if (mayRise && gap.Z > HighestOn(body, across.Length(), bySlope) + options.Tolerance) continue;
            double rising = Math.Max(0, begin.Velocity.Z), apex = bySlope ? HighestBySlope(begin) : rising * rising / Twice;
            bool isFree = IsFree(begin.Position, way.To, mayRise ? null : ContactOf(begin)) ||
                (mayRise && (IsFreeOver(begin.Position, way.To, gap.Z) || IsFreeOver(begin.Position, way.To, apex)));
            if (!isFree) continue;
            double level = new Vector2(begin.Velocity.X, begin.Velocity.Y).Length(), flown = across.Length() / level;
            bool flew = !body.OnWalkable && !bySlope && flown > way.Shortest && flown < way.Available;
            float down = (float)(begin.Velocity.Z + (PhysicsBody.Gravity * (flew ? flown : way.Shortest)));
            return Believe(way, ground, stands, way.Shortest, begin.Velocity with { Z = down });
        }

        return null;
    }

    /// <summary>
    /// How much higher a body may be so far away, metres: as high as it is on its flight when it gets there, or at the top of it when that
    /// comes later; by a slope all its speed may have become height.
    /// </summary>
    private double HighestOn(ShadowBody body, double away, bool bySlope)
    {
        BodySeat seat = body.Seat;
        if (bySlope) return HighestBySlope(seat);
        double speed = body.OnWalkable ? FastestSpeed : new Vector2(seat.Velocity.X, seat.Velocity.Y).Length();
        double top = seat.Velocity.Z / -(double)PhysicsBody.Gravity, at = Math.Max(Math.Max(0, away - options.Tolerance) / speed, top);
        return double.IsFinite(at) ? (seat.Velocity.Z * at) + (PhysicsBody.Gravity * at * at / 2) : double.NegativeInfinity;
    }

    /// <summary>
    /// A claim beside a course that something has thrown back, or that has landed, is believed now and then as well: where that happens
    /// small differences grow large. There must be a free way from the course to it, and it is hardly higher.
    /// </summary>
    private ClaimVerdict? DoubtNear(in Way way, bool stands, in Approach nearest)
    {
        double within = Math.Max(options.CorrectWithin, ShareLedAstray * Position.DistanceTo(way.To));
        if (doubts < 1 || !nearest.Bounced || nearest.Miss > within) return null;
        BodySeat seat = nearest.Seat;
        if (seat.Position.OffsetTo(way.To).Z > options.Tolerance) return null;
        Contact? ground = stands ? FootingAt(way.To) : null;
        if (stands && ground is null) return null;
        if (Math.Min(nearest.Time, way.Shortest) > way.Available || !IsFree(seat.Position, way.To, null)) return null;
        return Believe(way, ground, stands, Math.Min(nearest.Time, way.Shortest), seat.Velocity);
    }

    private ClaimVerdict Believe(in Way way, in Contact? ground, bool stands, double time, Vector3 velocity)
    {
        doubts--;
        Pay(time, way.Elapsed, way.Available, way.Now);
        beliefs.Guess(way.To, ground, stands
            ? [Vector3.Zero, new Vector3(0, 0, Beliefs.Hop)]
            : [velocity, new Vector3(0, 0, velocity.Z), Vector3.Zero]);
        return new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, way.To, options.Tolerance);
    }

    /// <summary>A way does not lead back: from where the body was going, or from where the keys lead it once it has landed.</summary>
    private static bool IsAhead(ShadowBody body, Vector3 across, in Position to)
    {
        Vector3 going = body.Going, keys = body.Striding(body.Position), later = body.Striding(to);
        return Leads(going) || (!body.OnWalkable && (Leads(keys) || Leads(later)));

        bool Leads(Vector3 way) => Vector3.Dot(across, way) >= -Back * way.Length();
    }

    /// <summary>
    /// How much higher a body gets that turns all its speed into height, as running or jumping at a slope does that is too steep to stand
    /// on, metres.
    /// </summary>
    private double HighestBySlope(in BodySeat begin)
    {
        double speed = Math.Max(FastestSpeed, begin.Velocity.Length());
        return speed * speed / Twice;
    }

    /// <summary>A slope that is too steep to stand on is beside a place.</summary>
    private bool IsBySlope(in Position place)
    {
        for (int i = 0; i < Sides; i++)
        {
            SweepResult met = query.Sweep(new SweepInput(soft, place, Beside(place, i, SlopeReach)));
            if (met.CollisionNormal is { } normal && normal.Z is > LeastSlope and < RetailMath.FloorZ) return true;
        }

        return false;
    }

    /// <summary>Finds the walls that a player who goes as it does may touch.</summary>
    /// <param name="walls">Takes their normals, on the level.</param>
    /// <returns>How many there are.</returns>
    private int FindWalls(Span<Vector3> walls)
    {
        ShadowBody body = beliefs.First;
        Vector3 way = body.Going with { Z = 0 };
        if (way.Length() < SlowestAgainstWall) return 0;
        int count = 0;
        for (int i = 0; i < Sides; i++)
        {
            SweepResult met = query.Sweep(new SweepInput(soft, body.Position, Beside(body.Position, i, WallReach)));
            if (met.CollisionNormal is not { } normal || Math.Abs(normal.Z) > SteepestWall || Vector3.Dot(normal, way) >= 0) continue;
            normal = Vector3.Normalize(normal with { Z = 0 });
            bool isKnown = false;
            foreach (Vector3 wall in walls[..count]) isKnown |= Vector3.Distance(wall, normal) < SameWall;
            if (!isKnown) walls[count++] = normal;
        }

        return count;
    }

    /// <summary>A place so many metres beside another one, in one of eight directions.</summary>
    private static Position Beside(Position place, int side, float metres)
    {
        (double sine, double cosine) = Math.SinCos(side * 2 * Math.PI / Sides);
        place.Frame.Origin += metres * new Vector3((float)sine, (float)cosine, 0);
        if (CellIds.IsOutdoor(place.CellId)) place.AdjustToOutside();
        return place;
    }

    private bool IsFree(in Position begin, in Position to, in Contact? contact)
    {
        SweepResult way = query.Sweep(new SweepInput(soft, begin, to) { Contact = contact });
        return way.Found && way.Position.DistanceTo(to) <= options.Tolerance;
    }

    /// <summary>First up, then across, then down: a body that jumps against a wall rises along it, and flies over what is lower.</summary>
    private bool IsFreeOver(in Position begin, in Position to, double up)
    {
        Position above = begin, beyond = to;
        above.Frame.Origin.Z += (float)up;
        beyond.Frame.Origin.Z = above.Frame.Origin.Z;
        return IsFree(begin, above, null) && IsFree(above, beyond, null) && IsFree(beyond, to, null);
    }
}
