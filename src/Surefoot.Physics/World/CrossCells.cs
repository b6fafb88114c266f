using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>Finds the cells that an object reaches from where it is, by its parts, its cylinders or its sorting sphere.</summary>
/// <remarks>Retail: the forms of CObjCell::find_cell_list and CPhysicsObj::find_bbox_cell_list; specification 05, 4.15 and 4.17.</remarks>
internal sealed class CrossCells(PhysicsWorld world)
{
    private const int MaxCylinders = 10;

    private readonly Sphere[] spheres = new Sphere[MaxCylinders];
    private PartExtent[] parts = new PartExtent[8];

    /// <summary>The list found last.</summary>
    internal CellArray Cells { get; } = new();

    /// <summary>The cells of an object that moves.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_cross_cells @0x00515230.</remarks>
    internal void Find(WorldObject item)
    {
        Cells.DoNotLoadCells = false;
        if (item.State.Has(PhysicsState.HasPhysicsBsp)) ByParts(item);
        else if (item.Setup is { Cylinders.IsEmpty: false } standing) ByCylinders(item, standing);
        else BySortingSphere(item);
    }

    /// <summary>The cells of a static object, by where its parts were when it was made: they do not follow an animation.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_cross_cells_static @0x00515160.</remarks>
    internal void FindStatic(StaticObject item)
    {
        Cells.DoNotLoadCells = true;
        if (!item.State.Has(PhysicsState.HasPhysicsBsp) && item.Setup is { Cylinders.IsEmpty: false } standing) ByCylinders(item, standing);
        else ByParts(item);
    }

    /// <summary>Only the first ten cylinders count, each as a sphere about its low point; retail scales neither.</summary>
    private void ByCylinders(WorldObject item, SetupAsset setup)
    {
        int count = Math.Min(setup.Cylinders.Length, MaxCylinders);
        for (int i = 0; i < count; i++)
            spheres[i] = new Sphere(item.Position.Frame.LocalToGlobal(setup.Cylinders[i].LowPoint), setup.Cylinders[i].Radius);
        BySpheres(item, count);
    }

    private void BySortingSphere(WorldObject item)
    {
        Sphere sphere = item.Setup is { Parts.IsEmpty: false } setup ? setup.SortingSphere : default;
        spheres[0] = new Sphere(item.Position.Frame.LocalToGlobal(sphere.Center), sphere.Radius);
        BySpheres(item, 1);
    }

    private void BySpheres(WorldObject item, int count)
    {
        ObjCell? unused = null;
        world.FindCellList(Cells, item.Position, spheres.AsSpan(0, count), false, ref unused);
    }

    /// <remarks>Retail: CPhysicsObj::find_bbox_cell_list @0x00510FC0. No containment, no pruning.</remarks>
    private void ByParts(WorldObject item)
    {
        Cells.Clear();
        if (item.Cell is null) return;
        Cells.Add(item.Cell.Id, item.Cell);
        int count = CollectParts(item);
        ReadOnlySpan<PartExtent> extents = parts.AsSpan(0, count);
        for (int k = 0; k < Cells.Count; k++) Cells[k].Cell?.FindTransitCells(world, extents, Cells);
    }

    private int CollectParts(WorldObject item)
    {
        int count = item.PlacedPartCount, used = 0;
        if (parts.Length < count) parts = new PartExtent[count];
        for (int i = 0; i < count; i++)
        {
            GfxObjAsset mesh = item.Setup!.Parts[i].Mesh;
            // A mesh without vertices is nowhere.
            if (mesh.BoundingBox.IsEmpty && !mesh.Always2D) continue;
            Position place = new(item.Position.CellId, item is StaticObject still ? still.FirstPartFrame(i) : item.PartFrame(i));
            parts[used++] = new PartExtent(place, mesh.BoundingBox, mesh.AnySphere ?? default, mesh.AnySphere.HasValue, mesh.Always2D);
        }

        return used;
    }
}
