using System.Numerics;

namespace Surefoot.Physics.Assets;

/// <summary>What an animation does to its body besides moving it.</summary>
internal enum MotionHookKind
{
    /// <summary>An animation before the cycle has ended.</summary>
    AnimationDone,

    /// <summary>The body becomes ethereal or solid.</summary>
    Ethereal,

    /// <summary>The body turns by itself.</summary>
    Omega,

    /// <summary>The body grows or shrinks.</summary>
    Scale,

    /// <summary>Nothing that matters to movement: a sound, an attack, a light.</summary>
    Other,
}

/// <summary>Something that happens when an animation passes a frame.</summary>
/// <param name="Kind">What.</param>
/// <param name="Frame">At the end of which frame.</param>
/// <param name="Direction">1 when played forward, -1 backward, 0 both ways.</param>
/// <param name="Value">
/// rad/s in world axes; for a scale x is the scale at the end and y the seconds until then; for ethereal x is 0 or 1.
/// </param>
/// <remarks>Retail: the CAnimHook family, as far as it matters to movement (specification 02, 4.18).</remarks>
internal readonly record struct MotionHook(MotionHookKind Kind, int Frame, int Direction, Vector3 Value)
{
    /// <summary>Id of the animation that has it; 0 for the end of an animation.</summary>
    internal uint AnimationId { get; init; }

    /// <summary>Its place among the hooks of its frame, as the record lists them.</summary>
    internal int Index { get; init; }
}
