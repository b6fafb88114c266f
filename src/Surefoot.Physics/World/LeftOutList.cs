using System.Collections;

namespace Surefoot.Physics.World;

/// <summary>
/// What a world does without because it cannot be read or is missing, in the order in which it was met; equal things are one item with a
/// count. Each landblock adds to it once, however often it is loaded. One thread at a time, as the world.
/// </summary>
/// <remarks>
/// At most <see cref="Capacity"/> items are kept. What comes later is only counted, so that hostile files cost no memory.
/// </remarks>
public sealed class LeftOutList : IReadOnlyList<LeftOutItem>
{
    /// <summary>Most items kept.</summary>
    public const int Capacity = 1024;

    private readonly List<LeftOutItem> items = [];
    private readonly Dictionary<LeftOutItem, int> places = [];

    /// <summary>How many things are left out, those in no item included.</summary>
    public long Total { get; private set; }

    /// <summary>How many things are left out that no item tells of.</summary>
    public long Unlisted { get; private set; }

    /// <summary>Number of items.</summary>
    public int Count => items.Count;

    /// <inheritdoc/>
    public LeftOutItem this[int index] => items[index];

    /// <inheritdoc/>
    public IEnumerator<LeftOutItem> GetEnumerator() => items.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>Adds to the item that tells of the same, or makes one.</summary>
    internal void Add(LeftOutItem item)
    {
        Total += item.Count;
        LeftOutItem key = item with { FirstIn = 0, Count = 1 };
        if (places.TryGetValue(key, out int place))
        {
            items[place] = items[place] with { Count = items[place].Count + item.Count };
        }
        else if (items.Count < Capacity)
        {
            places.Add(key, items.Count);
            items.Add(item);
        }
        else
        {
            Unlisted += item.Count;
        }
    }
}
