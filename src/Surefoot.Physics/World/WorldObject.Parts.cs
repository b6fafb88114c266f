using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <content>Where the parts of an object are.</content>
public partial class WorldObject
{
    /// <summary>
    /// Where each part was put when the frame was set last, block coordinates; null as long as they are where <see cref="StillPose"/> has
    /// them.
    /// </summary>
    private Frame[]? parts;
    private int placedParts;

    /// <summary>How many parts, always the first ones, have a place: a part that no frame was ever given for is nowhere.</summary>
    public int PlacedPartCount => parts is not null ? placedParts : Setup is null ? 0 : Math.Min(Setup.Parts.Length, StillPose.Length);

    /// <summary>Where a part is now, in the coordinates of the object's landblock, metres.</summary>
    /// <param name="index">0 to <see cref="PlacedPartCount"/> less one.</param>
    public Frame PartFrame(int index) => parts is not null ? parts[index] : PlacePart(StillPose[index], StillScale);

    /// <summary>Origin of a part's frame, to a rounding or two.</summary>
    internal Vector3 PartOrigin(int index) =>
        parts is not null ? parts[index].Origin : PositionField.Frame.LocalToGlobal(RetailMath.Scale(StillPose[index].Origin, StillScale));

    /// <summary>Frames of the parts in the object's frame as long as nothing moves them.</summary>
    private protected virtual ReadOnlySpan<Frame> StillPose => Setup is null ? default : Setup.RestPose;

    /// <summary>The scale of that pose.</summary>
    private protected virtual float StillScale => Scale;

    /// <summary>
    /// Puts the parts where a pose has them, by the object's frame and scale of this moment; those that it has no frame for stay where they
    /// are.
    /// </summary>
    /// <remarks>Retail: CPartArray::UpdateParts; specification 06, 3.</remarks>
    private protected void PlaceParts(ReadOnlySpan<Frame> pose, float scale)
    {
        parts ??= new Frame[Setup!.Parts.Length];
        int count = Math.Min(pose.Length, parts.Length);
        for (int i = 0; i < count; i++) parts[i] = PlacePart(pose[i], scale);
        placedParts = Math.Max(placedParts, count);
    }

    /// <summary>From now on the parts are where <see cref="StillPose"/> has them.</summary>
    private protected void ForgetParts()
    {
        parts = null;
        placedParts = 0;
    }

    private Frame PlacePart(in Frame pose, float scale) => SetupAsset.PlacePart(PositionField.Frame, pose, scale);
}
