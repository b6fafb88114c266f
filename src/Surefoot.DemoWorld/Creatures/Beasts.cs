using System.Collections.Immutable;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Creatures;

/// <summary>What the creatures have in common: their setups' form and the order of their steps.</summary>
internal static class Beasts
{
    /// <summary>The setup of a creature.</summary>
    /// <param name="id">Its id.</param>
    /// <param name="motions">Its motion table.</param>
    /// <param name="shapes">Body, head, tail, upper and lower part of a limb; then the same of the hind limbs where they differ.</param>
    /// <param name="resting">How it is held while nothing animates it.</param>
    /// <param name="height">Metres.</param>
    /// <param name="radius">Metres.</param>
    /// <param name="spheres">Those it moves by.</param>
    /// <param name="cylinders">Those that others meet; none when they meet its spheres.</param>
    public static Setup Setup(
        uint id, uint motions, ImmutableArray<uint> shapes, BeastPose resting, float height, float radius,
        ImmutableArray<DatSphere> spheres, ImmutableArray<DatCylSphere> cylinders)
    {
        uint frontUpper = shapes[3], frontLower = shapes[4], hindUpper = shapes[^2], hindLower = shapes[^1];
        return new()
        {
            Id = id,
            Flags = SetupFlags.HasParents,
            PartIds =
            [
                shapes[0], shapes[1], shapes[2], frontUpper, frontLower, frontUpper, frontLower, hindUpper, hindLower, hindUpper, hindLower,
            ],
            ParentParts = [Dats.Records.Setup.NoParent, 0, 0, 0, 3, 0, 5, 0, 7, 0, 9],
            PlacementFrames = [new(0, resting.ToFrame())],
            Spheres = spheres,
            CylSpheres = cylinders,
            Height = height,
            Radius = radius,
            StepUpHeight = 0.4f,
            StepDownHeight = 0.6f,
            SortingSphere = new(new(0, 0, height / 2), (height / 2) + radius),
            SelectionSphere = new(new(0, 0, height / 2), height / 2),
            DefaultMotionTableId = motions,
        };
    }

    /// <summary>A round of steps on four legs: those that stand crosswise go together.</summary>
    /// <param name="standing">The pose without steps.</param>
    /// <param name="phase">0 to 1.</param>
    /// <param name="swing">How far each leg swings to each side, degrees.</param>
    /// <param name="lift">How far a knee folds while its leg goes forward, degrees.</param>
    public static BeastPose Crosswise(BeastPose standing, double phase, double swing, double lift)
    {
        double one = Sine(phase), oneLift = lift * Math.Max(0, Sine(phase + 0.25)), otherLift = lift * Math.Max(0, Sine(phase + 0.75));
        return standing with
        {
            FrontRight = standing.FrontRight + (swing * one),
            HindLeft = standing.HindLeft + (swing * one),
            FrontLeft = standing.FrontLeft - (swing * one),
            HindRight = standing.HindRight - (swing * one),
            FrontRightKnee = standing.FrontRightKnee + oneLift,
            HindLeftKnee = standing.HindLeftKnee + oneLift,
            FrontLeftKnee = standing.FrontLeftKnee + otherLift,
            HindRightKnee = standing.HindRightKnee + otherLift,
        };
    }

    /// <summary>A round of steps on the hind legs; the arms swing a little against them.</summary>
    public static BeastPose Striding(BeastPose standing, double phase, double swing, double lift)
    {
        double one = Sine(phase);
        return standing with
        {
            HindRight = standing.HindRight + (swing * one),
            HindLeft = standing.HindLeft - (swing * one),
            HindRightKnee = standing.HindRightKnee + (lift * Math.Max(0, Sine(phase + 0.25))),
            HindLeftKnee = standing.HindLeftKnee + (lift * Math.Max(0, Sine(phase + 0.75))),
            FrontRight = standing.FrontRight - (0.4 * swing * one),
            FrontLeft = standing.FrontLeft + (0.4 * swing * one),
        };
    }

    /// <summary>The sine of a phase, 0 to 1.</summary>
    public static double Sine(double phase) => Math.Sin(phase * 2 * Math.PI);
}
