namespace Surefoot.Physics.Decisions;

/// <summary>
/// What sweeps tell, in order, one value a decision. Whoever wants to know gives a body such a buffer, reads it after a tick and clears it;
/// once it has grown it allocates nothing. One thread at a time.
/// </summary>
public sealed class TraceBuffer
{
    /// <summary>Entries that a buffer keeps unless told otherwise.</summary>
    public const int DefaultLimit = 1 << 16;

    private const int InitialCapacity = 256, MaxHeld = 16;

    private readonly TraceSubject[] held = new TraceSubject[MaxHeld];
    private readonly int limit;
    private TraceEntry[] entries;
    private int heldCount;

    /// <summary>An empty buffer.</summary>
    /// <param name="limit">Most entries kept; later ones are only counted, until the buffer is cleared.</param>
    /// <exception cref="ArgumentOutOfRangeException">The limit is not positive.</exception>
    public TraceBuffer(int limit = DefaultLimit)
    {
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(limit);
        this.limit = limit;
        entries = new TraceEntry[Math.Min(limit, InitialCapacity)];
    }

    /// <summary>Number of entries.</summary>
    public int Count { get; private set; }

    /// <summary>Entries that were left out because the limit was reached.</summary>
    public long Dropped { get; private set; }

    /// <summary>The entries in the order of the decisions; valid until the next one.</summary>
    public ReadOnlySpan<TraceEntry> Entries => entries.AsSpan(0, Count);

    /// <summary>What is being asked at the moment.</summary>
    internal TraceSubject Subject { get; set; } = TraceSubject.None;

    /// <summary>Whose plane the body rests on at the moment.</summary>
    internal TraceSubject Contact { get; set; } = TraceSubject.AsBefore;

    /// <summary>Whose plane it rested on after the last accepted sub-step.</summary>
    internal TraceSubject LastContact { get; set; } = TraceSubject.AsBefore;

    /// <summary>What was overlapped and is to be answered later.</summary>
    internal TraceSubject Deferred { get; set; } = TraceSubject.None;

    /// <summary>What a landing was asked for on.</summary>
    internal TraceSubject Landing { get; set; } = TraceSubject.None;

    /// <summary>Forgets all entries.</summary>
    public void Clear()
    {
        Count = 0;
        Dropped = 0;
    }

    internal void Add(in TraceEntry entry)
    {
        if (Count == limit)
        {
            Dropped++;
            return;
        }

        if (Count == entries.Length) Array.Resize(ref entries, Math.Min(limit, Count * 2));
        entries[Count++] = entry;
    }

    /// <summary>A new sweep begins: whatever the last one left is forgotten.</summary>
    internal void Restart()
    {
        heldCount = 0;
        Subject = Deferred = Landing = TraceSubject.None;
        Contact = LastContact = TraceSubject.AsBefore;
    }

    /// <summary>Further questions are about to be asked on account of the subject, which <see cref="Resume"/> brings back.</summary>
    internal void Hold()
    {
        if (heldCount < MaxHeld) held[heldCount] = Subject;
        heldCount++;
    }

    /// <summary>The questions that followed <see cref="Hold"/> are answered.</summary>
    internal void Resume()
    {
        heldCount--;
        if (heldCount < MaxHeld) Subject = held[heldCount];
    }
}
