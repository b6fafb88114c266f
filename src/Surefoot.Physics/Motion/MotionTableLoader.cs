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
    /// <param name="withParts">
    /// Load where the parts are as well: for bodies that stop others by the trees of their parts, such as doors. It takes much memory and nobody else asks for it.
    /// </param>
    /// <exception cref="DatRecordMissingException">There is no such table. A missing animation is left out, as in retail.</exception>
    /// <exception cref="DatFormatException">The bytes of the table or of an animation are wrong.</exception>
    public static MotionTableAsset Load(IDatSource source, uint id, bool withParts = false)
    {
        ArgumentNullException.ThrowIfNull(source);
        return Create(source.Read<MotionTable>(id), animation => source.TryRead(animation, out Animation? record) ? record : null, withParts);
    }

    /// <summary>Flattens a motion table.</summary>
    /// <param name="record">The table.</param>
    /// <param name="findAnimation">Finds an animation by id; null when there is none.</param>
    /// <param name="withParts">Load where the parts are as well.</param>
    public static MotionTableAsset Create(MotionTable record, Func<uint, Animation?> findAnimation, bool withParts = false)
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
            if (!animations.TryGetValue(id, out AnimationAsset? asset)) animations.Add(id, asset = Flatten(findAnimation(id), withParts));
            return asset;
        }
    }

    /// <summary>An animation without frames is as good as none.</summary>
    private static AnimationAsset? Flatten(Animation? record, bool withParts)
    {
        if (record is null || record.Frames.Length == 0) return null;
        Frame[] rootMotion = [.. record.RootMotion.Select(FrameOf)];
        Frame[] parts = withParts ? [.. record.Frames.SelectMany(static frame => frame.Parts).Select(FrameOf)] : [];
        return new AnimationAsset(record.Id, record.Frames.Length, rootMotion, parts) { Hooks = HooksOf(record) };
    }

    private static Frame FrameOf(DatFrame frame) => new(FiniteOrZero(frame.Origin), frame.Rotation);

    /// <summary>The hooks that matter to movement; a scale that is none is left out.</summary>
    private static MotionHook[] HooksOf(Animation record)
    {
        List<MotionHook> hooks = [];
        for (int i = 0; i < record.Frames.Length; i++)
        {
            foreach (AnimationHook hook in record.Frames[i].Hooks)
            {
                if (hook is EtherealHook { Ethereal: int on })
                    hooks.Add(new MotionHook(MotionHookKind.Ethereal, i, hook.Direction, new Vector3(on != 0 ? 1 : 0, 0, 0)));
                else if (hook is SetOmegaHook spin)
                    hooks.Add(new MotionHook(MotionHookKind.Omega, i, hook.Direction, FiniteOrZero(spin.Omega)));
                else if (hook is ScaleHook { End: > 0 and <= float.MaxValue } scale)
                    hooks.Add(new MotionHook(MotionHookKind.Scale, i, hook.Direction, new Vector3(scale.End, float.IsFinite(scale.Time) ? scale.Time : 0, 0)));
            }
        }

        return [.. hooks];
    }

    /// <summary>A number that is none would poison every position from then on.</summary>
    private static Vector3 FiniteOrZero(Vector3 v) => RetailMath.IsFinite(v) ? v : Vector3.Zero;
}
