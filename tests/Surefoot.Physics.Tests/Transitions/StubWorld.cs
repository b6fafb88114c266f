using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>The one-cell worlds of specification 03, 6.8: a ground, perhaps a wall, perhaps a place where nothing fits.</summary>
internal sealed class StubWorld : ICellWorld
{
    internal const uint CellId = 0xA9B40009;

    private readonly StubCell cell;

    internal StubWorld(Func<Vector3, Plane?> ground) => cell = new StubCell(ground);

    internal (Vector3 Normal, float D, Func<Vector3, bool> Reaches)? Wall { set => cell.Wall = value; }

    internal Func<Transition, bool>? Blocks { set => cell.Blocks = value; }

    /// <summary>Where the cell is loaded for a body that is tried there; everywhere without it.</summary>
    internal Func<Vector3, bool>? IsLoaded { private get; set; }

    internal StubCell Cell => cell;

    public LeftOutList LeftOut { get; } = new();

    public IMoveRestrictions? Restrictions => null;

    public ObjCell? GetVisible(uint cellId) => cellId == CellId ? cell : null;

    public void FindCellList(CellArray array, in Position position, ReadOnlySpan<Sphere> spheres, bool wantHome, ref ObjCell? home)
    {
        array.Clear();
        array.Add(CellId, cell);
        if (wantHome) home = IsLoaded is { } loaded && !loaded(position.Frame.Origin) ? null : cell;
    }

    public bool AdjustPosition(ref Position position, in Vector3 center, out ObjCell? adjusted)
    {
        adjusted = cell;
        return true;
    }

    public void PlaceShadows(WorldObject item, CellArray cells)
    {
    }

    public void RemoveShadows(WorldObject item)
    {
    }

    public void CalcCrossCells(WorldObject item)
    {
    }

    public bool AnyOverlaps(WorldObject item) => false;

    internal static Plane Flat(float height) => new(0, 0, 1, -height);

    /// <summary>A slope of the given steepness whose foot (rising towards +x) or brink (falling) is at x = 1.</summary>
    internal static Plane SlopeFromX1(double degrees, bool rising)
    {
        double a = degrees * Math.PI / 180;
        float sine = (float)Math.Sin(a), cosine = (float)Math.Cos(a);
        return rising ? new Plane(-sine, 0, cosine, sine) : new Plane(sine, 0, cosine, -sine);
    }

    internal static SetupAsset Setup(params Sphere[] spheres) => new()
    {
        Id = 0x02000001,
        Spheres = spheres,
        Height = 1.83f,
        Radius = spheres[0].Radius,
        StepUpHeight = 0.6f,
        StepDownHeight = 0.6f,
    };

    internal PhysicsBody Walker() => new PhysicsEngine(this).CreateBody(
        1,
        Setup(new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)),
        PhysicsState.Gravity | PhysicsState.ReportCollisions);

    /// <summary>
    /// A transition from <paramref name="start"/> by <paramref name="displacement"/>, seeded with the ground's plane where the mover has
    /// contact.
    /// </summary>
    internal Transition Sweep(Vector3 start, Vector3 displacement, MoverFlags flags, int stationary = 0, Vector3? sliding = null)
    {
        Transition transition = new(this);
        transition.Reset();
        PhysicsBody body = Walker();
        transition.Object.Init(body, flags);
        transition.Path.InitSpheres(body.Setup!.Spheres, 1);
        if ((flags & MoverFlags.Contact) != 0) transition.InitContactPlane(CellId, cell.Ground(start)!.Value, false);
        if (sliding is { } wall) transition.Collision.SetSlidingNormal(wall);
        transition.Path.InitPath(cell, true, new Position(CellId, start), new Position(CellId, start + displacement));
        transition.Collision.FramesStationaryFall = stationary;
        return transition;
    }

    internal sealed class StubCell(Func<Vector3, Plane?> ground) : ObjCell(CellId)
    {
        internal (Vector3 Normal, float D, Func<Vector3, bool> Reaches)? Wall { get; set; }

        internal Func<Transition, bool>? Blocks { get; set; }

        /// <summary>Asked after the ground; its answer is the cell's.</summary>
        internal Func<Transition, TransitionState>? Obstacle { get; set; }

        internal Plane? Ground(Vector3 lowPoint) => ground(lowPoint);

        internal override bool PointInCell(in Vector3 point) => true;

        internal override TransitionState FindCollisions(Transition t)
        {
            if (Blocks is { } blocks && blocks(t)) return TransitionState.Collided;
            if (ground(t.Path.GlobalLowPoint) is { } plane)
            {
                TransitionState state = t.ValidateWalkable(t.Path.GlobalSpheres[0], plane, false, 0, CellId);
                if (state != TransitionState.OK) return state;
            }

            if (Obstacle is { } obstacle) return obstacle(t);
            if (Wall is not { } wall) return TransitionState.OK;
            Sphere foot = t.Path.GlobalSpheres[0];
            bool hit = wall.Reaches(foot.Center) && RetailMath.Dot(wall.Normal, foot.Center) + wall.D < foot.Radius - RetailMath.Epsilon;
            if (!hit) return TransitionState.OK;
            if (t.Path.InsertType != InsertType.Transition) return TransitionState.Collided;
            if (t.Path.SteppingDown || t.Path.CheckingWalkable || t.Path.Collide) return TransitionState.OK;
            if (t.Object.Has(MoverFlags.Contact)) return t.StepUp(wall.Normal) ? TransitionState.OK : t.StepUpSlide();
            t.Path.SetCollide(wall.Normal);
            t.Path.WalkableAllowance = RetailMath.LandingZ;
            return TransitionState.Adjusted;
        }
    }
}
