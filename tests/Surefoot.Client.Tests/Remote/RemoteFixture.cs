using System.Diagnostics.CodeAnalysis;
using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>An endless plain at z = 0 with the local player's body in it, and a server whose messages come as bytes.</summary>
internal sealed class RemoteFixture : IRemoteObserver
{
    internal const uint PlayerId = 0x50000001, One = 0x80000001, Other = 0x80000002;
    internal const uint Human = 0x02000001, Thing = 0x02000002, HumanTable = 0x09000001;
    internal const uint Hand = 1, NoSuchLocation = 9;
    internal const ushort NonCombat = 0x3D, RunForward = 0x07, WalkForward = 0x05;
    internal const uint Standing = (uint)PhysicsState.Default;
    internal const uint Creature = 0x10;

    internal static readonly Vector3 Start = new(100, 100, WalkFixture.RestHeight);
    internal static readonly MoveToParams Way = new((uint)MovementFlags.Default, 0.6f, 0, float.MaxValue, 1, 15, 0);

    private readonly byte[] bytes = new byte[4096];
    private int frames;

    internal RemoteFixture(
        RemoteWorldOptions? options = null, float playerDistance = 30, PhysicsEngine? engine = null, IObjectAssets? assets = null)
    {
        Engine = engine ?? new PhysicsEngine(new StubWorld(_ => StubWorld.Flat(0)));
        Assets = assets ?? new StubAssets();
        Remote = new RemoteWorld(Engine, Assets, (options ?? new RemoteWorldOptions { Player = PlayerId }) with { Observer = this });
        if (engine is not null) return;
        PhysicsBody player = Engine.CreateBody(
            PlayerId, StubAssets.HumanShape, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player);
        Assert.True(player.EnterWorld(new Position(StubWorld.CellId, Start + new Vector3(playerDistance, 0, 0))));
        Engine.Player = player;
    }

    internal PhysicsEngine Engine { get; }

    internal IObjectAssets Assets { get; }

    internal RemoteWorld Remote { get; }

    internal double Now => frames * WalkFixture.FrameTime;

    /// <summary>What the world told, in order.</summary>
    internal List<string> Told { get; } = [];

    internal RemoteBody Item => Remote.Find(One)!;

    internal PhysicsBody Body => Item.Body;

    internal Vector3 Origin => Body.Position.Frame.Origin;

    internal MovementManager Movement => Item.Movement!;

    internal InterpretedMotionState Motion => Movement.Interpreter.Interpreted;

    /// <summary>The leash of the object, or null while there is none.</summary>
    internal ConstraintManager? Leash => SteeredPhysicsBody.Of(Body).PositionManager?.Constraint;

    internal static ObjectStamps Stamps(ushort position = 0, ushort teleport = 0, ushort instance = 1) =>
        new(position, 0, 0, 0, teleport, 0, 0, 0, instance);

    internal static WirePosition At(Vector3 origin) => new(StubWorld.CellId, origin, Quaternion.Identity);

    /// <summary>A creature that stands at a place.</summary>
    internal static ObjectDescription Describe(uint guid, Vector3? origin = null, ObjectStamps? stamps = null) => new(
        guid, new ModelData(),
        new PhysicsDescription
        {
            State = Standing,
            Setup = Human,
            MotionTable = HumanTable,
            Position = origin is { } place ? At(place) : null,
            Stamps = stamps ?? Stamps(),
        },
        new WeenieDescription { Name = "a thing", ItemType = Creature });

    /// <summary>Something without motions.</summary>
    internal static ObjectDescription DescribeThing(uint guid, Vector3? origin = null)
    {
        ObjectDescription creature = Describe(guid, origin);
        return creature with
        {
            Physics = creature.Physics with { Setup = Thing, MotionTable = null },
            Weenie = new WeenieDescription { ItemType = 1 },
        };
    }

    internal static UpdatePosition PositionOf(
        Vector3 origin, ushort position, ushort teleport = 0, bool contact = true, ushort instance = 1, uint guid = One) =>
        new(guid, new PositionPack(At(origin), contact, instance, position, teleport, 0));

    internal static UpdateMotion MotionOf(
        ushort movement, ushort serverControl, in MovementData order, bool autonomous = false, ushort instance = 1, uint guid = One) =>
        new(guid, instance, movement, serverControl, autonomous, order);

    internal static MovementData Run(float speed = 1) =>
        MovementData.Motion(NonCombat, new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: speed));

    internal RemoteBody Create(ObjectDescription description)
    {
        Say(new CreateObject(description));
        RemoteBody? item = Remote.Find(description.Guid);
        Assert.NotNull(item);
        return item;
    }

    /// <summary>A creature that has stood for a few frames.</summary>
    internal RemoteBody CreateStanding(ObjectStamps? stamps = null)
    {
        RemoteBody item = Create(Describe(One, Start, stamps));
        Frames(5);
        Assert.True(item.Body.OnWalkable);
        return item;
    }

    /// <summary>The server says something.</summary>
    internal byte[] Say<T>(in T message)
        where T : IMessage<T>
    {
        byte[] encoded = Encode(message);
        SayBytes(encoded);
        return encoded;
    }

    internal byte[] Encode<T>(in T message)
        where T : IMessage<T>
    {
        Assert.True(WireMessage.TryWrite(message, bytes, out int length));
        return bytes[..length];
    }

    internal void SayBytes(ReadOnlySpan<byte> message)
    {
        if (WireMessage.TryParse(message, out WireMessage parsed)) Remote.OnMessage(parsed);
    }

    internal void Frames(int count)
    {
        for (int i = 0; i < count; i++)
        {
            frames++;
            Remote.Update(Now);
            Engine.Tick(Now);
        }
    }

    /// <summary>Frames up to a time; its own frame is the last.</summary>
    internal void FramesUntil(double time)
    {
        while ((frames + 1) * WalkFixture.FrameTime <= time) Frames(1);
    }

    public void OnCreated(RemoteBody item) => Told.Add($"created {item.Id:X}");

    public void OnDeleting(RemoteBody item) => Told.Add($"deleting {item.Id:X}");

    public void OnMissing(uint guid) => Told.Add($"missing {guid:X}");

    /// <summary>A human that can hold things, and a thing that cannot.</summary>
    internal sealed class StubAssets : IObjectAssets
    {
        internal static readonly SetupAsset HumanShape = new()
        {
            Id = Human,
            Spheres = WalkFixture.Setup.Spheres,
            Height = 1.83f,
            Radius = 0.48f,
            StepUpHeight = 0.6f,
            StepDownHeight = 0.6f,
            HoldingLocations = [new HoldingLocation(Hand, uint.MaxValue, new Frame(new Vector3(0.5f, 0.25f, 1), Quaternion.Identity))],
        };

        private static readonly SetupAsset ThingShape = new() { Id = Thing, Spheres = [new Sphere(new Vector3(0, 0, 0.1f), 0.1f)] };
        private static readonly MotionTableAsset Table = HumanoidTable.Create(smooth: true);

        public bool TryGetSetup(uint id, [NotNullWhen(true)] out SetupAsset? setup)
        {
            setup = id switch { Human => HumanShape, Thing => ThingShape, _ => null };
            return setup is not null;
        }

        public bool TryGetMotions(uint id, SetupAsset setup, [NotNullWhen(true)] out MotionTableAsset? table)
        {
            table = id == HumanTable ? Table : null;
            return table is not null;
        }
    }
}
