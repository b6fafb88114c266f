namespace Surefoot.Protocol.Session;

/// <summary>Receives what a client's session has to tell, from within <see cref="ClientSession.Receive"/> and
/// <see cref="ClientSession.Update"/>.</summary>
public interface ISessionHandler : IMessageReceiver
{
    /// <summary>The session has come to another state.</summary>
    void OnStateChanged(SessionState state);
}
