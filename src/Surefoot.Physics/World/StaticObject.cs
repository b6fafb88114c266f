using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// Something of the dat files that never moves: an object of a landblock or room, a piece of scenery, a building's shell. Its parts may,
/// when its setup names an animation that they play for ever.
/// </summary>
public sealed class StaticObject : WorldObject
{
    /// <summary>Where the parts of an object that moves them were when it was made; null for the many that do not.</summary>
    private readonly Frame[]? firstParts;

    /// <summary>
    /// An object as retail makes it: its frame is set before its scale, which therefore does not reach the places of its parts.
    /// </summary>
    internal StaticObject(SetupAsset setup, in Position position, ulong order, ObjCell cell, float scale, AnimationAsset? animation = null)
        : base(0, setup,
            PhysicsState.Default | PhysicsState.Static | (setup.DefaultAnimationId != 0 ? PhysicsState.HasDefaultAnim : PhysicsState.None))
    {
        Scale = scale;
        Order = order;
        Animation = animation;
        SeatAt(position, cell);
        if (animation is null) return;
        PlaceParts(animation.PartFrames(0), StillScale);
        firstParts = [.. Enumerable.Range(0, PlacedPartCount).Select(PartFrame)];
    }

    /// <summary>It was strewn by the rules of the terrain, and stands in no record.</summary>
    public bool IsScenery { get; internal init; }

    /// <summary>The animation that moves its parts for ever; null for the many that nothing moves.</summary>
    public AnimationAsset? Animation { get; }

    /// <summary>Its first part is over land that is not loaded; the cells it reaches are known when that is.</summary>
    internal bool LacksGround { get; set; }

    /// <summary>
    /// Place in the order in which statics are tested: land objects and scenery of all landblocks, column by column, then those of rooms.
    /// It does not depend on the order of loading.
    /// </summary>
    internal ulong Order { get; }

    /// <inheritdoc/>
    private protected override float StillScale => 1f;

    /// <summary>Its animation moves a part.</summary>
    internal bool MovesPart(int index)
    {
        if (Animation is null || index >= Animation.PartFrames(0).Length) return false;
        for (int frame = 1; frame < Animation.FrameCount; frame++)
            if (Animation.PartFrames(frame)[index] != Animation.PartFrames(0)[index]) return true;
        return false;
    }

    /// <summary>Where a part was when the object was made, which decides the cells it is listed in.</summary>
    internal Frame FirstPartFrame(int index) => firstParts is null ? PartFrame(index) : firstParts[index];

    /// <summary>Moves the parts to a pose of the animation, by the scale of this moment.</summary>
    internal void Pose(ReadOnlySpan<Frame> pose) => PlaceParts(pose, Scale);

    /// <summary>Turns the object by a rotation vector, radians, world axes; its parts follow with the next pose.</summary>
    internal void Turn(in Vector3 radians) => PositionField.Frame.RotateGlobal(radians);
}
