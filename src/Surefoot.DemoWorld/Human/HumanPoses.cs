namespace Surefoot.DemoWorld.Human;

/// <summary>How a human stands and moves: each function gives the pose at a phase of its cycle, 0 to 1.</summary>
internal static partial class HumanPoses
{
    /// <summary>Standing, breathing.</summary>
    public static HumanPose Ready(double phase)
    {
        double breath = Sine(phase);
        return new() { Lean = 1 + breath, RightShoulder = 2 + breath, LeftShoulder = 2 + breath, Elbows = 12, ArmSpread = 6, Spread = 2 };
    }

    /// <summary>Walking: two steps a cycle.</summary>
    public static HumanPose Walk(double phase)
    {
        double swing = Sine(phase);
        return new()
        {
            Rise = -0.03 + (0.02 * Sine((2 * phase) + 0.25)),
            Lean = 4,
            Twist = 6 * swing,
            RightHip = 4 + (28 * swing),
            LeftHip = 4 - (28 * swing),
            RightKnee = 10 + (22 * Math.Max(0, Sine(phase + 0.2))),
            LeftKnee = 10 + (22 * Math.Max(0, Sine(phase + 0.7))),
            RightShoulder = -24 * swing,
            LeftShoulder = 24 * swing,
            Elbows = 22,
            ArmSpread = 6,
        };
    }

    /// <summary>Running: two steps a cycle.</summary>
    public static HumanPose Run(double phase)
    {
        double swing = Sine(phase);
        return new()
        {
            Rise = -0.05 + (0.05 * Sine((2 * phase) + 0.25)),
            Lean = 14,
            Twist = 10 * swing,
            RightHip = 12 + (44 * swing),
            LeftHip = 12 - (44 * swing),
            RightKnee = 28 + (55 * Math.Max(0, Sine(phase + 0.2))),
            LeftKnee = 28 + (55 * Math.Max(0, Sine(phase + 0.7))),
            RightShoulder = -46 * swing,
            LeftShoulder = 46 * swing,
            Elbows = 75,
            ArmSpread = 8,
        };
    }

    /// <summary>Stepping to the right.</summary>
    public static HumanPose SideStep(double phase)
    {
        double swing = Sine(phase);
        return Ready(0) with
        {
            Rise = -0.03 - (0.02 * Sine((2 * phase) + 0.25)),
            Spread = 8 + (8 * swing),
            RightKnee = 8 + (14 * Math.Max(0, swing)),
            LeftKnee = 8 + (14 * Math.Max(0, -swing)),
            RightHip = 5 + (7 * Math.Max(0, swing)),
            LeftHip = 5 + (7 * Math.Max(0, -swing)),
            ArmSpread = 12,
        };
    }

    /// <summary>Turning on the spot: small steps.</summary>
    public static HumanPose Turn(double phase)
    {
        double swing = Sine(phase);
        return Ready(0) with
        {
            Rise = -0.01,
            Twist = -6,
            RightHip = 10 * Math.Max(0, swing),
            LeftHip = 10 * Math.Max(0, -swing),
            RightKnee = 6 + (18 * Math.Max(0, swing)),
            LeftKnee = 6 + (18 * Math.Max(0, -swing)),
        };
    }

    /// <summary>In the air.</summary>
    public static HumanPose Falling(double phase)
    {
        double flutter = Sine(phase);
        return new()
        {
            Lean = 8,
            RightHip = 32 + (4 * flutter),
            LeftHip = 12 - (4 * flutter),
            RightKnee = 48,
            LeftKnee = 30,
            RightShoulder = 20 + (6 * flutter),
            LeftShoulder = 20 - (6 * flutter),
            Elbows = 40,
            ArmSpread = 48,
            Spread = 6,
        };
    }

    /// <summary>Lying on the back.</summary>
    public static HumanPose Dead() => new() { Rise = -0.83, Fall = -90, ArmSpread = 30, Spread = 10, Elbows = 10 };

    /// <summary>Lying on the face.</summary>
    public static HumanPose Fallen() => new() { Rise = -0.81, Fall = 90, ArmSpread = 40, Spread = 8 };

    /// <summary>Down on the heels.</summary>
    public static HumanPose Crouch(double phase)
        => new()
        {
            Rise = -0.42,
            Lean = 25 + Sine(phase),
            RightHip = 85,
            LeftHip = 75,
            RightKnee = 118,
            LeftKnee = 125,
            RightShoulder = 35,
            LeftShoulder = 35,
            Elbows = 35,
            ArmSpread = 8,
        };

    /// <summary>Sitting on the ground.</summary>
    public static HumanPose Sitting(double phase)
        => new()
        {
            Rise = -0.85,
            Lean = -8 + Sine(phase),
            RightHip = 92,
            LeftHip = 92,
            RightKnee = 12,
            LeftKnee = 12,
            Spread = 8,
            RightShoulder = -22,
            LeftShoulder = -22,
            ArmSpread = 12,
        };

    /// <summary>Lying on the back, at ease.</summary>
    public static HumanPose Sleeping(double phase)
        => new()
        {
            Rise = -0.83,
            Fall = -90,
            Lean = 1.5 + (1.5 * Sine(phase)),
            RightHip = 25,
            RightKnee = 50,
            RightShoulder = 20,
            LeftShoulder = 10,
            Elbows = 80,
            ArmSpread = 20,
        };

    private static double Sine(double phase) => Math.Sin(phase * 2 * Math.PI);
}
