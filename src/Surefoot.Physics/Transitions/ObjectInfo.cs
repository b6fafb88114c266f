using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>
/// The mover as the transition sees it, and its rule for touching terrain. What a sweep needs of a body is copied when it begins; the body itself is neither read
/// nor written until the sweep is over.
/// </summary>
/// <remarks>Retail: OBJECTINFO.</remarks>
public sealed class ObjectInfo
{
    /// <summary>Lowest value of the step-down interpolation that is still footing.</summary>
    private const float InterpFloor = -0.1f;

    /// <summary>Whose sweep it is, so that nobody runs into himself; null before a transition was given one.</summary>
    public WorldObject? Mover { get; private set; }

    /// <summary>The mover's physics state word.</summary>
    public PhysicsState State { get; private set; }

    /// <summary>What the server says of the mover.</summary>
    public WeenieTraits Weenie { get; private set; }

    /// <summary>Who moves and how it stands; contact bits are rewritten after every sub-step.</summary>
    public MoverFlags Flags { get; internal set; }

    /// <summary>Highest step climbed, metres.</summary>
    public float StepUpHeight { get; private set; }

    /// <summary>Deepest step descended without leaving the ground, metres.</summary>
    public float StepDownHeight { get; private set; }

    /// <summary>The mover lets others through.</summary>
    public bool Ethereal { get; private set; }

    /// <summary>The mover keeps to the ground: all but missiles.</summary>
    public bool KeepsToGround { get; private set; }

    /// <summary>Id a missile is aimed at. Nothing in the client sets it.</summary>
    public uint TargetId { get; internal set; }

    internal bool Has(MoverFlags flag) => (Flags & flag) != 0;

    internal void Reset()
    {
        Mover = null;
        State = PhysicsState.None;
        Weenie = WeenieTraits.None;
        Flags = MoverFlags.None;
        TargetId = 0;
    }

    /// <remarks>Retail: OBJECTINFO::init @0x0050CF30.</remarks>
    internal void Init(WorldObject mover, MoverFlags flags)
    {
        Mover = mover;
        State = mover.State;
        Weenie = mover.Weenie;
        StepUpHeight = mover.StepUpHeight;
        StepDownHeight = mover.StepDownHeight;
        Ethereal = State.Has(PhysicsState.Ethereal);
        KeepsToGround = !State.Has(PhysicsState.Missile);
        if ((Weenie & WeenieTraits.Impenetrable) != 0) flags |= MoverFlags.IsImpenetrable;
        if ((Weenie & WeenieTraits.Player) != 0) flags |= MoverFlags.IsPlayer;
        if ((Weenie & WeenieTraits.PK) != 0) flags |= MoverFlags.IsPK;
        if ((Weenie & WeenieTraits.PKLite) != 0) flags |= MoverFlags.IsPKLite;
        Flags = flags;
    }

    /// <summary>True when a missile passes <paramref name="other"/>.</summary>
    /// <remarks>Retail: OBJECTINFO::missile_ignore @0x0050CEB0.</remarks>
    internal bool MissileIgnores(WorldObject other)
    {
        if (other.State.Has(PhysicsState.Missile)) return true;
        if (!State.Has(PhysicsState.Missile)) return false;
        if (other.Id == TargetId || other.Weenie == WeenieTraits.None) return false;
        return other.State.Has(PhysicsState.Ethereal) || (TargetId != 0 && (other.Weenie & WeenieTraits.Creature) != 0);
    }

    /// <summary>A plane that can be walked on, by its unit normal.</summary>
    /// <remarks>Retail: OBJECTINFO::is_valid_walkable @0x0050CF10.</remarks>
    public static bool IsValidWalkable(in Vector3 normal) => normal.Z >= RetailMath.FloorZ;

    /// <summary>
    /// The terrain's answer to sphere 0: the lowest point of the sphere is tested against the plane, both in the block frame of
    /// <paramref name="cellId"/>; the check position is lifted out of the ground directly.
    /// </summary>
    /// <param name="transition">The transition whose check position is tested.</param>
    /// <param name="sphere">Sphere 0 at the check position.</param>
    /// <param name="plane">Plane of the terrain triangle.</param>
    /// <param name="isWater">The cell is water.</param>
    /// <param name="waterDepth">How deep a body sinks in here, metres.</param>
    /// <param name="cellId">Cell whose block frame the sphere and the plane are in.</param>
    /// <remarks>Retail: OBJECTINFO::validate_walkable @0x0050D010.</remarks>
    internal TransitionState ValidateWalkable(
        Transition transition, in Sphere sphere, in Plane plane, bool isWater, float waterDepth, uint cellId)
    {
        SpherePath path = transition.Path;
        CollisionInfo collision = transition.Collision;
        if (Has(MoverFlags.IsViewer)) return ValidateViewer(path, collision, sphere, plane);

        Vector3 low = sphere.Center;
        double distance = ((double)plane.Normal.X * low.X) + ((double)plane.Normal.Y * low.Y) +
                          (plane.Normal.Z * ((double)low.Z - sphere.Radius)) + plane.D + waterDepth;
        if (distance > RetailMath.Epsilon) return TransitionState.OK;

        bool mayStand = path.StepDown || !Has(MoverFlags.OnWalkable) || IsValidWalkable(plane.Normal);
        TransitionState state = TransitionState.OK;
        if (distance >= -RetailMath.Epsilon)
        {
            if (mayStand) collision.SetContactPlane(plane, isWater, cellId);
        }
        else
        {
            if (path.CheckWalkable) return TransitionState.Collided;
            float depth = (float)(distance / plane.Normal.Z);
            if (mayStand)
            {
                collision.SetContactPlane(plane, isWater, cellId);
                if (path.StepDown)
                {
                    double interp = UsedInterp(path.WalkInterp, path.StepDownAmount, depth);
                    if (interp >= path.WalkInterp || interp < InterpFloor) return TransitionState.Collided;
                    path.WalkInterp = (float)interp;
                }

                path.AddOffsetToCheckPos(new Vector3(0, 0, -depth));
                state = TransitionState.Adjusted;
            }
        }

        if (!Has(MoverFlags.Contact) && !path.StepDown)
        {
            collision.SetCollisionNormal(plane.Normal);
            collision.CollidedWithEnvironment = true;
        }

        return state;
    }

    /// <summary>
    /// What is left of a downward probe after it found footing. Retail's formula divides by the present value; at exactly 0,
    /// where that is 0 times infinity, its continuation is used.
    /// </summary>
    private static double UsedInterp(double interp, double amount, double depth) =>
        interp == 0 ? depth / amount : (1.0 - ((-1.0 / (amount * interp)) * depth)) * interp;

    /// <summary>The camera stops where its sphere touches the ground instead of standing on it.</summary>
    private static TransitionState ValidateViewer(SpherePath path, CollisionInfo collision, in Sphere sphere, in Plane plane)
    {
        double distance = RetailMath.Distance(plane, sphere.Center) - sphere.Radius;
        if (distance > -RetailMath.Epsilon) return TransitionState.OK;
        Vector3 movement = sphere.Center - path.GlobalCurrCenters[0];
        double t = (float)distance / RetailMath.Dot(movement, plane.Normal);
        bool beganIndoors = path.HasBegin && !CellIds.IsOutdoor(path.BeginPos.CellId);
        if ((t <= 0 || t > 1) && beganIndoors) return TransitionState.OK;
        path.AddOffsetToCheckPos(RetailMath.Scale(movement, -t));
        collision.SetCollisionNormal(plane.Normal);
        collision.CollidedWithEnvironment = true;
        return TransitionState.Adjusted;
    }
}
