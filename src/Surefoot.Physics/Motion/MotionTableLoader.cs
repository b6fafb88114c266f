using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>Makes motion tables from records.</summary>
public static class MotionTableLoader
{
    /// <summary>Reads a motion table and the animations it names.</summary>
    /// <param name="source">Where from.</param>
    /// <param name="id">Motion table id, e.g. 0x09000001.</param>
    /// <exception cref="DatRecordMissingException">There is no such table. A missing animation is left out, as in retail.</exception>
    /// <exception cref="DatFormatException">The bytes of the table or of an animation are wrong.</exception>
    public static MotionTableAsset Load(IDatSource source, uint id)
    {
        ArgumentNullException.ThrowIfNull(source);
        return Create(source.Read<MotionTable>(id), animation => source.TryRead(animation, out Animation? record) ? record : null);
    }

    /// <summary>Flattens a motion table.</summary>
    /// <param name="record">The table.</param>
    /// <param name="findAnimation">Finds an animation by id; null when there is none.</param>
    public static MotionTableAsset Create(MotionTable record, Func<uint, Animation?> findAnimation)
    {
        ArgumentNullException.ThrowIfNull(record);
        ArgumentNullException.ThrowIfNull(findAnimation);
        Dictionary<uint, AnimationAsset?> animations = [];
        MotionTableBuilder table = new(record.Id, (MotionCommand)record.DefaultStyle);
        foreach (MotionStyle style in record.Styles) table.Style((MotionCommand)style.Style, (MotionCommand)style.DefaultSubstate);
        foreach (KeyedMotion cycle in record.Cycles) table.Cycle(cycle.Key, Motion(cycle.Data));
        foreach (KeyedMotion modifier in record.Modifiers) table.Modifier(modifier.Key, Motion(modifier.Data));
        foreach (MotionLinks links in record.Links)
            foreach (KeyedMotion target in links.Targets)
                table.Link(links.Key, (MotionCommand)target.Key, Motion(target.Data));
        return table.Build();

        MotionAsset Motion(MotionData data)
        {
            List<AnimationSpan> spans = [];
            foreach (MotionAnimation span in data.Animations)
                if (Find(span.AnimationId) is { } animation && float.IsFinite(span.FramesPerSecond))
                    spans.Add(new AnimationSpan(animation, span.LowFrame, span.HighFrame, span.FramesPerSecond));
            return new MotionAsset(spans.ToArray(), FiniteOrZero(data.Velocity), FiniteOrZero(data.Omega), data.Bitfield);
        }

        AnimationAsset? Find(uint id)
        {
            if (!animations.TryGetValue(id, out AnimationAsset? asset)) animations.Add(id, asset = Flatten(findAnimation(id)));
            return asset;
        }
    }

    /// <summary>An animation without frames is as good as none.</summary>
    private static AnimationAsset? Flatten(Animation? record)
    {
        if (record is null || record.Frames.Length == 0) return null;
        Frame[] frames = new Frame[record.RootMotion.Length];
        for (int i = 0; i < frames.Length; i++) frames[i] = new Frame(FiniteOrZero(record.RootMotion[i].Origin), record.RootMotion[i].Rotation);
        return new AnimationAsset(record.Id, record.Frames.Length, frames);
    }

    /// <summary>A number that is none would poison every position from then on.</summary>
    private static Vector3 FiniteOrZero(Vector3 v) => RetailMath.IsFinite(v) ? v : Vector3.Zero;
}
