using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>Which squares of land spheres and parts reach. Cells that are not loaded are listed without a cell.</summary>
/// <remarks>
/// Retail: CLandCell::add_all_outside_cells and what it calls; specification 05, 4.10. The order of the list is observable.
/// </remarks>
internal static class OutdoorCells
{
    /// <summary>
    /// Cells that an object can reach on each side of the one under it, 768 m. Retail knows no limit; a hostile mesh of kilometres would
    /// make it list the whole map.
    /// </summary>
    private const int MaxReach = 32;

    /// <summary>
    /// Adds the cell under each sphere and those of its eight neighbours that it reaches, whatever the radius; once for each list.
    /// </summary>
    /// <remarks>Retail: CLandCell::add_all_outside_cells @0x00533630.</remarks>
    internal static void AddAll(ICellWorld world, in Position position, ReadOnlySpan<Sphere> spheres, CellArray array)
    {
        if (array.AddedOutside) return;
        array.AddedOutside = true;
        if (spheres.IsEmpty)
        {
            uint id = position.CellId;
            Vector3 origin = position.Frame.Origin;
            if (CellIds.AdjustToOutside(ref id, ref origin) && CellIds.TryLandCoordinates(id, out int x, out int y))
                Add(world, array, x, y);
            return;
        }

        foreach (ref readonly Sphere sphere in spheres)
        {
            uint id = position.CellId;
            Vector3 point = sphere.Center;
            // A sphere off the map ends the search; the remaining ones are not looked at.
            if (!CellIds.AdjustToOutside(ref id, ref point)) break;
            if (!CellIds.TryLandCoordinates(id, out int x, out int y)) continue;
            Add(world, array, x, y);
            AddNeighbours(world, array, x, y, InCell(point.X), InCell(point.Y), sphere.Radius);
        }
    }

    /// <summary>
    /// Adds the rectangle of cells under the boxes of an object's parts, the cell under the first part included; once for each list.
    /// </summary>
    /// <remarks>Retail: CLandCell::add_all_outside_cells @0x00533360.</remarks>
    internal static void AddAll(ICellWorld world, ReadOnlySpan<PartExtent> parts, CellArray array)
    {
        if (array.AddedOutside) return;
        array.AddedOutside = true;
        if (parts.IsEmpty) return;
        uint id = parts[0].Position.CellId;
        Vector3 origin = parts[0].Position.Frame.Origin;
        if (!CellIds.AdjustToOutside(ref id, ref origin)) return;
        if (world.GetVisible(id) is not { } cell)
        {
            array.LacksGround = true;
            return;
        }

        if (!CellIds.TryLandCoordinates(id, out int x, out int y)) return;

        Position center = cell.Position;
        int index = CellIds.LandIndex(id), column = index >> 3, row = index & 7;
        int minX = 0, maxX = 0, minY = 0, maxY = 0;
        foreach (ref readonly PartExtent part in parts)
        {
            BoundingBox box = part.Always2D ? AroundSphere(part) : part.BoxInBlockOf(center);
            minX = Math.Min(minX, CellOf(box.Min.X) - column);
            maxX = Math.Max(maxX, CellOf(box.Max.X) - column);
            minY = Math.Min(minY, CellOf(box.Min.Y) - row);
            maxY = Math.Max(maxY, CellOf(box.Max.Y) - row);
        }

        for (int i = x + Math.Max(minX, -MaxReach); i <= x + Math.Min(maxX, MaxReach); i++)
        {
            for (int j = y + Math.Max(minY, -MaxReach); j <= y + Math.Min(maxY, MaxReach); j++) Add(world, array, i, j);
        }
    }

    /// <remarks>Retail: CLandCell::add_outside_cell @0x00532EC0.</remarks>
    private static void Add(ICellWorld world, CellArray array, int x, int y)
    {
        uint id = CellIds.FromLandCoordinates(x, y);
        if (id != 0) array.Add(id, world.GetVisible(id));
    }

    /// <remarks>Retail: CLandCell::check_add_cell_boundary @0x00533260. All comparisons are strict.</remarks>
    private static void AddNeighbours(ICellWorld world, CellArray array, int x, int y, float px, float py, float radius)
    {
        float far = (float)((double)CellIds.CellSize - radius);
        bool north = py > far, south = py < radius;
        if (px > far)
        {
            Add(world, array, x + 1, y);
            if (north) Add(world, array, x + 1, y + 1);
            if (south) Add(world, array, x + 1, y - 1);
        }

        if (px < radius)
        {
            Add(world, array, x - 1, y);
            if (north) Add(world, array, x - 1, y + 1);
            if (south) Add(world, array, x - 1, y - 1);
        }

        if (north) Add(world, array, x, y + 1);
        if (south) Add(world, array, x, y - 1);
    }

    private static float InCell(float coordinate) =>
        (float)(coordinate - (CellIds.CellSize * Math.Floor(coordinate / (double)CellIds.CellSize)));

    /// <summary>Column or row of a block coordinate; the cast saturates, and NaN is 0.</summary>
    private static int CellOf(float coordinate) =>
        (int)Math.Clamp(Math.Floor(coordinate / (double)CellIds.CellSize), -1e6, 1e6);

    private static BoundingBox AroundSphere(in PartExtent part)
    {
        Vector3 radius = new(part.Sphere.Radius), origin = part.Position.Frame.Origin;
        return new BoundingBox(origin - radius, origin + radius);
    }
}
