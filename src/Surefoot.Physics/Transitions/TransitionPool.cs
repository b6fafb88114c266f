using System.Diagnostics.CodeAnalysis;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>The work objects of one world, by nesting level; the eleventh is refused. A result stays readable until its level is used again.</summary>
/// <remarks>Retail: CTransition::makeTransition @0x0050B150, cleanupTransition @0x00509DC0.</remarks>
internal sealed class TransitionPool(ICellWorld world)
{
    private const int Levels = 10;

    private readonly Transition?[] levels = new Transition?[Levels];
    private int depth;

    internal ITransitionTrace? Trace { get; set; }

    internal bool TryRent([NotNullWhen(true)] out Transition? transition)
    {
        transition = null;
        if (depth >= Levels) return false;
        transition = levels[depth] ??= new Transition(world);
        transition.Reset();
        transition.Trace = Trace;
        depth++;
        return true;
    }

    internal void Return() => depth--;
}
