using System.Diagnostics.CodeAnalysis;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>
/// The work objects of one world, by nesting level; the eleventh is refused. A result stays readable until its level is used again.
/// </summary>
/// <remarks>Retail: CTransition::makeTransition @0x0050B150, cleanupTransition @0x00509DC0.</remarks>
internal sealed class TransitionPool(ICellWorld world)
{
    private const int Levels = 10;

    private readonly Transition?[] levels = new Transition?[Levels];
    private int depth;

    /// <summary>Hands out the work object of the next level.</summary>
    /// <param name="transition">The work object, as good as new.</param>
    /// <param name="trace">Who is told its decisions.</param>
    internal bool TryRent([NotNullWhen(true)] out Transition? transition, TraceBuffer? trace = null)
    {
        transition = null;
        if (depth >= Levels) return false;
        transition = levels[depth] ??= new Transition(world);
        transition.Reset();
        transition.Trace = trace;
        depth++;
        return true;
    }

    internal void Return() => depth--;
}
