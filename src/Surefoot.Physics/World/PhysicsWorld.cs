using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// The landblocks that are loaded, and the cells in them. One thread at a time; worlds share nothing that is written. What is loaded does
/// not depend on the order in which it was.
/// </summary>
/// <remarks>
/// Retail loads rooms and landblocks as the player moves: the blocks within one of the player's, and the rooms that are seen from there.
/// Here the caller decides what is loaded, all rooms of a block come with it, and nothing is ever loaded from inside a quantum.
/// </remarks>
public sealed partial class PhysicsWorld : ICellWorld
{
    private const int MapBlocks = 255;

    private readonly Landblock?[]?[] columns = new Landblock?[]?[MapBlocks];
    private readonly SortedDictionary<uint, Landblock> blocks = [];

    /// <summary>Loaded blocks, ascending by id: column by column from the west, each from the south.</summary>
    public IReadOnlyCollection<Landblock> Landblocks => blocks.Values;

    /// <inheritdoc/>
    public LeftOutList LeftOut { get; } = new();

    /// <summary>Who may enter guarded cells; without it no player enters one.</summary>
    public IMoveRestrictions? Restrictions { get; set; }

    /// <summary>The loaded block of an id, or null.</summary>
    public Landblock? FindLandblock(uint cellId)
    {
        uint column = cellId >> 24, row = (cellId >> 16) & 0xFF;
        return column < MapBlocks && row < MapBlocks ? columns[column]?[row] : null;
    }

    /// <inheritdoc/>
    /// <remarks>Retail: CObjCell::GetVisible @0x0052AD40.</remarks>
    public ObjCell? GetVisible(uint cellId) => FindLandblock(cellId)?.Find(cellId);

    /// <inheritdoc/>
    public bool AdjustPosition(ref Position position, in Vector3 center, out ObjCell? cell)
    {
        cell = null;
        if (!CellIds.HasValidIndex(position.CellId)) return false;
        if (!CellIds.IsOutdoor(position.CellId))
        {
            if (GetVisible(position.CellId) is not EnvCell room) return false;
            Vector3 point = position.LocalToGlobal(position, center);
            cell = room.FindVisibleChildCell(this, point, searchVisible: true);
            if (cell is not null)
            {
                position.CellId = cell.Id;
                return true;
            }

            if (!room.SeenOutside) return false;
        }

        if (!position.AdjustToOutside()) return false;
        cell = GetVisible(position.CellId);
        return true;
    }

    void ICellWorld.FindCellList(CellArray array, in Position position, ReadOnlySpan<Sphere> spheres, bool wantHome, ref ObjCell? home) =>
        FindCellList(array, position, spheres, wantHome, ref home);

    /// <inheritdoc cref="ICellWorld.FindCellList"/>
    internal void FindCellList(CellArray array, in Position position, ReadOnlySpan<Sphere> spheres, bool wantHome, ref ObjCell? home)
    {
        array.Clear();
        ObjCell? start = GetVisible(position.CellId);
        bool indoors = !CellIds.IsOutdoor(position.CellId);
        if (indoors)
        {
            array.HitsInteriorCell = true;
            array.Add(position.CellId, start);
        }
        else
        {
            OutdoorCells.AddAll(this, position, spheres, array);
        }

        if (start is null || spheres.IsEmpty) return;
        for (int k = 0; k < array.Count; k++) array[k].Cell?.FindTransitCells(this, position, spheres, array);
        if (wantHome) home = FindHome(array, position.CellId, spheres[0].Center);
        if (array.DoNotLoadCells && indoors) DropCellsNotSeenFrom(start, array);
    }

    private static ObjCell? FindHome(CellArray array, uint cellId, in Vector3 center)
    {
        ObjCell? home = null;
        for (int k = 0; k < array.Count; k++)
        {
            ObjCell? cell = array[k].Cell;
            if (cell is null || !cell.PointInCell(center - CellIds.BlockOffset(cellId, cell.Id))) continue;
            home = cell;
            if (CellIds.IsOutdoor(cell.Id)) continue;
            array.HitsInteriorCell = true;
            break;
        }

        return home;
    }

    private static void DropCellsNotSeenFrom(ObjCell start, CellArray array)
    {
        for (int k = 0; k < array.Count;)
        {
            if (array[k].Id == start.Id || start.StabList.Contains(array[k].Id)) k++;
            else array.RemoveAt(k);
        }
    }
}
