using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>
/// The mover as the transition sees it. What a sweep needs of a body is copied when it begins; the body itself is neither read
/// nor written until the sweep is over.
/// </summary>
/// <remarks>Retail: OBJECTINFO.</remarks>
internal sealed class ObjectInfo
{
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

    /// <summary>The mover passes what has changed since, seconds, and what moves for ever; infinite, as in retail, for none.</summary>
    public double PassesChangedSince { get; private set; } = double.PositiveInfinity;

    /// <summary>The mover keeps to the ground: all but missiles.</summary>
    public bool KeepsToGround { get; private set; }

    internal bool Has(MoverFlags flag) => (Flags & flag) != 0;

    internal void Reset()
    {
        Mover = null;
        State = PhysicsState.None;
        Weenie = WeenieTraits.None;
        Flags = MoverFlags.None;
    }

    /// <remarks>Retail: OBJECTINFO::init @0x0050CF30.</remarks>
    /// <param name="mover">Who moves.</param>
    /// <param name="flags">How it stands.</param>
    /// <param name="identity">Who is not run into, when that is somebody else.</param>
    internal void Init(WorldObject mover, MoverFlags flags, WorldObject? identity = null)
    {
        Mover = identity ?? mover.StandsFor ?? mover;
        State = mover.State;
        Weenie = mover.Weenie;
        StepUpHeight = mover.StepUpHeight;
        StepDownHeight = mover.StepDownHeight;
        Ethereal = State.Has(PhysicsState.Ethereal);
        PassesChangedSince = mover.PassesChangedSince;
        KeepsToGround = !State.Has(PhysicsState.Missile);
        if ((Weenie & WeenieTraits.Impenetrable) != 0) flags |= MoverFlags.IsImpenetrable;
        if ((Weenie & WeenieTraits.Player) != 0) flags |= MoverFlags.IsPlayer;
        if ((Weenie & WeenieTraits.PK) != 0) flags |= MoverFlags.IsPK;
        if ((Weenie & WeenieTraits.PKLite) != 0) flags |= MoverFlags.IsPKLite;
        Flags = flags;
    }

    /// <summary>True when a missile passes <paramref name="other"/>.</summary>
    /// <remarks>
    /// Retail: OBJECTINFO::missile_ignore @0x0050CEB0, without what it does for a missile that is aimed at somebody: nothing in the client
    /// aims.
    /// </remarks>
    internal bool MissileIgnores(WorldObject other)
    {
        if (other.State.Has(PhysicsState.Missile)) return true;
        return State.Has(PhysicsState.Missile) && other.Weenie != WeenieTraits.None && other.State.Has(PhysicsState.Ethereal);
    }

    /// <summary>A plane that can be walked on, by its unit normal.</summary>
    /// <remarks>Retail: OBJECTINFO::is_valid_walkable @0x0050CF10.</remarks>
    public static bool IsValidWalkable(in Vector3 normal) => normal.Z >= RetailMath.FloorZ;
}
