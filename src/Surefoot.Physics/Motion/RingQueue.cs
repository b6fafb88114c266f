namespace Surefoot.Physics.Motion;

/// <summary>A first-in first-out queue over an array that is reused and grows only when it is full.</summary>
internal sealed class RingQueue<T>
    where T : struct
{
    private T[] items;
    private int head;

    /// <summary>An empty queue.</summary>
    /// <param name="capacity">Items it has room for at once; a power of two, or 0.</param>
    public RingQueue(int capacity = 0) => items = capacity == 0 ? [] : new T[capacity];

    /// <summary>Number of items.</summary>
    public int Count { get; private set; }

    /// <summary>The item at a distance from the oldest one.</summary>
    public ref T this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)index, (uint)Count, nameof(index));
            return ref items[(head + index) & (items.Length - 1)];
        }
    }

    /// <summary>Appends an item.</summary>
    public void Enqueue(in T item)
    {
        if (Count == items.Length) Grow();
        items[(head + Count) & (items.Length - 1)] = item;
        Count++;
    }

    /// <summary>Takes the oldest item off.</summary>
    public T Dequeue()
    {
        T item = this[0];
        head = (head + 1) & (items.Length - 1);
        Count--;
        return item;
    }

    /// <summary>The newest item.</summary>
    public ref T Newest => ref this[Count - 1];

    /// <summary>Takes the newest item off.</summary>
    public void RemoveNewest()
    {
        ArgumentOutOfRangeException.ThrowIfZero(Count);
        Count--;
    }

    /// <summary>Takes everything off.</summary>
    public void Clear() => (head, Count) = (0, 0);

    /// <summary>Becomes the same as another one.</summary>
    public void CopyFrom(RingQueue<T> other)
    {
        Clear();
        for (int i = 0; i < other.Count; i++) Enqueue(other[i]);
    }

    private void Grow()
    {
        T[] larger = new T[Math.Max(8, items.Length * 2)];
        for (int i = 0; i < Count; i++) larger[i] = this[i];
        items = larger;
        head = 0;
    }
}
