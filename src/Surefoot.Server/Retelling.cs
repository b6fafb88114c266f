using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>
/// Tells the newest motion, velocity and place of an object again, twice within half a second. A client whose packet was lost asks for it
/// only when the next has come, and not before 0.6 s are over: meanwhile who stopped is seen running on. What it has heard already it
/// drops, because the stamp is not newer (specification 09, 5.2).
/// </summary>
/// <param name="audience">Who is told.</param>
internal sealed class Retelling(IAudience audience)
{
    private const double First = 0.1, Second = 0.3;

    private Repeated<UpdateMotion> motion;
    private Repeated<VectorUpdate> velocity;
    private Repeated<UpdatePosition> place;

    /// <summary>A motion was told.</summary>
    internal void Note(in UpdateMotion message) => motion = new Repeated<UpdateMotion>(message);

    /// <summary>A velocity was told.</summary>
    internal void Note(in VectorUpdate message) => velocity = new Repeated<VectorUpdate>(message);

    /// <summary>A place was told.</summary>
    internal void Note(in UpdatePosition message) => place = new Repeated<UpdatePosition>(message);

    /// <summary>Tells again what is due: first that it stands, then how it takes off, then where it is (specification 09, 4.4).</summary>
    /// <param name="now">Seconds.</param>
    internal void Update(double now)
    {
        motion.Update(audience, now);
        velocity.Update(audience, now);
        place.Update(audience, now);
    }

    /// <summary>A message that was told once, and how often since; none to begin with.</summary>
    private struct Repeated<T>(T? message)
        where T : struct, IMessage<T>
    {
        private double? since;
        private int times;

        public void Update(IAudience audience, double now)
        {
            if (message is not { } told || times > 1) return;
            since ??= now;
            if (now - since < (times == 0 ? First : Second)) return;
            times++;
            audience.Tell(told);
        }
    }
}
