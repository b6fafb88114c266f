using System.Numerics;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>A trace that counts sub-steps.</summary>
internal sealed class StepCounter : ITransitionTrace
{
    internal int Count { get; private set; }

    public void StepBegins(Transition transition, int index, int count) => Count++;

    public void CellAnswered(Transition transition, ObjCell cell, TransitionState answer)
    {
    }

    public void StepEnds(Transition transition, TransitionState outcome)
    {
    }

    public void Responded(Transition transition, TransitionResponse response, in Vector3 normal, bool succeeded)
    {
    }
}
