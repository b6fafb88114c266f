using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>What movement needs of an animation: how many frames it has and how the body itself moves in each. Immutable.</summary>
public sealed class AnimationAsset
{
    private readonly Frame[] positionFrames;

    /// <summary>An animation.</summary>
    /// <param name="id">Animation id.</param>
    /// <param name="frameCount">Number of frames, at least 1.</param>
    /// <param name="positionFrames">Root motion of each frame, or empty.</param>
    /// <exception cref="ArgumentException">No frames, or another number of position frames.</exception>
    public AnimationAsset(uint id, int frameCount, ReadOnlySpan<Frame> positionFrames = default)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(frameCount, 1);
        if (positionFrames.Length != 0 && positionFrames.Length != frameCount)
            throw new ArgumentException($"Animation 0x{id:X8} has {frameCount} frames but {positionFrames.Length} position frames.", nameof(positionFrames));
        Id = id;
        FrameCount = frameCount;
        this.positionFrames = positionFrames.ToArray();
    }

    /// <summary>Animation id.</summary>
    public uint Id { get; }

    /// <summary>Number of frames.</summary>
    public int FrameCount { get; }

    /// <summary>Root motion of each frame (metres, body axes); empty when the body moves by velocity only.</summary>
    public ReadOnlySpan<Frame> PositionFrames => positionFrames;
}
