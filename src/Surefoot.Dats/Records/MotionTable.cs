using System.Collections.Immutable;
using System.Numerics;

namespace Surefoot.Dats.Records;

/// <summary>A style and the substate it rests in.</summary>
/// <param name="Style">Full style number, e.g. 0x8000003D.</param>
/// <param name="DefaultSubstate">Full motion number, e.g. 0x41000003.</param>
public readonly record struct MotionStyle(uint Style, uint DefaultSubstate);

/// <summary>A stretch of an animation.</summary>
/// <param name="AnimationId">The animation.</param>
/// <param name="LowFrame">First frame.</param>
/// <param name="HighFrame">Last frame; −1 the animation's last.</param>
/// <param name="FramesPerSecond">Speed; negative plays backward.</param>
public readonly record struct MotionAnimation(uint AnimationId, int LowFrame, int HighFrame, float FramesPerSecond);

/// <summary>Bits of <see cref="MotionData.Flags"/>.</summary>
[Flags]
public enum MotionDataFlags : byte
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>A velocity is stored.</summary>
    HasVelocity = 1,

    /// <summary>An angular velocity is stored.</summary>
    HasOmega = 2,
}

/// <summary>What a motion plays and how it moves the body (spec 07, 7.9).</summary>
/// <remarks>Retail: MotionData::UnPack @0x00526570.</remarks>
public sealed record MotionData
{
    internal const int LeastSize = 4;

    /// <summary>Bit field of the motion (spec 01b).</summary>
    public byte Bitfield { get; init; }

    /// <summary>What is stored.</summary>
    public MotionDataFlags Flags { get; init; }

    /// <summary>Animations, played one after the other.</summary>
    public ImmutableArray<MotionAnimation> Animations { get; init; } = [];

    /// <summary>Velocity in body axes; m/s. Zero when not stored.</summary>
    public Vector3 Velocity { get; init; }

    /// <summary>Angular velocity; rad/s. Zero when not stored.</summary>
    public Vector3 Omega { get; init; }

    internal static MotionData Read(ref DatReader reader)
    {
        byte animations = reader.ReadByte(), bitfield = reader.ReadByte();
        var flags = (MotionDataFlags)reader.ReadByte();
        reader.Align4();
        return new()
        {
            Bitfield = bitfield,
            Flags = flags,
            Animations = reader.ReadArray(
                animations, 16, static (ref r) => new MotionAnimation(r.ReadUInt32(), r.ReadInt32(), r.ReadInt32(), r.ReadSingle())),
            Velocity = flags.HasFlag(MotionDataFlags.HasVelocity) ? reader.ReadVector3() : default,
            Omega = flags.HasFlag(MotionDataFlags.HasOmega) ? reader.ReadVector3() : default,
        };
    }

    internal void Write(DatWriter writer)
    {
        bool velocity = Flags.HasFlag(MotionDataFlags.HasVelocity), omega = Flags.HasFlag(MotionDataFlags.HasOmega);
        DatWriter.Require(velocity || Velocity == default, "A motion has a velocity but not the flag for it.");
        DatWriter.Require(omega || Omega == default, "A motion has an angular velocity but not the flag for it.");
        writer.WriteByte((byte)DatWriter.RequireCount(Animations.Length, byte.MaxValue, "animations of a motion"));
        writer.WriteByte(Bitfield);
        writer.WriteByte((byte)Flags);
        writer.Align4();
        writer.WriteArray(Animations, static (w, animation) =>
        {
            w.WriteUInt32(animation.AnimationId);
            w.WriteInt32(animation.LowFrame);
            w.WriteInt32(animation.HighFrame);
            w.WriteSingle(animation.FramesPerSecond);
        });
        if (velocity)
            writer.WriteVector3(Velocity);
        if (omega)
            writer.WriteVector3(Omega);
    }
}

/// <summary>A motion under its key.</summary>
/// <param name="Key">See <see cref="MotionTable.KeyOf"/>; inside a link the full motion number one goes to.</param>
/// <param name="Data">What it plays.</param>
public sealed record KeyedMotion(uint Key, MotionData Data)
{
    internal const int LeastSize = 8;

    internal static KeyedMotion Read(ref DatReader reader) => new(reader.ReadUInt32(), MotionData.Read(ref reader));

    internal static void Write(DatWriter writer, KeyedMotion motion)
    {
        writer.WriteUInt32(motion.Key);
        motion.Data.Write(writer);
    }
}

/// <summary>The ways out of one substate.</summary>
/// <param name="Key">Key of style and substate one leaves.</param>
/// <param name="Targets">Transition for each full motion number one goes to.</param>
public sealed record MotionLinks(uint Key, ImmutableArray<KeyedMotion> Targets)
{
    internal static MotionLinks Read(ref DatReader reader)
        => new(reader.ReadUInt32(), reader.ReadList(KeyedMotion.LeastSize, KeyedMotion.Read));

    internal static void Write(DatWriter writer, MotionLinks links)
    {
        writer.WriteUInt32(links.Key);
        writer.WriteList(links.Targets, KeyedMotion.Write);
    }
}

/// <summary>0x09: which animations a style and motion play (spec 07, 7.9; spec 01b says how they are used).</summary>
/// <remarks>Retail: CMotionTable::UnPack @0x005238C0.</remarks>
public sealed class MotionTable : DatRecord, IDatRecord<MotionTable>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.MotionTable;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Full number of the style one starts in.</summary>
    public uint DefaultStyle { get; init; }

    /// <summary>The styles and what they rest in.</summary>
    public ImmutableArray<MotionStyle> Styles { get; init; } = [];

    /// <summary>Motions that go on until another comes.</summary>
    public ImmutableArray<KeyedMotion> Cycles { get; init; } = [];

    /// <summary>Motions added to a cycle.</summary>
    public ImmutableArray<KeyedMotion> Modifiers { get; init; } = [];

    /// <summary>Transitions between motions.</summary>
    public ImmutableArray<MotionLinks> Links { get; init; } = [];

    /// <summary>Key of a motion in a style: the low half of the style above the low three bytes of the motion.</summary>
    public static uint KeyOf(uint style, uint motion) => (style << 16) | (motion & 0x00FFFFFF);

    /// <inheritdoc/>
    public static MotionTable Decode(ref DatReader reader) => new()
    {
        Id = reader.ReadId(),
        DefaultStyle = reader.ReadUInt32(),
        Styles = reader.ReadList(8, static (ref r) => new MotionStyle(r.ReadUInt32(), r.ReadUInt32())),
        Cycles = reader.ReadList(KeyedMotion.LeastSize, KeyedMotion.Read),
        Modifiers = reader.ReadList(KeyedMotion.LeastSize, KeyedMotion.Read),
        Links = reader.ReadList(8, MotionLinks.Read),
    };

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteUInt32(DefaultStyle);
        writer.WriteList(Styles, static (w, style) =>
        {
            w.WriteUInt32(style.Style);
            w.WriteUInt32(style.DefaultSubstate);
        });
        writer.WriteList(Cycles, KeyedMotion.Write);
        writer.WriteList(Modifiers, KeyedMotion.Write);
        writer.WriteList(Links, MotionLinks.Write);
    }
}
