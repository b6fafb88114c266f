namespace Surefoot.Physics.World;

/// <summary>The ordered list of cells that a sphere path reaches; cells are tested in this order.</summary>
/// <remarks>Retail: CELLARRAY.</remarks>
internal sealed class CellArray
{
    private Entry[] entries = new Entry[16];

    /// <summary>True when the outdoor cells around the path were already added.</summary>
    public bool AddedOutside { get; set; }

    /// <summary>
    /// The outdoor cells of an object's parts could not be told, because the one under its first part is not loaded; the list grows when it
    /// is.
    /// </summary>
    internal bool LacksGround { get; set; }

    /// <summary>The list was begun in a room, or reaches into one through a portal.</summary>
    /// <remarks>Retail keeps this with the path: SPHEREPATH::hits_interior_cell.</remarks>
    internal bool HitsInteriorCell { get; set; }

    /// <summary>Cells that are not resident must not be created for this path.</summary>
    public bool DoNotLoadCells { get; set; }

    /// <summary>Number of entries.</summary>
    public int Count { get; private set; }

    /// <summary>Entry <paramref name="index"/>, in the order of adding.</summary>
    public Entry this[int index] => entries[index];

    /// <summary>Adds a cell unless its id is there already.</summary>
    /// <remarks>Retail: CELLARRAY::add_cell @0x006B4FF0.</remarks>
    public void Add(uint id, ObjCell? cell)
    {
        for (int i = 0; i < Count; i++)
            if (entries[i].Id == id) return;
        if (Count == entries.Length) Array.Resize(ref entries, Count * 2);
        entries[Count++] = new Entry(id, cell);
    }

    /// <summary>Removes an entry; the last one takes its slot.</summary>
    /// <remarks>Retail: CELLARRAY::remove_cell @0x006B4E80.</remarks>
    public void RemoveAt(int index)
    {
        if (Count > 0) entries[index] = entries[--Count];
    }

    /// <summary>Empties the list before a new build.</summary>
    public void Clear()
    {
        Count = 0;
        AddedOutside = LacksGround = HitsInteriorCell = false;
    }

    /// <summary>An id and, where it is loaded, its cell.</summary>
    /// <param name="Id">Cell id.</param>
    /// <param name="Cell">The cell, null when it is not loaded.</param>
    public readonly record struct Entry(uint Id, ObjCell? Cell);
}
