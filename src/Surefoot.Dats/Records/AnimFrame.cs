using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>Where the parts of an object are at one moment, and what happens then (spec 07, 7.6).</summary>
/// <remarks>Retail: AnimFrame::UnPack @0x0051F8E0.</remarks>
/// <param name="Parts">Frame of each part in object coordinates; metres.</param>
/// <param name="Hooks">What happens when an animation passes this frame.</param>
public sealed record AnimFrame(ImmutableArray<DatFrame> Parts, ImmutableArray<AnimationHook> Hooks)
{
    internal const int FrameSize = 28;

    /// <summary>A frame at which nothing happens.</summary>
    public AnimFrame(ImmutableArray<DatFrame> parts)
        : this(parts, [])
    {
    }

    internal static AnimFrame Read(ref DatReader reader, long partCount)
    {
        ImmutableArray<DatFrame> parts = reader.ReadArray(partCount, FrameSize, static (ref r) => r.ReadFrame());
        return new(parts, reader.ReadList(AnimationHook.LeastSize, AnimationHook.Read));
    }

    internal void Write(DatWriter writer, long partCount)
    {
        DatWriter.Require(Parts.Length == partCount, $"An animation frame has {Parts.Length} parts instead of {partCount}.");
        writer.WriteArray(Parts, static (w, frame) => w.WriteFrame(frame));
        writer.WriteList(Hooks, AnimationHook.Write);
    }
}
