using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;
using static Surefoot.DemoWorld.Motions.MotionIds;

namespace Surefoot.DemoWorld.Creatures;

/// <summary>The small creature: a quick one on four legs that trots and gallops, lies down to sleep, and bites.</summary>
internal static class Hound
{
    private const uint FirstAnimation = 0x03000101;
    private const uint Body = 0x01000170, Head = 0x01000171, Tail = 0x01000173, Upper = 0x01000174, Lower = 0x01000175;

    private static readonly BeastBuild Build = new(0.42, new(0, 0.27, 0.1), new(0, -0.32, 0.08), new(0.1, 0.2, -0.06),
        new(0.1, -0.25, -0.06), 0.18, 0.18);

    private static readonly Vector3 WalkVelocity = new(0, 1.5f, 0), RunVelocity = new(0, 3f, 0), SideStepVelocity = new(0.8f, 0, 0),
        TurnOmega = new(0, 0, -1.5f);

    private static BeastPose Standing => new(Build) { HindRight = -4, HindLeft = -4, HindRightKnee = -6, HindLeftKnee = -6 };

    /// <summary>Shapes, setup, motion table and animations.</summary>
    public static IEnumerable<DatRecord> All()
    {
        var animations = new AnimationList<BeastPose>(FirstAnimation);
        return
        [
            .. Shapes(),
            Beasts.Setup(DemoIds.SmallCreatureSetup, DemoIds.CreatureMotionTable, [Body, Head, Tail, Upper, Lower], Ready(0), 0.8f, 0.3f,
                [new(new(0, 0, 0.3f), 0.3f), new(new(0, 0, 0.55f), 0.3f)], []),
            Table(animations),
            .. animations.Records,
        ];
    }

    private static IEnumerable<DatRecord> Shapes() =>
    [
        Meshes.Drawn(Body, new BoxGrid()
            .Fill(new(-0.13, -0.34, -0.1, 0.13, 0.28, 0.14), Surfaces.Hide).Faces()),
        Meshes.Drawn(Head, new BoxGrid()
            .Fill(new(-0.09, -0.04, -0.06, 0.09, 0.2, 0.16), Surfaces.Hide)
            .Fill(new(-0.05, 0.2, -0.06, 0.05, 0.34, 0.05), Surfaces.Hide)
            .Fill(new(-0.09, -0.02, 0.16, -0.05, 0.02, 0.24), Surfaces.Boots)
            .Fill(new(0.05, -0.02, 0.16, 0.09, 0.02, 0.24), Surfaces.Boots).Faces()),
        Meshes.Drawn(Tail, new BoxGrid().Fill(new(-0.025, -0.3, -0.025, 0.025, 0.02, 0.025), Surfaces.Hide).Faces()),
        Meshes.Drawn(Upper, new BoxGrid().Fill(new(-0.045, -0.055, -0.18, 0.045, 0.055, 0.06), Surfaces.Hide).Faces()),
        Meshes.Drawn(Lower, new BoxGrid()
            .Fill(new(-0.035, -0.035, -0.14, 0.035, 0.035, 0), Surfaces.Hide)
            .Fill(new(-0.04, -0.035, -0.18, 0.04, 0.065, -0.14), Surfaces.Boots).Faces()),
    ];

    private static MotionTable Table(AnimationList<BeastPose> animations)
    {
        var sheet = new MotionSheet(DemoIds.CreatureMotionTable, NonCombat) { Style = NonCombat };
        BeastPose ready = Ready(0), walk = Trot(0), run = Gallop(0), falling = InTheAir(0);
        sheet.Cycle(MotionIds.Ready, CycleRule.None, animations.Cycle(60, Ready));
        sheet.Cycle(Walk, CycleRule.None, animations.Cycle(14, Trot), WalkVelocity);
        sheet.Cycle(Run, CycleRule.None, animations.Cycle(12, Gallop), RunVelocity);
        sheet.Cycle(Falling, CycleRule.None, animations.Cycle(12, InTheAir));
        sheet.Cycle(Turn, CycleRule.OnlyFromDefault, animations.Cycle(16, Step), omega: TurnOmega);
        sheet.Cycle(SideStep, CycleRule.OnlyFromDefault, animations.Cycle(16, Step), SideStepVelocity);
        sheet.Cycle(Sleeping, CycleRule.ClearsModifiers, animations.Cycle(90, Asleep));
        sheet.Cycle(Dead, CycleRule.ClearsModifiers, animations.Still(OnItsSide));
        sheet.Modifier(Turn, omega: TurnOmega);
        sheet.Modifier(SideStep, SideStepVelocity);
        sheet.Link(MotionIds.Ready, Walk, animations.Transition(4, ready, walk));
        sheet.Link(MotionIds.Ready, Run, animations.Transition(4, ready, run));
        sheet.Link(MotionIds.Ready, Falling, animations.Transition(3, ready, falling));
        sheet.Link(MotionIds.Ready, Sleeping, animations.Transition(20, ready, Asleep(0)));
        sheet.Link(MotionIds.Ready, Dead, animations.Transition(14, ready, OnItsSide));
        sheet.Link(MotionIds.Ready, Attack, animations.Once(18, Bite));
        sheet.Link(Walk, MotionIds.Ready, animations.Transition(4, walk, ready));
        sheet.Link(Walk, Run, animations.Transition(3, walk, run));
        sheet.Link(Run, MotionIds.Ready, animations.Transition(5, run, ready));
        sheet.Link(Run, Walk, animations.Transition(3, run, walk));
        sheet.Link(Falling, MotionIds.Ready, animations.Transition(5, falling, ready));
        sheet.Link(Sleeping, MotionIds.Ready, animations.Transition(20, Asleep(0), ready));
        return sheet.ToRecord();
    }

    private static BeastPose Ready(double phase)
    {
        double breath = Beasts.Sine(phase);
        return Standing with { Rise = -0.003 * breath, Nod = 6 + (3 * breath), Wag = 22 * Beasts.Sine(2 * phase), Look = 8 * breath };
    }

    // Legs that are crosswise to each other go together.
    private static BeastPose Trot(double phase) => Beasts.Crosswise(Standing, phase, swing: 24, lift: 34) with
    {
        Rise = 0.012 * Beasts.Sine((2 * phase) + 0.25),
        Nod = 4 * Beasts.Sine(2 * phase),
        Wag = 10 * Beasts.Sine(phase),
    };

    // The front legs go together, and the hind legs half a round later.
    private static BeastPose Gallop(double phase)
    {
        double front = Beasts.Sine(phase), hind = Beasts.Sine(phase + 0.55);
        return Standing with
        {
            Rise = 0.03 * Beasts.Sine(phase + 0.1),
            Pitch = 7 * Beasts.Sine(phase + 0.3),
            Nod = -4 + (6 * front),
            Wag = 4,
            FrontRight = 4 + (38 * front),
            FrontLeft = 4 + (38 * Beasts.Sine(phase + 0.08)),
            HindRight = -4 + (40 * hind),
            HindLeft = -4 + (40 * Beasts.Sine(phase + 0.63)),
            FrontRightKnee = 50 * Math.Max(0, Beasts.Sine(phase + 0.25)),
            FrontLeftKnee = 50 * Math.Max(0, Beasts.Sine(phase + 0.33)),
            HindRightKnee = -10 + (46 * Math.Max(0, Beasts.Sine(phase + 0.8))),
            HindLeftKnee = -10 + (46 * Math.Max(0, Beasts.Sine(phase + 0.88))),
        };
    }

    private static BeastPose Step(double phase) => Beasts.Crosswise(Standing, phase, swing: 8, lift: 22);

    private static BeastPose InTheAir(double phase) => Standing with
    {
        FrontRight = 34 + (4 * Beasts.Sine(phase)),
        FrontLeft = 34 - (4 * Beasts.Sine(phase)),
        HindRight = -36,
        HindLeft = -36,
        FrontRightKnee = 20,
        FrontLeftKnee = 20,
        Nod = 8,
        Wag = 30 * Beasts.Sine(phase),
    };

    private static BeastPose Asleep(double phase) => Standing with
    {
        Rise = -0.31 + (0.006 * Beasts.Sine(phase)),
        Nod = -14 + Beasts.Sine(phase),
        Look = 30,
        Wag = 60,
        FrontRight = 78,
        FrontLeft = 82,
        HindRight = 70,
        HindLeft = 74,
        HindRightKnee = 150,
        HindLeftKnee = 148,
        Spread = 6,
    };

    private static BeastPose OnItsSide
        => Standing with { Rise = -0.28, Roll = 88, Nod = -10, FrontRight = 20, FrontLeft = 34, HindRight = -12 };

    private static BeastPose Bite(double phase)
    {
        double forward = Math.Sin(phase * Math.PI), snap = Math.Max(0, Beasts.Sine((phase * 1.5) - 0.25));
        return Standing with
        {
            Pitch = -8 * forward,
            Nod = 6 + (26 * snap) - (18 * forward),
            FrontRight = 18 * forward,
            FrontLeft = 12 * forward,
            HindRight = -4 - (16 * forward),
            HindLeft = -4 - (16 * forward),
        };
    }
}
