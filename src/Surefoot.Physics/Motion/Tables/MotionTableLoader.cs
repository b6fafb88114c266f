using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Motion;

/// <summary>Makes motion tables from records.</summary>
public static class MotionTableLoader
{
    /// <summary>
    /// Reads a motion table and the animations it names. An animation that is missing, as in retail, or cannot be read is left out.
    /// </summary>
    /// <param name="source">Where from.</param>
    /// <param name="id">Motion table id, e.g. 0x09000001.</param>
    /// <param name="withParts">
    /// Load where the parts are as well: for bodies that stop others by the trees of their parts, such as doors. It takes much memory and
    /// nobody else asks for it.
    /// </param>
    /// <param name="leftOut">Where animations that are left out are listed, usually <see cref="PhysicsWorld.LeftOut"/>.</param>
    /// <exception cref="DatRecordMissingException">There is no such table.</exception>
    /// <exception cref="DatFormatException">The bytes of the table are wrong.</exception>
    public static MotionTableAsset Load(IDatSource source, uint id, bool withParts = false, LeftOutList? leftOut = null) =>
        LoadNamed(source, id, requestedBy: null, withParts, leftOut);

    /// <summary>Reads the motion table that a setup names, as <see cref="Load"/> does.</summary>
    /// <param name="source">Where from.</param>
    /// <param name="setup">The setup.</param>
    /// <param name="withParts">Load where the parts are as well.</param>
    /// <param name="leftOut">Where animations that are left out are listed.</param>
    /// <exception cref="InvalidDataException">The setup names none. The message is one sentence for people.</exception>
    /// <exception cref="DatRecordMissingException">There is no such table.</exception>
    /// <exception cref="DatFormatException">The bytes of the table are wrong.</exception>
    public static MotionTableAsset LoadFor(IDatSource source, SetupAsset setup, bool withParts = false, LeftOutList? leftOut = null)
    {
        ArgumentNullException.ThrowIfNull(setup);
        if (setup.DefaultMotionTableId == 0)
            throw new InvalidDataException($"Setup 0x{setup.Id:X8} names no motion table, and such a body cannot walk by itself.");
        return LoadNamed(source, setup.DefaultMotionTableId, setup.Id, withParts, leftOut);
    }

    private static MotionTableAsset LoadNamed(IDatSource source, uint id, uint? requestedBy, bool withParts, LeftOutList? leftOut)
    {
        ArgumentNullException.ThrowIfNull(source);
        return Create(source.Read<MotionTable>(id, requestedBy), FindAnimation, withParts);

        Animation? FindAnimation(uint animation)
        {
            if (animation == 0) return null;
            Exception fault;
            try
            {
                if (!source.TryRead(animation, out Animation? record))
                    fault = new DatRecordMissingException(animation, DatRecordType.Animation);
                else if (record.Frames.Length == 0)
                    fault = new DatFormatException(record.File, animation, PhysicsDataCache.AnimationCounts, "it has no frames");
                else
                    return record;
            }
            catch (DatFormatException unreadable)
            {
                fault = unreadable;
            }

            leftOut?.Add(LeftOutItem.Of(LeftOutKind.Animation, animation, id, fault));
            return null;
        }
    }

    /// <summary>Flattens a motion table.</summary>
    /// <param name="record">The table.</param>
    /// <param name="findAnimation">Finds an animation by id; null when there is none.</param>
    /// <param name="withParts">Load where the parts are as well.</param>
    internal static MotionTableAsset Create(MotionTable record, Func<uint, Animation?> findAnimation, bool withParts = false)
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
            return new MotionAsset(spans.ToArray(), RetailMath.FiniteOrZero(data.Velocity), RetailMath.FiniteOrZero(data.Omega),
                data.Bitfield);
        }

        AnimationAsset? Find(uint id)
        {
            if (!animations.TryGetValue(id, out AnimationAsset? asset))
                animations.Add(id, asset = findAnimation(id) is { } record ? AnimationAsset.Build(record, withParts) : null);
            return asset;
        }
    }
}
