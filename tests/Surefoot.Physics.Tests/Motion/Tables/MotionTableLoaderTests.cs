using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Motion;

public class MotionTableLoaderTests
{
    private static MotionData Data(uint animation, Vector3 velocity = default) => new()
    {
        Animations = [new MotionAnimation(animation, 0, -1, 30f)],
        Flags = MotionDataFlags.HasVelocity,
        Velocity = velocity,
    };

    private static readonly MotionTable Table = new()
    {
        Id = 0x09000001,
        DefaultStyle = 0x8000003D,
        Styles = [new MotionStyle(0x8000003D, 0x41000003)],
        Cycles = [new KeyedMotion(0x003D0003, Data(0x03000001)), new KeyedMotion(0x003D0005, Data(0x03000099, new Vector3(0, 3.12f, 0)))],
        Modifiers = [new KeyedMotion(0x0000000D, Data(0x03000001))],
        Links = [new MotionLinks(0x003D0003, [new KeyedMotion(0x45000005, Data(0x03000001))])],
    };

    private static Animation? Find(uint id) => id != 0x03000001 ? null : new Animation
    {
        Id = id,
        Flags = AnimationFlags.HasRootMotion,
        RootMotion = [new DatFrame(new Vector3(0, 1, 0), Quaternion.Identity), DatFrame.Identity],
        Frames = [new AnimFrame([], []), new AnimFrame([], [])],
    };

    [Fact]
    [Behaviour("motion.table.loads-from-records", "spec/07, 7.7 and 7.9")]
    public void A_table_is_flattened_from_its_records()
    {
        MotionTableAsset table = MotionTableLoader.Create(Table, Find);
        Assert.Equal((0x09000001u, MotionCommand.NonCombat, MotionCommand.Ready),
            (table.Id, table.DefaultStyle, table.DefaultSubstate(MotionCommand.NonCombat)));
        AnimationSpan span = table.Cycle(MotionCommand.NonCombat, MotionCommand.Ready)!.Animations[0];
        Assert.Equal((2, new Vector3(0, 1, 0)), (span.Animation.FrameCount, span.Animation.PositionFrames[0].Origin));
        Assert.Same(span.Animation, table.Modifier(MotionCommand.DualWieldCombat, MotionCommand.TurnRight)!.Animations[0].Animation);
        Assert.NotNull(table.Link(MotionCommand.NonCombat, MotionCommand.Ready, 1f, MotionCommand.WalkForward, 1f));
        Assert.Null(table.Cycle(MotionCommand.NonCombat, MotionCommand.RunForward));
    }

    [Fact]
    [Behaviour("motion.table.missing-animation-is-left-out", "spec/01b, 1, node")]
    public void A_missing_animation_is_left_out_and_the_velocity_stays()
    {
        MotionAsset walk = MotionTableLoader.Create(Table, Find).Cycle(MotionCommand.NonCombat, MotionCommand.WalkForward)!;
        Assert.Equal(0, walk.Animations.Length);
        Assert.Equal(new Vector3(0, 3.12f, 0), walk.Velocity);
    }

    [Fact]
    [Behaviour("motion.table.unusable-animations-are-listed", "spec/07, 9.1")]
    public void Animations_that_are_missing_unreadable_or_without_frames_are_left_out_and_listed()
    {
        const uint missing = 0x03000099, unreadable = 0x03000098, empty = 0x03000097;
        MotionTable table = new()
        {
            Id = 0x09000001,
            Cycles = [
                .. new uint[] { missing, unreadable, empty, 0x03000001 }.Select(
                    (animation, i) => new KeyedMotion((uint)i, Data(animation)))],
        };
        MemorySource source = new MemorySource().Add(table, Find(0x03000001)!, new Animation { Id = empty });
        source.Add(unreadable, 0x98, 0, 0, 3, 1);
        LeftOutList leftOut = new();
        SetupAsset human = new() { Id = 0x02000001, DefaultMotionTableId = table.Id };
        MotionTableAsset loaded = MotionTableLoader.LoadFor(source, human, leftOut: leftOut);
        Assert.Equal([missing, unreadable, empty], leftOut.Select(item => item.Id));
        Assert.All(leftOut, item => Assert.Equal((LeftOutKind.Animation, table.Id, 1), (item.Kind, item.FirstIn, item.Count)));
        Assert.Equal(
            ["Animation 0x03000099 is not in the dat files", "the record ends here: 4 bytes wanted, 1 left", "it has no frames"],
            leftOut.Select(item => item.Reason));
        Assert.NotNull(loaded);
        Assert.NotNull(MotionTableLoader.Load(source, table.Id));
    }

    [Fact]
    [Behaviour("motion.table.setup-names-none", "spec/07, 9.1")]
    public void A_setup_without_a_motion_table_is_one_sentence_and_one_whose_table_is_missing_names_both()
    {
        MemorySource source = new();
        InvalidDataException none = Assert.Throws<InvalidDataException>(
            () => MotionTableLoader.LoadFor(source, new SetupAsset { Id = 0x02000001 }));
        Assert.Equal("Setup 0x02000001 names no motion table, and such a body cannot walk by itself.", none.Message);
        DatRecordMissingException missing = Assert.Throws<DatRecordMissingException>(
            () => MotionTableLoader.LoadFor(source, new SetupAsset { Id = 0x02000001, DefaultMotionTableId = 0x09000005 }));
        Assert.Equal((0x09000005u, 0x02000001u), (missing.Id, missing.RequestedBy));
    }

    [Fact]
    [Behaviour("motion.table.loads-parts-and-hooks", "spec/07, 7.6 to 7.8; spec/02, 4.18")]
    public void Parts_are_loaded_on_request_and_hooks_always()
    {
        Animation swing = new()
        {
            Id = 0x03000001,
            PartCount = 2,
            Frames =
            [
                new AnimFrame([new DatFrame(Vector3.UnitX, Quaternion.Identity), DatFrame.Identity],
                    [new SoundHook(1), new EtherealHook(1) { Direction = 1 }]),
                new AnimFrame(
                    [DatFrame.Identity, new DatFrame(Vector3.UnitY, Quaternion.Identity)],
                    [
                        new SetOmegaHook(Vector3.UnitZ), new ScaleHook(2, 0.5f) { Direction = -1 }, new ScaleHook(float.NaN, 0),
                        new EtherealHook(0)]),
            ],
        };
        AnimationAsset Load(bool parts) => MotionTableLoader.Create(Table, id => id == swing.Id ? swing : null, parts)
            .Cycle(MotionCommand.NonCombat, MotionCommand.Ready)!.Animations[0].Animation;

        Assert.Equal(0, Load(parts: false).PartFrames(1).Length);
        AnimationAsset animation = Load(parts: true);
        Assert.Equal((2, Vector3.UnitX), (animation.PartFrames(0).Length, animation.PartFrames(0)[0].Origin));
        Assert.Equal(Vector3.UnitY, animation.PartFrames(1)[1].Origin);
        Assert.Equal(
            [
                Hook(MotionHookKind.Other, 0, 0, 0, Vector3.Zero), Hook(MotionHookKind.Ethereal, 0, 1, 1, Vector3.UnitX),
                Hook(MotionHookKind.Omega, 1, 0, 0, Vector3.UnitZ), Hook(MotionHookKind.Scale, 1, 1, -1, new Vector3(2, 0.5f, 0)),
                Hook(MotionHookKind.Other, 1, 2, 0, Vector3.Zero), Hook(MotionHookKind.Ethereal, 1, 3, 0, Vector3.Zero),
            ],
            animation.Hooks.ToArray());
        Assert.Throws<ArgumentException>(() => new AnimationAsset(1, 2, default, new Physics.Geometry.Frame[3]));

        MotionHook Hook(MotionHookKind kind, int frame, int index, int direction, Vector3 value) =>
            new(kind, frame, direction, value) { AnimationId = swing.Id, Index = index };
    }
}
