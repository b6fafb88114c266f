using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;

namespace Surefoot.Protocol.Messages;

/// <summary>The at most 31 actions of a motion state, in place: nothing is allocated for them.</summary>
public readonly struct MotionActions : IEquatable<MotionActions>
{
    /// <summary>The wire has five bits for their number.</summary>
    public const int Most = 31;

    private readonly Slots slots;

    /// <summary>Copies actions.</summary>
    /// <exception cref="ArgumentException">More than 31.</exception>
    public MotionActions(ReadOnlySpan<MotionAction> actions)
    {
        if (actions.Length > Most)
            throw new ArgumentException($"A motion state carries at most {Most} actions, not {actions.Length}.", nameof(actions));
        actions.CopyTo(slots);
        Count = actions.Length;
    }

    /// <summary>How many there are.</summary>
    public int Count { get; }

    /// <summary>The actions, oldest first.</summary>
    [UnscopedRef]
    public ReadOnlySpan<MotionAction> Span => ((ReadOnlySpan<MotionAction>)slots)[..Count];

    /// <summary>The action at an index.</summary>
    public MotionAction this[int index] => Span[index];

    /// <summary>Equal actions in the same order are equal.</summary>
    public static bool operator ==(MotionActions left, MotionActions right) => left.Equals(right);

    /// <summary>Equal actions in the same order are equal.</summary>
    public static bool operator !=(MotionActions left, MotionActions right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(MotionActions other) => Span.SequenceEqual(other.Span);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is MotionActions other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode()
    {
        var hash = default(HashCode);
        foreach (MotionAction action in Span)
            hash.Add(action);
        return hash.ToHashCode();
    }

    /// <inheritdoc/>
    public override string ToString() => $"[{string.Join(", ", Span.ToArray())}]";

    internal static MotionActions Read(ref WireReader reader, int count)
    {
        Span<MotionAction> actions = stackalloc MotionAction[count];
        foreach (ref MotionAction action in actions)
            action = MotionAction.Read(ref reader);
        return new MotionActions(actions);
    }

    internal void Write(ref WireWriter writer)
    {
        foreach (MotionAction action in Span)
            action.Write(ref writer);
    }

    [InlineArray(Most)]
    private struct Slots
    {
        private MotionAction first;
    }
}
