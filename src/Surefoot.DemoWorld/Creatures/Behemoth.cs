using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;
using static Surefoot.DemoWorld.Motions.MotionIds;

namespace Surefoot.DemoWorld.Creatures;

/// <summary>
/// The large creature: slow and heavy on two legs, with short arms and a tail. It sways as it goes, turns slowly, and stomps.
/// </summary>
internal static class Behemoth
{
    private const uint FirstAnimation = 0x03000141;
    private const uint Body = 0x01000190, Head = 0x01000191, Tail = 0x01000192, ArmUpper = 0x01000193, ArmLower = 0x01000194,
        LegUpper = 0x01000195, LegLower = 0x01000196;

    private static readonly BeastBuild Build = new(1.15, new(0, 0.5, 0.62), new(0, -0.55, 0.05), new(0.5, 0.36, 0.36),
        new(0.3, -0.12, -0.15), 0.36, 0.5);

    private static readonly Vector3 WalkVelocity = new(0, 0.9f, 0), RunVelocity = new(0, 1.8f, 0), TurnOmega = new(0, 0, -0.9f);

    private static BeastPose Standing => new(Build)
    {
        FrontRight = 18,
        FrontLeft = 18,
        FrontRightKnee = -52,
        FrontLeftKnee = -52,
        HindRight = 6,
        HindLeft = 6,
        HindRightKnee = 10,
        HindLeftKnee = 10,
        Spread = 3,
        Rise = -0.02,
    };

    /// <summary>Shapes, setup, motion table and animations.</summary>
    public static IEnumerable<DatRecord> All()
    {
        var animations = new AnimationList<BeastPose>(FirstAnimation);
        return
        [
            .. Shapes(),
            // Others meet its cylinder; it moves by its spheres, without which a body stays where it is.
            Beasts.Setup(DemoIds.LargeCreatureSetup, DemoIds.HeavyCreatureMotionTable,
                [Body, Head, Tail, ArmUpper, ArmLower, LegUpper, LegLower], Ready(0), 2.2f, 0.8f,
                [new(new(0, 0, 0.8f), 0.8f), new(new(0, 0, 1.4f), 0.8f)], [new(Vector3.Zero, 0.8f, 2.2f)]),
            Table(animations),
            .. animations.Records,
        ];
    }

    private static IEnumerable<DatRecord> Shapes() =>
    [
        Meshes.Drawn(Body, new BoxGrid()
            .Fill(new(-0.45, -0.55, -0.25, 0.45, 0.35, 0.5), Surfaces.Scales)
            .Fill(new(-0.38, -0.2, 0.5, 0.38, 0.5, 0.8), Surfaces.Scales).Faces()),
        Meshes.Drawn(Head, new BoxGrid()
            .Fill(new(-0.26, -0.05, -0.2, 0.26, 0.4, 0.24), Surfaces.Scales)
            .Fill(new(-0.18, 0.4, -0.2, 0.18, 0.62, 0.02), Surfaces.Scales)
            .Fill(new(-0.22, 0.1, 0.24, -0.14, 0.18, 0.44), Surfaces.Plaster)
            .Fill(new(0.14, 0.1, 0.24, 0.22, 0.18, 0.44), Surfaces.Plaster).Faces()),
        Meshes.Drawn(Tail, new BoxGrid()
            .Fill(new(-0.16, -0.45, -0.16, 0.16, 0.05, 0.14), Surfaces.Scales)
            .Fill(new(-0.08, -0.85, -0.1, 0.08, -0.45, 0.06), Surfaces.Scales).Faces()),
        Meshes.Drawn(ArmUpper, new BoxGrid().Fill(new(-0.1, -0.1, -0.36, 0.1, 0.1, 0.08), Surfaces.Scales).Faces()),
        Meshes.Drawn(ArmLower, new BoxGrid()
            .Fill(new(-0.08, -0.08, -0.3, 0.08, 0.08, 0), Surfaces.Scales)
            .Fill(new(-0.09, -0.06, -0.42, 0.09, 0.1, -0.3), Surfaces.Plaster).Faces()),
        Meshes.Drawn(LegUpper, new BoxGrid().Fill(new(-0.2, -0.22, -0.5, 0.2, 0.22, 0.15), Surfaces.Scales).Faces()),
        Meshes.Drawn(LegLower, new BoxGrid()
            .Fill(new(-0.16, -0.16, -0.38, 0.16, 0.16, 0), Surfaces.Scales)
            .Fill(new(-0.2, -0.18, -0.5, 0.2, 0.34, -0.38), Surfaces.Boots).Faces()),
    ];

    private static MotionTable Table(AnimationList<BeastPose> animations)
    {
        var sheet = new MotionSheet(DemoIds.HeavyCreatureMotionTable, NonCombat) { Style = NonCombat };
        BeastPose ready = Ready(0), walk = Plod(0), run = Charge(0), falling = InTheAir(0);
        sheet.Cycle(MotionIds.Ready, CycleRule.None, animations.Cycle(90, Ready));
        sheet.Cycle(Walk, CycleRule.None, animations.Cycle(48, Plod), WalkVelocity);
        sheet.Cycle(Run, CycleRule.None, animations.Cycle(32, Charge), RunVelocity);
        sheet.Cycle(Falling, CycleRule.None, animations.Cycle(20, InTheAir));
        sheet.Cycle(Turn, CycleRule.OnlyFromDefault, animations.Cycle(36, Shift), omega: TurnOmega);
        sheet.Cycle(Dead, CycleRule.ClearsModifiers, animations.Still(OnItsSide));
        sheet.Modifier(Turn, omega: TurnOmega);
        // What is heavy takes its time to get going and to stop.
        sheet.Link(MotionIds.Ready, Walk, animations.Transition(10, ready, walk));
        sheet.Link(MotionIds.Ready, Run, animations.Transition(12, ready, run));
        sheet.Link(MotionIds.Ready, Falling, animations.Transition(5, ready, falling));
        sheet.Link(MotionIds.Ready, Dead, animations.Transition(40, ready, OnItsSide));
        sheet.Link(MotionIds.Ready, Attack, animations.Once(44, Stomp));
        sheet.Link(Walk, MotionIds.Ready, animations.Transition(10, walk, ready));
        sheet.Link(Walk, Run, animations.Transition(8, walk, run));
        sheet.Link(Run, MotionIds.Ready, animations.Transition(14, run, ready));
        sheet.Link(Run, Walk, animations.Transition(8, run, walk));
        sheet.Link(Falling, MotionIds.Ready, animations.Transition(10, falling, ready));
        return sheet.ToRecord();
    }

    private static BeastPose Ready(double phase)
    {
        double breath = Beasts.Sine(phase);
        return Standing with { Rise = -0.02 + (0.012 * breath), Pitch = breath, Nod = -4 + (3 * breath), Wag = 10 * breath };
    }

    private static BeastPose Plod(double phase) => Beasts.Striding(Standing, phase, swing: 20, lift: 26) with
    {
        Rise = -0.05 + (0.03 * Beasts.Sine((2 * phase) + 0.25)),
        Roll = 5 * Beasts.Sine(phase + 0.2),
        Nod = -4 + (4 * Beasts.Sine(2 * phase)),
        Wag = 14 * Beasts.Sine(phase),
    };

    private static BeastPose Charge(double phase) => Beasts.Striding(Standing, phase, swing: 32, lift: 44) with
    {
        Rise = -0.06 + (0.06 * Beasts.Sine((2 * phase) + 0.25)),
        Pitch = -10,
        Roll = 6 * Beasts.Sine(phase + 0.2),
        Nod = 2 + (5 * Beasts.Sine(2 * phase)),
        Wag = 10 * Beasts.Sine(phase),
    };

    private static BeastPose Shift(double phase) => Beasts.Striding(Standing, phase, swing: 6, lift: 20) with
    {
        Roll = 4 * Beasts.Sine(phase + 0.2),
        Look = 10,
    };

    private static BeastPose InTheAir(double phase) => Standing with
    {
        HindRight = 24 + (5 * Beasts.Sine(phase)),
        HindLeft = 24 - (5 * Beasts.Sine(phase)),
        HindRightKnee = 30,
        HindLeftKnee = 30,
        FrontRight = 60,
        FrontLeft = 60,
        Pitch = 6,
        Wag = 20 * Beasts.Sine(phase),
    };

    private static BeastPose OnItsSide
        => Standing with { Rise = -0.68, Roll = 86, Nod = -12, FrontRight = 40, HindRight = 30, HindRightKnee = 50 };

    // The right leg is lifted high and put down hard.
    private static BeastPose Stomp(double phase)
    {
        double lifted = phase < 0.6 ? Math.Sin(phase / 0.6 * Math.PI / 2) : Math.Max(0, 1 - ((phase - 0.6) * 6));
        double bent = phase < 0.76 ? 0 : Math.Sin((1 - phase) / 0.24 * Math.PI);
        return Standing with
        {
            Rise = -0.02 - (0.08 * Math.Max(0, bent)),
            Roll = 8 * lifted,
            Pitch = 6 * lifted,
            HindRight = 6 + (62 * lifted),
            HindRightKnee = 10 + (70 * lifted),
            HindLeftKnee = 10 + (14 * Math.Max(0, bent)),
            FrontRight = 18 + (30 * lifted),
            FrontLeft = 18 + (30 * lifted),
            Nod = -4 + (14 * lifted),
        };
    }
}
