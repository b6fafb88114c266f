using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.Transitions.Obstacles;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;
using EnvCellRecord = Surefoot.Dats.Records.EnvCell;
using StaticObject = Surefoot.Physics.World.StaticObject;
using StaticRecord = Surefoot.Dats.Records.StaticObject;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>
/// Statics whose setup names a default animation: specification 02, 4.19, and 06, 3. The slab of two metres lies at x = 0, 4 and 8 in the
/// three frames, at x = 30 when nothing moves it. A tick of 0.04 s is 1.2 frames of 30 a second.
/// </summary>
public sealed class AnimatedStaticTests
{
    private const uint Mill = 0x02000001, Turning = 0x03000001, Shapes = 0x0D000001, Room = 0xA9B40100;
    private const double Tick = 0.04;

    private static readonly Vector3 Place = new(100, 100, 5);

    [Fact, Behaviour("object.animated.parts-follow", "spec/02, 4.19; spec/01b, 1: frames 1.2, 2.4, then 3.6 less 3 is 0.6, 1.8, 3.0")]
    public void A_static_with_a_default_animation_moves_its_part_and_is_hit_where_it_is()
    {
        PhysicsWorld world = Outdoors().World();
        PhysicsEngine engine = new(world);
        StaticObject mill = Only(world);
        Assert.True(mill.State.HasFlag(PhysicsState.HasDefaultAnim));
        Assert.Equal(0f, SlabAt(mill));
        for (int i = 1; i <= 4; i++)
        {
            engine.Tick(i * Tick);
            Assert.Equal(i switch { 1 => 4f, 2 => 8f, 3 => 0f, _ => 4f }, SlabAt(mill));
        }
    }

    [Fact, Behaviour("object.animated.in-rooms", "spec/02, 4.19; spec/05, 4.7, 7")]
    public void A_static_of_a_room_moves_as_well()
    {
        PhysicsWorld world = Base(new LandBlockInfo { Id = WorldRecords.Info, CellCount = 1 }, animation: Frames()).Add(
            new EnvCellRecord
            {
                Id = Room,
                CellId = Room,
                Flags = EnvCellFlags.HasStaticObjects,
                EnvironmentId = Shapes,
                Position = DatFrame.Identity,
                StaticObjects = [new StaticRecord(Mill, At(Place))],
            },
            new CellEnvironment
            {
                Id = Shapes,
                Cells = [new CellStruct { CellTree = BspTree.OfLeaf(new BspNode()), PhysicsTree = BspTree.OfLeaf(new BspNode()) }],
            }).World();
        PhysicsEngine engine = new(world);
        StaticObject mill = Only(world);
        Assert.Equal(Room, mill.Position.CellId);
        engine.Tick(Tick);
        Assert.Equal(4f, SlabAt(mill));
    }

    [Fact]
    [Behaviour("object.animated.scenery", "spec/05, 4.8 f; spec/02, 4.19: the places of its parts are scaled from its first quantum on")]
    public void Animated_scenery_begins_at_unscaled_places_and_goes_on_at_scaled_ones()
    {
        PhysicsWorld world = Base(null, (i, j) => (i, j) == (3, 4) ? WorldRecords.Wooded : 0, Frames()).Add(new Scene
        {
            Id = WorldRecords.Scene,
            Objects =
            [
                new SceneObject
                {
                    ObjectId = Mill,
                    BaseFrame = At(new(2, 3, 0)),
                    Frequency = 1,
                    MinSlope = 0,
                    MaxSlope = 2,
                    MinScale = 2,
                    MaxScale = 2,
                },
            ],
        }).World();
        PhysicsEngine engine = new(world);
        StaticObject mill = Only(world);
        Assert.Equal((2f, true), (mill.Scale, mill.IsScenery));
        Assert.Equal(new Vector3(75, 94, 0), mill.PartFrame(0).Origin);
        engine.Tick(Tick);
        Assert.Equal(new Vector3(75 + 8, 94, 0), mill.PartFrame(0).Origin);
    }

    [Theory, Behaviour("object.animated.unreadable", "spec/06, 3; spec/07, 9.1; docs/fidelity.md")]
    [InlineData("missing", "is not in the dat files", 0)]
    [InlineData("no frames", "it has no frames", 8)]
    [InlineData("no parts", "it moves no parts", 8)]
    [InlineData("cut off", "", 16)]
    public void A_static_whose_animation_cannot_be_read_rests_and_is_counted_and_named(string fault, string reason, long offset)
    {
        Animation broken = new() { Id = Turning, Frames = fault == "no parts" ? [new AnimFrame([])] : [] };
        WorldRecords records = Base(
            new LandBlockInfo
            {
                Id = WorldRecords.Info,
                Objects = [new StaticRecord(Mill, At(Place)), new StaticRecord(Mill, At(Place + new Vector3(0, 20, 0)))],
            },
            animation: fault == "missing" ? null : broken);
        if (fault == "cut off") records.Add(Turning, [.. broken.Encode()[..12], 7, 0, 0, 0]);
        PhysicsWorld world = records.World();
        PhysicsEngine engine = new(world);
        engine.Tick(Tick);
        Assert.All(world.FindLandblock(WorldRecords.Block)!.StaticObjects, mill => Assert.Equal(30f, SlabDistance(mill)));

        LeftOutItem item = Assert.Single(world.LeftOut);
        Assert.Equal((LeftOutKind.Animation, Turning, 2L, Mill), (item.Kind, item.Id, item.Count, item.FirstIn));
        Assert.Contains(reason, item.Reason, StringComparison.Ordinal);
        Assert.Equal(offset, item.Offset);
    }

    [Fact, Behaviour("object.animated.time-rules", "spec/02, 4.19: less than 1/30 s waits, more than 2 s are lost")]
    public void Time_too_short_waits_and_time_too_long_is_lost()
    {
        StaticObject mill = Only(Outdoors().World());
        AnimatedStatic playing = new(mill, new PhysicsWorld(), 10);
        playing.Animate(10.03125);
        Assert.Equal(0f, SlabAt(mill));
        // 1.875 frames in the sixteenth of a second since the beginning.
        playing.Animate(10.0625);
        Assert.Equal(4f, SlabAt(mill));
        playing.Animate(12.125);
        Assert.Equal(4f, SlabAt(mill));
        // A clock that runs backwards is followed; 3.75 less 3.
        playing.Animate(5);
        playing.Animate(5.0625);
        Assert.Equal(0f, SlabAt(mill));
        // Two seconds are not too long: 60 frames, which end where they began.
        playing.Animate(7.0625);
        Assert.Equal(0f, SlabAt(mill));
        playing.Animate(7.125);
        Assert.Equal(8f, SlabAt(mill));
    }

    [Fact, Behaviour("object.animated.omega", "spec/02, 4.19: grotate(omega), omega itself and not times the time")]
    public void A_static_that_an_animation_spins_turns_by_omega_each_quantum()
    {
        StaticObject mill = Only(Outdoors(new SetOmegaHook(new Vector3(0, 0, MathF.PI / 2)) { Direction = 1 }).World());
        AnimatedStatic playing = new(mill, new PhysicsWorld(), 0);
        // The hook of frame 0 is passed in the first quantum and acts in the next.
        playing.Animate(Tick);
        Assert.Equal(0f, mill.Position.Frame.Heading);
        playing.Animate(2 * Tick);
        Assert.Equal(270, mill.Position.Frame.Heading, 1e-3);
        playing.Animate(2.5 + Tick);
        playing.Animate(2.5 + Tick + 0.2);
        Assert.Equal(180, mill.Position.Frame.Heading, 1e-3);
        Assert.Equal(0, (mill.PartFrame(0).Origin - (Place + new Vector3(-SlabDistance(mill), 0, 0))).Length(), 1e-4);
    }

    [Fact, Behaviour("object.animated.hooks", "spec/02, 4.18 and 4.19: hooks after the parts were moved")]
    public void An_animation_makes_its_static_ethereal_and_scales_it()
    {
        StaticObject mill = Only(Outdoors(new EtherealHook(1) { Direction = 1 }, new ScaleHook(2, 0) { Direction = 1 }).World());
        AnimatedStatic playing = new(mill, new PhysicsWorld(), 0);
        playing.Animate(Tick);
        Assert.Equal((true, 2f), (mill.State.HasFlag(PhysicsState.Ethereal), mill.Scale));
        Assert.Equal(4f, SlabDistance(mill));
        playing.Animate(2 * Tick);
        Assert.Equal(16f, SlabDistance(mill));
    }

    [Fact, Behaviour("object.animated.solid-again", "spec/02, 4.18 set_ethereal: solid again unless somebody is inside")]
    public void A_static_does_not_become_solid_around_a_body()
    {
        foreach (bool inside in new[] { true, false })
        {
            PhysicsWorld world = Outdoors(new EtherealHook(0) { Direction = 1 }).World();
            PhysicsEngine engine = new(world);
            StaticObject mill = Only(world);
            mill.State |= PhysicsState.Ethereal;
            PhysicsBody body = engine.CreateBody(1, StubWorld.Setup(new Sphere(new Vector3(0, 0, 0.5f), 0.5f)), PhysicsState.None);
            // The quantum that passes the hook puts the slab at x = 4 first.
            Assert.True(body.EnterWorld(new Position(mill.Position.CellId, Place + new Vector3(inside ? 4 : 0, 0, -0.2f))));
            new AnimatedStatic(mill, world, 0).Animate(Tick);
            Assert.Equal(inside, mill.State.HasFlag(PhysicsState.Ethereal));
        }
    }

    [Fact]
    [Behaviour("object.animated.cells", "spec/05, 4.7, 5, and 4.17: listed by where its parts are when it is placed; docs/fidelity.md")]
    public void The_cells_of_an_animated_static_are_those_of_its_first_frame_whenever_they_are_found()
    {
        PhysicsWorld world = Outdoors().World();
        PhysicsEngine engine = new(world);
        StaticObject mill = Only(world);
        Assert.Equal("A9B40025", Cells(mill));
        // Eight metres on its part is over the next square, at x = 120, within which it is not listed.
        for (int i = 1; i <= 2; i++) engine.Tick(i * Tick);
        Assert.Equal(8f, SlabAt(mill));
        CrossCells again = new(world);
        again.FindStatic(mill);
        Assert.Equal("A9B40025", CellListTests.Ids(again.Cells));
    }

    [Fact, Behaviour("object.animated.begins-with-its-block", "spec/02, 4.19; design, decision 5")]
    public void A_static_that_is_loaded_again_begins_anew()
    {
        PhysicsWorld world = Outdoors().World();
        PhysicsEngine engine = new(world);
        engine.Tick(Tick);
        Assert.Equal(4f, SlabAt(Only(world)));
        world.UnloadLandblock(WorldRecords.Block);
        engine.Tick(2 * Tick);
        Assert.True(world.LoadLandblock(WorldRecords.Block));
        Assert.Equal(0f, SlabAt(Only(world)));
        engine.Tick(3 * Tick);
        Assert.Equal(4f, SlabAt(Only(world)));
    }

    [Fact, Behaviour("engine.hash.animated-statics", "design, decision 5")]
    public void The_state_hash_tells_where_an_animation_is()
    {
        ulong[] hashes = [.. new[] { 3, 3, 4 }.Select(ticks =>
        {
            PhysicsEngine engine = new(Outdoors().World());
            for (int i = 1; i <= ticks; i++) engine.Tick(i * Tick);
            return engine.HashState();
        })];
        Assert.Equal(hashes[0], hashes[1]);
        Assert.NotEqual(hashes[0], hashes[2]);
    }

    [Fact, Behaviour("object.animated.quanta-without-allocation", "design, decision 4")]
    public void An_animated_static_allocates_nothing()
    {
        PhysicsEngine engine = new(Outdoors(new SetOmegaHook(Vector3.UnitZ) { Direction = 1 }).World());
        for (int i = 1; i < 100; i++) engine.Tick(i * Tick);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 100; i < 200; i++) engine.Tick(i * Tick);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    private static WorldRecords Outdoors(params AnimationHook[] hooks) => Base(
        new LandBlockInfo { Id = WorldRecords.Info, Objects = [new StaticRecord(Mill, At(Place))] }, animation: Frames(hooks));

    private static WorldRecords Base(LandBlockInfo? info, Func<int, int, int>? word = null, Animation? animation = null)
    {
        WorldRecords records = new WorldRecords().Ground(word, info: info is not null).Add(
            Assets.Records.Slab(),
            new Setup
            {
                Id = Mill,
                PartIds = [Assets.Records.SlabId],
                PlacementFrames = [new PlacementFrame(0, new AnimFrame([At(new(30, 0, 0))]))],
                SortingSphere = new DatSphere(Vector3.Zero, 1),
                DefaultAnimationId = Turning,
            });
        if (info is not null) records.Add(info);
        return animation is null ? records : records.Add(animation);
    }

    private static Animation Frames(params AnimationHook[] hooks) =>
        new() { Id = Turning, PartCount = 1, Frames = [new AnimFrame([At(Vector3.Zero)], [.. hooks]), Frame(4), Frame(8)] };

    private static AnimFrame Frame(float x) => new([At(new(x, 0, 0))]);

    private static DatFrame At(Vector3 origin) => WorldRecords.At(origin.X, origin.Y, origin.Z);

    private static StaticObject Only(PhysicsWorld world) => Assert.Single(world.FindLandblock(WorldRecords.Block)!.StaticObjects);

    /// <summary>How far from the object the slab is.</summary>
    private static float SlabDistance(StaticObject mill) => (mill.PartFrame(0).Origin - mill.Position.Frame.Origin).Length();

    /// <summary>Where along x, of the three places, the slab stops a small ball that is dipped into its top.</summary>
    private static float SlabAt(StaticObject mill) => Assert.Single(new[] { 0f, 4f, 8f }, x =>
    {
        Vector3 center = Place + new Vector3(x, 0, -0.05f);
        Mover mover = new Mover(MoverFlags.None, center, center, 0.1f).With(p => p.InsertType = InsertType.Placement);
        return mill.FindObjCollisions(mover.Transition) != TransitionState.OK;
    });

    private static string Cells(StaticObject item) =>
        string.Join(' ', Enumerable.Range(0, item.ShadowCount).Select(i => item.ShadowAt(i).CellId.ToString("X8")));
}
