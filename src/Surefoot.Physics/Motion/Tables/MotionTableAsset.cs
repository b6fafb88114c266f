using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <summary>A stretch of an animation that belongs to a motion.</summary>
/// <param name="Animation">The animation.</param>
/// <param name="LowFrame">First frame.</param>
/// <param name="HighFrame">Last frame; negative is the animation's last.</param>
/// <param name="Framerate">Frames a second.</param>
internal readonly record struct AnimationSpan(AnimationAsset Animation, int LowFrame, int HighFrame, float Framerate);

/// <summary>Animations and velocity of a motion. Immutable.</summary>
/// <remarks>Retail: MotionData.</remarks>
internal sealed class MotionAsset
{
    private readonly AnimationSpan[] animations;

    /// <summary>A motion.</summary>
    /// <param name="animations">What is played, in order; only the last of a cycle repeats.</param>
    /// <param name="velocity">m/s, body axes.</param>
    /// <param name="omega">rad/s, body axes.</param>
    /// <param name="bitfield">1: ends modifiers; 2: only from the default substate.</param>
    /// <exception cref="ArgumentException">A number is NaN or infinite.</exception>
    public MotionAsset(ReadOnlySpan<AnimationSpan> animations, Vector3 velocity = default, Vector3 omega = default, byte bitfield = 0)
    {
        if (!RetailMath.IsFinite(velocity) || !RetailMath.IsFinite(omega))
            throw new ArgumentException("A velocity of a motion is not finite.");
        foreach (AnimationSpan animation in animations)
        {
            ArgumentNullException.ThrowIfNull(animation.Animation, nameof(animations));
            if (!float.IsFinite(animation.Framerate))
                throw new ArgumentException("A framerate of a motion is not finite.", nameof(animations));
        }

        this.animations = animations.ToArray();
        Velocity = velocity;
        Omega = omega;
        Bitfield = bitfield;
    }

    /// <summary>What is played, in order.</summary>
    public ReadOnlySpan<AnimationSpan> Animations => animations;

    /// <summary>m/s, body axes.</summary>
    public Vector3 Velocity { get; }

    /// <summary>rad/s, body axes.</summary>
    public Vector3 Omega { get; }

    /// <summary>1: ends modifiers; 2: only from the default substate.</summary>
    public byte Bitfield { get; }

    internal bool ClearsModifiers => (Bitfield & 1) != 0;

    internal bool OnlyFromDefault => (Bitfield & 2) != 0;
}

/// <summary>The motions of a kind of body, looked up by key. Immutable, shared by any number of bodies and threads.</summary>
/// <remarks>Retail: CMotionTable; keys as in specification 07, 7.9.</remarks>
public sealed class MotionTableAsset
{
    private readonly Dictionary<MotionCommand, MotionCommand> styleDefaults;
    private readonly Dictionary<uint, MotionAsset> cycles;
    private readonly Dictionary<uint, MotionAsset> modifiers;
    private readonly Dictionary<(uint From, MotionCommand To), MotionAsset> links;

    internal MotionTableAsset(
        uint id,
        MotionCommand defaultStyle,
        Dictionary<MotionCommand, MotionCommand> styleDefaults,
        Dictionary<uint, MotionAsset> cycles,
        Dictionary<uint, MotionAsset> modifiers,
        Dictionary<(uint From, MotionCommand To), MotionAsset> links)
    {
        Id = id;
        DefaultStyle = defaultStyle;
        this.styleDefaults = styleDefaults;
        this.cycles = cycles;
        this.modifiers = modifiers;
        this.links = links;
    }

    /// <summary>Motion table id.</summary>
    public uint Id { get; }

    /// <summary>The style a body begins in.</summary>
    public MotionCommand DefaultStyle { get; }

    /// <summary>The substate a style begins in; <see cref="MotionCommand.None"/> for an unknown style.</summary>
    internal MotionCommand DefaultSubstate(MotionCommand style) => styleDefaults.GetValueOrDefault(style);

    /// <summary>The cycle of a substate in a style, or null.</summary>
    internal MotionAsset? Cycle(MotionCommand style, MotionCommand motion) => cycles.GetValueOrDefault(Key(style, motion));

    /// <summary>A modifier in a style, or for every style, or null.</summary>
    internal MotionAsset? Modifier(MotionCommand style, MotionCommand motion) =>
        modifiers.GetValueOrDefault(Key(style, motion)) ?? modifiers.GetValueOrDefault((uint)motion & MotionCommands.KeyMask);

    /// <summary>What leads from one substate to another motion, or null. Backwards the link of the opposite way is taken.</summary>
    /// <remarks>Retail: CMotionTable::get_link.</remarks>
    internal MotionAsset? Link(MotionCommand style, MotionCommand substate, float substateSpeed, MotionCommand motion, float speed)
    {
        if (substateSpeed >= 0 && speed >= 0)
            return links.GetValueOrDefault((Key(style, substate), motion))
                ?? links.GetValueOrDefault((Key(style, MotionCommand.None), motion));
        return links.GetValueOrDefault((Key(style, motion), substate)) ??
               links.GetValueOrDefault((Key(style, substate), DefaultSubstate(style)));
    }

    /// <summary>Key of a motion in a style: the upper half of the style drops out.</summary>
    internal static uint Key(MotionCommand style, MotionCommand motion) => ((uint)style << 16) | ((uint)motion & MotionCommands.KeyMask);
}

/// <summary>Collects the motions of a <see cref="MotionTableAsset"/>.</summary>
internal sealed class MotionTableBuilder
{
    private readonly Dictionary<MotionCommand, MotionCommand> styleDefaults = [];
    private readonly Dictionary<uint, MotionAsset> cycles = [];
    private readonly Dictionary<uint, MotionAsset> modifiers = [];
    private readonly Dictionary<(uint From, MotionCommand To), MotionAsset> links = [];
    private readonly uint id;
    private readonly MotionCommand defaultStyle;

    /// <summary>An empty table.</summary>
    public MotionTableBuilder(uint id, MotionCommand defaultStyle = MotionCommand.NonCombat)
    {
        this.id = id;
        this.defaultStyle = defaultStyle;
    }

    /// <summary>Says which substate a style begins in.</summary>
    public MotionTableBuilder Style(MotionCommand style, MotionCommand defaultSubstate)
    {
        styleDefaults[style] = defaultSubstate;
        return this;
    }

    /// <summary>Adds a cycle.</summary>
    public MotionTableBuilder Cycle(MotionCommand style, MotionCommand motion, MotionAsset data) =>
        Cycle(MotionTableAsset.Key(style, motion), data);

    /// <summary>Adds a cycle under its key.</summary>
    public MotionTableBuilder Cycle(uint key, MotionAsset data)
    {
        cycles[key] = data;
        return this;
    }

    /// <summary>Adds a modifier of one style.</summary>
    public MotionTableBuilder Modifier(MotionCommand style, MotionCommand motion, MotionAsset data) =>
        Modifier(MotionTableAsset.Key(style, motion), data);

    /// <summary>Adds a modifier under its key; one without a style is for every style.</summary>
    public MotionTableBuilder Modifier(uint key, MotionAsset data)
    {
        modifiers[key] = data;
        return this;
    }

    /// <summary>Adds what leads from a substate to a motion.</summary>
    public MotionTableBuilder Link(MotionCommand style, MotionCommand from, MotionCommand to, MotionAsset data) =>
        Link(MotionTableAsset.Key(style, from), to, data);

    /// <summary>Adds a link under its key.</summary>
    public MotionTableBuilder Link(uint fromKey, MotionCommand to, MotionAsset data)
    {
        links[(fromKey, to)] = data;
        return this;
    }

    /// <summary>The table collected so far.</summary>
    public MotionTableAsset Build() => new(id, defaultStyle, new(styleDefaults), new(cycles), new(modifiers), new(links));
}
