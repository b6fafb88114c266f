namespace Surefoot.Physics.Motion;

/// <summary>
/// What is asked of a body's motion side; the numbers are retail's. <see cref="MotionInterpreter.PerformMovement"/> does the first five.
/// </summary>
internal enum MovementKind
{
    /// <summary>A motion as a key names it.</summary>
    RawCommand = 1,

    /// <summary>A normalised motion.</summary>
    InterpretedCommand = 2,

    /// <summary>The end of a motion as a key names it.</summary>
    StopRawCommand = 3,

    /// <summary>The end of a normalised motion.</summary>
    StopInterpretedCommand = 4,

    /// <summary>The end of everything.</summary>
    StopCompletely = 5,

    /// <summary>A way to an object.</summary>
    MoveToObject = 6,

    /// <summary>A way to a place.</summary>
    MoveToPosition = 7,

    /// <summary>A turn to face an object.</summary>
    TurnToObject = 8,

    /// <summary>A turn to a heading.</summary>
    TurnToHeading = 9,
}

/// <content>Single motions.</content>
internal sealed partial class MotionInterpreter
{
    private const int MaxActions = 6;

    /// <summary>Does one of the five kinds of movement and looks for motions that are done.</summary>
    /// <exception cref="ArgumentException">The speed is NaN or infinite.</exception>
    /// <remarks>Retail: CMotionInterp::PerformMovement @0x00528E80.</remarks>
    public MotionError PerformMovement(MovementKind kind, MotionCommand motion, in MovementParameters p)
    {
        ThrowIfNotFinite(p.Speed, nameof(p));
        MotionError error;
        switch (kind)
        {
            case MovementKind.RawCommand: error = DoMotion(motion, p); break;
            case MovementKind.InterpretedCommand: error = DoInterpretedMotion(motion, p); break;
            case MovementKind.StopRawCommand: error = StopMotion(motion, p); break;
            case MovementKind.StopInterpretedCommand: error = StopInterpretedMotion(motion, p); break;
            case MovementKind.StopCompletely: StopCompletely(); error = MotionError.None; break;
            default: return MotionError.GeneralFailure;
        }

        Animation?.CheckForCompletedMotions();
        return error;
    }

    /// <summary>Does a motion as a key names it.</summary>
    /// <remarks>Retail: CMotionInterp::DoMotion @0x00528D20.</remarks>
    public MotionError DoMotion(MotionCommand motion, in MovementParameters p)
    {
        if (body is null) return MotionError.NoBody;
        ThrowIfNotFinite(p.Speed, nameof(p));
        MovementParameters q = p;
        bool cancel = p.Has(MovementFlags.CancelMoveTo);
        if (cancel) body.CancelMoveTo();
        if (p.Has(MovementFlags.SetHoldKey)) SetHoldKey(p.HoldKey, cancel);
        MotionCommand normalised = motion;
        AdjustMotion(ref normalised, ref q.Speed, p.HoldKey);

        if (Interpreted.CurrentStyle != MotionCommand.NonCombat)
        {
            if (motion == MotionCommand.Crouch) return MotionError.NoCrouchInCombat;
            if (motion == MotionCommand.Sitting) return MotionError.NoSitInCombat;
            if (motion == MotionCommand.Sleeping) return MotionError.NoSleepInCombat;
            if (motion.IsChatEmote()) return MotionError.NoEmoteInCombat;
        }

        if (motion.IsAction() && Interpreted.ActionCount >= MaxActions) return MotionError.TooManyActions;
        MotionError error = DoInterpretedMotion(normalised, q);
        if (error == MotionError.None && p.Has(MovementFlags.ModifyRawState)) Raw.ApplyMotion(motion, p);
        return error;
    }

    /// <summary>Ends a motion as a key names it. No hold key, posture, emote or number of actions stands in its way.</summary>
    /// <remarks>Retail: CMotionInterp::StopMotion @0x00528530.</remarks>
    public MotionError StopMotion(MotionCommand motion, in MovementParameters p)
    {
        if (body is null) return MotionError.NoBody;
        ThrowIfNotFinite(p.Speed, nameof(p));
        MovementParameters q = p;
        if (p.Has(MovementFlags.CancelMoveTo)) body.CancelMoveTo();
        MotionCommand normalised = motion;
        AdjustMotion(ref normalised, ref q.Speed, p.HoldKey);
        MotionError error = StopInterpretedMotion(normalised, q);
        if (error == MotionError.None && p.Has(MovementFlags.ModifyRawState)) Raw.RemoveMotion(motion);
        return error;
    }

    /// <summary>Does a normalised motion. What the ground does not allow is remembered and done when it does.</summary>
    /// <remarks>Retail: CMotionInterp::DoInterpretedMotion @0x00528360.</remarks>
    public MotionError DoInterpretedMotion(MotionCommand motion, in MovementParameters p)
    {
        if (body is null) return MotionError.NoBody;
        MotionError error = MotionError.None;
        bool modifies = p.Has(MovementFlags.ModifyInterpretedState);
        if (!ContactAllowsMove(motion))
        {
            if (motion.IsAction()) error = MotionError.NotOnGround;
            else if (modifies) Interpreted.ApplyMotion(motion, p);
        }
        else if (IsHeldBack(motion))
        {
            if (modifies) Interpreted.ApplyMotion(motion, p);
        }
        else
        {
            if (motion == MotionCommand.Dead) RemoveLinkAnimations();
            error = Animate(motion, stop: false, p.Speed);
            if (error == MotionError.None)
            {
                AddToQueue(p.ContextId, motion, JumpErrorDuring(motion, p));
                if (modifies) Interpreted.ApplyMotion(motion, p);
            }
        }

        if (!body.HasCell) RemoveLinkAnimations();
        return error;
    }

    /// <summary>Ends a normalised motion.</summary>
    /// <remarks>Retail: CMotionInterp::StopInterpretedMotion @0x00528470.</remarks>
    public MotionError StopInterpretedMotion(MotionCommand motion, in MovementParameters p)
    {
        if (body is null) return MotionError.NoBody;
        MotionError error = MotionError.None;
        bool modifies = p.Has(MovementFlags.ModifyInterpretedState);
        if (!ContactAllowsMove(motion) || IsHeldBack(motion))
        {
            if (modifies) Interpreted.RemoveMotion(motion);
        }
        else
        {
            error = Animate(motion, stop: true, p.Speed);
            if (error == MotionError.None)
            {
                AddToQueue(p.ContextId, MotionCommand.Ready, MotionError.None);
                if (modifies) Interpreted.RemoveMotion(motion);
            }
        }

        if (!body.HasCell) RemoveLinkAnimations();
        return error;
    }

    /// <summary>Ends everything: the body stands.</summary>
    /// <remarks>Retail: CMotionInterp::StopCompletely @0x00527E40.</remarks>
    public MotionError StopCompletely()
    {
        if (body is null) return MotionError.NoBody;
        body.CancelMoveTo();
        MotionError jumpError = MotionAllowsJump(Interpreted.ForwardCommand);
        (Raw.ForwardCommand, Raw.ForwardSpeed) = (MotionCommand.Ready, 1f);
        Raw.SidestepCommand = Raw.TurnCommand = MotionCommand.None;
        (Interpreted.ForwardCommand, Interpreted.ForwardSpeed) = (MotionCommand.Ready, 1f);
        Interpreted.SidestepCommand = Interpreted.TurnCommand = MotionCommand.None;
        Animation?.StopCompletely();
        AddToQueue(0, MotionCommand.Ready, jumpError);
        if (!body.HasCell) RemoveLinkAnimations();
        return MotionError.None;
    }

    /// <summary>Falling, dying and turning need no ground; everything else a creature with weight does, needs it.</summary>
    /// <remarks>Retail: CMotionInterp::contact_allows_move @0x00528240.</remarks>
    public bool ContactAllowsMove(MotionCommand motion)
    {
        if (body is null) return false;
        if (motion is MotionCommand.Falling or MotionCommand.Dead or MotionCommand.TurnRight or MotionCommand.TurnLeft) return true;
        if (!IsCreature || !body.HasGravity) return true;
        return Stands(body);
    }

    /// <summary>While a standing long jump is charged the body stays where it is.</summary>
    private bool IsHeldBack(MotionCommand motion) =>
        StandingLongJump && motion is MotionCommand.WalkForward or MotionCommand.RunForward or MotionCommand.SideStepRight;

    private MotionError JumpErrorDuring(MotionCommand motion, in MovementParameters p)
    {
        if (p.Has(MovementFlags.DisableJumpDuringLink)) return MotionError.CannotJumpFromThisPosition;
        MotionError error = MotionAllowsJump(motion);
        return error == MotionError.None && !motion.IsAction() ? MotionAllowsJump(Interpreted.ForwardCommand) : error;
    }

    private MotionError Animate(MotionCommand motion, bool stop, float speed)
    {
        if (Animation is null) return MotionError.NoAnimationTable;
        return stop ? Animation.StopMotion(motion) : Animation.DoMotion(motion, speed);
    }
}
