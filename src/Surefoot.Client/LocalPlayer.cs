using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client;

/// <summary>A player in a world: body, motions, keys, and a server in the same process.</summary>
public sealed class LocalPlayer : IMovementSink
{
    private readonly IMovementSink? observer;

    private LocalPlayer(PhysicsEngine engine, PhysicsBody body, MotionTableAsset table, CharacterStats stats, LocalPlayerOptions options)
    {
        observer = options.Observer;
        Body = body;
        Weenie = new PlayerWeenie(stats, RunRateSource.Server, options.TopSpeedRule);
        Movement = new MovementManager(body, table, Weenie);
        body.AttachMovement(Movement);
        Server = new LoopbackServer(stats, engine.Now, options.Latency, options.TopSpeedRule);
        Controller = new PlayerMovementController(body, Movement, this, engine.Now);
    }

    /// <summary>The body.</summary>
    public PhysicsBody Body { get; }

    /// <summary>Its motions.</summary>
    public MovementManager Movement { get; }

    /// <summary>What the client knows of the character.</summary>
    public PlayerWeenie Weenie { get; }

    /// <summary>The keys.</summary>
    public PlayerMovementController Controller { get; }

    /// <summary>The server; the character's numbers are changed here.</summary>
    public LoopbackServer Server { get; }

    /// <summary>Puts a player into the world.</summary>
    /// <param name="engine">The world.</param>
    /// <param name="id">Id of the body, unique and not 0.</param>
    /// <param name="setup">Shape of the body.</param>
    /// <param name="table">Motions of the body.</param>
    /// <param name="position">Where it begins.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="options">Latency, rules, observer.</param>
    /// <returns>The player; null when there is no room for it.</returns>
    /// <exception cref="ArgumentException">An argument is out of range; nothing has changed.</exception>
    public static LocalPlayer? Spawn(
        PhysicsEngine engine, uint id, SetupAsset setup, MotionTableAsset table, in Position position, CharacterStats stats, LocalPlayerOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        ArgumentNullException.ThrowIfNull(setup);
        ArgumentNullException.ThrowIfNull(table);
        PhysicsBody body = engine.CreateBody(
            id, setup, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player);
        try
        {
            LocalPlayer player = new(engine, body, table, stats, options ?? new LocalPlayerOptions());
            if (body.EnterWorld(position)) return player;
        }
        catch
        {
            engine.RemoveBody(body);
            throw;
        }

        engine.RemoveBody(body);
        return null;
    }

    /// <summary>A frame: what the server says arrives, then the keys act. To be called before <see cref="PhysicsEngine.Tick"/>.</summary>
    /// <param name="keys">Keys held now.</param>
    /// <param name="now">Seconds.</param>
    public void Update(MovementKeys keys, double now)
    {
        Server.Deliver(Controller, now);
        Controller.Update(keys, now);
    }

    /// <inheritdoc/>
    void IMovementSink.OnMoveToState(in MoveToStateEvent e)
    {
        Server.OnMoveToState(e);
        observer?.OnMoveToState(e);
    }

    /// <inheritdoc/>
    void IMovementSink.OnJump(in JumpEvent e)
    {
        Server.OnJump(e);
        observer?.OnJump(e);
    }

    /// <inheritdoc/>
    void IMovementSink.OnAutonomousPosition(in AutonomousPositionEvent e)
    {
        Server.OnAutonomousPosition(e);
        observer?.OnAutonomousPosition(e);
    }
}

/// <summary>How a <see cref="LocalPlayer"/> is set up.</summary>
public sealed record LocalPlayerOptions
{
    /// <summary>Seconds from a message of the client to its answer.</summary>
    public double Latency { get; init; }

    /// <summary>From which run skill on the top speed holds.</summary>
    public TopSpeedRule TopSpeedRule { get; init; }

    /// <summary>Receives what the client sends, after the server has; null for nobody.</summary>
    public IMovementSink? Observer { get; init; }
}
