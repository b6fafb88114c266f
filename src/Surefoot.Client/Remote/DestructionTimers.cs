namespace Surefoot.Client;

/// <summary>Objects that are to be forgotten unless something happens to them: each has 25 s from its last start.</summary>
/// <remarks>
/// Retail: CObjectMaint::AddObjectToBeDestroyed @0x00508F70, RemoveObjectToBeDestroyed @0x00508440; specification 09, 5.10.
/// </remarks>
internal sealed class DestructionTimers
{
    /// <summary>Seconds from the start to the end.</summary>
    internal const double Life = 25.0;

    private readonly Dictionary<uint, LinkedListNode<(uint Id, double Due)>> places = [];

    // All live equally long, so that the order of the starts is that of the ends.
    private readonly LinkedList<(uint Id, double Due)> order = new();

    /// <summary>Number of timers that run.</summary>
    internal int Count => places.Count;

    /// <summary>Starts the timer of an object, or starts it again.</summary>
    internal void Start(uint id, double now)
    {
        if (places.TryGetValue(id, out LinkedListNode<(uint Id, double Due)>? node))
        {
            order.Remove(node);
            node.Value = (id, now + Life);
            order.AddLast(node);
        }
        else
        {
            places.Add(id, order.AddLast((id, now + Life)));
        }
    }

    /// <summary>Stops the timer of an object, if it runs.</summary>
    internal void Stop(uint id)
    {
        if (places.Remove(id, out LinkedListNode<(uint Id, double Due)>? node)) order.Remove(node);
    }

    /// <summary>Takes an object whose time is over; to be called again until there is none.</summary>
    internal bool TryTakeDue(double now, out uint id)
    {
        if (order.First is { } first && first.Value.Due < now)
        {
            id = first.Value.Id;
            Stop(id);
            return true;
        }

        id = 0;
        return false;
    }
}
