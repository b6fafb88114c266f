using System.Numerics;
using Surefoot.Physics.Assets;

namespace Surefoot.Physics.World;

/// <summary>Something that stands in cells and can be run into: a static object, a piece of scenery, or a body.</summary>
/// <remarks>Retail: the part of CPhysicsObj that statics share with bodies.</remarks>
public partial class WorldObject
{
    /// <summary>An object with this id and shape.</summary>
    /// <param name="id">Object id; 0 for scenery and other things without one.</param>
    /// <param name="setup">Its shape; null for an object without parts.</param>
    /// <param name="state">Physics state word; its <see cref="PhysicsState.HasPhysicsBsp"/> is replaced by what the parts have.</param>
    /// <remarks>Retail: CPhysicsObj::CacheHasPhysicsBSP @0x0050F570; specification 02, 2.2.</remarks>
    internal WorldObject(uint id, SetupAsset? setup, PhysicsState state)
    {
        Id = id;
        Setup = setup;
        State = setup is { HasPhysicsBsp: true } ? state | PhysicsState.HasPhysicsBsp : state & ~PhysicsState.HasPhysicsBsp;
    }

    /// <summary>Object id.</summary>
    public uint Id { get; }

    /// <summary>Shape; null for an object without parts.</summary>
    public SetupAsset? Setup { get; }

    /// <summary>Physics state word.</summary>
    public PhysicsState State { get; internal set; }

    /// <summary>What the server says of it.</summary>
    public WeenieTraits Weenie { get; internal set; }

    /// <summary>Where it is.</summary>
    public Position Position => PositionField;

    /// <summary>Uniform scale.</summary>
    public float Scale { get; internal set; } = 1f;

    /// <summary>The cell it is in, or null.</summary>
    public ObjCell? Cell { get; internal set; }

    /// <summary>What it is attached to; attached objects are not collided with.</summary>
    public WorldObject? Parent { get; internal set; }

    /// <summary>When it last moved or became another obstacle, seconds of its world; never for statics.</summary>
    internal double ChangedAt { get; private protected set; } = double.NegativeInfinity;

    /// <summary>
    /// As a mover it passes what has changed since, seconds, and the parts of statics that an animation moves; infinite, as in retail, for
    /// none. For judging a body of whose moment only so much is known.
    /// </summary>
    internal double PassesChangedSince { get; set; } = double.PositiveInfinity;

    /// <summary>As a mover it does not run into this one, for which it stands; null for nobody.</summary>
    internal WorldObject? StandsFor { get; set; }

    /// <summary>Velocity, metres a second, world axes.</summary>
    public virtual Vector3 Velocity => Vector3.Zero;

    /// <summary>It touches a plane.</summary>
    public virtual bool HasContact => false;

    /// <summary>Highest step it climbs, metres; 0 without parts.</summary>
    /// <remarks>Retail: CPhysicsObj::GetStepUpHeight @0x0050EA00.</remarks>
    public float StepUpHeight => Setup is null ? 0f : (float)((double)Setup.StepUpHeight * Scale);

    /// <summary>Deepest step it descends without leaving the ground, metres; 0 without parts.</summary>
    /// <remarks>Retail: CPhysicsObj::GetStepDownHeight @0x0050EA20.</remarks>
    public float StepDownHeight => Setup is null ? 0f : (float)((double)Setup.StepDownHeight * Scale);

    /// <summary>Height, metres; 0 without parts.</summary>
    public float Height => Setup is null ? 0f : (float)((double)Setup.Height * Scale);

    /// <summary>Radius, metres; 0 without parts.</summary>
    public float Radius => Setup is null ? 0f : (float)((double)Setup.Radius * Scale);

    /// <summary>Where it is, for those who move it.</summary>
    private protected Position PositionField = Position.Nowhere;

    /// <summary>Would another object be hit by this one where it stands? Only bodies hit anything.</summary>
    /// <remarks>Retail: CPhysicsObj::check_collision @0x00512ED0.</remarks>
    internal virtual bool Overlaps(WorldObject target) => false;

    /// <summary>Seats the object without any test.</summary>
    internal void SeatAt(in Position position, ObjCell? cell)
    {
        PositionField = position;
        Cell = cell;
    }
}
