using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>A player in a world: body, motions, keys, and the way to its server.</summary>
public sealed class LocalPlayer
{
    /// <summary>How long a killer counts as fighting after an attack on a player, seconds (specification 01, 4.1).</summary>
    private const double FightLasts = 20;

    private readonly PlayerMessages messages;
    private int killerStatus;
    private double? attackedPlayerAt;

    private LocalPlayer(PhysicsEngine engine, PhysicsBody body, PlayerWeenie weenie, IServerLink server, LocalPlayerOptions options)
    {
        Body = body;
        Server = server;
        Weenie = weenie;
        Character = new CharacterSheet(options.AttributesRaiseSkills);
        Movement = engine.MovementOf(body)!;
        PlayerObject player = new(body.Id, options.Stamps);
        Controller = new PlayerMovementController(body, Movement,
            new MovementSender(body, Movement, player, server, options.Observer, engine.Now));
        messages = new PlayerMessages(player, Movement, Controller, Weenie, Character, options.Commands);
    }

    /// <summary>The body.</summary>
    public PhysicsBody Body { get; }

    /// <summary>Its motions.</summary>
    public MovementManager Movement { get; }

    /// <summary>What the physics asks of the character.</summary>
    public PlayerWeenie Weenie { get; }

    /// <summary>The character's numbers, as the server told them.</summary>
    public CharacterSheet Character { get; }

    /// <summary>The keys.</summary>
    public PlayerMovementController Controller { get; }

    /// <summary>The way to the server.</summary>
    public IServerLink Server { get; }

    /// <summary>Messages of the server about the player that could not be read. They changed nothing.</summary>
    public long UnreadableMessages => messages.UnreadableCount;

    /// <summary>Puts a player into the world. What its server has to say by now of the character is heard first.</summary>
    /// <param name="engine">The world.</param>
    /// <param name="id">Id of the body, unique and not 0; its server knows it by the same one.</param>
    /// <param name="setup">Shape of the body.</param>
    /// <param name="table">Motions of the body.</param>
    /// <param name="position">Where it begins.</param>
    /// <param name="server">The way to its server, which tells the character's numbers.</param>
    /// <param name="options">Rules, stamps, observer.</param>
    /// <returns>The player; null when there is no room for it.</returns>
    /// <exception cref="ArgumentException">An argument is out of range; nothing has changed.</exception>
    public static LocalPlayer? Spawn(
        PhysicsEngine engine, uint id, SetupAsset setup, MotionTableAsset table, in Position position, IServerLink server,
        LocalPlayerOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        ArgumentNullException.ThrowIfNull(setup);
        ArgumentNullException.ThrowIfNull(table);
        ArgumentNullException.ThrowIfNull(server);
        options ??= new LocalPlayerOptions();
        PlayerWeenie weenie = new(new CharacterStats(0, 0), options.TopSpeedRule);
        PhysicsBody body = engine.CreateBody(
            id, setup, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player,
            motions: new BodyMotions(table, weenie));
        body.Trace = options.Trace;
        try
        {
            LocalPlayer player = new(engine, body, weenie, server, options);
            player.Receive(engine.Now);
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
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Update(MovementKeys keys, double now)
    {
        PlayerMovementController.ThrowIfNotFinite(now);
        Receive(now);
        Controller.Update(keys, now);
    }

    /// <summary>Puts the player somewhere else, on the nearest free place. It stands still there, autorun ends, and the server is told what
    /// is asked of it.</summary>
    /// <param name="place">Where.</param>
    /// <param name="now">Seconds.</param>
    /// <returns>OK also when the cell is not loaded: the player then waits for it. Otherwise nothing has changed.</returns>
    /// <exception cref="ArgumentException">The place or the time is not finite, or the id names no cell; nothing has changed.</exception>
    /// <remarks>Specification 02, 4.17 (local player) and 08, 4.4, step 5.</remarks>
    public PlacementResult Teleport(in Position place, double now)
    {
        PlayerMovementController.ThrowIfNotFinite(now);
        PlacementResult result = Body.SetPositionSimple(place, sliding: true);
        if (result != PlacementResult.OK) return result;
        Body.TeleportHook();
        Body.SetVelocity(Vector3.Zero);
        Controller.OnTeleported(now);
        return result;
    }

    /// <summary>The player attacked another player. For 20 s from now on a player killer's jumps cost the stamina of a fight.</summary>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    /// <remarks>Retail: CACQualities::JumpStaminaCost @0x00591B90. Whoever uses this leaves the weenie's flag alone.</remarks>
    public void NoteAttackOnPlayer(double now)
    {
        PlayerMovementController.ThrowIfNotFinite(now);
        attackedPlayerAt = now;
        NoteFight(now);
    }

    private void NoteFight(double now)
    {
        if (attackedPlayerAt is not { } since) return;
        bool fights = now - since <= FightLasts;
        if (!fights) attackedPlayerAt = null;
        Weenie.IsPlayerKillerInCombat = fights && (Body.Weenie & (WeenieTraits.PK | WeenieTraits.PKLite)) != 0;
    }

    /// <summary>What the server says acts; whether the character is a killer of players decides by whom its body is stopped.</summary>
    private void Receive(double now)
    {
        Server.Receive(now, messages);
        if (Character.PlayerKillerStatus != killerStatus)
        {
            killerStatus = Character.PlayerKillerStatus;
            Body.SetWeenie(WeenieForms.WithStatus(Body.Weenie, killerStatus));
        }

        NoteFight(now);
    }
}

/// <summary>How a <see cref="LocalPlayer"/> is set up.</summary>
public sealed record LocalPlayerOptions
{
    /// <summary>From which run skill on the top speed holds.</summary>
    public TopSpeedRule TopSpeedRule { get; init; }

    /// <summary>
    /// The character's attributes are part of its skills (run: quickness; jump: half of strength and coordination), as with servers of the
    /// field, which leave them out of what they tell. Off for a server that tells skills as they are.
    /// </summary>
    public bool AttributesRaiseSkills { get; init; }

    /// <summary>The server's numbering of commands; servers of the field have <see cref="CommandTable.Ace"/>.</summary>
    public CommandTable Commands { get; init; } = CommandTable.Retail;

    /// <summary>The stamps of the player's object, as CreateObject brought them; at first those of a character's first life.</summary>
    public ObjectStamps Stamps { get; init; } = new(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1);

    /// <summary>Looks on at what the client sends; null for nobody.</summary>
    public IMovementObserver? Observer { get; init; }

    /// <summary>Is told each decision when the body is swept or placed, from its coming into the world on; null for nobody.</summary>
    public TraceBuffer? Trace { get; init; }
}
