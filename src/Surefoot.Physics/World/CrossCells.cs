using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;

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
        if (item.Setup is { HasPhysicsBsp: true } setup) ByParts(item, setup, item.Scale);
        else if (item.Setup is { Cylinders.IsEmpty: false } standing) ByCylinders(item, standing);
        else BySortingSphere(item);
    }

    /// <summary>The cells of a static object. Its scale takes no part, as when retail places scenery, which is scaled afterwards.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_cross_cells_static @0x00515160.</remarks>
    internal void FindStatic(StaticObject item)
    {
        Cells.DoNotLoadCells = true;
        SetupAsset setup = item.Setup!;
        if (!setup.HasPhysicsBsp && !setup.Cylinders.IsEmpty) ByCylinders(item, setup);
        else ByParts(item, setup, 1f);
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
        world.FindCellList(Cells, item.Position, spheres.AsSpan(0, count), null, false, ref unused);
    }

    /// <remarks>Retail: CPhysicsObj::find_bbox_cell_list @0x00510FC0. No containment, no pruning.</remarks>
    private void ByParts(WorldObject item, SetupAsset setup, float scale)
    {
        Cells.Clear();
        if (item.Cell is null) return;
        Cells.Add(item.Cell.Id, item.Cell);
        ReadOnlySpan<PartExtent> extents = parts.AsSpan(0, CollectParts(item, setup, scale));
        for (int k = 0; k < Cells.Count; k++) Cells[k].Cell?.FindTransitCells(world, extents, Cells);
    }

    private int CollectParts(WorldObject item, SetupAsset setup, float scale)
    {
        ReadOnlySpan<Frame> pose = item.PartPose;
        int count = Math.Min(setup.Parts.Length, pose.Length), used = 0;
        if (parts.Length < count) parts = new PartExtent[count];
        for (int i = 0; i < count; i++)
        {
            GfxObjAsset mesh = setup.Parts[i].Mesh;
            // A mesh without vertices is nowhere.
            if (mesh.BoundingBox.IsEmpty && !mesh.Always2D) continue;
            parts[used++] = new PartExtent(
                SetupAsset.PlacePart(item.Position, pose[i], scale), mesh.BoundingBox, mesh.AnySphere ?? default, mesh.AnySphere.HasValue, mesh.Always2D);
        }

        return used;
    }
}
