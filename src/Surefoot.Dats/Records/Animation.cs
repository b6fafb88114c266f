using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>Bits of <see cref="Animation.Flags"/>.</summary>
[Flags]
public enum AnimationFlags : uint
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Root motion follows.</summary>
    HasRootMotion = 1,

    /// <summary>Some frame has hooks; stored, never tested.</summary>
    HasHooks = 2,
}

/// <summary>0x03: frames of the parts over time (spec 07, 7.7).</summary>
/// <remarks>Retail: CAnimation::UnPack @0x0051FB50.</remarks>
public sealed class Animation : DatRecord, IDatRecord<Animation>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Animation;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>What is stored.</summary>
    public AnimationFlags Flags { get; init; }

    /// <summary>Parts of each frame.</summary>
    public uint PartCount { get; init; }

    /// <summary>Motion of the whole body in each frame, in its own axes; metres. Empty without
    /// <see cref="AnimationFlags.HasRootMotion"/>.</summary>
    public ImmutableArray<DatFrame> RootMotion { get; init; } = [];

    /// <summary>The frames.</summary>
    public ImmutableArray<AnimFrame> Frames { get; init; } = [];

    /// <inheritdoc/>
    public static Animation Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        var flags = (AnimationFlags)reader.ReadUInt32();
        uint parts = reader.ReadUInt32();
        int count = reader.ReadCount(4);
        ImmutableArray<DatFrame> rootMotion = reader.ReadArray(
            flags.HasFlag(AnimationFlags.HasRootMotion) ? count : 0, AnimFrame.FrameSize, static (ref r) => r.ReadFrame());
        var frames = ImmutableArray.CreateBuilder<AnimFrame>(reader.CheckCount(count, 4));
        while (frames.Count < count)
            frames.Add(AnimFrame.Read(ref reader, parts));
        return new() { Id = id, Flags = flags, PartCount = parts, RootMotion = rootMotion, Frames = frames.MoveToImmutable() };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        DatWriter.Require(
            RootMotion.Length == (Flags.HasFlag(AnimationFlags.HasRootMotion) ? Frames.Length : 0),
            $"Animation 0x{Id:X8} has {RootMotion.Length} frames of root motion, which fits neither its frames nor its flags.");
        writer.WriteUInt32(Id);
        writer.WriteUInt32((uint)Flags);
        writer.WriteUInt32(PartCount);
        writer.WriteUInt32((uint)Frames.Length);
        writer.WriteArray(RootMotion, static (w, frame) => w.WriteFrame(frame));
        foreach (AnimFrame frame in Frames)
            frame.Write(writer, PartCount);
    }
}
