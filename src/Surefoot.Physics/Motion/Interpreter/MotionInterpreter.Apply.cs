namespace Surefoot.Physics.Motion;

/// <content>Putting a whole state into effect.</content>
internal sealed partial class MotionInterpreter
{
    private const int StampMask = 0x7FFF;
    private const int HalfStampRange = 0x3FFF;

    /// <summary>The player's own keys count when the last motion came from them; else what a server said.</summary>
    /// <remarks>Retail: CMotionInterp::apply_current_movement @0x00528870.</remarks>
    public void ApplyCurrentMovement(bool cancelMoveTo, bool disallowJump)
    {
        if (body is null || !IsInitialised) return;
        if (IsThePlayer && body.LastMoveWasAutonomous) ApplyRawMovement(cancelMoveTo, disallowJump);
        else ApplyInterpretedMovement(cancelMoveTo, disallowJump);
    }

    /// <summary>Stamina ran out or came back: the same keys, at other speeds.</summary>
    /// <remarks>Retail: CMotionInterp::ReportExhaustion @0x005288D0.</remarks>
    public void ReportExhaustion() => ApplyCurrentMovement(cancelMoveTo: false, disallowJump: false);

    /// <summary>Normalises the keys into the interpreted state and puts it into effect.</summary>
    /// <remarks>Retail: CMotionInterp::apply_raw_movement @0x005287E0.</remarks>
    public void ApplyRawMovement(bool cancelMoveTo, bool disallowJump)
    {
        if (body is null) return;
        Interpreted.CurrentStyle = Raw.CurrentStyle;

        (MotionCommand motion, float speed) = (Raw.ForwardCommand, Raw.ForwardSpeed);
        AdjustMotion(ref motion, ref speed, Raw.ForwardHoldKey);
        (Interpreted.ForwardCommand, Interpreted.ForwardSpeed) = (motion, speed);

        (motion, speed) = (Raw.SidestepCommand, Raw.SidestepSpeed);
        AdjustMotion(ref motion, ref speed, Raw.SidestepHoldKey);
        (Interpreted.SidestepCommand, Interpreted.SidestepSpeed) = (motion, speed);

        (motion, speed) = (Raw.TurnCommand, Raw.TurnSpeed);
        AdjustMotion(ref motion, ref speed, Raw.TurnHoldKey);
        (Interpreted.TurnCommand, Interpreted.TurnSpeed) = (motion, speed);

        ApplyInterpretedMovement(cancelMoveTo, disallowJump);
    }

    /// <summary>Makes the animations do what the interpreted state says.</summary>
    /// <remarks>Retail: CMotionInterp::apply_interpreted_movement @0x00528600.</remarks>
    public void ApplyInterpretedMovement(bool cancelMoveTo, bool disallowJump)
    {
        if (body is null) return;

        // Cleared flags: the calls below put the state into effect and must not rewrite it.
        MovementParameters p = new();
        p.Flags &= ~(MovementFlags.SetHoldKey | MovementFlags.ModifyInterpretedState | MovementFlags.CancelMoveTo |
            MovementFlags.DisableJumpDuringLink);
        if (cancelMoveTo) p.Flags |= MovementFlags.CancelMoveTo;
        if (disallowJump) p.Flags |= MovementFlags.DisableJumpDuringLink;

        if (Interpreted.ForwardCommand == MotionCommand.RunForward) MyRunRate = Interpreted.ForwardSpeed;
        DoInterpretedMotion(Interpreted.CurrentStyle, p);

        if (!ContactAllowsMove(Interpreted.ForwardCommand))
        {
            p.Speed = 1f;
            DoInterpretedMotion(MotionCommand.Falling, p);
        }
        else if (StandingLongJump)
        {
            p.Speed = 1f;
            DoInterpretedMotion(MotionCommand.Ready, p);
            StopInterpretedMotion(MotionCommand.SideStepRight, p);
        }
        else
        {
            p.Speed = Interpreted.ForwardSpeed;
            DoInterpretedMotion(Interpreted.ForwardCommand, p);
            if (Interpreted.SidestepCommand == MotionCommand.None)
            {
                StopInterpretedMotion(MotionCommand.SideStepRight, p);
            }
            else
            {
                p.Speed = Interpreted.SidestepSpeed;
                DoInterpretedMotion(Interpreted.SidestepCommand, p);
            }
        }

        if (Interpreted.TurnCommand != MotionCommand.None)
        {
            p.Speed = Interpreted.TurnSpeed;
            DoInterpretedMotion(Interpreted.TurnCommand, p);
        }
        else if (Animate(MotionCommand.TurnRight, stop: true, p.Speed) == MotionError.None)
        {
            AddToQueue(0, MotionCommand.Ready, MotionError.None);
        }
    }

    /// <summary>Does what a server's UpdateMotion says.</summary>
    /// <param name="state">The state in the message, with its actions.</param>
    /// <exception cref="ArgumentException">A speed is NaN or infinite; nothing has changed.</exception>
    /// <remarks>Retail: CMotionInterp::move_to_interpreted_state @0x005289C0.</remarks>
    public void MoveToInterpretedState(InterpretedMotionState state)
    {
        ArgumentNullException.ThrowIfNull(state);
        ThrowIfNotFinite(state);

        Raw.CurrentStyle = state.CurrentStyle;
        body?.CancelMoveTo();
        bool disallowJump = MotionAllowsJump(Interpreted.ForwardCommand) != MotionError.None;
        Interpreted.CopyMovementFrom(state);
        ApplyCurrentMovement(cancelMoveTo: true, disallowJump);

        for (int i = 0; i < state.ActionCount; i++)
        {
            MotionAction action = state.GetAction(i);
            if (!IsNewerStamp((int)ServerActionStamp & StampMask, (int)action.Stamp & StampMask)) continue;
            if (action.Autonomous && IsThePlayer) continue;
            ServerActionStamp = action.Stamp;
            MovementParameters p = new() { Speed = action.Speed, ActionStamp = action.Stamp };
            if (action.Autonomous) p.Flags |= MovementFlags.Autonomous;
            DoInterpretedMotion(action.Command, p);
        }
    }

    /// <summary>Stamps of 15 bits, which wrap around.</summary>
    internal static bool IsNewerStamp(int own, int other) => Math.Abs(own - other) <= HalfStampRange ? other > own : other < own;

    /// <summary>Switches between walking and running.</summary>
    /// <remarks>Retail: CMotionInterp::set_hold_run @0x00528B70.</remarks>
    public void SetHoldRun(bool run, bool cancelMoveTo)
    {
        if (Raw.CurrentHoldKey == HoldKey.Run == run) return;
        Raw.CurrentHoldKey = run ? HoldKey.Run : HoldKey.None;
        ApplyCurrentMovement(cancelMoveTo, disallowJump: false);
    }

    /// <summary>Takes a hold key: none only when run was held, run only when it was not.</summary>
    /// <remarks>Retail: CMotionInterp::SetHoldKey @0x00528BB0.</remarks>
    public void SetHoldKey(HoldKey key, bool cancelMoveTo)
    {
        if (key == HoldKey.Run) SetHoldRun(run: true, cancelMoveTo);
        else if (key == HoldKey.None) SetHoldRun(run: false, cancelMoveTo);
    }
}
