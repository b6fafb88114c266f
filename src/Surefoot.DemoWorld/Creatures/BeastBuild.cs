namespace Surefoot.DemoWorld.Creatures;

/// <summary>The build of a four-limbed creature: where its joints are, metres.</summary>
/// <param name="BodyHeight">Height of the body's joint over the ground.</param>
/// <param name="Head">Head joint, seen from the body's.</param>
/// <param name="Tail">Tail joint, seen from the body's.</param>
/// <param name="Front">Joint of the right front limb, seen from the body's; the left one is its mirror image.</param>
/// <param name="Hind">Joint of the right hind limb.</param>
/// <param name="FrontUpper">Length of the upper part of the front limbs.</param>
/// <param name="HindUpper">Length of the upper part of the hind limbs.</param>
internal sealed record BeastBuild(
    double BodyHeight, BeastBuild.Place Head, BeastBuild.Place Tail, BeastBuild.Place Front, BeastBuild.Place Hind, double FrontUpper,
    double HindUpper)
{
    /// <summary>A place in metres.</summary>
    internal readonly record struct Place(double X, double Y, double Z);
}
