using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Human;

/// <summary>The human's motion table and animations.</summary>
/// <remarks>
/// Velocities are retail's (spec 01, 3): walk 3.12, run 4.0, sidestep 1.25 m/s and turn 1.5 rad/s at speed 1. They stand in the
/// table, not in the animations, so each animation frame passed hands out velocity / 30 (spec 01b, 4). Turning and
/// sidestepping have a cycle of their own, allowed from Ready only (bit 2), and act as modifiers while walking, running or
/// falling, whose cycles therefore leave bit 1 clear (spec 01b, 2). There is nothing for left and backward: they reach a table
/// as the right and forward motions with negative speed.
/// </remarks>
internal static class HumanMotions
{
    private const uint NonCombat = 0x8000003D;
    private const uint Ready = 0x41000003, Walk = 0x45000005, Run = 0x44000007, Turn = 0x6500000D, SideStep = 0x6500000F,
        Fallen = 0x40000008, Dead = 0x40000011, Crouch = 0x41000012, Sitting = 0x41000013, Sleeping = 0x41000014, Falling = 0x40000015;

    // Bit 1 takes running modifiers off when the cycle starts; bit 2 allows it from the default substate only.
    private const byte Plain = 0, ClearsModifiers = 1, OnlyFromDefault = 2;

    private const float FramesPerSecond = 30f;

    /// <summary>Table and animations.</summary>
    public static IEnumerable<DatRecord> All()
    {
        var animations = new AnimationList();
        var table = Table(animations);
        return [table, .. animations.Records];
    }

    private static MotionTable Table(AnimationList animations)
    {
        uint ready = animations.Cycle(60, HumanPoses.Ready);
        uint walk = animations.Cycle(24, HumanPoses.Walk);
        uint run = animations.Cycle(20, HumanPoses.Run);
        uint sideStep = animations.Cycle(20, HumanPoses.SideStep);
        uint turn = animations.Cycle(16, HumanPoses.Turn);
        uint falling = animations.Cycle(20, HumanPoses.Falling);
        Vector3 turnOmega = new(0, 0, -1.5f), sideStepVelocity = new(1.25f, 0, 0);
        return new()
        {
            Id = DemoIds.HumanMotionTable,
            DefaultStyle = NonCombat,
            Styles = [new(NonCombat, Ready)],
            Cycles =
            [
                Keyed(Ready, Motion(ClearsModifiers, ready)),
                Keyed(Walk, Motion(Plain, walk, velocity: new(0, 3.12f, 0))),
                Keyed(Run, Motion(Plain, run, velocity: new(0, 4f, 0))),
                Keyed(Fallen, Motion(ClearsModifiers, animations.Still(HumanPoses.Fallen()))),
                Keyed(Turn, Motion(OnlyFromDefault, turn, omega: turnOmega)),
                Keyed(SideStep, Motion(OnlyFromDefault, sideStep, velocity: sideStepVelocity)),
                Keyed(Dead, Motion(ClearsModifiers, animations.Still(HumanPoses.Dead()))),
                Keyed(Crouch, Motion(ClearsModifiers, animations.Still(HumanPoses.Crouch()))),
                Keyed(Sitting, Motion(ClearsModifiers, animations.Still(HumanPoses.Sitting()))),
                Keyed(Sleeping, Motion(ClearsModifiers, animations.Still(HumanPoses.Sleeping()))),
                Keyed(Falling, Motion(Plain, falling)),
            ],
            Modifiers =
            [
                Keyed(Turn, Motion(Plain, null, omega: turnOmega)),
                Keyed(SideStep, Motion(Plain, null, velocity: sideStepVelocity)),
            ],
            Links = Links(animations),
        };
    }

    // Short, so that nothing seems to wait for them. The velocity is the coming cycle's from the first frame on.
    private static ImmutableArray<MotionLinks> Links(AnimationList animations)
    {
        HumanPose ready = HumanPoses.Ready(0), walk = HumanPoses.Walk(0), run = HumanPoses.Run(0), falling = HumanPoses.Falling(0);
        KeyedMotion To(uint motion, int frames, HumanPose from, HumanPose to)
            => new(motion, Motion(Plain, animations.Transition(frames, from, to)));
        return
        [
            new(MotionTable.KeyOf(NonCombat, Ready),
            [
                To(Walk, 4, ready, walk),
                To(Run, 4, ready, run),
                To(Falling, 3, ready, falling),
                To(Dead, 20, ready, HumanPoses.Dead()),
                To(Fallen, 12, ready, HumanPoses.Fallen()),
                To(Crouch, 10, ready, HumanPoses.Crouch()),
                To(Sitting, 18, ready, HumanPoses.Sitting()),
                To(Sleeping, 24, ready, HumanPoses.Sleeping()),
            ]),
            new(MotionTable.KeyOf(NonCombat, Walk), [To(Ready, 4, walk, ready), To(Run, 3, walk, run), To(Falling, 3, walk, falling)]),
            new(MotionTable.KeyOf(NonCombat, Run), [To(Ready, 5, run, ready), To(Walk, 3, run, walk), To(Falling, 3, run, falling)]),
            new(MotionTable.KeyOf(NonCombat, Falling),
                [To(Ready, 6, falling, ready), To(Walk, 3, falling, walk), To(Run, 3, falling, run)]),
            new(MotionTable.KeyOf(NonCombat, Fallen), [To(Ready, 16, HumanPoses.Fallen(), ready)]),
            new(MotionTable.KeyOf(NonCombat, Crouch), [To(Ready, 10, HumanPoses.Crouch(), ready)]),
            new(MotionTable.KeyOf(NonCombat, Sitting), [To(Ready, 18, HumanPoses.Sitting(), ready)]),
            new(MotionTable.KeyOf(NonCombat, Sleeping), [To(Ready, 24, HumanPoses.Sleeping(), ready)]),
        ];
    }

    private static KeyedMotion Keyed(uint motion, MotionData data) => new(MotionTable.KeyOf(NonCombat, motion), data);

    private static MotionData Motion(byte bitfield, uint? animation, Vector3 velocity = default, Vector3 omega = default) => new()
    {
        Bitfield = bitfield,
        Flags = (velocity != default ? MotionDataFlags.HasVelocity : 0) | (omega != default ? MotionDataFlags.HasOmega : 0),
        Animations = animation is { } id ? [new(id, 0, -1, FramesPerSecond)] : [],
        Velocity = velocity,
        Omega = omega,
    };
}
