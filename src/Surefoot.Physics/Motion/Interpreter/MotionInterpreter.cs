using Surefoot.Physics.Bodies;

namespace Surefoot.Physics.Motion;

/// <summary>A motion that is not done yet.</summary>
/// <param name="ContextId">Identifies the request.</param>
/// <param name="Motion">The motion.</param>
/// <param name="JumpError">Why the body may not jump until this is done; <see cref="MotionError.None"/> when it may.</param>
internal readonly record struct PendingMotion(uint ContextId, MotionCommand Motion, MotionError JumpError);

/// <summary>
/// Turns what the player asks for (<see cref="Raw"/>) or what a server says (<see cref="Interpreted"/>) into motions of the body. Each
/// group of verbs has a file of its own: <c>Apply</c> (both states), <c>Motions</c> (single motions), <c>Jump</c>, <c>Speeds</c>.
/// </summary>
/// <remarks>Retail: CMotionInterp; specification 01, section 4.</remarks>
internal sealed partial class MotionInterpreter
{
    private readonly RingQueue<PendingMotion> pending = new();
    private readonly IMotionBody? body;
    private readonly IWeenieObj? weenie;

    /// <summary>An interpreter for a body with these animations.</summary>
    /// <param name="animation">The animations; null for a body without a motion table.</param>
    /// <param name="body">The body; may be set later.</param>
    /// <param name="weenie">What the game knows of it, if anything.</param>
    public MotionInterpreter(MotionTableManager? animation, IMotionBody? body = null, IWeenieObj? weenie = null)
    {
        Animation = animation;
        if (animation is not null) animation.MotionDone = (_, success) => MotionDone(success);
        this.body = body;
        this.weenie = weenie;
    }

    /// <summary>The animations, or null.</summary>
    public MotionTableManager? Animation { get; }

    /// <summary>What the game knows of the body, or null.</summary>
    public IWeenieObj? Weenie => weenie;

    /// <summary>What the player asks for.</summary>
    public RawMotionState Raw { get; } = new();

    /// <summary>What the body does.</summary>
    public InterpretedMotionState Interpreted { get; } = new();

    /// <summary><see cref="EnterDefaultState"/> was called.</summary>
    public bool IsInitialised { get; private set; }

    /// <summary>The body stands and charges a jump; where it goes is decided by the keys held when it jumps.</summary>
    public bool StandingLongJump { get; internal set; }

    /// <summary>Charge of the jump under way, 0 without one.</summary>
    public float JumpExtent { get; private set; }

    /// <summary>Run rate a server told, used when the weenie does not know its own.</summary>
    public float MyRunRate { get; internal set; } = 1f;

    /// <summary>Stamp of the last action a server ordered, 15 bits.</summary>
    public uint ServerActionStamp { get; private set; }

    /// <summary>Number of motions that are not done.</summary>
    public int PendingCount => pending.Count;

    /// <summary>Motions wait to be done.</summary>
    /// <remarks>Retail: CMotionInterp::motions_pending @0x00527FE0.</remarks>
    public bool MotionsPending => pending.Count > 0;

    /// <summary>A motion that is not done, the oldest at 0.</summary>
    public PendingMotion GetPending(int index) => pending[index];

    private bool IsCreature => weenie is null || weenie.IsCreature;

    private bool IsThePlayer => weenie is null || weenie.IsThePlayer;

    private static bool Stands(IMotionBody b) => b.HasContact && b.OnWalkable;

    /// <summary>Both states to their defaults, the animations to the beginning.</summary>
    /// <remarks>Retail: CMotionInterp::enter_default_state @0x00528C80.</remarks>
    public void EnterDefaultState()
    {
        Raw.CopyFrom(new RawMotionState());
        Interpreted.Reset();
        Animation?.InitializeState();
        AddToQueue(0, MotionCommand.Ready, MotionError.None);
        IsInitialised = true;
        LeaveGround();
    }

    /// <summary>The oldest motion is done.</summary>
    /// <param name="success">It was played to its end; retail does not look.</param>
    /// <remarks>Retail: CMotionInterp::MotionDone @0x00527EC0.</remarks>
    public void MotionDone(bool success)
    {
        _ = success;
        if (body is null || pending.Count == 0) return;
        if (pending[0].Motion.IsAction())
        {
            body.Unstick();
            Interpreted.RemoveAction();
            Raw.RemoveAction();
        }

        pending.Dequeue();
    }

    /// <summary>The body leaves the world: everything pending is done.</summary>
    /// <remarks>Retail: CMotionInterp::HandleExitWorld @0x00527F30.</remarks>
    public void HandleExitWorld()
    {
        while (body is not null && pending.Count > 0) MotionDone(success: false);
    }

    /// <summary>Becomes the same as another one; the animations are copied apart.</summary>
    public void CopyFrom(MotionInterpreter other)
    {
        pending.CopyFrom(other.pending);
        Raw.CopyFrom(other.Raw);
        Interpreted.CopyFrom(other.Interpreted);
        (IsInitialised, StandingLongJump, JumpExtent) = (other.IsInitialised, other.StandingLongJump, other.JumpExtent);
        (MyRunRate, ServerActionStamp) = (other.MyRunRate, other.ServerActionStamp);
    }

    private void AddToQueue(uint contextId, MotionCommand motion, MotionError jumpError) =>
        pending.Enqueue(new PendingMotion(contextId, motion, jumpError));

    private void RemoveLinkAnimations() => Animation?.Sequence.RemoveAllLinks();

    internal static void ThrowIfNotFinite(InterpretedMotionState state)
    {
        ThrowIfNotFinite(state.ForwardSpeed, nameof(state));
        ThrowIfNotFinite(state.SidestepSpeed, nameof(state));
        ThrowIfNotFinite(state.TurnSpeed, nameof(state));
        for (int i = 0; i < state.ActionCount; i++) ThrowIfNotFinite(state.GetAction(i).Speed, nameof(state));
    }

    internal static void ThrowIfNotFinite(float value, string name)
    {
        if (!float.IsFinite(value)) throw new ArgumentException($"The speed {value} is not finite.", name);
    }
}
