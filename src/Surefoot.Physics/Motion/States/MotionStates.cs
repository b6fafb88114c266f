namespace Surefoot.Physics.Motion;

/// <summary>An action waiting to be done, or done once.</summary>
/// <param name="Command">The action.</param>
/// <param name="Speed">Speed factor.</param>
/// <param name="Stamp">15-bit stamp.</param>
/// <param name="Autonomous">The player asked for it.</param>
public readonly record struct MotionAction(MotionCommand Command, float Speed, uint Stamp, bool Autonomous);

/// <summary>What the player asks for: commands as the keys name them, each with the hold key it was pressed with.</summary>
/// <remarks>Retail: RawMotionState; specification 01, 2.2.</remarks>
internal sealed class RawMotionState
{
    private readonly RingQueue<MotionAction> actions = new();

    /// <summary>The key held now.</summary>
    public HoldKey CurrentHoldKey { get; set; } = HoldKey.None;

    /// <summary>Style.</summary>
    public MotionCommand CurrentStyle { get; set; } = MotionCommand.NonCombat;

    /// <summary>Forward command or another substate.</summary>
    public MotionCommand ForwardCommand { get; set; } = MotionCommand.Ready;

    /// <summary>Hold key of the forward command; <see cref="HoldKey.Invalid"/> follows <see cref="CurrentHoldKey"/>.</summary>
    public HoldKey ForwardHoldKey { get; set; }

    /// <summary>Speed factor of the forward command, before walk, run or backward factors.</summary>
    public float ForwardSpeed { get; set; } = 1f;

    /// <summary>Sidestep command or none.</summary>
    public MotionCommand SidestepCommand { get; set; }

    /// <summary>Hold key of the sidestep.</summary>
    public HoldKey SidestepHoldKey { get; set; }

    /// <summary>Speed factor of the sidestep.</summary>
    public float SidestepSpeed { get; set; } = 1f;

    /// <summary>Turn command or none.</summary>
    public MotionCommand TurnCommand { get; set; }

    /// <summary>Hold key of the turn.</summary>
    public HoldKey TurnHoldKey { get; set; }

    /// <summary>Speed factor of the turn.</summary>
    public float TurnSpeed { get; set; } = 1f;

    /// <summary>Number of actions that wait.</summary>
    public int ActionCount => actions.Count;

    /// <summary>An action, the oldest at 0.</summary>
    public MotionAction GetAction(int index) => actions[index];

    /// <summary>Enters a motion into the state. <see cref="MotionCommand.RunForward"/> is ignored: running is a hold key here.</summary>
    /// <remarks>Retail: RawMotionState::ApplyMotion @0x0051EB60.</remarks>
    public void ApplyMotion(MotionCommand motion, in MovementParameters parameters)
    {
        HoldKey key = parameters.Has(MovementFlags.SetHoldKey) ? HoldKey.Invalid : parameters.HoldKey;
        switch (motion)
        {
            case MotionCommand.SideStepRight or MotionCommand.SideStepLeft:
                (SidestepCommand, SidestepHoldKey, SidestepSpeed) = (motion, key, parameters.Speed);
                break;
            case MotionCommand.TurnRight or MotionCommand.TurnLeft:
                (TurnCommand, TurnHoldKey, TurnSpeed) = (motion, key, parameters.Speed);
                break;
            case MotionCommand.RunForward:
                break;
            case var _ when motion.IsSubstate():
                (ForwardCommand, ForwardHoldKey, ForwardSpeed) = (motion, key, parameters.Speed);
                break;
            case var _ when motion.IsStyle():
                if (motion != CurrentStyle) (ForwardCommand, CurrentStyle) = (MotionCommand.Ready, motion);
                break;
            case var _ when motion.IsAction():
                AddAction(new MotionAction(motion, parameters.Speed, parameters.ActionStamp, parameters.Has(MovementFlags.Autonomous)));
                break;
        }
    }

    /// <summary>Takes a motion out of the state.</summary>
    /// <remarks>Retail: RawMotionState::RemoveMotion @0x0051E6E0.</remarks>
    public void RemoveMotion(MotionCommand motion)
    {
        if (motion is MotionCommand.SideStepRight or MotionCommand.SideStepLeft) SidestepCommand = MotionCommand.None;
        else if (motion is MotionCommand.TurnRight or MotionCommand.TurnLeft) TurnCommand = MotionCommand.None;
        else if (motion.IsSubstate())
        {
            if (motion == ForwardCommand) (ForwardCommand, ForwardSpeed) = (MotionCommand.Ready, 1f);
        }
        else if (motion.IsStyle() && motion == CurrentStyle)
        {
            CurrentStyle = MotionCommand.NonCombat;
        }
    }

    /// <summary>Appends an action.</summary>
    public void AddAction(in MotionAction action) => actions.Enqueue(action);

    /// <summary>Takes the oldest action off; nothing when there is none.</summary>
    public void RemoveAction()
    {
        if (actions.Count > 0) actions.Dequeue();
    }

    /// <summary>Takes over every field and action of another state.</summary>
    public void CopyFrom(RawMotionState other)
    {
        ArgumentNullException.ThrowIfNull(other);
        if (ReferenceEquals(this, other)) return;
        CurrentHoldKey = other.CurrentHoldKey;
        CurrentStyle = other.CurrentStyle;
        (ForwardCommand, ForwardHoldKey, ForwardSpeed) = (other.ForwardCommand, other.ForwardHoldKey, other.ForwardSpeed);
        (SidestepCommand, SidestepHoldKey, SidestepSpeed) = (other.SidestepCommand, other.SidestepHoldKey, other.SidestepSpeed);
        (TurnCommand, TurnHoldKey, TurnSpeed) = (other.TurnCommand, other.TurnHoldKey, other.TurnSpeed);
        actions.Clear();
        for (int i = 0; i < other.actions.Count; i++) actions.Enqueue(other.actions[i]);
    }
}

/// <summary>What the body does: normalised commands (right and forward only) with signed speeds.</summary>
/// <remarks>Retail: InterpretedMotionState; specification 01, 2.3.</remarks>
public sealed class InterpretedMotionState
{
    private readonly RingQueue<MotionAction> actions = new();

    /// <summary>Style.</summary>
    public MotionCommand CurrentStyle { get; set; } = MotionCommand.NonCombat;

    /// <summary>Forward command or another substate.</summary>
    public MotionCommand ForwardCommand { get; set; } = MotionCommand.Ready;

    /// <summary>Speed factor of the forward command; the run rate when running, negative backwards.</summary>
    public float ForwardSpeed { get; set; } = 1f;

    /// <summary><see cref="MotionCommand.SideStepRight"/> or none.</summary>
    public MotionCommand SidestepCommand { get; set; }

    /// <summary>Speed factor of the sidestep, negative to the left.</summary>
    public float SidestepSpeed { get; set; } = 1f;

    /// <summary><see cref="MotionCommand.TurnRight"/> or none.</summary>
    public MotionCommand TurnCommand { get; set; }

    /// <summary>Speed factor of the turn, negative to the left.</summary>
    public float TurnSpeed { get; set; } = 1f;

    /// <summary>Number of actions.</summary>
    /// <remarks>Retail: InterpretedMotionState::GetNumActions @0x0051EB00.</remarks>
    public int ActionCount => actions.Count;

    /// <summary>An action, the oldest at 0.</summary>
    public MotionAction GetAction(int index) => actions[index];

    /// <summary>Enters a motion into the state.</summary>
    /// <remarks>Retail: InterpretedMotionState::ApplyMotion @0x0051EA40.</remarks>
    internal void ApplyMotion(MotionCommand motion, in MovementParameters parameters)
    {
        if (motion == MotionCommand.TurnRight) (TurnCommand, TurnSpeed) = (motion, parameters.Speed);
        else if (motion == MotionCommand.SideStepRight) (SidestepCommand, SidestepSpeed) = (motion, parameters.Speed);
        else if (motion.IsSubstate()) (ForwardCommand, ForwardSpeed) = (motion, parameters.Speed);
        else if (motion.IsStyle()) (ForwardCommand, CurrentStyle) = (MotionCommand.Ready, motion);
        else if (motion.IsAction())
        {
            AddAction(new MotionAction(motion, parameters.Speed, parameters.ActionStamp, parameters.Has(MovementFlags.Autonomous)));
        }
    }

    /// <summary>Takes a motion out of the state.</summary>
    /// <remarks>Retail: InterpretedMotionState::RemoveMotion @0x0051E790.</remarks>
    internal void RemoveMotion(MotionCommand motion)
    {
        if (motion == MotionCommand.TurnRight) TurnCommand = MotionCommand.None;
        else if (motion == MotionCommand.SideStepRight) SidestepCommand = MotionCommand.None;
        else if (motion.IsSubstate())
        {
            if (motion == ForwardCommand) (ForwardCommand, ForwardSpeed) = (MotionCommand.Ready, 1f);
        }
        else if (motion.IsStyle() && motion == CurrentStyle)
        {
            CurrentStyle = MotionCommand.NonCombat;
        }
    }

    /// <summary>Appends an action.</summary>
    public void AddAction(in MotionAction action) => actions.Enqueue(action);

    /// <summary>Takes the oldest action off; nothing when there is none.</summary>
    internal void RemoveAction()
    {
        if (actions.Count > 0) actions.Dequeue();
    }

    /// <summary>Takes over style, commands and speeds of another state; the actions stay.</summary>
    /// <remarks>Retail: InterpretedMotionState::copy_movement_from @0x0051E750.</remarks>
    internal void CopyMovementFrom(InterpretedMotionState other)
    {
        ArgumentNullException.ThrowIfNull(other);
        CurrentStyle = other.CurrentStyle;
        (ForwardCommand, ForwardSpeed) = (other.ForwardCommand, other.ForwardSpeed);
        (SidestepCommand, SidestepSpeed) = (other.SidestepCommand, other.SidestepSpeed);
        (TurnCommand, TurnSpeed) = (other.TurnCommand, other.TurnSpeed);
    }

    /// <summary>Becomes the same as another one, its actions included.</summary>
    internal void CopyFrom(InterpretedMotionState other)
    {
        CopyMovementFrom(other);
        actions.CopyFrom(other.actions);
    }

    /// <summary>Back to standing in the peaceful style, without actions.</summary>
    internal void Reset()
    {
        (CurrentStyle, ForwardCommand, ForwardSpeed) = (MotionCommand.NonCombat, MotionCommand.Ready, 1f);
        (SidestepCommand, SidestepSpeed, TurnCommand, TurnSpeed) = (MotionCommand.None, 1f, MotionCommand.None, 1f);
        actions.Clear();
    }
}
