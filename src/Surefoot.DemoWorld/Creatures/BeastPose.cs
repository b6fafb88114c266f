using System.Collections.Immutable;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;

namespace Surefoot.DemoWorld.Creatures;

/// <summary>Angles of a creature's joints in degrees, and how high its body is.</summary>
/// <param name="Build">The build of the creature.</param>
internal readonly record struct BeastPose(BeastBuild Build) : IPose<BeastPose>
{
    /// <summary>
    /// Number of parts: body, head, tail, then the upper and the lower part of each limb: front right, front left, hind right, hind left.
    /// </summary>
    public static int PartCount => 11;

    /// <summary>Height of the body above its normal height (m).</summary>
    public double Rise { get; init; }

    /// <summary>The body's front goes up.</summary>
    public double Pitch { get; init; }

    /// <summary>The body leans over to its left.</summary>
    public double Roll { get; init; }

    /// <summary>The head goes up.</summary>
    public double Nod { get; init; }

    /// <summary>The head turns left.</summary>
    public double Look { get; init; }

    /// <summary>The tail swings to the left.</summary>
    public double Wag { get; init; }

    /// <summary>Limbs swing forward.</summary>
    public double FrontRight { get; init; }

    /// <inheritdoc cref="FrontRight"/>
    public double FrontLeft { get; init; }

    /// <inheritdoc cref="FrontRight"/>
    public double HindRight { get; init; }

    /// <inheritdoc cref="FrontRight"/>
    public double HindLeft { get; init; }

    /// <summary>The lower parts of limbs fold backward (negative: forward).</summary>
    public double FrontRightKnee { get; init; }

    /// <inheritdoc cref="FrontRightKnee"/>
    public double FrontLeftKnee { get; init; }

    /// <inheritdoc cref="FrontRightKnee"/>
    public double HindRightKnee { get; init; }

    /// <inheritdoc cref="FrontRightKnee"/>
    public double HindLeftKnee { get; init; }

    /// <summary>Limbs spread sideways, each by this.</summary>
    public double Spread { get; init; }

    /// <inheritdoc/>
    public static BeastPose Between(BeastPose a, BeastPose b, double share)
    {
        double Mix(double from, double to) => from + ((to - from) * share);
        return new(a.Build)
        {
            Rise = Mix(a.Rise, b.Rise),
            Pitch = Mix(a.Pitch, b.Pitch),
            Roll = Mix(a.Roll, b.Roll),
            Nod = Mix(a.Nod, b.Nod),
            Look = Mix(a.Look, b.Look),
            Wag = Mix(a.Wag, b.Wag),
            FrontRight = Mix(a.FrontRight, b.FrontRight),
            FrontLeft = Mix(a.FrontLeft, b.FrontLeft),
            HindRight = Mix(a.HindRight, b.HindRight),
            HindLeft = Mix(a.HindLeft, b.HindLeft),
            FrontRightKnee = Mix(a.FrontRightKnee, b.FrontRightKnee),
            FrontLeftKnee = Mix(a.FrontLeftKnee, b.FrontLeftKnee),
            HindRightKnee = Mix(a.HindRightKnee, b.HindRightKnee),
            HindLeftKnee = Mix(a.HindLeftKnee, b.HindLeftKnee),
            Spread = Mix(a.Spread, b.Spread),
        };
    }

    /// <inheritdoc/>
    public AnimFrame ToFrame()
    {
        var body = Joint.At(0, 0, Build.BodyHeight + Rise).Roll(-Roll).Pitch(Pitch);
        var head = At(body, Build.Head, 1).Yaw(Look).Pitch(Nod);
        var tail = At(body, Build.Tail, 1).Yaw(-Wag);
        var frontRight = At(body, Build.Front, 1).Roll(-Spread).Pitch(FrontRight - Pitch);
        var frontLeft = At(body, Build.Front, -1).Roll(Spread).Pitch(FrontLeft - Pitch);
        var hindRight = At(body, Build.Hind, 1).Roll(-Spread).Pitch(HindRight - Pitch);
        var hindLeft = At(body, Build.Hind, -1).Roll(Spread).Pitch(HindLeft - Pitch);
        ImmutableArray<Joint> joints =
        [
            body, head, tail,
            frontRight, frontRight.Move(0, 0, -Build.FrontUpper).Pitch(-FrontRightKnee),
            frontLeft, frontLeft.Move(0, 0, -Build.FrontUpper).Pitch(-FrontLeftKnee),
            hindRight, hindRight.Move(0, 0, -Build.HindUpper).Pitch(-HindRightKnee),
            hindLeft, hindLeft.Move(0, 0, -Build.HindUpper).Pitch(-HindLeftKnee),
        ];
        return new([.. joints.Select(joint => joint.ToFrame())]);
    }

    private static Joint At(Joint body, BeastBuild.Place place, int side) => body.Move(place.X * side, place.Y, place.Z);
}
