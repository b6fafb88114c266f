using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.World;

/// <summary>What a transition asks of the world it moves through.</summary>
public interface ICellWorld
{
    /// <summary>The loaded cell with this id, or null.</summary>
    ObjCell? GetVisible(uint cellId);

    /// <summary>
    /// Rebuilds <paramref name="array"/> around the path's check position with all its spheres. With <paramref name="wantHome"/>, and when the check
    /// position's own cell is loaded, <paramref name="home"/> becomes the cell that contains the centre of sphere 0 (null for none);
    /// otherwise it is left as it is.
    /// </summary>
    /// <remarks>Retail: CObjCell::find_cell_list @0x0052B960; specification 03, 4.8.4.</remarks>
    void FindCellList(CellArray array, SpherePath path, bool wantHome, ref ObjCell? home);
}
