using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>Notices that a body gets nowhere, and when it is worth while to try again.</summary>
internal sealed class StuckWatch(PhysicsBody body, CreatureDriverOptions options)
{
    /// <summary>A turn on the spot by more than this is getting somewhere, degrees.</summary>
    private const double Turned = 10;

    /// <summary>A target that is elsewhere by this share of its distance lies in another direction.</summary>
    private const double ElsewhereShare = 0.25;
    private const double ElsewhereLeast = 1;

    private Position mark = Position.Nowhere, place = Position.Nowhere, sought;
    private double markTime, waitUntil, wait;
    private ulong surroundings;

    /// <summary>An attempt begins.</summary>
    public void Begin(double now) => SetMark(now);

    /// <summary>The body got nowhere for too long.</summary>
    /// <param name="now">Seconds.</param>
    /// <param name="busy">It waits for a motion of its own to end.</param>
    public bool IsStuck(double now, bool busy)
    {
        Position here = body.Position;
        double turned = Math.Abs(((here.Frame.Heading - mark.Frame.Heading + 540) % 360) - 180);
        if (!busy && turned <= Turned && mark.DistanceTo(here) <= options.StuckWithin) return now - markTime >= options.StuckAfter;
        SetMark(now);
        return false;
    }

    /// <summary>Remembers what is around: nothing is tried as long as it stays like this.</summary>
    /// <param name="now">Seconds.</param>
    /// <param name="target">Where the body wants to go, or what it wants to get away from.</param>
    public void Park(double now, in Position target)
    {
        bool again = place.CellId != 0 && place.DistanceTo(body.Position) <= options.StuckWithin;
        wait = again ? Math.Min(2 * wait, options.LongestWait) : options.ShortestWait;
        waitUntil = now + wait;
        place = body.Position;
        sought = target;
        surroundings = body.HashSurroundings(options.WakeRadius);
    }

    /// <summary>Something changed: the surroundings, or where the target is.</summary>
    public bool IsWorthATry(double now, in Position target)
    {
        if (now < waitUntil) return false;
        double elsewhere = Math.Max(ElsewhereLeast, ElsewhereShare * place.DistanceTo(sought));
        return sought.DistanceTo(target) > elsewhere || body.HashSurroundings(options.WakeRadius) != surroundings;
    }

    /// <summary>Another goal: what was tried before says nothing of it.</summary>
    public void Forget() => place = Position.Nowhere;

    private void SetMark(double now) => (mark, markTime) = (body.Position, now);
}
