namespace Surefoot.DemoWorld.Human;

/// <content>With fists up, and what is done once.</content>
internal static partial class HumanPoses
{
    /// <summary>Standing with fists up, weight going from foot to foot.</summary>
    public static HumanPose Guard(double phase)
    {
        double sway = Sine(phase);
        return WithFists(new()
        {
            Rise = -0.07 + (0.01 * sway),
            RightHip = -14 + (2 * sway),
            LeftHip = 24 + (2 * sway),
            RightKnee = 22,
            LeftKnee = 24,
            Spread = 7,
        });
    }

    /// <summary>Walking with fists up.</summary>
    public static HumanPose GuardWalk(double phase) => WithFists(Walk(phase));

    /// <summary>Running with fists up.</summary>
    public static HumanPose GuardRun(double phase) => WithFists(Run(phase)) with { Lean = 18 };

    /// <summary>Stepping to the right with fists up.</summary>
    public static HumanPose GuardSideStep(double phase) => WithFists(SideStep(phase));

    /// <summary>Turning on the spot with fists up.</summary>
    public static HumanPose GuardTurn(double phase) => WithFists(Turn(phase));

    /// <summary>From fists up through a blow with the right and back.</summary>
    public static HumanPose Punch(double phase)
    {
        // Drawn back, then out, then back to where it was.
        double drawn = Hill(phase, 0, 0.2, 0.4), reached = Hill(phase, 0.25, 0.5, 0.95);
        HumanPose guard = Guard(0);
        return guard with
        {
            Twist = guard.Twist - (24 * drawn) + (44 * reached),
            Lean = guard.Lean + (10 * reached),
            RightShoulder = guard.RightShoulder - (40 * drawn) + (66 * reached),
            RightElbow = -(100 * reached),
            RightHip = guard.RightHip + (10 * reached),
        };
    }

    /// <summary>From standing through a wave of the right hand and back.</summary>
    public static HumanPose Wave(double phase)
    {
        double raised = Math.Min(Math.Min(phase / 0.2, (1 - phase) / 0.2), 1);
        HumanPose ready = Ready(0);
        return ready with
        {
            RightShoulder = ready.RightShoulder + (12 * raised),
            RightArmSpread = 92 * raised,
            RightElbow = 10 * raised,
            RightForearmTurn = raised * (78 + (24 * Math.Sin(phase * 6 * Math.PI))),
            Lean = ready.Lean - (2 * raised),
        };
    }

    /// <summary>Just landed: knees bent, arms out.</summary>
    public static HumanPose Landed() => new()
    {
        Rise = -0.16,
        Lean = 16,
        RightHip = 46,
        LeftHip = 42,
        RightKnee = 74,
        LeftKnee = 70,
        RightShoulder = 12,
        LeftShoulder = 12,
        Elbows = 30,
        ArmSpread = 24,
        Spread = 4,
    };

    private static HumanPose WithFists(HumanPose legs) => legs with
    {
        Lean = 10,
        Twist = -12 + (0.5 * legs.Twist),
        RightShoulder = 38,
        LeftShoulder = 52,
        Elbows = 104,
        ArmSpread = 8,
    };

    // 0 before the first and after the last of three places, 1 at the second.
    private static double Hill(double at, double from, double top, double to)
    {
        double share = at <= top ? (at - from) / (top - from) : (to - at) / (to - top);
        return Math.Sin(Math.Clamp(share, 0, 1) * Math.PI / 2);
    }
}
