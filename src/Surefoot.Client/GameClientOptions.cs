using Surefoot.Physics;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>Rules and bounds of a <see cref="GameClient"/>. The defaults suit servers of the field.</summary>
public sealed record GameClientOptions
{
    /// <summary>The server's numbering of commands.</summary>
    public CommandTable Commands { get; init; } = CommandTable.Ace;

    /// <summary>From which run skill on the top speed holds.</summary>
    public TopSpeedRule TopSpeedRule { get; init; }

    /// <summary>The character's attributes are part of its skills; servers of the field leave them out of what they tell.</summary>
    public bool AttributesRaiseSkills { get; init; } = true;

    /// <summary>Rules of the engine; null for the usual ones.</summary>
    public PhysicsEngineOptions? Engine { get; init; }

    /// <summary>Landblocks of 192 m that are loaded around the player's own in each direction, 1 or more.</summary>
    public int LandAhead { get; init; } = 1;

    /// <summary>Landblocks around the player's own that stay loaded, at least <see cref="LandAhead"/>.</summary>
    public int LandKept { get; init; } = 3;

    /// <summary>Most objects known at once.</summary>
    public int MostObjects { get; init; } = 65536;

    /// <summary>Most bytes of messages that wait for an object or for the player.</summary>
    public int MostWaitingBytes { get; init; } = 4 << 20;

    /// <summary>Looks on at what the player tells the server; null for nobody.</summary>
    public IMovementObserver? Observer { get; init; }

    /// <summary>Is told which objects come and go; null for nobody.</summary>
    public IRemoteObserver? OthersObserver { get; init; }
}
