using System.Numerics;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>Where a way leads.</summary>
/// <param name="Found">A valid position was found; it may be the begin.</param>
/// <param name="IsLoaded">False when the way begins, or ends, where no cell is loaded: nothing is known of what is there.</param>
/// <param name="Position">Where it ends; the begin when nothing was found.</param>
/// <param name="Contact">What the mover touches there, or null.</param>
/// <param name="SlidingNormal">Horizontal unit normal, or zero, of the wall it slides along next; null for none.</param>
/// <param name="CollisionNormal">Unit normal of the last collision on the way, or null.</param>
/// <param name="CollidedWithEnvironment">It hit terrain, a building, a room or a static object without standing.</param>
/// <param name="LosesVelocity">A body that goes there loses its velocity, even when no valid position was found.</param>
public readonly record struct SweepResult(
    bool Found, bool IsLoaded, Position Position, Contact? Contact, Vector3? SlidingNormal, Vector3? CollisionNormal,
    bool CollidedWithEnvironment, bool LosesVelocity)
{
    internal static SweepResult Of(bool found, Transition transition)
    {
        CollisionInfo met = transition.Collision;
        return new SweepResult(
            found, transition.Path.CurrCell is not null, transition.Path.CurrPos, Queries.Contact.Of(met),
            met.SlidingNormalValid ? met.SlidingNormal : null, met.CollisionNormalValid ? met.CollisionNormal : null,
            met.CollidedWithEnvironment, met.StopsMover);
    }

    /// <summary>The answer where a way begins in no cell that is loaded.</summary>
    internal static SweepResult NotLoaded(in Position from) => new(false, false, from, null, null, null, false, false);
}
