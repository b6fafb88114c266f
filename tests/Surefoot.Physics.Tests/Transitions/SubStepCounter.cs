using Surefoot.Physics.Decisions;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>Counts the sub-steps that a trace tells of.</summary>
internal static class SubStepCounter
{
    internal static int SubStepCount(this TraceBuffer trace)
    {
        int count = 0;
        foreach (ref readonly TraceEntry entry in trace.Entries)
            if (entry.Kind == TraceKind.SubStepBegins) count++;
        return count;
    }
}
