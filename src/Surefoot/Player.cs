using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot;

/// <summary>A player of a <see cref="Simulation"/>, with a server of its own in the same process.</summary>
public sealed class Player
{
    private readonly Simulation simulation;

    internal Player(Simulation simulation, LocalPlayer local, LoopbackServer server)
    {
        this.simulation = simulation;
        Local = local;
        Server = server;
    }

    /// <summary>The keys held, until they are others.</summary>
    public MovementKeys Keys { get; set; }

    /// <summary>Where the player is: metres from the corner of its landblock, and its rotation.</summary>
    public Position Position => Body.Position;

    /// <summary>The body.</summary>
    public PhysicsBody Body => Local.Body;

    /// <summary>What belongs to the player at its client: motions, the controller of keys and pointer.</summary>
    public LocalPlayer Local { get; }

    /// <summary>The server; the character's numbers are changed there.</summary>
    public LoopbackServer Server { get; }

    /// <summary>The landblock around which the world was loaded for this player.</summary>
    internal uint LoadedBlock { get; set; }

    /// <summary>A frame of a game with one player: takes the keys and lets time pass. With several, set their <see cref="Keys"/> and call
    /// <see cref="Simulation.Tick"/> once.</summary>
    /// <param name="keys">Keys held now.</param>
    /// <param name="now">Seconds, of a clock that starts anywhere and does not run backwards.</param>
    /// <returns>True when bodies moved; that is at most every 1/30 s.</returns>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public bool Update(MovementKeys keys, double now)
    {
        Keys = keys;
        return simulation.Tick(now);
    }

    /// <summary>Puts the player somewhere else, on the nearest free place. It stands still there and its server is told.</summary>
    /// <param name="place">Where.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="PlaceException">No player can be there; nothing has changed but that the world there is loaded.</exception>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Teleport(Place place, double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        Position position = simulation.Find(place);
        if (Local.Teleport(position, now) != PlacementResult.OK) throw Simulation.NoRoom(place);
        simulation.Follow(this);
    }

    /// <summary>Changes the character's numbers. They act when the server's message has arrived.</summary>
    /// <param name="stats">The numbers.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">A number is negative, or the time is not finite; nothing has changed.</exception>
    public void SetStats(CharacterStats stats, double now) => Server.SetStats(stats, now);
}
