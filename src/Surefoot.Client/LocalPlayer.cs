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

    private readonly PlayerObject player;
    private readonly MovementSender sender;
    private readonly PlayerMessages messages;
    private readonly PlayerPlaces places;
    private readonly Receiver receiver;
    private int killerStatus;
    private double? attackedPlayerAt;

    private LocalPlayer(PhysicsEngine engine, PhysicsBody body, PlayerWeenie weenie, IServerLink server, LocalPlayerOptions options)
    {
        Body = body;
        Server = server;
        Weenie = weenie;
        Character = options.Character ?? new CharacterSheet(body.Id);
        Movement = engine.MovementOf(body)!;
        player = new PlayerObject(body.Id, options.Stamps);
        sender = new MovementSender(body, Movement, player, server, options.Observer, engine.Now);
        Controller = new PlayerMovementController(body, Movement, sender);
        messages = new PlayerMessages(
            player, Movement, Controller, Weenie, Character, options.Commands, options.AttributesRaiseSkills);
        places = new PlayerPlaces(body, Movement, player, options.LoadLand);
        receiver = new Receiver(this);
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
    public long UnreadableMessages => messages.UnreadableCount + places.UnreadableCount;

    /// <summary>
    /// The player is on its way to another place, or waits to be let into the world: no key acts and no position is told. It ends by
    /// itself, when the land at the other end is there and the server has been told.
    /// </summary>
    public bool IsInPortalSpace => places.IsInPortalSpace;

    /// <summary>It is in portal space only because the land that it is to stand on is not loaded.</summary>
    internal bool WaitsForLand => places is { IsInPortalSpace: true, HasArrived: true } && !Body.HasCell;

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
        LocalPlayer player = Make(engine, id, setup, table, server, options ?? new LocalPlayerOptions());
        try
        {
            player.Receive(engine.Now);
            if (player.Body.EnterWorld(position)) return player;
        }
        catch
        {
            engine.RemoveBody(player.Body);
            throw;
        }

        engine.RemoveBody(player.Body);
        return null;
    }

    /// <summary>
    /// Puts a player into the world as its server describes it. It is in portal space, and arrives when the land is there; where there is
    /// no room for it, or no land ever, it waits for a teleport.
    /// </summary>
    /// <remarks>Specification 08, 3.5, steps 5 and 7, and 4.5, step 3.</remarks>
    internal static LocalPlayer Spawn(
        PhysicsEngine engine, ObjectDescription description, SetupAsset setup, MotionTableAsset table, IServerLink server,
        LocalPlayerOptions options)
    {
        PhysicsDescription physics = description.Physics;
        LocalPlayer player = Make(engine, description.Guid, setup, table, server, options with { Stamps = physics.Stamps });
        player.Body.SetWeenie(WeenieForms.TraitsOf(description.Weenie) | WeenieTraits.Creature | WeenieTraits.Player);
        if (physics.Scale is { } scale && WireForms.IsScale(scale)) player.Body.SetScale(scale);
        player.Begin(physics);
        return player;
    }

    /// <summary>A frame: what the server says arrives, then the keys act. To be called before <see cref="PhysicsEngine.Tick"/>.</summary>
    /// <param name="keys">Keys held now.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Update(MovementKeys keys, double now)
    {
        PlayerMovementController.ThrowIfNotFinite(now);
        Receive(now);
        Act(keys, now);
    }

    /// <summary>What the server says arrives by <see cref="Hear"/>; then the keys act.</summary>
    internal void Act(MovementKeys keys, double now)
    {
        NoteStatus(now);
        if (places.OwesMotion)
        {
            places.NoteMotion();
            Controller.OnTeleported(now);
        }

        if (places.OwesPosition)
        {
            places.NotePosition();
            sender.SendCorrectedPosition(now);
        }

        if (places is { IsInPortalSpace: true, HasArrived: true } && Body.HasCell)
        {
            Server.Send(new LoginComplete(), now);
            places.LeavePortalSpace();
        }

        if (!places.IsInPortalSpace) Controller.Update(keys, now);
    }

    /// <summary>A message of the server; those that are not about the player or its character are not looked at.</summary>
    internal void Hear(in WireMessage message)
    {
        messages.OnMessage(message);
        places.OnMessage(message);
    }

    /// <summary>The server describes the player's object once more.</summary>
    /// <param name="description">The description.</param>
    /// <param name="isForced">It is to be taken as that of another life, whatever its stamps say.</param>
    /// <remarks>Specification 08, 4.5.</remarks>
    internal void HearDescription(ObjectDescription description, bool isForced)
    {
        InstanceAge age = player.AgeOf(description.Physics.Stamps.Instance);
        if (isForced || age == InstanceAge.Ahead)
        {
            Body.TeleportHook();
            player.TakeStamps(description.Physics.Stamps);
            Begin(description.Physics);
        }
        else if (age == InstanceAge.Current)
        {
            places.Refresh(description.Physics);
        }
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

    private static LocalPlayer Make(
        PhysicsEngine engine, uint id, SetupAsset setup, MotionTableAsset table, IServerLink server, LocalPlayerOptions options)
    {
        PlayerWeenie weenie = new(new CharacterStats(0, 0), options.TopSpeedRule);
        PhysicsBody body = engine.CreateBody(
            id, setup, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player,
            motions: new BodyMotions(table, weenie));
        body.Trace = options.Trace;
        return new LocalPlayer(engine, body, weenie, server, options);
    }

    /// <summary>A life of the player's object begins, as it is described.</summary>
    private void Begin(PhysicsDescription physics)
    {
        bool autonomous = physics.Autonomous != 0;
        Body.LastMoveWasAutonomous = autonomous;
        if (physics.Movement is { } movement) messages.Begin(movement, autonomous);
        if (!autonomous) Controller.LoseControlToServer();
        Body.SetState((PhysicsState)physics.State);
        places.Begin(physics);
    }

    /// <summary>What the server says acts.</summary>
    private void Receive(double now)
    {
        Server.Receive(now, receiver);
        NoteStatus(now);
    }

    /// <summary>Whether the character is a killer of players decides by whom its body is stopped.</summary>
    private void NoteStatus(double now)
    {
        if (Character.PlayerKillerStatus != killerStatus)
        {
            killerStatus = Character.PlayerKillerStatus;
            Body.SetWeenie(WeenieForms.WithStatus(Body.Weenie, killerStatus));
        }

        NoteFight(now);
    }

    private sealed class Receiver(LocalPlayer player) : IMessageReceiver
    {
        public void OnMessage(in WireMessage message) => player.Hear(message);
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

    /// <summary>What is known of the character already; null for nothing. It is kept current from then on.</summary>
    public CharacterSheet? Character { get; init; }

    /// <summary>Loads the land around a place before the player is put there; null where somebody else does.</summary>
    internal Action<Position>? LoadLand { get; init; }

    /// <summary>Looks on at what the client sends; null for nobody.</summary>
    public IMovementObserver? Observer { get; init; }

    /// <summary>Is told each decision when the body is swept or placed, from its coming into the world on; null for nobody.</summary>
    public TraceBuffer? Trace { get; init; }
}
