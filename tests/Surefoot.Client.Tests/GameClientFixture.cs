using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>A client over the demo world, and a server that says what a test has it say.</summary>
internal sealed class GameClientFixture
{
    internal const uint Id = KeyFixture.Id, Human = 0x02000001, HumanMotions = 0x09000001;
    internal const uint Shown = 0x600408, Hidden = 0x604410;
    internal const double FrameTime = WalkFixture.FrameTime;

    /// <summary>Those of the local player in the scenarios of specification 08, 11.12.</summary>
    internal static readonly ObjectStamps Stamps = new(
        Position: 10, Movement: 5, State: 0, Vector: 0, Teleport: 3, ServerControlledMove: 2, ForcePosition: 4, ObjDesc: 0, Instance: 1);

    internal GameClientFixture(DemoFiles files) => Game = new GameClient(files.Cache, Server, new GameClientOptions { Observer = Moves });

    internal FakeServer Server { get; } = new();

    internal Recorder Moves { get; } = new();

    internal GameClient Game { get; }

    internal double Now { get; private set; }

    internal LocalPlayer Player => Game.Player!;

    internal Position Position => Player.Body.Position;

    /// <summary>Types of the actions sent since the list was cleared, in order.</summary>
    internal List<GameActionType> Sent => [.. Server.Sent.Select(bytes =>
    {
        Assert.True(WireMessage.TryParse(bytes, out WireMessage message));
        return message.Id.Action;
    })];

    internal static WirePosition At(string place, Vector3 beside = default)
    {
        Assert.True(DemoPlaces.TryFind(place, out NamedPlace named));
        Position position = new(named.CellId, new Frame(named.Origin + beside, named.Orientation));
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        return WireForms.Of(position);
    }

    internal static ObjectDescription Describe(uint guid, WirePosition? place, ObjectStamps stamps, uint state = Shown) => new(
        guid, new ModelData(),
        new PhysicsDescription { State = state, Setup = Human, MotionTable = HumanMotions, Position = place, Stamps = stamps },
        new WeenieDescription { Name = "Alma", ItemType = 0x10, Description = 0x8 });

    internal static UpdatePosition PositionOf(WirePosition place, ushort position, ushort teleport, ushort force, ushort instance = 1) =>
        new(Id, new PositionPack(place, contact: true, instance, position, teleport, force));

    internal void Frames(int count, MovementKeys keys = MovementKeys.None)
    {
        for (int i = 0; i < count; i++) Game.Update(keys, Now += FrameTime);
    }

    /// <summary>The server says something, and a frame passes.</summary>
    internal void Say<T>(in T message)
        where T : IMessage<T>
    {
        Server.Say(message);
        Frames(1);
    }

    /// <summary>The player enters the world and stands there.</summary>
    internal void Enter(string place = "meadow")
    {
        Server.Say(new PlayerCreate(Id));
        Say(new CreateObject(Describe(Id, At(place), Stamps)));
        Frames(30);
        Assert.True(Game.IsPlaying && Player.Body.OnWalkable);
        Server.Sent.Clear();
    }
}
