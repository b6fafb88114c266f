using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;

namespace Surefoot.Physics.Motion;

/// <summary>The animation side of a body: plays motions and says when they are done.</summary>
/// <remarks>Retail: MotionTableManager; specification 01b, section 3.</remarks>
public sealed class MotionTableManager
{
    private readonly RingQueue<Pending> pending = new();
    private readonly MotionTableState state = new();
    private readonly MotionTableSequencer sequencer;
    private int animationCounter;

    /// <summary>The animation side of a body with this motion table.</summary>
    internal MotionTableManager(MotionTableAsset table)
    {
        ArgumentNullException.ThrowIfNull(table);
        Table = table;
        sequencer = new MotionTableSequencer(table, state, Sequence);
    }

    /// <summary>The motion table.</summary>
    internal MotionTableAsset Table { get; }

    /// <summary>Style of the motion table.</summary>
    public MotionCommand Style => state.Style;

    /// <summary>Substate of the motion table: what the body is seen to do.</summary>
    public MotionCommand Substate => state.Substate;

    /// <summary>Speed of the substate.</summary>
    public float SubstateSpeed => state.SubstateSpeed;

    /// <summary>The animation playing, or null.</summary>
    public AnimationAsset? CurrentAnimation => Sequence.CurrentAnimation;

    /// <summary>Place in it, in frames.</summary>
    public double CurrentFrame => Sequence.FrameNumber;

    /// <summary>Motions that are not done.</summary>
    internal int PendingCount => pending.Count;

    internal MotionSequence Sequence { get; } = new();

    internal MotionTableState State => state;

    /// <summary>Is told of each motion that is done: which, and whether it was played to its end.</summary>
    internal Action<MotionCommand, bool>? MotionDone { get; set; }

    /// <summary>Begins in the table's default state.</summary>
    /// <remarks>Retail: MotionTableManager::initialize_state.</remarks>
    internal void InitializeState()
    {
        sequencer.SetDefaultState(out int animations);
        Queue(MotionCommand.Ready, animations);
    }

    /// <summary>Does a motion.</summary>
    internal MotionError DoMotion(MotionCommand motion, float speed)
    {
        if (!sequencer.DoObjectMotion(motion, speed, out int animations)) return MotionError.NoMotionData;
        Queue(motion, animations);
        return MotionError.None;
    }

    /// <summary>Ends a motion.</summary>
    internal MotionError StopMotion(MotionCommand motion)
    {
        if (!sequencer.StopObjectMotion(motion, out int animations)) return MotionError.NoMotionData;
        Queue(MotionCommand.Ready, animations);
        return MotionError.None;
    }

    /// <summary>Ends everything.</summary>
    internal MotionError StopCompletely()
    {
        sequencer.StopObjectCompletely(out int animations);
        Queue(MotionCommand.Ready, animations);
        return MotionError.None;
    }

    /// <summary>Advances the animations and adds the motion of the body in its own axes.</summary>
    internal void Update(float quantum, ref Geometry.Frame offset) => Sequence.Update(quantum, ref offset);

    /// <summary>Does what the animations have passed since the last call; a hook that leads to another one sees it done as well.</summary>
    /// <param name="owner">The body; null when only the ends of animations count.</param>
    /// <remarks>Retail: the second half of CPhysicsObj::process_hooks @0x00511550.</remarks>
    internal void ProcessHooks(IHookTarget? owner)
    {
        while (Sequence.Hooks.Count > 0)
        {
            MotionHook hook = Sequence.Hooks.Dequeue();
            if (hook.Kind == MotionHookKind.AnimationDone) AnimationDone(success: true);
            else if (owner is not null) hook.ActOn(owner);
        }
    }

    /// <summary>An animation ended; every motion whose animations have all ended is done.</summary>
    /// <remarks>Retail: MotionTableManager::AnimationDone.</remarks>
    internal void AnimationDone(bool success)
    {
        animationCounter++;
        CompleteHeads(success);
    }

    /// <summary>Motions that wait for no animation are done at once.</summary>
    /// <remarks>Retail: MotionTableManager::CheckForCompletedMotions.</remarks>
    internal void CheckForCompletedMotions()
    {
        while (pending.Count > 0 && pending[0].Animations == 0) CompleteHead(success: true);
    }

    /// <summary>The body came into the world: links are dropped and what was pending has failed.</summary>
    internal void HandleEnterWorld()
    {
        Sequence.RemoveAllLinks();
        FailPending();
    }

    /// <summary>The body leaves the world: what was pending has failed.</summary>
    internal void HandleExitWorld() => FailPending();

    /// <summary>Becomes the same as another one with the same table.</summary>
    internal void CopyFrom(MotionTableManager other)
    {
        pending.CopyFrom(other.pending);
        state.CopyFrom(other.state);
        Sequence.CopyFrom(other.Sequence);
        animationCounter = other.animationCounter;
    }

    private void FailPending()
    {
        while (pending.Count > 0)
        {
            animationCounter = pending[0].Animations;
            CompleteHeads(success: false);
        }
    }

    private void CompleteHeads(bool success)
    {
        while (pending.Count > 0 && pending[0].Animations <= animationCounter) CompleteHead(success);
        if (pending.Count == 0) animationCounter = 0;
    }

    private void CompleteHead(bool success)
    {
        Pending head = pending[0];
        if (head.Motion.IsAction()) state.RemoveAction();
        MotionDone?.Invoke(head.Motion, success);
        animationCounter -= head.Animations;
        pending.Dequeue();
    }

    private void Queue(MotionCommand motion, int animations)
    {
        // A cycle without animations, which our own tables may have, counts as one.
        pending.Enqueue(new Pending(motion, Math.Max(animations, 0)));
        RemoveRedundantLinks();
    }

    /// <summary>
    /// A substate or style that was on its way already makes the way there and back superfluous: what was queued after the first of the two
    /// is not played. Entries without animations stop no search, as others of the same kind do not; anything else between the two keeps the
    /// links.
    /// </summary>
    /// <remarks>Retail: MotionTableManager::remove_redundant_links.</remarks>
    private void RemoveRedundantLinks()
    {
        int newest = pending.Count - 1;
        while (newest > 0 && pending[newest].Animations == 0) newest--;
        if (newest <= 0) return;
        MotionCommand motion = pending[newest].Motion;
        bool style = motion.IsStyle();
        if (!style && (!motion.IsSubstate() || motion.IsModifier())) return;
        // Between substates these are styles, actions and modifiers; between styles substates, actions and modifiers.
        uint others = style ? 0x70000000 : 0xB0000000;
        for (int i = newest - 1; i >= 0; i--)
        {
            Pending earlier = pending[i];
            if (earlier.Motion == motion && (style || earlier.Animations != 0))
            {
                TruncateAfter(i);
                return;
            }

            if (earlier.Animations != 0 && ((uint)earlier.Motion & others) != 0) return;
        }
    }

    private void TruncateAfter(int index)
    {
        int dropped = 0;
        for (int i = index + 1; i < pending.Count; i++)
        {
            dropped += pending[i].Animations;
            pending[i] = pending[i] with { Animations = 0 };
        }

        Sequence.RemoveLinks(dropped);
    }

    private readonly record struct Pending(MotionCommand Motion, int Animations);
}
