using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Network;

/// <summary>
/// Tells whether a body overlaps the faces of something. Sweeps ask faces only; a leaf of a tree may be marked solid where none is near,
/// and that mark is asked only when a body is put somewhere: so a body may walk or fall to where it could not be put (specification 04,
/// 4.5 and 4.6).
/// </summary>
internal sealed class FaceTest(PhysicsWorld world)
{
    private readonly Transition transition = new(world);

    /// <summary>A sphere of the body, where it is, reaches into a face.</summary>
    internal bool Touches(PhysicsBody body)
    {
        if (world.GetVisible(body.Position.CellId) is not { } cell) return false;
        transition.Reset();
        transition.Object.Init(body, MoverFlags.None);
        transition.Path.InitSpheres(body.Setup!.Spheres, body.Scale);
        transition.Path.InitPath(cell, hasBegin: false, default, body.Position);
        transition.Path.SetCheckPos(body.Position, cell);
        ObjCell? home = null;
        world.FindCellList(transition.Cells, body.Position, transition.Path.CheckSpheres, wantHome: true, ref home);
        if (Objects(cell)) return true;
        for (int i = 0; i < transition.Cells.Count; i++)
            if (transition.Cells[i].Cell is { } other && !ReferenceEquals(other, cell) && Objects(other)) return true;
        return false;
    }

    private bool Objects(ObjCell cell)
    {
        // Together these two let a tree leave its marks out (specification 04, 4.6, row 1).
        transition.Path.BuildingCheck = transition.Cells.HitsInteriorCell = true;
        return cell.FindCollisions(transition) != TransitionState.OK;
    }
}
