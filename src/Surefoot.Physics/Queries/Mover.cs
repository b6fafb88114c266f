using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>
/// Who is swept or placed by a <see cref="WorldQuery"/>: a shape, a physics state word, and what a server would say of it. Immutable; to be
/// made once and asked about often, by any number of threads.
/// </summary>
public sealed class Mover
{
    /// <summary>A mover has at most this many spheres, as a body has: the first is the foot, the second the head.</summary>
    public const int MaxSpheres = SpherePath.MaxSpheres;

    /// <summary>
    /// A mover of a shape as the files have it. <see cref="OfBody"/> makes one of a shape that has more spheres than a body uses.
    /// </summary>
    /// <param name="setup">The shape; one without spheres is a ball of 0.1 m.</param>
    /// <param name="state">Physics state word: edge sliding, missile, ethereal and so on.</param>
    /// <param name="weenie">What a server says of it: players pass players, and so on.</param>
    /// <param name="scale">Uniform scale, more than 0.</param>
    /// <exception cref="ArgumentException">
    /// The shape has more than <see cref="MaxSpheres"/> spheres, a radius or the scale is not a positive finite number, also when they
    /// are multiplied, a sphere's centre is not finite, or a step height is not or is less than 0.
    /// </exception>
    public Mover(SetupAsset setup, PhysicsState state = PhysicsState.Default, WeenieTraits weenie = WeenieTraits.None, float scale = 1f)
        : this(setup, state, weenie, scale, MaxSpheres)
    {
    }

    /// <summary>A mover made up of spheres.</summary>
    /// <param name="spheres">One or two, the foot first; metres, in the mover's own frame.</param>
    /// <param name="stepUpHeight">Highest step climbed, metres.</param>
    /// <param name="stepDownHeight">Deepest step descended without leaving the ground, metres.</param>
    /// <param name="state">Physics state word.</param>
    /// <param name="weenie">What a server says of it.</param>
    /// <exception cref="ArgumentException">
    /// There is no sphere, there are more than <see cref="MaxSpheres"/>, a radius is not a positive finite number, a centre is not finite,
    /// or a height is not or is less than 0.
    /// </exception>
    public Mover(
        ReadOnlySpan<Sphere> spheres, float stepUpHeight, float stepDownHeight, PhysicsState state = PhysicsState.Default,
        WeenieTraits weenie = WeenieTraits.None)
        : this(SetupAsset.OfSpheres(0, spheres, stepUpHeight, stepDownHeight), state, weenie)
    {
    }

    private Mover(SetupAsset setup, PhysicsState state, WeenieTraits weenie, float scale, int mostSpheres)
    {
        ArgumentNullException.ThrowIfNull(setup);
        if (!(scale > 0) || !float.IsFinite(scale)) throw new ArgumentException("The scale is not a positive number.", nameof(scale));
        if (setup.Spheres.Length > mostSpheres)
            throw new ArgumentException($"A mover has at most {mostSpheres} spheres, not {setup.Spheres.Length}.", nameof(setup));
        foreach (ref readonly Sphere sphere in setup.Spheres[..Math.Min(setup.Spheres.Length, MaxSpheres)])
        {
            sphere.ThrowIfBad(nameof(setup));
            new Sphere(sphere.Center * scale, sphere.Radius * scale).ThrowIfBad(nameof(scale));
        }

        if (!IsHeight(setup.StepUpHeight) || !IsHeight(setup.StepDownHeight))
            throw new ArgumentException("A step height of the shape is not finite, or less than 0.", nameof(setup));
        Object = new WorldObject(0, setup, state & ~PhysicsState.Static) { Weenie = weenie, Scale = scale };
    }

    /// <summary>
    /// A mover of a shape as a body has it: of more than <see cref="MaxSpheres"/> spheres the first ones count, and the others stop others.
    /// </summary>
    /// <param name="setup">The shape.</param>
    /// <param name="state">Physics state word.</param>
    /// <param name="weenie">What a server says of it.</param>
    /// <param name="scale">Uniform scale, more than 0.</param>
    /// <exception cref="ArgumentException">A number is not as the other constructors want it.</exception>
    public static Mover OfBody(
        SetupAsset setup, PhysicsState state = PhysicsState.Default, WeenieTraits weenie = WeenieTraits.None, float scale = 1f) =>
        new(setup, state, weenie, scale, int.MaxValue);

    /// <summary>Its shape.</summary>
    public SetupAsset Setup => Object.Setup!;

    /// <summary>Its physics state word.</summary>
    public PhysicsState State => Object.State;

    /// <summary>What a server says of it.</summary>
    public WeenieTraits Weenie => Object.Weenie;

    /// <summary>Its uniform scale.</summary>
    public float Scale => Object.Scale;

    /// <summary>The mover as the world sees it: an object that is in no cell.</summary>
    internal WorldObject Object { get; }

    private static bool IsHeight(float height) => height >= 0 && float.IsFinite(height);
}
