using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>The way to a server over a <see cref="WorldSession"/>. Messages and changes of state come on the thread that asks.</summary>
/// <param name="session">The session. It keeps its own time, and belongs to the caller.</param>
/// <param name="observer">Told everything that comes, after the client; null for nobody.</param>
public sealed class SessionLink(WorldSession session, ISessionHandler? observer = null) : IServerLink
{
    private readonly Handler handler = new(observer);

    /// <inheritdoc/>
    /// <remarks>Without a connection it is lost, as on the way.</remarks>
    public void Send<T>(in T action, double now)
        where T : IGameAction<T> => session.Send(action);

    /// <inheritdoc/>
    public void Receive(double now, IMessageReceiver receiver)
    {
        handler.Receiver = receiver;
        session.Update(handler);
    }

    /// <inheritdoc/>
    public void RequestObject(uint guid, double now) => session.Send(new ForceObjDesc(guid));

    private sealed class Handler(ISessionHandler? observer) : ISessionHandler
    {
        public IMessageReceiver? Receiver { get; set; }

        public void OnMessage(in WireMessage message)
        {
            Receiver?.OnMessage(message);
            observer?.OnMessage(message);
        }

        public void OnStateChanged(SessionState state) => observer?.OnStateChanged(state);
    }
}
