namespace Surefoot.Physics.World;

/// <content>The cells that list the object.</content>
public partial class WorldObject
{
    /// <summary>
    /// One shadow for each cell the object reaches, in the order of the cell array it was placed with; see <see cref="ShadowCount"/>.
    /// </summary>
    internal ShadowObject[] Shadows = [];

    /// <summary>Number of cells that list the object, loaded or not.</summary>
    internal int ShadowCount { get; set; }

    /// <summary>A cell that lists the object.</summary>
    internal ShadowObject ShadowAt(int index) => Shadows[index];

    /// <summary>It is in a cell, has shadows, and every one of them has a cell.</summary>
    /// <remarks>Retail: CPhysicsObj::is_completely_visible @0x005112C0.</remarks>
    internal bool IsCompletelyVisible
    {
        get
        {
            if (Cell is null || ShadowCount == 0) return false;
            for (int i = 0; i < ShadowCount; i++)
            {
                if (Shadows[i].Cell is null) return false;
            }

            return true;
        }
    }

    /// <summary>Makes room for that many shadows.</summary>
    internal void ReserveShadows(int count)
    {
        if (count > Shadows.Length) Array.Resize(ref Shadows, count);
    }

    /// <summary>Lists the object in one more cell; room must have been made.</summary>
    internal void AddShadow(uint cellId, ObjCell? cell)
    {
        Shadows[ShadowCount] = new ShadowObject { CellId = cellId, Cell = cell };
        cell?.AddShadow(this, ShadowCount);
        ShadowCount++;
    }

    /// <summary>Lists the object nowhere.</summary>
    /// <remarks>Retail: CPhysicsObj::remove_shadows_from_cells @0x00511230.</remarks>
    internal void ClearShadows()
    {
        for (int i = 0; i < ShadowCount; i++)
        {
            Shadows[i].Cell?.RemoveShadow(Shadows[i].Index);
            Shadows[i].Cell = null;
        }

        ShadowCount = 0;
    }
}
