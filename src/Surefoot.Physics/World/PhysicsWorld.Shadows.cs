namespace Surefoot.Physics.World;

/// <content>Which cells list an object.</content>
public sealed partial class PhysicsWorld
{
    /// <summary>A body reaches at most nine squares of land and a few rooms, whatever its size.</summary>
    private const int UsualShadows = 16;

    /// <summary>Bodies that reach into cells that are not loaded.</summary>
    private readonly HashSet<WorldObject> waiting = [];
    private CrossCells? crossCells;

    private CrossCells CrossCells => crossCells ??= new CrossCells(this);

    /// <inheritdoc cref="ICellWorld.PlaceShadows"/>
    internal void PlaceShadows(WorldObject item, CellArray cells)
    {
        ClearShadows(item);
        AddShadows(item, cells);
    }

    /// <summary>What an object holds is listed where the object is, whatever it reaches itself.</summary>
    private void AddShadows(WorldObject item, CellArray cells)
    {
        item.ReserveShadows(item is StaticObject ? Math.Max(cells.Count, 1) : Math.Max(cells.Count, UsualShadows));
        if ((item.State & PhysicsState.ParticleEmitter) != 0)
        {
            if (item.Cell is not null) item.AddShadow(item.Cell.Id, item.Cell);
        }
        else
        {
            for (int i = 0; i < cells.Count; i++) item.AddShadow(cells[i].Id, cells[i].Cell);
        }

        if (item is StaticObject) return;
        if (item.IsCompletelyVisible) waiting.Remove(item);
        else waiting.Add(item);
        for (int i = 0; i < item.HeldCount; i++) AddShadows(item.HeldAt(i), cells);
    }

    private static void ClearShadows(WorldObject item)
    {
        item.ClearShadows();
        for (int i = 0; i < item.HeldCount; i++) ClearShadows(item.HeldAt(i));
    }

    void ICellWorld.RemoveShadows(WorldObject item) => RemoveShadows(item);

    /// <inheritdoc cref="ICellWorld.RemoveShadows"/>
    internal void RemoveShadows(WorldObject item)
    {
        item.ClearShadows();
        waiting.Remove(item);
        for (int i = 0; i < item.HeldCount; i++) RemoveShadows(item.HeldAt(i));
    }

    bool ICellWorld.AnyOverlaps(WorldObject item)
    {
        for (int i = 0; i < item.ShadowCount; i++)
        {
            if (item.Shadows[i].Cell is not { } cell) continue;
            for (int k = 0; k < cell.ShadowCount; k++)
            {
                WorldObject other = cell.ShadowAt(k);
                if (!ReferenceEquals(other, item) && other.Parent is null && other.Overlaps(item)) return true;
            }
        }

        return false;
    }

    void ICellWorld.PlaceShadows(WorldObject item, CellArray cells) => PlaceShadows(item, cells);

    void ICellWorld.CalcCrossCells(WorldObject item) => CalcCrossCells(item);

    /// <inheritdoc cref="ICellWorld.CalcCrossCells"/>
    internal void CalcCrossCells(WorldObject item)
    {
        CrossCells.Find(item);
        PlaceShadows(item, CrossCells.Cells);
    }

    private void CalcCrossCellsStatic(StaticObject item)
    {
        CrossCells.FindStatic(item);
        item.LacksGround = CrossCells.Cells.LacksGround;
        PlaceShadows(item, CrossCells.Cells);
    }

    /// <summary>Bodies that reach into a block that was just loaded are listed there; the order is that of their ids.</summary>
    private void FillWaitingShadows(Landblock block)
    {
        foreach (WorldObject item in waiting.OrderBy(o => o.Id).ToArray())
        {
            for (int i = 0; i < item.ShadowCount; i++)
            {
                ref ShadowObject shadow = ref item.Shadows[i];
                if (shadow.Cell is not null || CellIds.BlockOf(shadow.CellId) != block.Id || block.Find(shadow.CellId) is not { } cell)
                    continue;
                shadow.Cell = cell;
                cell.AddShadow(item, i);
            }

            if (item.IsCompletelyVisible) waiting.Remove(item);
        }
    }
}
