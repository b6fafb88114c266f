namespace Surefoot.Physics.World;

/// <summary>One entry of an object in the collision list of a cell.</summary>
/// <remarks>Retail: CShadowObj.</remarks>
internal struct ShadowObject
{
    /// <summary>The cell, null while it is not loaded.</summary>
    public ObjCell? Cell { get; internal set; }

    /// <summary>Id of the cell.</summary>
    public uint CellId { get; internal set; }

    /// <summary>Place in the cell's list.</summary>
    internal int Index { get; set; }
}
