using System.Net;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client.Tests.Peer;

/// <summary>A client on a server: a session, and in the world everything that goes with it.</summary>
internal sealed class OnlinePlayer : ISessionHandler, IMovementObserver, IDisposable
{
    private readonly List<byte[]> messages = [];
    private readonly PhysicsDataCache assets;

    internal OnlinePlayer(IPEndPoint server, PhysicsDataCache assets, ClientSessionOptions options)
    {
        this.assets = assets;
        Session = new WorldSession(server, options);
    }

    internal WorldSession Session { get; }

    /// <summary>The stay in the world; null before the first.</summary>
    internal GameClient? Game { get; private set; }

    internal LocalPlayer Player => Game!.Player!;

    internal Position Position => Player.Body.Position;

    internal uint Id => Session.Player;

    internal MovementKeys Keys { get; set; }

    /// <summary>What was sent, in words: moves, jumps, places.</summary>
    internal List<object> Sent { get; } = [];

    /// <summary>
    /// Time, keys and place of each frame since <see cref="Record"/>, from the first on in which bodies moved; null while nobody records.
    /// </summary>
    internal List<Frame>? Frames { get; private set; }

    public void OnMessage(in WireMessage message) => messages.Add(message.Bytes.ToArray());

    public void OnStateChanged(SessionState state)
    {
    }

    public void OnMoveToState(in MoveToState message, double now) => Sent.Add(message);

    public void OnJump(in Jump message, double now) => Sent.Add(message);

    public void OnAutonomousPosition(in AutonomousPosition message, double now) => Sent.Add(message);

    public void Dispose() => Session.Dispose();

    /// <summary>Asks to enter the world; what the server says from now on builds it.</summary>
    internal void EnterWorld(uint guid)
    {
        Game = new GameClient(assets, new SessionLink(Session, this), new GameClientOptions { Observer = this });
        Session.EnterWorld(guid);
    }

    internal void Update(double now)
    {
        if (Game is null)
        {
            Session.Update(this);
            return;
        }

        bool moved = Game.Update(Keys, now);
        Session.Flush();
        if (Frames is { } frames && (moved || frames.Count > 0)) frames.Add(new Frame(now, Keys, Position));
    }

    internal void Record() => Frames = [];

    /// <summary>All messages of a type that came, oldest first.</summary>
    internal IEnumerable<T> Heard<T>()
        where T : IMessage<T>
    {
        for (int i = 0; i < messages.Count; i++)
            if (WireMessage.TryParse(messages[i], out WireMessage message) && message.TryRead(out T value)) yield return value;
    }

    /// <summary>Where the server said last that an object is.</summary>
    internal PositionPack? LastPlaceOf(uint guid) =>
        Heard<UpdatePosition>().Where(m => m.Guid == guid).Select(m => (PositionPack?)m.Pack).LastOrDefault();

    /// <summary>Metres from where the server says the player is to where it is; infinite before the server has said it.</summary>
    internal float Disagreement => LastPlaceOf(Id) is { } told
        ? Distance(told.Position, Position)
        : float.PositiveInfinity;

    internal static float Distance(in WirePosition told, in Position position) =>
        (CellIds.BlockOffset(position.CellId, told.Cell) + told.Origin - position.Frame.Origin).Length();

    internal sealed record Frame(double Now, MovementKeys Keys, Position Position);
}
