using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Motions;

/// <summary>How a cycle of a motion table treats modifiers and from where it may begin.</summary>
[Flags]
internal enum CycleRule : byte
{
    /// <summary>It carries turns and sidesteps on.</summary>
    None = 0,

    /// <summary>It takes running modifiers off when it starts, and none is taken up during it.</summary>
    ClearsModifiers = 1,

    /// <summary>It begins from the default substate only.</summary>
    OnlyFromDefault = 2,
}

/// <summary>Collects the entries of a motion table; all animations play 30 frames a second.</summary>
/// <remarks>
/// Velocities stand in the table, not in the animations, so each animation frame passed hands out velocity / 30 (specification 01b, 4).
/// Turning and sidestepping have a cycle of their own, allowed from the default substate only, and act as modifiers while walking, running
/// or falling (01b, 2). There is nothing for left and backward: they reach a table as the right and forward motions with negative speed.
/// </remarks>
/// <param name="id">Id of the table.</param>
/// <param name="defaultStyle">The style that bodies begin in.</param>
internal sealed class MotionSheet(uint id, uint defaultStyle)
{
    private const float FramesPerSecond = 30f;

    private readonly ImmutableArray<MotionStyle>.Builder styles = ImmutableArray.CreateBuilder<MotionStyle>();
    private readonly ImmutableArray<KeyedMotion>.Builder cycles = ImmutableArray.CreateBuilder<KeyedMotion>();
    private readonly ImmutableArray<KeyedMotion>.Builder modifiers = ImmutableArray.CreateBuilder<KeyedMotion>();
    private readonly Dictionary<uint, ImmutableArray<KeyedMotion>> links = [];
    private readonly List<uint> linkOrder = [];

    /// <summary>The style that the next entries are of; it rests in Ready.</summary>
    public uint Style
    {
        get;
        set
        {
            field = value;
            styles.Add(new(value, MotionIds.Ready));
        }
    }

    /// <summary>Adds a cycle to the style.</summary>
    public void Cycle(uint motion, CycleRule rule, uint animation, Vector3 velocity = default, Vector3 omega = default)
        => cycles.Add(new(MotionTable.KeyOf(Style, motion), Data(rule, animation, velocity, omega)));

    /// <summary>Adds what a turn or sidestep adds to another cycle of the style.</summary>
    public void Modifier(uint motion, Vector3 velocity = default, Vector3 omega = default)
        => modifiers.Add(new(MotionTable.KeyOf(Style, motion), Data(CycleRule.None, null, velocity, omega)));

    /// <summary>Adds what is played between a substate of the style and another motion or style.</summary>
    public void Link(uint from, uint to, uint animation)
    {
        uint key = MotionTable.KeyOf(Style, from);
        if (!links.ContainsKey(key)) linkOrder.Add(key);
        links[key] = (links.TryGetValue(key, out var known) ? known : []).Add(new(to, Data(CycleRule.None, animation)));
    }

    /// <summary>The table.</summary>
    public MotionTable ToRecord() => new()
    {
        Id = id,
        DefaultStyle = defaultStyle,
        Styles = styles.ToImmutable(),
        Cycles = cycles.ToImmutable(),
        Modifiers = modifiers.ToImmutable(),
        Links = [.. linkOrder.Select(key => new MotionLinks(key, links[key]))],
    };

    private static MotionData Data(CycleRule rule, uint? animation, Vector3 velocity = default, Vector3 omega = default) => new()
    {
        Bitfield = (byte)rule,
        Flags = (velocity != default ? MotionDataFlags.HasVelocity : 0) | (omega != default ? MotionDataFlags.HasOmega : 0),
        Animations = animation is { } played ? [new(played, 0, -1, FramesPerSecond)] : [],
        Velocity = velocity,
        Omega = omega,
    };
}
