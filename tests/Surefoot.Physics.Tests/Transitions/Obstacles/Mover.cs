using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>
/// A transition at one attempt: spheres between an accepted and a tried place, and no cell that would let a step-up succeed. The tests here
/// ask an obstacle once and look at what it did.
/// </summary>
internal sealed class Mover
{
    internal const uint CellId = StubWorld.CellId;

    private readonly Position start;

    /// <param name="flags">Who moves.</param>
    /// <param name="curr">Centre of sphere 0 at the accepted place.</param>
    /// <param name="check">Centre of sphere 0 at the tried place.</param>
    /// <param name="radius">Radius of every sphere.</param>
    /// <param name="above">Offset of a second sphere, null for one sphere.</param>
    /// <param name="stepUpHeight">Highest step.</param>
    internal Mover(MoverFlags flags, Vector3 curr, Vector3 check, float radius, Vector3? above = null, float stepUpHeight = 0.6f)
    {
        Transition = new Transition(new StubWorld(_ => null) { Blocks = _ => true });
        Transition.Reset();
        Sphere[] spheres = above is { } offset ? [new(Vector3.Zero, radius), new(offset, radius)] : [new(Vector3.Zero, radius)];
        SetupAsset setup = new() { Spheres = spheres, StepUpHeight = stepUpHeight, StepDownHeight = stepUpHeight };
        Transition.Object.Init(new WorldObject(1, setup, default), flags);
        Path.InitSpheres(spheres, 1);
        Path.InitPath(null, true, new Position(CellId, curr), new Position(CellId, check));
        Path.SetCheckPos(new Position(CellId, check), null);
        Path.WalkInterp = 1;
        Path.WalkableAllowance = RetailMath.FloorZ;
        start = Path.CheckPos;
    }

    internal Transition Transition { get; }

    internal SpherePath Path => Transition.Path;

    internal CollisionInfo Collision => Transition.Collision;

    /// <summary>How far the attempt was moved: the difference of the stored positions.</summary>
    internal Vector3 Moved => Path.CheckPos.Frame.Origin - start.Frame.Origin;

    internal Vector3 At => Path.CheckPos.Frame.Origin;

    /// <summary>Puts the second sphere elsewhere: accepted and tried centre.</summary>
    internal Mover WithHead(Vector3 curr, Vector3 check)
    {
        Path.GlobalCurrCenters[1] = curr;
        Path.GlobalSpheres[1].Center = check;
        Path.LocalSpaceCurrCenters[1] = curr;
        return this;
    }

    internal Mover With(Action<SpherePath> change)
    {
        change(Path);
        return this;
    }

    internal Mover Standing(Vector3 normal)
    {
        Collision.SetContactPlane(new Plane(normal, 0), false, CellId);
        return this;
    }

    internal Mover LastStoodOn(Vector3 normal)
    {
        Collision.LastKnownContactPlane = new Plane(normal, 0);
        return this;
    }

    /// <summary>Asks a tree that stands at the origin of the block.</summary>
    internal TransitionState Ask(PhysicsBsp tree, Frame? at = null, float scale = 1)
    {
        Vector3 headCurr = Path.GlobalCurrCenters[1], head = Path.GlobalSpheres[1].Center;
        Path.CacheLocalSpaceSpheres(new Position(CellId, at ?? Frame.Identity), scale);
        if (at is null && Path.SphereCount > 1)
        {
            Path.LocalSpaceCurrCenters[1] = headCurr;
            Path.LocalSpaceSpheres[1].Center = head;
        }

        return Path.InsertType == InsertType.InitialPlacement ? tree.PlacementInsert(Transition) : tree.FindCollisions(Transition, scale);
    }

    internal TransitionState Ask(Sphere obstacle, bool creature = false) => BallObstacle.IntersectsSphere(Transition, obstacle, creature);

    internal TransitionState Ask(CylSphere obstacle, Frame? at = null) =>
        CylinderObstacle.IntersectsSphere(Transition, new Position(CellId, at ?? Frame.Identity), 1, obstacle);
}
