namespace Surefoot.Client;

/// <summary>Why a message about an object did nothing.</summary>
public enum RemoteDrop
{
    /// <summary>Its bytes are damaged.</summary>
    Unreadable,

    /// <summary>A number is not finite or out of all bounds, a command has no name, a place is in no cell, an id is 0.</summary>
    BadValue,

    /// <summary>It is for an earlier life of the object.</summary>
    EarlierLife,

    /// <summary>It is for a later life of an object that is known: it waits with the object, and goes with it.</summary>
    LaterLife,

    /// <summary>It came twice, or something newer came before it.</summary>
    Late,

    /// <summary>It waited for an object that did not come.</summary>
    NeverCame,

    /// <summary>Too much waits already, or there are too many objects.</summary>
    NoRoom,

    /// <summary>The object's shape or motions are in no file or cannot be read. The object is left out.</summary>
    NoAssets,

    /// <summary>The holder has no such holding location, or would hold itself.</summary>
    NotHeld,

    /// <summary>
    /// It would delete the local player or put it into a hand, or make a body that is there already without being one of these objects.
    /// </summary>
    NotOurs,
}

/// <summary>How many messages about objects did nothing, by reason.</summary>
public sealed class RemoteDrops
{
    private readonly long[] counts = new long[Enum.GetValues<RemoteDrop>().Length];

    /// <summary>How many for one reason.</summary>
    public long this[RemoteDrop reason] => counts[(int)reason];

    /// <summary>How many in all.</summary>
    public long Total
    {
        get
        {
            long total = 0;
            foreach (long count in counts) total += count;
            return total;
        }
    }

    internal void Add(RemoteDrop reason, long count = 1) => counts[(int)reason] += count;
}
