namespace Surefoot.Protocol.Messages;

/// <summary>Which values of a <see cref="WireRawMotion"/> are written (specification 08, 5.3).</summary>
[Flags]
internal enum RawMotionFields
{
    None = 0,
    CurrentHoldKey = 0x001,
    CurrentStyle = 0x002,
    ForwardCommand = 0x004,
    ForwardHoldKey = 0x008,
    ForwardSpeed = 0x010,
    SidestepCommand = 0x020,
    SidestepHoldKey = 0x040,
    SidestepSpeed = 0x080,
    TurnCommand = 0x100,
    TurnHoldKey = 0x200,
    TurnSpeed = 0x400,
}

/// <summary>What a player's keys ask of the body, as it travels: commands are full ids, and a value that is the default is left out.
/// Hold keys: 0 invalid, 1 none, 2 run.</summary>
/// <remarks>Retail: RawMotionState::Pack @0x0051ED10.</remarks>
public readonly record struct WireRawMotion
{
    private const uint NoHoldKey = 1, NonCombat = 0x8000003D, Ready = 0x41000003;

    /// <summary>The state in which nothing is asked.</summary>
    public WireRawMotion()
        : this(NoHoldKey)
    {
    }

    /// <summary>A state; what is not named is the default.</summary>
    /// <param name="currentHoldKey">The hold key of the whole state.</param>
    /// <param name="currentStyle">Stance.</param>
    /// <param name="forwardCommand">WalkForward, WalkBackwards, Ready or a substate.</param>
    /// <param name="forwardHoldKey">Hold key of the forward command; 0 when the state's counts.</param>
    /// <param name="forwardSpeed">Factor on the forward speed.</param>
    /// <param name="sidestepCommand">SideStepRight or SideStepLeft; 0 for none.</param>
    /// <param name="sidestepHoldKey">Hold key of the sidestep; 0 when the state's counts.</param>
    /// <param name="sidestepSpeed">Factor on the sidestep's speed.</param>
    /// <param name="turnCommand">TurnRight or TurnLeft; 0 for none.</param>
    /// <param name="turnHoldKey">Hold key of the turn; 0 when the state's counts.</param>
    /// <param name="turnSpeed">Factor on the turning speed.</param>
    /// <param name="actions">One-shot motions.</param>
    public WireRawMotion(
        uint currentHoldKey = NoHoldKey,
        uint currentStyle = NonCombat,
        uint forwardCommand = Ready,
        uint forwardHoldKey = 0,
        float forwardSpeed = 1,
        uint sidestepCommand = 0,
        uint sidestepHoldKey = 0,
        float sidestepSpeed = 1,
        uint turnCommand = 0,
        uint turnHoldKey = 0,
        float turnSpeed = 1,
        MotionActions actions = default)
    {
        CurrentHoldKey = currentHoldKey;
        CurrentStyle = currentStyle;
        ForwardCommand = forwardCommand;
        ForwardHoldKey = forwardHoldKey;
        ForwardSpeed = forwardSpeed;
        SidestepCommand = sidestepCommand;
        SidestepHoldKey = sidestepHoldKey;
        SidestepSpeed = sidestepSpeed;
        TurnCommand = turnCommand;
        TurnHoldKey = turnHoldKey;
        TurnSpeed = turnSpeed;
        Actions = actions;
        Fields = Differing();
    }

    /// <summary>The hold key of the whole state.</summary>
    public uint CurrentHoldKey { get; private init; }

    /// <summary>Stance.</summary>
    public uint CurrentStyle { get; private init; }

    /// <summary>WalkForward, WalkBackwards, Ready or a substate.</summary>
    public uint ForwardCommand { get; private init; }

    /// <summary>Hold key of the forward command; 0 when the state's counts.</summary>
    public uint ForwardHoldKey { get; private init; }

    /// <summary>Factor on the forward speed.</summary>
    public float ForwardSpeed { get; private init; }

    /// <summary>SideStepRight or SideStepLeft; 0 for none.</summary>
    public uint SidestepCommand { get; private init; }

    /// <summary>Hold key of the sidestep; 0 when the state's counts.</summary>
    public uint SidestepHoldKey { get; private init; }

    /// <summary>Factor on the sidestep's speed.</summary>
    public float SidestepSpeed { get; private init; }

    /// <summary>TurnRight or TurnLeft; 0 for none.</summary>
    public uint TurnCommand { get; private init; }

    /// <summary>Hold key of the turn; 0 when the state's counts.</summary>
    public uint TurnHoldKey { get; private init; }

    /// <summary>Factor on the turning speed.</summary>
    public float TurnSpeed { get; private init; }

    /// <summary>One-shot motions, oldest first.</summary>
    public MotionActions Actions { get; private init; }

    /// <summary>What is written: as read, or what differs from the default.</summary>
    internal RawMotionFields Fields { get; private init; }

    internal static WireRawMotion Read(ref WireReader reader)
    {
        uint word = reader.ReadUInt32();
        var fields = (RawMotionFields)(word & 0x7FF);
        return new WireRawMotion
        {
            Fields = fields,
            CurrentHoldKey = (fields & RawMotionFields.CurrentHoldKey) != 0 ? reader.ReadUInt32() : NoHoldKey,
            CurrentStyle = (fields & RawMotionFields.CurrentStyle) != 0 ? reader.ReadUInt32() : NonCombat,
            ForwardCommand = (fields & RawMotionFields.ForwardCommand) != 0 ? reader.ReadUInt32() : Ready,
            ForwardHoldKey = (fields & RawMotionFields.ForwardHoldKey) != 0 ? reader.ReadUInt32() : 0,
            ForwardSpeed = (fields & RawMotionFields.ForwardSpeed) != 0 ? reader.ReadSingle() : 1,
            SidestepCommand = (fields & RawMotionFields.SidestepCommand) != 0 ? reader.ReadUInt32() : 0,
            SidestepHoldKey = (fields & RawMotionFields.SidestepHoldKey) != 0 ? reader.ReadUInt32() : 0,
            SidestepSpeed = (fields & RawMotionFields.SidestepSpeed) != 0 ? reader.ReadSingle() : 1,
            TurnCommand = (fields & RawMotionFields.TurnCommand) != 0 ? reader.ReadUInt32() : 0,
            TurnHoldKey = (fields & RawMotionFields.TurnHoldKey) != 0 ? reader.ReadUInt32() : 0,
            TurnSpeed = (fields & RawMotionFields.TurnSpeed) != 0 ? reader.ReadSingle() : 1,
            Actions = MotionActions.Read(ref reader, (int)(word >> 11) & 0x1F),
        };
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32((uint)Fields | ((uint)Actions.Count << 11));
        if ((Fields & RawMotionFields.CurrentHoldKey) != 0)
            writer.WriteUInt32(CurrentHoldKey);
        if ((Fields & RawMotionFields.CurrentStyle) != 0)
            writer.WriteUInt32(CurrentStyle);
        if ((Fields & RawMotionFields.ForwardCommand) != 0)
            writer.WriteUInt32(ForwardCommand);
        if ((Fields & RawMotionFields.ForwardHoldKey) != 0)
            writer.WriteUInt32(ForwardHoldKey);
        if ((Fields & RawMotionFields.ForwardSpeed) != 0)
            writer.WriteSingle(ForwardSpeed);
        if ((Fields & RawMotionFields.SidestepCommand) != 0)
            writer.WriteUInt32(SidestepCommand);
        if ((Fields & RawMotionFields.SidestepHoldKey) != 0)
            writer.WriteUInt32(SidestepHoldKey);
        if ((Fields & RawMotionFields.SidestepSpeed) != 0)
            writer.WriteSingle(SidestepSpeed);
        if ((Fields & RawMotionFields.TurnCommand) != 0)
            writer.WriteUInt32(TurnCommand);
        if ((Fields & RawMotionFields.TurnHoldKey) != 0)
            writer.WriteUInt32(TurnHoldKey);
        if ((Fields & RawMotionFields.TurnSpeed) != 0)
            writer.WriteSingle(TurnSpeed);
        Actions.Write(ref writer);
    }

    private RawMotionFields Differing()
        => (CurrentHoldKey != NoHoldKey ? RawMotionFields.CurrentHoldKey : 0)
            | (CurrentStyle != NonCombat ? RawMotionFields.CurrentStyle : 0)
            | (ForwardCommand != Ready ? RawMotionFields.ForwardCommand : 0)
            | (ForwardHoldKey != 0 ? RawMotionFields.ForwardHoldKey : 0)
            | (IsOne(ForwardSpeed) ? 0 : RawMotionFields.ForwardSpeed)
            | (SidestepCommand != 0 ? RawMotionFields.SidestepCommand : 0)
            | (SidestepHoldKey != 0 ? RawMotionFields.SidestepHoldKey : 0)
            | (IsOne(SidestepSpeed) ? 0 : RawMotionFields.SidestepSpeed)
            | (TurnCommand != 0 ? RawMotionFields.TurnCommand : 0)
            | (TurnHoldKey != 0 ? RawMotionFields.TurnHoldKey : 0)
            | (IsOne(TurnSpeed) ? 0 : RawMotionFields.TurnSpeed);

    private static bool IsOne(float speed) => BitConverter.SingleToUInt32Bits(speed) == 0x3F800000;
}
