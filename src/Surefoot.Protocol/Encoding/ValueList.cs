using System.Collections;
using System.Runtime.CompilerServices;

namespace Surefoot.Protocol;

/// <summary>An immutable list that is equal to another one with equal elements, so that messages compare as values.</summary>
/// <typeparam name="T">An immutable type.</typeparam>
[CollectionBuilder(typeof(ValueList), nameof(ValueList.Create))]
public readonly struct ValueList<T> : IReadOnlyList<T>, IEquatable<ValueList<T>>
{
    private readonly T[]? elements;

    internal ValueList(T[] elements) => this.elements = elements;

    /// <inheritdoc/>
    public int Count => elements?.Length ?? 0;

    /// <inheritdoc/>
    public T this[int index] => Span[index];

    /// <summary>The elements.</summary>
    public ReadOnlySpan<T> Span => elements;

    /// <summary>Two lists with equal elements are equal.</summary>
    public static bool operator ==(ValueList<T> left, ValueList<T> right) => left.Equals(right);

    /// <summary>Two lists with equal elements are equal.</summary>
    public static bool operator !=(ValueList<T> left, ValueList<T> right) => !left.Equals(right);

    /// <inheritdoc/>
    public bool Equals(ValueList<T> other) => Span.SequenceEqual(other.Span, EqualityComparer<T>.Default);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is ValueList<T> other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode()
    {
        var hash = default(HashCode);
        foreach (T element in Span)
            hash.Add(element);
        return hash.ToHashCode();
    }

    /// <summary>Walks the elements.</summary>
    public ReadOnlySpan<T>.Enumerator GetEnumerator() => Span.GetEnumerator();

    /// <inheritdoc/>
    public override string ToString() => $"[{string.Join(", ", this)}]";

    IEnumerator<T> IEnumerable<T>.GetEnumerator() => ((IEnumerable<T>)(elements ?? [])).GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => (elements ?? []).GetEnumerator();
}

/// <summary>Makes <see cref="ValueList{T}"/>.</summary>
public static class ValueList
{
    /// <summary>A list of copies of <paramref name="elements"/>.</summary>
    public static ValueList<T> Create<T>(ReadOnlySpan<T> elements) => elements.IsEmpty ? default : new ValueList<T>(elements.ToArray());
}
