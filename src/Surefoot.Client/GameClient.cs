using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>
/// One stay of a character in a server's world: the local player, everybody else, and the land around them, over dat files. It is made
/// before the world is entered, hears everything that comes over its link, and is updated once a frame. One thread at a time.
/// </summary>
/// <remarks>
/// Nothing a server says is thrown at the caller: what cannot be used is counted in <see cref="LocalPlayer.UnreadableMessages"/> and
/// <see cref="RemoteWorld.Drops"/>. Retail: SmartBox; specification 08, 3.5, 4 and 5, and 09, 4.1.
/// </remarks>
public sealed class GameClient
{
    private readonly IServerLink link;
    private readonly GameClientOptions options;
    private readonly DatObjectAssets objectAssets;
    private readonly LoadedLand land;
    private readonly Receiver receiver;
    private readonly List<byte[]> waiting = [];
    private long waitingBytes;
    private double now;

    /// <summary>A stay that has not begun: the server has not told the player yet.</summary>
    /// <param name="assets">Shapes and records of the world that the server has; may be shared with other clients.</param>
    /// <param name="link">The way to the server.</param>
    /// <param name="options">Rules, bounds, observers.</param>
    /// <exception cref="Dats.DatRecordMissingException">The files have no region.</exception>
    /// <exception cref="Dats.DatFormatException">The region is malformed.</exception>
    public GameClient(PhysicsDataCache assets, IServerLink link, GameClientOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(assets);
        ArgumentNullException.ThrowIfNull(link);
        this.link = link;
        this.options = options ?? new GameClientOptions();
        Engine = new PhysicsEngine(assets, this.options.Engine);
        objectAssets = new DatObjectAssets(assets, Engine.World.LeftOut);
        land = new LoadedLand(Engine.World, this.options.LandAhead, this.options.LandKept);
        receiver = new Receiver(this);
        Others = new RemoteWorld(Engine, objectAssets, new RemoteWorldOptions
        {
            Commands = this.options.Commands,
            MostObjects = this.options.MostObjects,
            MostWaitingBytes = this.options.MostWaitingBytes,
            Observer = receiver,
        });
    }

    /// <summary>The engine that moves all bodies. Its time is that of <see cref="Update"/>.</summary>
    public PhysicsEngine Engine { get; }

    /// <summary>All objects but the player.</summary>
    public RemoteWorld Others { get; }

    /// <summary>The player; null before the server has described it.</summary>
    public LocalPlayer? Player { get; private set; }

    /// <summary>Id of the player's object; 0 before the server has told it.</summary>
    public uint PlayerId { get; private set; }

    /// <summary>What is told of the player's character.</summary>
    public CharacterSheet Character { get; } = new();

    /// <summary>
    /// Why the server's description of the player could not be used, in a sentence: its shape or motions are not in the files. The player
    /// stays away then. Null while nothing is wrong.
    /// </summary>
    public string? Fault { get; private set; }

    /// <summary>The player is in the world and keys act: it is not, or no more, on its way from one place to another.</summary>
    public bool IsPlaying => Player is { IsInPortalSpace: false, Body.HasCell: true };

    /// <summary>A frame, in retail's order: the land around the player, time passes, what the server says arrives, the keys
    /// act.</summary>
    /// <param name="keys">Keys held now.</param>
    /// <param name="now">Seconds, of a clock that starts anywhere and does not run backwards.</param>
    /// <returns>True when bodies moved; that is at most every 1/30 s.</returns>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public bool Update(MovementKeys keys, double now)
    {
        PlayerMovementController.ThrowIfNotFinite(now);
        this.now = now;
        if (Player is { } there) land.Follow(there.Body.Position);
        bool moved = false;
        if (Player is not { WaitsForLand: true })
        {
            Others.Update(now);
            moved = Engine.Tick(now);
        }

        link.Receive(now, receiver);
        Player?.Act(keys, now);
        return moved;
    }

    /// <summary>
    /// Until the player is there, what is about objects waits for it: others are held by it, stand around it, and are far from it or near.
    /// </summary>
    private void Hear(in WireMessage message)
    {
        if (Player is { } player)
        {
            if (!TryHearOwnDescription(message)) player.Hear(message);
            Others.OnMessage(message);
            return;
        }

        Opcode opcode = message.Id.Opcode;
        if (opcode == Opcode.PlayerCreate && message.TryRead(out PlayerCreate created)) Meet(created.Guid, message);
        else if (TryHearOwnDescription(message)) Replay(message);
        else if (opcode == Opcode.PlayerTeleport || RemoteWorld.IsAboutObjects(opcode)) Wait(message);
        else Character.Apply(message);
    }

    private void Meet(uint guid, in WireMessage message)
    {
        if (PlayerId != 0 || guid == 0) return;
        PlayerId = guid;
        Others.OnMessage(message);
        Replay(default);
    }

    /// <summary>The player's own object is described: it comes into the world, or what is news of it acts.</summary>
    private bool TryHearOwnDescription(in WireMessage message)
    {
        bool isForced = message.Id.Opcode == Opcode.UpdateObject;
        ObjectDescription description;
        if (isForced && message.TryRead(out UpdateObject updated)) description = updated.Object;
        else if (message.Id.Opcode == Opcode.CreateObject && message.TryRead(out CreateObject created)) description = created.Object;
        else return false;
        if (description.Guid != PlayerId || PlayerId == 0) return false;
        if (Player is { } player) player.HearDescription(description, isForced);
        else Spawn(description);
        return true;
    }

    private void Spawn(ObjectDescription description)
    {
        PhysicsDescription physics = description.Physics;
        MotionTableAsset? table = null;
        if (physics.Setup is not { } shape || !objectAssets.TryGetSetup(shape, out SetupAsset? setup))
        {
            Fault = $"The dat files have no setup 0x{physics.Setup ?? 0:X8}, which the server says is the player's.";
            return;
        }

        if (physics.MotionTable is not { } motions || !objectAssets.TryGetMotions(motions, setup, out table))
        {
            Fault = $"The dat files have no motion table 0x{physics.MotionTable ?? 0:X8}, which the server says is the player's.";
            return;
        }

        Fault = null;
        Player = LocalPlayer.Spawn(Engine, description, setup, table, new Sender(link), new LocalPlayerOptions
        {
            TopSpeedRule = options.TopSpeedRule,
            AttributesRaiseSkills = options.AttributesRaiseSkills,
            Commands = options.Commands,
            Character = Character,
            Observer = options.Observer,
            LoadLand = place => land.Follow(place),
        });
        Engine.Player = Player.Body;
    }

    /// <summary>What waited for the player is heard, in its order, and after the description that brought it.</summary>
    private void Replay(in WireMessage first)
    {
        byte[][] messages = [.. waiting];
        waiting.Clear();
        waitingBytes = 0;
        if (Player is not null) Others.OnMessage(first);
        foreach (byte[] bytes in messages)
            if (WireMessage.TryParse(bytes, out WireMessage message)) Hear(message);
    }

    private void Wait(in WireMessage message)
    {
        if (waitingBytes + message.Bytes.Length > options.MostWaitingBytes)
        {
            Others.Drops.Add(RemoteDrop.NoRoom);
            return;
        }

        waiting.Add(message.Bytes.ToArray());
        waitingBytes += message.Bytes.Length;
    }

    /// <summary>What the player tells goes out; what comes in, the client hands on itself.</summary>
    private sealed class Sender(IServerLink link) : IServerLink
    {
        public void Send<T>(in T action, double now)
            where T : IGameAction<T> => link.Send(action, now);

        public void Receive(double now, IMessageReceiver receiver)
        {
        }
    }

    private sealed class Receiver(GameClient client) : IMessageReceiver, IRemoteObserver
    {
        public void OnMessage(in WireMessage message) => client.Hear(message);

        public void OnCreated(RemoteBody item) => client.options.OthersObserver?.OnCreated(item);

        public void OnDeleting(RemoteBody item) => client.options.OthersObserver?.OnDeleting(item);

        public void OnMissing(uint guid)
        {
            client.link.RequestObject(guid, client.now);
            client.options.OthersObserver?.OnMissing(guid);
        }
    }
}
