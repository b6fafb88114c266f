using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>
/// A server in the same process: it owns the character's numbers, works out the run rate, and answers each MoveToState with an UpdateMotion, after a while.
/// </summary>
/// <remarks>
/// The numbers reach the client by messages only, so until an answer has arrived the player moves at the old rate. Conversion of states as in
/// specification 08, section 8.
/// </remarks>
public sealed class LoopbackServer : IMovementSink
{
    private const float SidestepFactor = 1.248f;
    private const float MaxSidestep = 3f;
    private const float RunTurnSpeed = 1.5f;
    private const float BackwardsFactor = -0.65f;

    private readonly Queue<(double Due, UpdateMotionEvent? Motion, CharacterUpdateEvent? Character)> messages = new();
    private readonly TopSpeedRule topSpeedRule;
    private MoveToStateEvent? lastState;
    private double latency;

    /// <summary>A server that knows the player.</summary>
    /// <param name="stats">The character's numbers; the client is told at once.</param>
    /// <param name="now">Seconds.</param>
    /// <param name="latency">Seconds from a message of the client to its answer, 0 or more.</param>
    /// <param name="topSpeedRule">From which run skill on the top speed holds.</param>
    public LoopbackServer(CharacterStats stats, double now, double latency = 0, TopSpeedRule topSpeedRule = TopSpeedRule.EightHundredAndAbove)
    {
        this.topSpeedRule = topSpeedRule;
        Latency = latency;
        SetStats(stats, now);
    }

    /// <summary>Seconds from a message of the client to its answer.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative or not finite.</exception>
    public double Latency
    {
        get => latency;
        set
        {
            if (!(value >= 0) || !double.IsFinite(value)) throw new ArgumentOutOfRangeException(nameof(value), value, "A latency is a number of seconds, 0 or more.");
            latency = value;
        }
    }

    /// <summary>The character's numbers, as the server has them.</summary>
    public CharacterStats Stats { get; private set; }

    /// <summary>The run rate that follows from them.</summary>
    public float RunRate => Stats.RunRate(topSpeedRule);

    /// <summary>Messages on their way to the client.</summary>
    public int PendingCount => messages.Count;

    /// <summary>Changes the character's numbers and tells the client: the numbers, and what the body does now when it moves.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is negative.</exception>
    public void SetStats(CharacterStats stats, double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.RunSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.JumpSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.Stamina, nameof(stats));
        Stats = stats;
        messages.Enqueue((now + latency, null, new CharacterUpdateEvent(stats, RunRate)));
        if (lastState is { } state) Answer(state, now);
    }

    /// <inheritdoc/>
    public void OnMoveToState(in MoveToStateEvent e)
    {
        lastState = e;
        Answer(e, e.Time);
    }

    /// <inheritdoc/>
    public void OnJump(in JumpEvent e)
    {
    }

    /// <inheritdoc/>
    public void OnAutonomousPosition(in AutonomousPositionEvent e)
    {
    }

    /// <summary>Hands over the messages that have arrived by now, in order.</summary>
    public void Deliver(IServerMessageHandler client, double now)
    {
        ArgumentNullException.ThrowIfNull(client);
        while (messages.Count > 0 && messages.Peek().Due <= now)
        {
            (_, UpdateMotionEvent? motion, CharacterUpdateEvent? character) = messages.Dequeue();
            if (motion is { } m) client.HandleUpdateMotion(m);
            if (character is { } c) client.HandleCharacterUpdate(c);
        }
    }

    /// <summary>What a server makes of a raw state for everybody to see: normalised commands, with its own run rate.</summary>
    public static InterpretedMotionState Interpret(RawMotionState raw, float runRate, bool standingLongJump)
    {
        ArgumentNullException.ThrowIfNull(raw);
        InterpretedMotionState state = new() { CurrentStyle = raw.CurrentStyle };
        if (!standingLongJump)
        {
            InterpretForward(raw, runRate, state);
            InterpretSidestep(raw, state);
        }

        if (raw.TurnCommand is MotionCommand.TurnRight or MotionCommand.TurnLeft)
        {
            // A raw speed of 1 is not sent at all, and the server puts its own in its place.
            float speed = IsRun(raw, raw.TurnHoldKey) ? RunTurnSpeed : 1f;
            if (raw.TurnSpeed != 0 && raw.TurnSpeed != 1 && raw.TurnSpeed <= RunTurnSpeed) speed = raw.TurnSpeed;
            (state.TurnCommand, state.TurnSpeed) = (MotionCommand.TurnRight, raw.TurnCommand == MotionCommand.TurnLeft ? -speed : speed);
        }

        return state;
    }

    private static void InterpretForward(RawMotionState raw, float runRate, InterpretedMotionState state)
    {
        bool run = IsRun(raw, raw.ForwardHoldKey);
        (state.ForwardCommand, state.ForwardSpeed) = raw.ForwardCommand switch
        {
            MotionCommand.WalkForward when run => (MotionCommand.RunForward, runRate),
            MotionCommand.WalkBackwards => (MotionCommand.WalkForward, raw.ForwardSpeed * BackwardsFactor),
            _ => (raw.ForwardCommand, raw.ForwardSpeed),
        };
    }

    private static void InterpretSidestep(RawMotionState raw, InterpretedMotionState state)
    {
        if (raw.SidestepCommand is not (MotionCommand.SideStepRight or MotionCommand.SideStepLeft)) return;
        float speed = Math.Clamp(raw.SidestepSpeed * SidestepFactor, -MaxSidestep, MaxSidestep);
        (state.SidestepCommand, state.SidestepSpeed) = (MotionCommand.SideStepRight, raw.SidestepCommand == MotionCommand.SideStepLeft ? -speed : speed);
    }

    private static bool IsRun(RawMotionState raw, HoldKey key) => (key == HoldKey.Invalid ? raw.CurrentHoldKey : key) == HoldKey.Run;

    private void Answer(in MoveToStateEvent e, double now) =>
        messages.Enqueue((now + latency, new UpdateMotionEvent(Interpret(e.State, RunRate, e.StandingLongJump), Autonomous: true, e.StandingLongJump), null));
}
