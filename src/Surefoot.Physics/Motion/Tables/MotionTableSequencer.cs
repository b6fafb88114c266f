namespace Surefoot.Physics.Motion;

/// <summary>Turns a motion into animations: which links to play, which cycle to repeat, at which velocity.</summary>
/// <remarks>Retail: CMotionTable::GetObjectSequence and its helpers; specification 01b, section 2.</remarks>
internal sealed class MotionTableSequencer(MotionTableAsset table, MotionTableState state, MotionSequence sequence)
{
    /// <summary>
    /// Most modifiers re-done for one order. Real tables need a few; a table whose turn and sidestep cycles evict each other would go on
    /// for ever.
    /// </summary>
    private const int MaxRedone = 64;

    private int redone;
    private int depth;

    /// <summary>Puts the body into the default substate of the default style.</summary>
    /// <param name="animations">Animations to wait for.</param>
    /// <returns>False, with nothing changed, when the table has no such cycle.</returns>
    public bool SetDefaultState(out int animations)
    {
        animations = 0;
        MotionCommand style = table.DefaultStyle, substate = table.DefaultSubstate(style);
        if (table.Cycle(style, substate) is not { } cycle) return false;
        (state.Style, state.Substate, state.SubstateSpeed) = (style, substate, 1f);
        state.ClearModifiers();
        state.ClearActions();
        sequence.ClearPhysics();
        sequence.ClearAnimations();
        AddMotion(cycle, 1f);
        animations = CountOf(cycle) - 1;
        return true;
    }

    /// <summary>Does a motion.</summary>
    public bool DoObjectMotion(MotionCommand motion, float speed, out int animations) =>
        GetObjectSequence(motion, speed, stopModifiers: false, out animations);

    /// <summary>Ends a motion: a substate gives way to the default one, a modifier goes.</summary>
    /// <remarks>Retail: CMotionTable::StopSequenceMotion.</remarks>
    public bool StopObjectMotion(MotionCommand motion, out int animations)
    {
        animations = 0;
        if (motion.IsSubstate() && motion == state.Substate)
        {
            GetObjectSequence(table.DefaultSubstate(state.Style), 1f, stopModifiers: true, out animations);
            return true;
        }

        if (!motion.IsModifier() || !state.TryGetModifier(motion, out float speed)) return false;
        if (table.Modifier(state.Style, motion) is not { } data) return false;
        sequence.SubtractPhysics(data, speed);
        state.RemoveModifier(motion);
        return true;
    }

    /// <summary>Ends all modifiers, then the substate.</summary>
    /// <remarks>Retail: CMotionTable::StopObjectCompletely.</remarks>
    public bool StopObjectCompletely(out int animations)
    {
        while (state.ModifierCount > 0)
        {
            MotionCommand modifier = state.GetModifier(0).Motion;
            if (!StopObjectMotion(modifier, out _)) state.RemoveModifier(modifier);
        }

        return StopObjectMotion(state.Substate, out animations);
    }

    private bool GetObjectSequence(MotionCommand motion, float speed, bool stopModifiers, out int animations)
    {
        animations = 0;
        if (state.Style == MotionCommand.None || state.Substate == MotionCommand.None) return false;
        MotionCommand defaultSubstate = table.DefaultSubstate(state.Style);
        if (motion == defaultSubstate && !stopModifiers && state.Substate.IsModifier()) return true;

        // The kinds are tried in this order, and a turn or sidestep is a substate before it is a modifier: load-bearing.
        return (motion.IsStyle() && DoStyle(motion, speed, defaultSubstate, out animations)) ||
               (motion.IsSubstate() && DoSubstate(motion, speed, defaultSubstate, out animations)) ||
               (motion.IsAction() && DoAction(motion, speed, defaultSubstate, out animations)) ||
               (motion.IsModifier() && DoModifier(motion, speed));
    }

    private bool DoStyle(MotionCommand style, float speed, MotionCommand defaultSubstate, out int animations)
    {
        animations = 0;
        if (style == state.Style) return true;
        MotionCommand newDefault = table.DefaultSubstate(style);
        if (newDefault == MotionCommand.None || table.Cycle(style, newDefault) is not { } cycle) return false;

        MotionAsset? toDefault = defaultSubstate == state.Substate
            ? null
            : table.Link(state.Style, state.Substate, state.SubstateSpeed, defaultSubstate, speed);
        if (cycle.ClearsModifiers) state.ClearModifiers();
        MotionAsset? toStyle = table.Link(state.Style, defaultSubstate, state.SubstateSpeed, style, speed), fromDefaultStyle = null;
        if (toStyle is null)
        {
            toStyle = table.Link(state.Style, defaultSubstate, 1f, table.DefaultStyle, 1f);
            fromDefaultStyle = table.Link(table.DefaultStyle, table.DefaultSubstate(table.DefaultStyle), 1f, style, 1f);
        }

        sequence.ClearPhysics();
        sequence.RemoveCyclic();
        AddMotion(toDefault, speed);
        AddMotion(toStyle, speed);
        AddMotion(fromDefaultStyle, speed);
        AddMotion(cycle, speed);
        (state.Substate, state.Style, state.SubstateSpeed) = (newDefault, style, speed);
        ReModify();
        animations = CountOf(toDefault) + CountOf(toStyle) + CountOf(fromDefaultStyle) + CountOf(cycle) - 1;
        return true;
    }

    private bool DoSubstate(MotionCommand motion, float speed, MotionCommand defaultSubstate, out int animations)
    {
        animations = 0;
        MotionAsset? cycle = table.Cycle(state.Style, motion) ?? table.Cycle(table.DefaultStyle, motion);
        if (cycle is null || !IsAllowed(motion, cycle, defaultSubstate)) return false;

        bool sameDirection = SameSign(speed, state.SubstateSpeed);
        if (motion == state.Substate && sequence.HasAnimations && sameDirection)
        {
            ChangeCycleSpeed(state.SubstateSpeed, speed);
            sequence.SubtractPhysics(cycle, state.SubstateSpeed);
            sequence.CombinePhysics(cycle, speed);
            state.SubstateSpeed = speed;
            return true;
        }

        if (cycle.ClearsModifiers) state.ClearModifiers();
        MotionAsset? link = table.Link(state.Style, state.Substate, state.SubstateSpeed, motion, speed), viaDefault = null;
        if (link is null || !sameDirection)
        {
            link = table.Link(state.Style, state.Substate, state.SubstateSpeed, defaultSubstate, 1f);
            viaDefault = table.Link(state.Style, defaultSubstate, 1f, motion, speed);
        }

        sequence.ClearPhysics();
        sequence.RemoveCyclic();
        if (viaDefault is not null)
        {
            AddMotion(link, state.SubstateSpeed);
            AddMotion(viaDefault, speed);
        }
        else
        {
            AddMotion(link, state.SubstateSpeed < 0 && speed > 0 ? -speed : speed);
        }

        AddMotion(cycle, speed);
        if (state.Substate != motion && state.Substate.IsModifier() && defaultSubstate != motion)
            state.AddModifierUnchecked(state.Substate, state.SubstateSpeed);
        (state.Substate, state.SubstateSpeed) = (motion, speed);
        ReModify();
        animations = CountOf(link) + CountOf(viaDefault) + CountOf(cycle) - 1;
        return true;
    }

    private bool DoAction(MotionCommand motion, float speed, MotionCommand defaultSubstate, out int animations)
    {
        animations = 0;
        if (table.Cycle(state.Style, state.Substate) is not { } cycle) return false;
        MotionAsset? toAction = table.Link(state.Style, state.Substate, state.SubstateSpeed, motion, speed);
        if (toAction is not null)
        {
            BeginAction(motion, speed);
            AddMotion(toAction, speed);
            EndAction(cycle);
            animations = CountOf(toAction);
            return true;
        }

        MotionAsset? toDefault = table.Link(state.Style, state.Substate, state.SubstateSpeed, defaultSubstate, 1f);
        if (toDefault is null) return false;
        toAction = table.Link(state.Style, defaultSubstate, 1f, motion, speed);
        if (toAction is null) return false;
        MotionAsset? back = table.Link(state.Style, defaultSubstate, 1f, state.Substate, state.SubstateSpeed);
        BeginAction(motion, speed);
        AddMotion(toDefault, 1f);
        AddMotion(toAction, speed);
        AddMotion(back, 1f);
        EndAction(cycle);
        animations = CountOf(toDefault) + CountOf(toAction) + CountOf(back);
        return true;
    }

    private void BeginAction(MotionCommand motion, float speed)
    {
        state.AddAction(motion, speed);
        sequence.ClearPhysics();
        sequence.RemoveCyclic();
    }

    private void EndAction(MotionAsset cycle)
    {
        AddMotion(cycle, state.SubstateSpeed);
        ReModify();
    }

    private bool DoModifier(MotionCommand motion, float speed)
    {
        if (table.Cycle(state.Style, state.Substate) is not { ClearsModifiers: false }) return false;
        if (table.Modifier(state.Style, motion) is not { } data) return false;
        if (!state.AddModifier(motion, speed))
        {
            StopObjectMotion(motion, out _);
            if (!state.AddModifier(motion, speed)) return false;
        }

        sequence.CombinePhysics(data, speed);
        return true;
    }

    /// <summary>Replaces the velocities and appends the animations of a motion.</summary>
    /// <remarks>Retail: add_motion.</remarks>
    private void AddMotion(MotionAsset? data, float speed)
    {
        if (data is null) return;
        sequence.SetPhysics(data, speed);
        foreach (ref readonly AnimationSpan animation in data.Animations) sequence.Append(animation, speed);
    }

    /// <summary>
    /// As often as there are modifiers, takes the newest off and does it again on the new cycle. One that comes back is the newest again:
    /// of several only that one is re-done, and its velocities count once for each that there was. The others stay listed without acting.
    /// </summary>
    /// <remarks>Retail: CMotionTable::re_modify.</remarks>
    private void ReModify()
    {
        if (depth++ == 0) redone = 0;
        for (int times = state.ModifierCount; times > 0 && state.ModifierCount > 0 && redone < MaxRedone; times--)
        {
            redone++;
            MotionSpeed newest = state.GetModifier(0);
            state.RemoveModifier(newest.Motion);
            GetObjectSequence(newest.Motion, newest.Speed, stopModifiers: false, out _);
        }

        depth--;
    }

    /// <summary>Scales the framerate of the cycle from one speed to another; nothing leads back from speed 0, as in retail.</summary>
    /// <remarks>Retail: change_cycle_speed.</remarks>
    private void ChangeCycleSpeed(float from, float to)
    {
        if (Math.Abs(from) > Geometry.RetailMath.Epsilon) sequence.MultiplyCyclicFramerate((float)((double)to / from));
        else if (Math.Abs(to) < Geometry.RetailMath.Epsilon) sequence.MultiplyCyclicFramerate(0f);
    }

    private bool IsAllowed(MotionCommand motion, MotionAsset data, MotionCommand defaultSubstate) =>
        !data.OnlyFromDefault || motion == state.Substate || defaultSubstate == state.Substate;

    private static bool SameSign(float a, float b) => a >= 0 == b >= 0;

    private static int CountOf(MotionAsset? data) => data?.Animations.Length ?? 0;
}
