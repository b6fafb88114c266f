using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>Rules and bounds of a <see cref="RemoteWorld"/>.</summary>
public sealed record RemoteWorldOptions
{
    /// <summary>
    /// Id of the local player's object, whose messages are somebody else's business. 0 where there is none, as for one who only looks on;
    /// null where the server tells it: until then every message waits. How bodies follow their positions depends on how far they are from
    /// <see cref="Physics.PhysicsEngine.Player"/>; without one they are put to each.
    /// </summary>
    public uint? Player { get; init; }

    /// <summary>The numbering of the server's commands.</summary>
    public CommandTable Commands { get; init; } = CommandTable.Ace;

    /// <summary>Most objects known at once; further ones are left out.</summary>
    public int MostObjects { get; init; } = 65536;

    /// <summary>Most unknown objects that messages wait for at once.</summary>
    public int MostAwaited { get; init; } = 1024;

    /// <summary>Most messages that wait for one object.</summary>
    public int MostMessagesEach { get; init; } = 256;

    /// <summary>Most bytes of messages that wait, in all.</summary>
    public int MostWaitingBytes { get; init; } = 4 << 20;

    /// <summary>Is told what comes and goes.</summary>
    public IRemoteObserver? Observer { get; init; }
}

/// <summary>Is told what comes into a <see cref="RemoteWorld"/> and what goes.</summary>
public interface IRemoteObserver
{
    /// <summary>An object is known and stands in the world, if it has a place there.</summary>
    /// <param name="item">The object.</param>
    void OnCreated(RemoteBody item)
    {
    }

    /// <summary>An object is about to be forgotten.</summary>
    /// <param name="item">The object, still as it was.</param>
    void OnDeleting(RemoteBody item)
    {
    }

    /// <summary>Messages came for an object that is not known: the server is to be asked for it, with <see cref="ForceObjDesc"/>.</summary>
    /// <param name="guid">The object.</param>
    void OnMissing(uint guid)
    {
    }
}
