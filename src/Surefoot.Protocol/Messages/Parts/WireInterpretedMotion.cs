namespace Surefoot.Protocol.Messages;

/// <summary>Which values of a <see cref="WireInterpretedMotion"/> are written (specification 08, 6.4).</summary>
[Flags]
internal enum InterpretedMotionFields
{
    None = 0,
    Style = 0x01,
    ForwardCommand = 0x02,
    ForwardSpeed = 0x04,
    SidestepCommand = 0x08,
    SidestepSpeed = 0x10,
    TurnCommand = 0x20,
    TurnSpeed = 0x40,
}

/// <summary>What a body does, as it travels: commands are low words (<see cref="CommandTable"/> has the full ids), and a value may be left
/// out.</summary>
/// <remarks>Retail: InterpretedMotionState::UnPack @0x0051F400.</remarks>
public readonly record struct WireInterpretedMotion
{
    private const ushort NonCombat = 0x003D, Ready = 0x0003;

    /// <summary>The state in which nothing is said: Ready, without a weapon.</summary>
    public WireInterpretedMotion()
        : this(style: null)
    {
    }

    /// <summary>A state; what is null is left out and read as its default.</summary>
    /// <param name="style">Stance; 0x3D, non-combat, when left out.</param>
    /// <param name="forwardCommand">What the body does; 0x03, Ready, when left out.</param>
    /// <param name="forwardSpeed">Factor on its speed; 1 when left out.</param>
    /// <param name="sidestepCommand">SideStepRight; 0, none, when left out.</param>
    /// <param name="sidestepSpeed">Factor on its speed, negative to the left; 1 when left out.</param>
    /// <param name="turnCommand">TurnRight; 0, none, when left out.</param>
    /// <param name="turnSpeed">Factor on its speed, negative to the left; 1 when left out.</param>
    /// <param name="actions">One-shot motions.</param>
    public WireInterpretedMotion(
        ushort? style = null,
        ushort? forwardCommand = null,
        float? forwardSpeed = null,
        ushort? sidestepCommand = null,
        float? sidestepSpeed = null,
        ushort? turnCommand = null,
        float? turnSpeed = null,
        MotionActions actions = default)
    {
        Style = style ?? NonCombat;
        ForwardCommand = forwardCommand ?? Ready;
        ForwardSpeed = forwardSpeed ?? 1;
        SidestepCommand = sidestepCommand ?? 0;
        SidestepSpeed = sidestepSpeed ?? 1;
        TurnCommand = turnCommand ?? 0;
        TurnSpeed = turnSpeed ?? 1;
        Actions = actions;
        Fields = (style is null ? 0 : InterpretedMotionFields.Style)
            | (forwardCommand is null ? 0 : InterpretedMotionFields.ForwardCommand)
            | (forwardSpeed is null ? 0 : InterpretedMotionFields.ForwardSpeed)
            | (sidestepCommand is null ? 0 : InterpretedMotionFields.SidestepCommand)
            | (sidestepSpeed is null ? 0 : InterpretedMotionFields.SidestepSpeed)
            | (turnCommand is null ? 0 : InterpretedMotionFields.TurnCommand)
            | (turnSpeed is null ? 0 : InterpretedMotionFields.TurnSpeed);
    }

    /// <summary>Stance.</summary>
    public ushort Style { get; }

    /// <summary>What the body does.</summary>
    public ushort ForwardCommand { get; }

    /// <summary>Factor on the speed of what it does.</summary>
    public float ForwardSpeed { get; }

    /// <summary>SideStepRight; 0 for none.</summary>
    public ushort SidestepCommand { get; }

    /// <summary>Factor on the sidestep's speed, negative to the left.</summary>
    public float SidestepSpeed { get; }

    /// <summary>TurnRight; 0 for none.</summary>
    public ushort TurnCommand { get; }

    /// <summary>Factor on the turning speed, negative to the left.</summary>
    public float TurnSpeed { get; }

    /// <summary>One-shot motions, oldest first.</summary>
    public MotionActions Actions { get; }

    /// <summary>What is written.</summary>
    internal InterpretedMotionFields Fields { get; }

    internal static WireInterpretedMotion Read(ref WireReader reader)
    {
        uint word = reader.ReadUInt32();
        var fields = (InterpretedMotionFields)(word & 0x7F);
        ushort? style = (fields & InterpretedMotionFields.Style) != 0 ? reader.ReadUInt16() : null;
        ushort? forward = (fields & InterpretedMotionFields.ForwardCommand) != 0 ? reader.ReadUInt16() : null;
        ushort? sidestep = (fields & InterpretedMotionFields.SidestepCommand) != 0 ? reader.ReadUInt16() : null;
        ushort? turn = (fields & InterpretedMotionFields.TurnCommand) != 0 ? reader.ReadUInt16() : null;
        float? forwardSpeed = (fields & InterpretedMotionFields.ForwardSpeed) != 0 ? reader.ReadSingle() : null;
        float? sidestepSpeed = (fields & InterpretedMotionFields.SidestepSpeed) != 0 ? reader.ReadSingle() : null;
        float? turnSpeed = (fields & InterpretedMotionFields.TurnSpeed) != 0 ? reader.ReadSingle() : null;
        MotionActions actions = MotionActions.Read(ref reader, (int)(word >> 7) & 0x1F);
        reader.Align4();
        return new WireInterpretedMotion(style, forward, forwardSpeed, sidestep, sidestepSpeed, turn, turnSpeed, actions);
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32((uint)Fields | ((uint)Actions.Count << 7));
        if ((Fields & InterpretedMotionFields.Style) != 0)
            writer.WriteUInt16(Style);
        if ((Fields & InterpretedMotionFields.ForwardCommand) != 0)
            writer.WriteUInt16(ForwardCommand);
        if ((Fields & InterpretedMotionFields.SidestepCommand) != 0)
            writer.WriteUInt16(SidestepCommand);
        if ((Fields & InterpretedMotionFields.TurnCommand) != 0)
            writer.WriteUInt16(TurnCommand);
        if ((Fields & InterpretedMotionFields.ForwardSpeed) != 0)
            writer.WriteSingle(ForwardSpeed);
        if ((Fields & InterpretedMotionFields.SidestepSpeed) != 0)
            writer.WriteSingle(SidestepSpeed);
        if ((Fields & InterpretedMotionFields.TurnSpeed) != 0)
            writer.WriteSingle(TurnSpeed);
        Actions.Write(ref writer);
        writer.Align4();
    }
}
