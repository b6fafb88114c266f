using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>What movement needs of a setup: spheres, heights and steps, in metres at scale 1.</summary>
public sealed class SetupAsset
{
    /// <summary>Setup id.</summary>
    public uint Id { get; init; }

    /// <summary>Collision spheres; the first is the foot.</summary>
    public Sphere[] Spheres { get; init; } = [];

    /// <summary>Height.</summary>
    public float Height { get; init; }

    /// <summary>Radius.</summary>
    public float Radius { get; init; }

    /// <summary>Highest step climbed.</summary>
    public float StepUpHeight { get; init; }

    /// <summary>Deepest step descended.</summary>
    public float StepDownHeight { get; init; }

    /// <summary>The body may turn freely in one sweep.</summary>
    public bool AllowFreeHeading { get; init; }

    internal Transitions.TransitionState FindCollisions(Transitions.Transition transition, Bodies.WorldObject target, bool creature) => Transitions.TransitionState.OK;
}
