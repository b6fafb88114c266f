using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>A player's own client: its world, its body, its keys. What it tells goes into a session with a bad network.</summary>
internal sealed class PlayedClient : IMovementObserver, IDisposable
{
    internal const uint PlayerId = 0x50000001;

    private readonly PhysicsEngine engine;
    private readonly double began;
    private readonly SimulatedSession session;
    private uint loadedBlock;

    /// <summary>A client whose player is at a place; its world's time goes on from where it is.</summary>
    internal PlayedClient(
        PhysicsEngine engine, SetupAsset setup, MotionTableAsset motions, in Position place, CharacterStats stats, SimulatedSession session)
    {
        this.engine = engine;
        this.session = session;
        began = engine.Now + 1;
        engine.World.EnsureLoadedAround(place, 1);
        engine.Tick(began);
        Player = LocalPlayer.Spawn(
            engine, PlayerId, setup, motions, place, new LoopbackServer(PlayerId, stats, began), new LocalPlayerOptions { Observer = this })
            ?? throw new InvalidDataException($"There is no room for a player at {place}.");
    }

    internal LocalPlayer Player { get; }

    internal PhysicsBody Body => Player.Body;

    internal Position Position => Player.Body.Position;

    /// <summary>How fast its clock runs; 1 for an honest one.</summary>
    internal double ClockRate { get; set; } = 1;

    /// <summary>Messages that told where the player is.</summary>
    internal int PositionsTold { get; private set; }

    /// <summary>Messages of its movement.</summary>
    internal int ClaimsTold { get; private set; }

    /// <summary>What it says of whether it stands on the ground; null for the truth.</summary>
    internal bool? SaysContact { get; set; }

    private double ClientTime { get; set; }

    /// <summary>A frame.</summary>
    /// <param name="keys">The keys held.</param>
    /// <param name="frame">How long the last one was, seconds of the world's time.</param>
    internal void Frame(MovementKeys keys, double frame)
    {
        ClientTime += frame * ClockRate;
        uint block = CellIds.BlockOf(Position.CellId);
        if (block != loadedBlock) engine.World.EnsureLoadedAround(Position, 1);
        loadedBlock = block;
        Player.Update(keys, began + ClientTime);
        engine.Tick(began + ClientTime);
    }

    /// <summary>Tells where the body is although no rule asks for it.</summary>
    internal void TellPosition()
    {
        Position here = Position;
        OnAutonomousPosition(new AutonomousPosition(
            new WirePosition(here.CellId, here.Frame.Origin, here.Frame.Rotation), new MovementStamps(1, 0, 0, 0), Contact: true), 0);
    }

    public void OnMoveToState(in MoveToState message, double now)
    {
        PositionsTold++;
        Send(message with { Contact = SaysContact ?? message.Contact });
    }

    public void OnJump(in Jump message, double now) => Send(message);

    public void OnAutonomousPosition(in AutonomousPosition message, double now)
    {
        PositionsTold++;
        Send(message with { Contact = SaysContact ?? message.Contact });
    }

    private void Send<T>(in T message)
        where T : IGameAction<T>
    {
        ClaimsTold++;
        session.SendToServer(message);
    }

    public void Dispose() => engine.RemoveBody(Body);
}
