using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>A body that tracks another one, as the other one keeps it.</summary>
internal struct Voyeur
{
    /// <summary>Its id.</summary>
    internal uint Id;

    /// <summary>How far the target may get before it is told again, metres.</summary>
    internal float Radius;

    /// <summary>How far ahead the target's place is foretold, seconds.</summary>
    internal double Quantum;

    /// <summary>The place told last.</summary>
    internal Position LastSent;
}

/// <summary>
/// The voyeurs of a body in the order in which retail's hash table walks them: four buckets by (id xor id &gt;&gt; 16) mod 4, the newest of
/// each first. Telling one may take it off the list and put it on again while the list is walked.
/// </summary>
internal sealed class VoyeurList
{
    private const int Buckets = 4;
    private const int NoWalk = -1;

    private Voyeur[] items = [];
    private int walkNext = NoWalk;

    /// <summary>Number of voyeurs.</summary>
    internal int Count { get; private set; }

    /// <summary>A voyeur; the reference holds until the list changes.</summary>
    internal ref Voyeur this[int index] => ref items.AsSpan(0, Count)[index];

    /// <summary>Place of a voyeur, negative when it is not there.</summary>
    internal int Find(uint id)
    {
        for (int i = 0; i < Count; i++)
        {
            if (items[i].Id == id) return i;
        }

        return -1;
    }

    /// <summary>Puts a voyeur first in its bucket.</summary>
    /// <returns>Its place.</returns>
    internal int Add(uint id)
    {
        int index = 0;
        while (index < Count && BucketOf(items[index].Id) < BucketOf(id)) index++;
        if (Count == items.Length) Array.Resize(ref items, Math.Max(4, Count * 2));
        Array.Copy(items, index, items, index + 1, Count - index);
        items[index] = new Voyeur { Id = id, LastSent = Position.Nowhere };
        Count++;
        // A walk goes on with the same voyeur; a new one before it is not told again.
        if (walkNext >= index) walkNext++;
        return index;
    }

    /// <summary>Takes a voyeur off the list.</summary>
    /// <returns>False when it was not there.</returns>
    /// <remarks>Retail: TargetManager::RemoveVoyeur @0x0051AD90.</remarks>
    internal bool Remove(uint id)
    {
        int index = Find(id);
        if (index < 0) return false;
        Count--;
        Array.Copy(items, index + 1, items, index, Count - index);
        if (walkNext > index) walkNext--;
        return true;
    }

    /// <summary>Begins to walk the list, which goes on before each voyeur is told.</summary>
    /// <returns>Place of the first voyeur, negative when there is none.</returns>
    internal int BeginWalk()
    {
        walkNext = 0;
        return Next();
    }

    /// <summary>Place of the next voyeur, negative at the end.</summary>
    internal int Next()
    {
        if (walkNext >= 0 && walkNext < Count) return walkNext++;
        walkNext = NoWalk;
        return NoWalk;
    }

    private static uint BucketOf(uint id) => (id ^ (id >> 16)) % Buckets;

    internal void AddTo(ref StateHash hash)
    {
        for (int i = 0; i < Count; i++)
        {
            hash.Add(items[i].Id);
            hash.Add(items[i].Radius);
            hash.Add(items[i].Quantum);
            hash.Add(items[i].LastSent);
        }
    }
}
