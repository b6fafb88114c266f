using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>Receives the decisions of a transition while they are made. Implementations only look.</summary>
public interface ITransitionTrace
{
    /// <summary>A sub-step of the sweep begins.</summary>
    void StepBegins(Transition transition, int index, int count);

    /// <summary>A cell answered the position under test.</summary>
    void CellAnswered(Transition transition, ObjCell cell, TransitionState answer);

    /// <summary>A sub-step was accepted, or refused and undone.</summary>
    void StepEnds(Transition transition, TransitionState outcome);

    /// <summary>A response was tried: its name, its normal, and whether it found a way.</summary>
    void Responded(Transition transition, TransitionResponse response, in Vector3 normal, bool succeeded);
}

/// <summary>The ways a transition answers an obstacle or a missing floor.</summary>
public enum TransitionResponse
{
    /// <summary>Onto an obstacle.</summary>
    StepUp,

    /// <summary>Down to keep the ground.</summary>
    StepDown,

    /// <summary>Along a wall.</summary>
    Slide,

    /// <summary>Along or off an edge.</summary>
    EdgeSlide,

    /// <summary>Along a slope too steep to walk on.</summary>
    CliffSlide,

    /// <summary>Along the edge of the polygon walked on.</summary>
    PrecipiceSlide,

    /// <summary>A landing was confirmed or refused.</summary>
    Landing,
}
