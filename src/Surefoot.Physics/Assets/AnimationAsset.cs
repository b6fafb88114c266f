using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;
using Frame = Surefoot.Physics.Geometry.Frame;

namespace Surefoot.Physics.Assets;

/// <summary>
/// What movement needs of an animation: how many frames it has, how the body itself moves in each, where its parts are, and what happens
/// then. Immutable.
/// </summary>
public sealed class AnimationAsset
{
    private readonly Frame[] positionFrames;
    private readonly Frame[] partFrames;
    private readonly int partCount;
    private readonly MotionHook[] hooks = [];

    /// <summary>An animation.</summary>
    /// <param name="id">Animation id.</param>
    /// <param name="frameCount">Number of frames, at least 1.</param>
    /// <param name="positionFrames">Root motion of each frame, or empty.</param>
    /// <param name="partFrames">
    /// All parts of the first frame, then all of the second, and so on; empty where nobody asks where the parts are.
    /// </param>
    /// <exception cref="ArgumentException">
    /// No frames, another number of position frames, or part frames that do not divide by the frames.
    /// </exception>
    internal AnimationAsset(uint id, int frameCount, ReadOnlySpan<Frame> positionFrames = default, ReadOnlySpan<Frame> partFrames = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(frameCount, 1);
        if (positionFrames.Length != 0 && positionFrames.Length != frameCount)
            throw new ArgumentException($"Animation 0x{id:X8} has {frameCount} frames but {positionFrames.Length} position frames.",
                nameof(positionFrames));
        if (partFrames.Length % frameCount != 0)
            throw new ArgumentException(
                $"Animation 0x{id:X8} has {frameCount} frames, which do not share {partFrames.Length} part frames evenly.",
                nameof(partFrames));
        Id = id;
        FrameCount = frameCount;
        this.positionFrames = positionFrames.ToArray();
        this.partFrames = partFrames.ToArray();
        partCount = partFrames.Length / frameCount;
    }

    /// <summary>Animation id.</summary>
    public uint Id { get; }

    /// <summary>Number of frames.</summary>
    public int FrameCount { get; }

    /// <summary>Root motion of each frame (metres, body axes); empty when the body moves by velocity only.</summary>
    public ReadOnlySpan<Frame> PositionFrames => positionFrames;

    /// <summary>Where the parts are in a frame, in the body's frame at scale 1; empty when that was not loaded.</summary>
    /// <param name="frame">0 to <see cref="FrameCount"/> less one.</param>
    public ReadOnlySpan<Frame> PartFrames(int frame) => partFrames.AsSpan(frame * partCount, partCount);

    /// <summary>What happens at the frames, those of one frame in the order of the record.</summary>
    internal ReadOnlySpan<MotionHook> Hooks
    {
        get => hooks;
        init => hooks = value.ToArray();
    }

    /// <summary>Flattens a record; null for an animation without frames, which is as good as none.</summary>
    /// <param name="record">The record.</param>
    /// <param name="withParts">Keep where the parts are as well.</param>
    internal static AnimationAsset? Build(Animation record, bool withParts)
    {
        if (record.Frames.Length == 0) return null;
        Frame[] rootMotion = [.. record.RootMotion.Select(FrameOf)];
        Frame[] parts = withParts ? [.. record.Frames.SelectMany(static frame => frame.Parts).Select(FrameOf)] : [];
        return new AnimationAsset(record.Id, record.Frames.Length, rootMotion, parts) { Hooks = HooksOf(record) };
    }

    private static Frame FrameOf(DatFrame frame) => new(RetailMath.FiniteOrZero(frame.Origin), frame.Rotation);

    /// <summary>All hooks, whatever they do; a scale that is not a positive number does nothing.</summary>
    private static MotionHook[] HooksOf(Animation record)
    {
        List<MotionHook> hooks = [];
        for (int i = 0; i < record.Frames.Length; i++)
        {
            ImmutableArray<AnimationHook> listed = record.Frames[i].Hooks;
            for (int k = 0; k < listed.Length; k++)
            {
                (MotionHookKind kind, Vector3 value) = listed[k] switch
                {
                    EtherealHook hook => (MotionHookKind.Ethereal, new Vector3(hook.Ethereal != 0 ? 1 : 0, 0, 0)),
                    SetOmegaHook hook => (MotionHookKind.Omega, RetailMath.FiniteOrZero(hook.Omega)),
                    ScaleHook { End: > 0 and <= float.MaxValue } hook =>
                        (MotionHookKind.Scale, new Vector3(hook.End, float.IsFinite(hook.Time) ? hook.Time : 0, 0)),
                    _ => (MotionHookKind.Other, Vector3.Zero),
                };
                hooks.Add(new MotionHook(kind, i, listed[k].Direction, value) { AnimationId = record.Id, Index = k });
            }
        }

        return [.. hooks];
    }
}
