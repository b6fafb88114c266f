using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>Receives messages as they are complete.</summary>
public interface IMessageReceiver
{
    /// <summary>A message, known or not.</summary>
    /// <param name="message">Lives until this returns.</param>
    void OnMessage(in WireMessage message);
}
