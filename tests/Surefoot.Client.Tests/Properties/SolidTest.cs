using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>
/// What retail's own test says of a place. All but the first two are the specification's own exceptions to "nobody ends inside a solid".
/// </summary>
internal enum Stand
{
    /// <summary>Nothing objects.</summary>
    Free,

    /// <summary>Inside something, and nothing in the specification excuses it.</summary>
    Inside,

    /// <summary>
    /// A walker that does not slide along edges walked into ground too steep to stand on: the ground answers OK without lifting it
    /// (specification 03, 4.4, end), no floor is found, and it "walks off" where it is (03, 4.7, edge_slide, case A). The next quantum
    /// lifts it.
    /// </summary>
    SteepGroundWalkedInto,

    /// <summary>
    /// A body of one sphere that stands passes polygons that it overlaps without running against them: only those of two spheres answer
    /// them later (specification 04, 4.6 row 5, and 4.13, last point).
    /// </summary>
    PassedByOneSphere,

    /// <summary>
    /// The centre is in a leaf marked solid and no polygon is touched: sweeps ask polygons only, and the mark is consulted only when a body
    /// is placed (specification 04, 4.5 and 4.6). Met in the hollow of a building: a room is reached one centimetre (04, 3, CELL_FUDGE)
    /// before its faces are.
    /// </summary>
    SolidWithoutFaces,

    /// <summary>
    /// A part of an animated static came to where the body is: only the part moves, nothing pushes a body out of its way (specification 02,
    /// 4.19).
    /// </summary>
    SweptOver,
}

/// <summary>
/// Retail's own test of a place: the spheres of a body are inserted as a placement does it (specification 03, 4.8.3 and 4.9), into the
/// body's cell and every cell that the spheres reach.
/// </summary>
internal sealed class SolidTest(PhysicsWorld world)
{
    private readonly Transition transition = new(world);

    /// <summary>The cell that objected last.</summary>
    internal ObjCell? Culprit { get; private set; }

    /// <summary>Judges a body where it is.</summary>
    internal Stand Judge(PhysicsBody body) => Judge(body, body.Position, body.HasContact);

    /// <summary>Judges a body as if it were somewhere else.</summary>
    internal Stand Judge(PhysicsBody body, in Position place, bool hasContact)
    {
        ObjCell cell = world.GetVisible(place.CellId)!;
        TransitionState state = Insert(body, place, cell, facesOnly: false);
        if (state == TransitionState.OK) return Stand.Free;
        if (IsFreeOfWhatStandsStill(body, place, cell)) return Stand.SweptOver;
        // The ground is the only one to move a body that is being placed: it lifts it.
        if (state == TransitionState.Adjusted)
            return !hasContact && !body.State.Has(PhysicsState.EdgeSlide) && IsOverSteepGround()
                ? Stand.SteepGroundWalkedInto
                : Stand.Inside;
        if (Insert(body, place, cell, facesOnly: true) == TransitionState.OK) return Stand.SolidWithoutFaces;
        return body.Setup!.Spheres.Length == 1 ? Stand.PassedByOneSphere : Stand.Inside;
    }

    private bool IsFreeOfWhatStandsStill(PhysicsBody body, in Position place, ObjCell cell)
    {
        const PhysicsState untested = PhysicsState.Ethereal | PhysicsState.IgnoreCollisions;
        List<StaticObject> moving = [.. world.Landblocks.SelectMany(block => block.AnimatedStatics)];
        ObjCell? culprit = Culprit;
        foreach (StaticObject item in moving) item.State |= untested;
        bool free = moving.Count > 0 && Insert(body, place, cell, facesOnly: false) == TransitionState.OK;
        foreach (StaticObject item in moving) item.State &= ~untested;
        Culprit = culprit;
        return free;
    }

    private TransitionState Insert(PhysicsBody body, in Position place, ObjCell cell, bool facesOnly)
    {
        transition.Reset();
        transition.Object.Init(body, MoverFlags.None);
        transition.Path.InitSpheres(body.Setup!.Spheres, body.Scale);
        transition.Path.InitPath(cell, hasBegin: false, default, place);
        transition.Path.SetCheckPos(place, cell);
        ObjCell? home = null;
        world.FindCellList(transition.Cells, place, transition.Path.CheckSpheres, wantHome: true, ref home);
        TransitionState state = Ask(cell, facesOnly);
        for (int i = 0; i < transition.Cells.Count && state == TransitionState.OK; i++)
        {
            if (transition.Cells[i].Cell is { } other && !ReferenceEquals(other, cell)) state = Ask(other, facesOnly);
        }

        return state;
    }

    private TransitionState Ask(ObjCell cell, bool facesOnly)
    {
        // Together these two let a tree ignore its solid marks (specification 04, 4.6, row 1).
        if (facesOnly) transition.Path.BuildingCheck = transition.Cells.HitsInteriorCell = true;
        TransitionState state = cell.FindCollisions(transition);
        if (state != TransitionState.OK) Culprit = cell;
        return state;
    }

    private bool IsOverSteepGround()
    {
        if (Culprit is not LandCell land) return false;
        int triangle = land.FindTriangle(transition.Path.GlobalLowPoint - CellIds.BlockOffset(transition.Path.CheckPos.CellId, land.Id));
        return triangle >= 0 && land.Landblock.Terrain.PlaneOf(triangle).Normal.Z < RetailMath.FloorZ;
    }
}
