using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>Everybody who knows an object: where a server's words about it go.</summary>
public interface IAudience
{
    /// <summary>Tells everybody something.</summary>
    /// <param name="message">The message.</param>
    void Tell<T>(in T message)
        where T : IMessage<T>;
}
