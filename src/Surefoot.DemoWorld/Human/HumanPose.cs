using System.Collections.Immutable;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;

namespace Surefoot.DemoWorld.Human;

/// <summary>Angles of a human's joints in degrees, and how high the hips are.</summary>
internal readonly record struct HumanPose : IPose<HumanPose>
{
    private const double HipHeight = 0.95;

    /// <summary>
    /// Number of parts: hips, chest, head, then upper arm and forearm, right and left, then thigh and shin, right and left.
    /// </summary>
    public static int PartCount => 11;

    /// <summary>Height of the hips above their normal height (m).</summary>
    public double Rise { get; init; }

    /// <summary>The whole body falls forward (negative: backward).</summary>
    public double Fall { get; init; }

    /// <summary>Chest bends forward.</summary>
    public double Lean { get; init; }

    /// <summary>Chest turns left.</summary>
    public double Twist { get; init; }

    /// <summary>Thighs swing forward.</summary>
    public double RightHip { get; init; }

    /// <inheritdoc cref="RightHip"/>
    public double LeftHip { get; init; }

    /// <summary>Shins fold backward.</summary>
    public double RightKnee { get; init; }

    /// <inheritdoc cref="RightKnee"/>
    public double LeftKnee { get; init; }

    /// <summary>Legs spread sideways, each by this.</summary>
    public double Spread { get; init; }

    /// <summary>Upper arms swing forward.</summary>
    public double RightShoulder { get; init; }

    /// <inheritdoc cref="RightShoulder"/>
    public double LeftShoulder { get; init; }

    /// <summary>Forearms fold forward, both alike.</summary>
    public double Elbows { get; init; }

    /// <summary>Arms stand off sideways, both alike.</summary>
    public double ArmSpread { get; init; }

    /// <summary>The right arm stands off sideways by this more.</summary>
    public double RightArmSpread { get; init; }

    /// <summary>The right forearm folds forward by this more.</summary>
    public double RightElbow { get; init; }

    /// <summary>The right forearm stands off sideways from the upper arm.</summary>
    public double RightForearmTurn { get; init; }

    /// <inheritdoc/>
    public static HumanPose Between(HumanPose a, HumanPose b, double share)
    {
        double Mix(double from, double to) => from + ((to - from) * share);
        return new()
        {
            Rise = Mix(a.Rise, b.Rise),
            Fall = Mix(a.Fall, b.Fall),
            Lean = Mix(a.Lean, b.Lean),
            Twist = Mix(a.Twist, b.Twist),
            RightHip = Mix(a.RightHip, b.RightHip),
            LeftHip = Mix(a.LeftHip, b.LeftHip),
            RightKnee = Mix(a.RightKnee, b.RightKnee),
            LeftKnee = Mix(a.LeftKnee, b.LeftKnee),
            Spread = Mix(a.Spread, b.Spread),
            RightShoulder = Mix(a.RightShoulder, b.RightShoulder),
            LeftShoulder = Mix(a.LeftShoulder, b.LeftShoulder),
            Elbows = Mix(a.Elbows, b.Elbows),
            ArmSpread = Mix(a.ArmSpread, b.ArmSpread),
            RightArmSpread = Mix(a.RightArmSpread, b.RightArmSpread),
            RightElbow = Mix(a.RightElbow, b.RightElbow),
            RightForearmTurn = Mix(a.RightForearmTurn, b.RightForearmTurn),
        };
    }

    /// <inheritdoc/>
    public AnimFrame ToFrame()
    {
        var hips = Joint.At(0, 0, HipHeight + Rise).Pitch(-Fall);
        var chest = hips.Move(0, 0, 0.12).Yaw(Twist).Pitch(-Lean);
        var head = chest.Move(0, 0, 0.47);
        var rightArm = chest.Move(0.235, 0, 0.38).Roll(-ArmSpread - RightArmSpread).Pitch(RightShoulder);
        var leftArm = chest.Move(-0.235, 0, 0.38).Roll(ArmSpread).Pitch(LeftShoulder);
        var rightLeg = hips.Move(0.1, 0, -0.02).Roll(-Spread).Pitch(RightHip);
        var leftLeg = hips.Move(-0.1, 0, -0.02).Roll(Spread).Pitch(LeftHip);
        ImmutableArray<Joint> joints =
        [
            hips, chest, head,
            rightArm, rightArm.Move(0, 0, -0.3).Roll(-RightForearmTurn).Pitch(Elbows + RightElbow),
            leftArm, leftArm.Move(0, 0, -0.3).Pitch(Elbows),
            rightLeg, rightLeg.Move(0, 0, -0.45).Pitch(-RightKnee), leftLeg, leftLeg.Move(0, 0, -0.45).Pitch(-LeftKnee),
        ];
        return new([.. joints.Select(joint => joint.ToFrame())]);
    }
}
