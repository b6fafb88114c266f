using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Workbench.Simulation;

/// <summary>An object of the true world that pages know by a server's messages alone.</summary>
internal interface ISeenObject
{
    /// <summary>Its id.</summary>
    uint Id { get; }

    /// <summary>It is somewhere in the world.</summary>
    bool IsThere { get; }

    /// <summary>Where it is in truth.</summary>
    Position Place { get; }

    /// <summary>Who is told of it.</summary>
    Audience Audience { get; }

    /// <summary>All of it, for who does not know it yet.</summary>
    CreateObject Describe();
}

/// <summary>The viewers that know an object.</summary>
internal sealed class Audience : IAudience
{
    private readonly List<Viewer> viewers = [];

    /// <summary>Somebody has been told of it.</summary>
    public void Add(Viewer viewer) => viewers.Add(viewer);

    /// <summary>Somebody is to forget it.</summary>
    public void Remove(Viewer viewer) => viewers.Remove(viewer);

    /// <inheritdoc/>
    public void Tell<T>(in T message)
        where T : IMessage<T>
    {
        foreach (Viewer viewer in viewers) viewer.Tell(message);
    }
}
