using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>
/// Hears what a <see cref="CreatureDriver"/> has to say: the messages for every client that knows the creature, and how its goals go.
/// Orders may be given from inside.
/// </summary>
public interface ICreatureListener
{
    /// <summary>What the creature does from now on.</summary>
    /// <param name="creature">Who.</param>
    /// <param name="message">The message, types 0 and 6 to 9.</param>
    void OnMotion(CreatureDriver creature, in UpdateMotion message);

    /// <summary>Where the creature is: five times a second on its way, and once when it stops.</summary>
    /// <param name="creature">Who.</param>
    /// <param name="message">The message.</param>
    void OnPosition(CreatureDriver creature, in UpdatePosition message);

    /// <summary>
    /// A goal was reached: the creature is where it should be, or faces where it should. Who follows, flees or sticks goes on.
    /// </summary>
    /// <param name="creature">Who.</param>
    void OnArrived(CreatureDriver creature)
    {
    }

    /// <summary>A goal was given up: its target is gone, or the body may not move.</summary>
    /// <param name="creature">Who.</param>
    /// <param name="error">Why.</param>
    void OnGivenUp(CreatureDriver creature, MotionError error)
    {
    }

    /// <summary>
    /// The creature wants to move and cannot. It stands and waits until something near it changes, unless it is told otherwise.
    /// </summary>
    /// <param name="creature">Who.</param>
    void OnStuck(CreatureDriver creature)
    {
    }

    /// <summary>Something changed near a creature that was stuck: it tries again.</summary>
    /// <param name="creature">Who.</param>
    void OnTriesAgain(CreatureDriver creature)
    {
    }
}
