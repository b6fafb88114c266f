using System.Numerics;

namespace Surefoot.Physics.Decisions;

/// <summary>One decision of a sweep. Which members mean something depends on <see cref="Kind"/>; the others are zero.</summary>
public readonly record struct TraceEntry
{
    /// <summary>What is told.</summary>
    public TraceKind Kind { get; init; }

    /// <summary>What the world was being asked.</summary>
    public SweepQuestion Question { get; init; }

    /// <summary>The answer of a cell or an object, or how a sub-step ended before it was taken back.</summary>
    public TransitionState Answer { get; init; }

    /// <summary>The response tried or given.</summary>
    public TransitionResponse Response { get; init; }

    /// <summary>A response found a way, a sub-step was accepted, a sweep found a valid place.</summary>
    public bool Succeeded { get; init; }

    /// <summary>Why.</summary>
    public TraceReason Reason { get; init; }

    /// <summary>What it was about.</summary>
    public TraceSubject Subject { get; init; }

    /// <summary>
    /// The plane met or rested on, its normal of unit length and in world axes; the constant, metres, is in the block frame of
    /// <see cref="PlaneCellId"/>. Of responses and bends only the normal, with a constant of 0; zero for none.
    /// </summary>
    public Plane Plane { get; init; }

    /// <summary>Cell whose block frame <see cref="Plane"/> is in.</summary>
    public uint PlaneCellId { get; init; }

    /// <summary>How far the sphere is from what it met, metres; negative inside. 0 where a shape only says that it is overlapped.</summary>
    public float Gap { get; init; }

    /// <summary>A displacement, metres, world axes.</summary>
    public Vector3 Offset { get; init; }

    /// <summary>
    /// Where the body's origin was being tried, or where it was accepted; metres in the block frame of <see cref="CellId"/>.
    /// </summary>
    public Vector3 Origin { get; init; }

    /// <summary>Cell of <see cref="Origin"/>.</summary>
    public uint CellId { get; init; }

    /// <summary>Which sub-step begins, from 0.</summary>
    public int Index { get; init; }

    /// <summary>Of how many.</summary>
    public int Count { get; init; }
}
