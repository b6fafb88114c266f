using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>A creature: its wits, its driver, and what clients are told of it.</summary>
internal sealed class CreatureItem : WorldItem, ICreatureListener
{
    private const uint CreatureType = 0x10, Attackable = 0x10, Stuck = 0x4;

    /// <summary>How fast it runs when it must, as a factor of its motions' own speed: as a player of some skill.</summary>
    private const float RunRate = 2f;

    /// <summary>A hunter chases who comes so near, until it is so far from home, metres.</summary>
    private const double HuntsWithin = 15, HuntsUpTo = 60;

    private readonly WorldSpawn spawn;
    private readonly SetupAsset shape;
    private readonly CreatureMind mind;
    private MovementData order = MovementData.Motion(0, new WireInterpretedMotion());
    private ObjectStamps stamps = new(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1);

    public CreatureItem(WorldStage stage, uint id, WorldSpawn spawn, SetupAsset shape, MotionTableAsset? motions, ulong seed)
        : base(stage)
    {
        this.spawn = spawn;
        this.shape = shape;
        Body = stage.Engine.CreateBody(
            id, shape, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature,
            motions: new BodyMotions(motions, new OtherWeenie()));
        CreatureDriver driver = new(stage.Engine, Body, this, new CreatureDriverOptions { RunRate = RunRate, Stamps = stamps });
        driver.Home = spawn.Place;
        mind = new CreatureMind(driver, spawn.Place, spawn.WanderRadius, OnGround, seed);
    }

    public override PhysicsBody Body { get; }

    public override ushort Instance => stamps.Instance;

    /// <summary>A person wants it to do something.</summary>
    public void Ask(CreatureWish wish, uint player) => mind.Ask(wish, player, Stage.Engine.Now);

    /// <summary>It decides what to do next; before the world's tick.</summary>
    public void Act(double now)
    {
        if (!IsThere)
        {
            if (Body is { IsLost: false } && Stage.IsLoaded(spawn.Place)) Body.EnterWorld(spawn.Place);
            return;
        }

        if (spawn.Kind == WorldSpawnKind.Hunter) Hunt(now);
        mind.Act(now);
    }

    /// <summary>It looks how that goes; after the world's tick.</summary>
    public void LookOn() => mind.LookOn();

    public override CreateObject Describe() => new(new ObjectDescription(
        Id, new ModelData(),
        new PhysicsDescription
        {
            State = (uint)Body.State,
            Setup = shape.Id,
            MotionTable = shape.DefaultMotionTableId == 0 ? null : shape.DefaultMotionTableId,
            Movement = order,
            Position = WireOf(Body.Position),
            Scale = Body.Scale,
            Stamps = stamps,
        },
        new WeenieDescription { Name = spawn.Name, ItemType = CreatureType, Description = Attackable | Stuck }));

    void ICreatureListener.OnMotion(CreatureDriver creature, in UpdateMotion message)
    {
        order = message.Movement;
        stamps = stamps with { Movement = message.MovementStamp, ServerControlledMove = message.ServerControlledMove };
        Audience.Tell(message);
    }

    void ICreatureListener.OnPosition(CreatureDriver creature, in UpdatePosition message)
    {
        stamps = stamps with { Position = message.Pack.PositionStamp };
        Audience.Tell(message);
    }

    private void Hunt(double now)
    {
        bool isFar = Place.DistanceTo(spawn.Place) > HuntsUpTo;
        if (mind.Wish == CreatureWish.Follow && isFar) mind.Ask(CreatureWish.AsItLikes, 0, now);
        if (mind.Wish != CreatureWish.AsItLikes || isFar) return;
        foreach (PlayerItem player in Stage.Players)
        {
            if (!player.IsThere || player.Broadcast.IsTeleporting || player.Place.DistanceTo(Place) > HuntsWithin) continue;
            mind.Ask(CreatureWish.Follow, player.Id, now);
            return;
        }
    }

    private Position? OnGround(Position place)
    {
        if (!place.AdjustToOutside() || Stage.Engine.World.FindLandblock(place.CellId) is not { } block) return null;
        Vector3 at = place.Frame.Origin;
        if (!block.Terrain.TryGetHeight(at.X, at.Y, out float height)) return null;
        place.Frame.Origin.Z = height;
        return place;
    }
}
