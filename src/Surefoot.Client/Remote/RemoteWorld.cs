using System.Diagnostics.CodeAnalysis;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>
/// The objects that a server tells of, moved by its messages: all but the local player. A frame is, in retail's order:
/// <see cref="Update"/>, then <see cref="PhysicsEngine.Tick"/>, then the messages that have arrived, each to <see cref="OnMessage"/>, then
/// the keys. While the local player waits for cells, retail leaves out the first two.
/// </summary>
/// <remarks>
/// What cannot be read, comes late or has no room is counted in <see cref="Drops"/>, and nothing is thrown. Retail: SmartBox::UseTime
/// @0x00455410, ACSmartBox::DispatchSmartBoxEvent @0x005595D0; specification 09, 4.1 and 5.
/// </remarks>
public sealed partial class RemoteWorld : IMessageReceiver
{
    private readonly PhysicsEngine engine;
    private readonly IObjectAssets assets;
    private readonly RemoteWorldOptions options;
    private readonly ServerOrders orders;
    private readonly Dictionary<uint, RemoteBody> objects = [];
    private readonly DestructionTimers timers = new();
    private readonly Placeholders placeholders;
    private readonly List<byte[]> beforePlayer = [];
    private readonly Stack<Replay> replays = new();
    private long bytesBeforePlayer;
    private uint? player;
    private ushort? playerInstance;
    private double now;

    /// <summary>The objects of a server in an engine's world.</summary>
    /// <param name="engine">The engine. Bodies that it has already are not touched.</param>
    /// <param name="assets">Shapes and motions.</param>
    /// <param name="options">Rules and bounds.</param>
    public RemoteWorld(PhysicsEngine engine, IObjectAssets assets, RemoteWorldOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        ArgumentNullException.ThrowIfNull(assets);
        this.engine = engine;
        this.assets = assets;
        this.options = options ?? new RemoteWorldOptions();
        player = this.options.Player;
        now = engine.Now;
        orders = new ServerOrders(this.options.Commands);
        placeholders = new Placeholders(this.options, Drops);
    }

    /// <summary>Messages that did nothing, by reason.</summary>
    public RemoteDrops Drops { get; } = new();

    /// <summary>The objects, in no order.</summary>
    public IReadOnlyCollection<RemoteBody> Objects => objects.Values;

    /// <summary>Unknown objects that messages wait for.</summary>
    public int AwaitedCount => placeholders.Count;

    /// <summary>Messages that wait, for unknown objects and for the player.</summary>
    public int WaitingMessageCount => placeholders.MessageCount + beforePlayer.Count;

    /// <summary>Id of the local player's object, as it was given or as the server told it; null while it is not known.</summary>
    public uint? Player => player;

    /// <summary>An object, or null when it is not known.</summary>
    public RemoteBody? Find(uint guid) => objects.GetValueOrDefault(guid);

    /// <summary>What time asks for: objects that nobody saw for 25 s are forgotten, and unknown ones are asked for every 20 s.</summary>
    /// <param name="now">The frame's time, seconds, by the clock of <see cref="PhysicsEngine.Tick"/>.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    /// <remarks>Retail: CObjectMaint::UseTime @0x005089B0.</remarks>
    public void Update(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        // What went out of sight since the last frame did so in its tick.
        foreach (RemoteBody item in objects.Values) Watch(item, engine.Now);
        this.now = now;
        while (timers.TryTakeDue(now, out uint id)) Destroy(id);
        placeholders.Request(now, options.Observer);
    }

    /// <summary>Does what a message says; those that are not about objects, or are about the local player, are not looked at.</summary>
    /// <param name="message">The message.</param>
    public void OnMessage(in WireMessage message)
    {
        if (player is null && message.Id.Opcode != Opcode.PlayerCreate && IsAboutObjects(message.Id.Opcode)) WaitForPlayer(message);
        else Dispatch(message);

        // What waited for this message is heard now, and what waited for that before the rest.
        while (replays.TryPeek(out Replay? replay))
        {
            if (!replay.TryTakeNext(out byte[]? bytes)) replays.Pop();
            else if (WireMessage.TryParse(bytes, out WireMessage waited)) Dispatch(waited);
        }
    }

    internal static bool IsAboutObjects(Opcode opcode) => opcode is Opcode.CreateObject or Opcode.UpdateObject or Opcode.UpdatePosition
        or Opcode.PositionAndMovement or Opcode.UpdateMotion or Opcode.VectorUpdate or Opcode.SetState or Opcode.ObjDescEvent
        or Opcode.ParentEvent or Opcode.PickupEvent or Opcode.DeleteObject or Opcode.Sound or Opcode.PlayScriptId or Opcode.PlayScriptType;

    private void Dispatch(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.PlayerCreate when IsReadable(message, out PlayerCreate value):
                MeetPlayer(value.Guid);
                break;
            case Opcode.CreateObject when IsReadable(message, out CreateObject value):
                Create(value.Object, isForced: false, message);
                break;
            case Opcode.UpdateObject when IsReadable(message, out UpdateObject value):
                Create(value.Object, isForced: true, message);
                break;
            case Opcode.DeleteObject when IsReadable(message, out DeleteObject value):
                if (value.Guid == player) Drops.Add(RemoteDrop.NotOurs);
                else if (Meant(value.Guid, value.Instance, message) is { } item) Delete(item);
                break;
            case Opcode.UpdatePosition when IsReadable(message, out UpdatePosition value):
                if (Meant(value.Guid, value.Pack.Instance, message) is { } placed) Place(placed, value.Pack);
                break;
            case Opcode.UpdateMotion when IsReadable(message, out UpdateMotion value):
                if (Meant(value.Guid, value.Instance, message) is { } moved) Move(moved, value);
                break;
            case Opcode.PositionAndMovement when IsReadable(message, out PositionAndMovement value):
                // The movement acts unless the object is not the one meant; a position that comes late does not stop it.
                if (Meant(value.Position.Guid, value.Position.Pack.Instance, message) is not { } both) break;
                Place(both, value.Position.Pack);
                Move(both, value.Motion);
                break;
            case Opcode.VectorUpdate when IsReadable(message, out VectorUpdate value):
                if (Meant(value.Guid, value.Instance, message) is { } hurled) Hurl(hurled, value);
                break;
            case Opcode.SetState when IsReadable(message, out SetState value):
                if (Meant(value.Guid, value.Instance, message) is { } changed)
                    CountLate(changed.TryTakeState(value.State, value.StateStamp));
                break;
            case Opcode.ObjDescEvent when IsReadable(message, out ObjDescEvent value):
                if (Meant(value.Guid, value.Instance, message) is { } dressed)
                    CountLate(dressed.TryTakeModel(value.Model, value.ObjDescStamp));
                break;
            case Opcode.PickupEvent when IsReadable(message, out PickupEvent value):
                if (Meant(value.Guid, value.Instance, message) is { } taken) PickUp(taken, value.PositionStamp);
                break;
            case Opcode.ParentEvent when IsReadable(message, out ParentEvent value):
                Hold(value, message);
                break;
            case Opcode.Sound when IsReadable(message, out Sound value):
                WaitIfUnknown(value.Guid, message);
                break;
            case Opcode.PlayScriptId when IsReadable(message, out PlayScriptId value):
                WaitIfUnknown(value.Guid, message);
                break;
            case Opcode.PlayScriptType when IsReadable(message, out PlayScriptType value):
                WaitIfUnknown(value.Guid, message);
                break;
            case Opcode.PublicUpdatePropertyInt when IsReadable(message, out PublicUpdatePropertyInt value):
                if (value.Property == WeenieForms.StatusProperty) Find(value.Guid)?.TakeKillerStatus(value.Value);
                break;
        }
    }

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value)) return true;
        Drops.Add(RemoteDrop.Unreadable);
        return false;
    }

    /// <summary>The object that a message is for. When there is none, the message waits, is dropped, or is the local player's.</summary>
    /// <remarks>The instance rule of specification 09, 5.1.</remarks>
    private RemoteBody? Meant(uint guid, ushort instance, in WireMessage message)
    {
        if (guid == player) return null;
        if (!objects.TryGetValue(guid, out RemoteBody? item))
        {
            Wait(guid, message);
            return null;
        }

        InstanceAge age = item.Stamps.AgeOf(instance);
        if (age == InstanceAge.Current) return item;

        // What is ahead would hang on this object, and go with it when the next one of its id comes.
        Drops.Add(age == InstanceAge.Ahead ? RemoteDrop.LaterLife : RemoteDrop.EarlierLife);
        return null;
    }

    private void Wait(uint guid, in WireMessage message)
    {
        if (guid == 0) Drops.Add(RemoteDrop.BadValue);
        else if (placeholders.TryQueue(guid, message.Bytes, now)) timers.Start(guid, now);
    }

    private void WaitIfUnknown(uint guid, in WireMessage message)
    {
        if (guid != player && !objects.ContainsKey(guid)) Wait(guid, message);
    }

    private void WaitForPlayer(in WireMessage message)
    {
        if (bytesBeforePlayer + message.Bytes.Length > options.MostWaitingBytes)
        {
            Drops.Add(RemoteDrop.NoRoom);
            return;
        }

        beforePlayer.Add(message.Bytes.ToArray());
        bytesBeforePlayer += message.Bytes.Length;
    }

    /// <summary>The first one that the server names is the player; what waited for that is heard now.</summary>
    private void MeetPlayer(uint guid)
    {
        if (player is not null) return;
        player = guid;
        replays.Push(new Replay([.. beforePlayer]));
        beforePlayer.Clear();
        bytesBeforePlayer = 0;
    }

    private void CountLate(bool isNews)
    {
        if (!isNews) Drops.Add(RemoteDrop.Late);
    }

    private void Place(RemoteBody item, in PositionPack pack)
    {
        if (!WireForms.TryRead(pack.Position, out Position place))
        {
            Drops.Add(RemoteDrop.BadValue);
            return;
        }

        bool isNews = item.TryTakePosition(place, pack.Contact, pack.PositionStamp, pack.Teleport, pack.Placement);
        CountLate(isNews);
        if (isNews) WatchAnew(item);
    }

    private void Move(RemoteBody item, in UpdateMotion motion)
    {
        CountLate(item.TryObey(
            motion.Movement, motion.MovementStamp, motion.ServerControlledMove, motion.Autonomous, orders, out bool isReadable));
        if (!isReadable) Drops.Add(RemoteDrop.BadValue);
    }

    private void Hurl(RemoteBody item, in VectorUpdate vector)
    {
        if (WireForms.IsVector(vector.Velocity) && WireForms.IsVector(vector.Omega))
            CountLate(item.TryTakeVelocity(vector.Velocity, vector.Omega, vector.VectorStamp));
        else
            Drops.Add(RemoteDrop.BadValue);
    }

    private void PickUp(RemoteBody item, ushort positionStamp)
    {
        bool isNews = item.TryLeave(positionStamp);
        CountLate(isNews);
        if (isNews) Unwatch(item);
    }

    /// <summary>A holder takes an object.</summary>
    /// <remarks>
    /// Retail: SmartBox::HandleParentEvent @0x004535D0. The holder must be known, then what it holds, also when the message is late for the
    /// holder.
    /// </remarks>
    private void Hold(in ParentEvent link, in WireMessage message)
    {
        if (FindHolder(link.Parent) is not { } holder)
        {
            Wait(link.Parent, message);
            return;
        }

        InstanceAge age = AgeOfHolder(link.Parent, link.ParentInstance);
        if (age == InstanceAge.Ahead || link.Child == player)
        {
            Drops.Add(age == InstanceAge.Ahead ? RemoteDrop.LaterLife : RemoteDrop.NotOurs);
            return;
        }

        if (!objects.TryGetValue(link.Child, out RemoteBody? item)) Wait(link.Child, message);
        else if (age == InstanceAge.Stale) Drops.Add(RemoteDrop.EarlierLife);
        else Hold(item, holder, link.Location, link.Placement, link.PositionStamp);
    }

    private void Hold(RemoteBody item, PhysicsBody holder, uint location, uint? placement, ushort positionStamp)
    {
        bool isNews = item.TryBeHeld(holder, location, placement, positionStamp, out bool isHeld);
        CountLate(isNews);
        if (isHeld) Unwatch(item);
        else if (isNews) Drops.Add(RemoteDrop.NotHeld);
    }

    /// <summary>The body that may hold something: an object's, or the local player's.</summary>
    private PhysicsBody? FindHolder(uint guid) =>
        objects.TryGetValue(guid, out RemoteBody? item) ? item.Body : guid == player ? engine.Find(guid) : null;

    private InstanceAge AgeOfHolder(uint guid, ushort instance)
    {
        if (objects.TryGetValue(guid, out RemoteBody? item)) return item.Stamps.AgeOf(instance);
        if (playerInstance is not { } own || own == instance) return InstanceAge.Current;
        return MessageStamps.IsNewer(own, instance) ? InstanceAge.Ahead : InstanceAge.Stale;
    }

    /// <summary>Messages that waited, and how many of them have been heard.</summary>
    private sealed class Replay(List<byte[]> messages)
    {
        private int next;

        internal bool TryTakeNext([NotNullWhen(true)] out byte[]? message)
        {
            message = next < messages.Count ? messages[next++] : null;
            return message is not null;
        }
    }
}
