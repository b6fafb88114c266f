using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>A client's way to its server, be that in the same process or at the other end of a session: what the player does goes out,
/// what the server says comes in. (<see cref="ServerLink"/> is the server's end of a session.)</summary>
public interface IServerLink
{
    /// <summary>Tells the server what the player does.</summary>
    /// <param name="action">The message.</param>
    /// <param name="now">The time, seconds.</param>
    void Send<T>(in T action, double now)
        where T : IGameAction<T>;

    /// <summary>Hands over the messages that have arrived by now, in order.</summary>
    /// <param name="now">The time, seconds.</param>
    /// <param name="receiver">Told each of them.</param>
    void Receive(double now, IMessageReceiver receiver);

    /// <summary>Asks the server to describe an object again, of which messages came but no description. A server that knows of no objects
    /// has nothing to say to that.</summary>
    /// <param name="guid">The object.</param>
    /// <param name="now">The time, seconds.</param>
    void RequestObject(uint guid, double now)
    {
    }
}
