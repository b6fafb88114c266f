using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>The body of a client's player in a world of its own, moved by keys; what it tells goes to the server.</summary>
internal sealed class PlayedPlayer : IMovementObserver, IDisposable
{
    private readonly TestClient client;
    private readonly PhysicsEngine engine;
    private readonly LocalPlayer player;
    private MovementKeys keys;
    private uint loaded;

    internal PlayedPlayer(DemoGround ground, TestClient client)
    {
        this.client = client;
        engine = new PhysicsEngine(ground.Cache, new PhysicsEngineOptions { Region = ground.Region });
        WirePosition at = client.Place;
        Position place = new(at.Cell, new Frame(at.Origin, at.Orientation));
        Load(place);
        Stats = new CharacterStats(200, 200, 60, 60);
        player = LocalPlayer.Spawn(
            engine, client.Id, ground.Human, ground.Motions, place, new LoopbackServer(client.Id, Stats, 0),
            new LocalPlayerOptions { Observer = this })!;
    }

    internal CharacterStats Stats { get; }

    /// <summary>How many messages it told.</summary>
    internal int Told { get; private set; }

    /// <summary>Is shown what it tells.</summary>
    internal Action<object>? Hears { get; init; }

    internal PhysicsBody Body => player.Body;

    internal void Hold(MovementKeys held) => keys = held;

    internal void Frame(double now)
    {
        Load(Body.Position);
        player.Update(keys, now);
        engine.Tick(now);
    }

    public void OnMoveToState(in MoveToState message, double now)
    {
        Note(message);
        client.Session.Send(message with { Stamps = client.Stamps });
    }

    public void OnJump(in Jump message, double now)
    {
        Note(message);
        client.Session.Send(message with { Stamps = client.Stamps });
    }

    public void OnAutonomousPosition(in AutonomousPosition message, double now)
    {
        Note(message);
        client.Session.Send(message with { Stamps = client.Stamps });
    }

    public void Dispose() => engine.RemoveBody(Body);

    private void Note<T>(in T message)
        where T : struct
    {
        Told++;
        Hears?.Invoke(message);
    }

    private void Load(in Position place)
    {
        if (CellIds.BlockOf(place.CellId) != loaded) engine.World.EnsureLoadedAround(place, 1);
        loaded = CellIds.BlockOf(place.CellId);
    }
}
