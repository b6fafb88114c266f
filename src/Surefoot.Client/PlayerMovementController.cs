using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>
/// Turns keys and time into motions of the player's body, and into what a client tells its server. Called once a frame, before the world is advanced; it
/// reads no clock and owns nothing global.
/// </summary>
/// <remarks>Retail: CommandInterpreter, and the jump of ClientCombatSystem; specification 01, 4.12 and 4.15, and 08, 5.6.</remarks>
public sealed class PlayerMovementController : IServerMessageHandler
{
    private const MovementKeys DirectionKeys = MovementKeys.Forward | MovementKeys.Back | MovementKeys.TurnLeft | MovementKeys.TurnRight |
                                               MovementKeys.SidestepLeft | MovementKeys.SidestepRight;

    private readonly MovementManager movement;
    private readonly IMotionBody body;
    private readonly IMovementSink sink;
    private readonly HeldCommands substates = new();
    private readonly HeldCommands sidesteps = new();
    private readonly HeldCommands turns = new();
    private MovementKeys held;
    private JumpCharge charge;
    private PositionReport report;

    /// <summary>A controller of a body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="movement">Its motion side, which the body already calls.</param>
    /// <param name="sink">Receives what the client would send.</param>
    /// <param name="now">Seconds, of the same clock as later calls.</param>
    public PlayerMovementController(IMotionBody body, MovementManager movement, IMovementSink sink, double now)
    {
        ArgumentNullException.ThrowIfNull(body);
        ArgumentNullException.ThrowIfNull(movement);
        ArgumentNullException.ThrowIfNull(sink);
        ThrowIfNotFinite(now);
        this.body = body;
        this.movement = movement;
        this.sink = sink;
        report = new PositionReport(now);
    }

    /// <summary>Forward runs and <see cref="MovementKeys.Walk"/> walks; or, when false, the other way round. Acts at the next <see cref="Update"/>.</summary>
    public bool RunAsDefault { get; set; } = true;

    /// <summary>Runs ahead without a key. Ended by the keys for ahead and back and when a server takes over.</summary>
    public bool AutoRun { get; private set; }

    /// <summary>A server moves the body; the next key takes control back.</summary>
    public bool IsControlledByServer { get; private set; } = true;

    /// <summary>The jump key is held and charges a jump.</summary>
    public bool IsChargingJump => charge.IsPending;

    /// <summary>Why the last jump was refused; none when it was not.</summary>
    public MotionError LastRefusal { get; private set; }

    /// <summary>Charge of the jump under way, 0 to 1; 0 without one.</summary>
    /// <param name="now">Seconds.</param>
    public float JumpLevel(double now) => charge.Level(now, Interpreter.Interpreted.CurrentStyle);

    private MotionInterpreter Interpreter => movement.Interpreter;

    private bool StandsStill => Interpreter.Raw is
    { ForwardCommand: MotionCommand.Ready, SidestepCommand: MotionCommand.None, TurnCommand: MotionCommand.None };

    /// <summary>A frame of input.</summary>
    /// <param name="keys">Keys held now. Unknown bits are ignored.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Update(MovementKeys keys, double now)
    {
        ThrowIfNotFinite(now);
        MovementKeys changed = keys ^ held;
        held = keys;

        HandleHoldRun(now);
        HandleHoldSidestep(changed, now);
        HandleKey(changed, MovementKeys.Forward, substates, MotionCommand.WalkForward, now);
        HandleKey(changed, MovementKeys.Back, substates, MotionCommand.WalkBackwards, now);
        HandleKey(changed, MovementKeys.SidestepLeft, sidesteps, MotionCommand.SideStepLeft, now);
        HandleKey(changed, MovementKeys.SidestepRight, sidesteps, MotionCommand.SideStepRight, now);
        HandleTurnKey(changed, MovementKeys.TurnLeft, MotionCommand.TurnLeft, MotionCommand.SideStepLeft, now);
        HandleTurnKey(changed, MovementKeys.TurnRight, MotionCommand.TurnRight, MotionCommand.SideStepRight, now);
        if ((changed & MovementKeys.Jump) != 0)
        {
            if ((keys & MovementKeys.Jump) != 0) CommenceJump(now);
            else DoJump(now);
        }

        // Keys that were held while a server moved the body act again as soon as what it ordered is done.
        if (IsControlledByServer && (held & DirectionKeys) != 0 && !Interpreter.MotionsPending)
        {
            TakeControl();
            SendMoveToState(now);
        }

        if (report.IsDue(body, now)) sink.OnAutonomousPosition(new AutonomousPositionEvent(now, body.Position, Contact: true));
    }

    /// <summary>Runs ahead without a key, or stops doing so.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void SetAutoRun(bool on, double now)
    {
        ThrowIfNotFinite(now);
        if (on == AutoRun) return;
        AutoRun = on;
        if (IsControlledByServer && !on) return;
        BeginCommand();
        ApplyHoldRun();
        ApplySubstates();
        SendMoveToState(now);
    }

    /// <summary>The page lost the focus or the input ends: every key counts as let go, and a jump under way is given up.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void ReleaseAll(double now)
    {
        ThrowIfNotFinite(now);
        held = MovementKeys.None;
        substates.Clear();
        sidesteps.Clear();
        turns.Clear();
        AutoRun = false;
        FinishJump();
        if (IsControlledByServer) return;
        Interpreter.PerformMovement(MovementKind.StopCompletely, MotionCommand.None, new MovementParameters());
        SendMoveToState(now);
    }

    /// <summary>The body was teleported: the server is told what is asked of it there.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void OnTeleported(double now)
    {
        ThrowIfNotFinite(now);
        if (AutoRun)
        {
            AutoRun = false;
            if (!IsControlledByServer)
            {
                ApplyHoldRun();
                ApplySubstates();
            }
        }

        SendMoveToState(now);
    }

    /// <summary>
    /// A server says what the player's body does. When the server ordered it, the body does it and the keys wait. When it only repeats what the player asked for, the
    /// motion is ignored, as in retail, but the forward speed of a runner is adopted: it is the server's run rate.
    /// </summary>
    /// <exception cref="ArgumentException">A speed is NaN or infinite, or a runner's is not positive; nothing has changed.</exception>
    public void HandleUpdateMotion(in UpdateMotionEvent message)
    {
        ArgumentNullException.ThrowIfNull(message.State, nameof(message));
        if (message.Autonomous)
        {
            if (message.State.ForwardCommand == MotionCommand.RunForward) Interpreter.AdoptRunRate(message.State.ForwardSpeed);
            return;
        }

        movement.ApplyUpdate(message.State, autonomous: false, message.StandingLongJump);
        IsControlledByServer = true;
        AutoRun = false;
    }

    /// <summary>A server says what numbers the character has. Only here do they reach the player's weenie, so until then everything stays as it was.</summary>
    /// <exception cref="ArgumentException">A number is out of range.</exception>
    public void HandleCharacterUpdate(in CharacterUpdateEvent message)
    {
        if (Interpreter.Weenie is PlayerWeenie weenie) weenie.SetStats(message.Stats);
        Interpreter.AdoptRunRate(message.RunRate);
    }

    private void HandleKey(MovementKeys changed, MovementKeys key, HeldCommands list, MotionCommand command, double now)
    {
        if ((changed & key) == 0) return;
        bool pressed = (held & key) != 0;
        MotionCommand before = list.Acting;
        if (pressed) list.Press(command);
        else list.Release(command);
        if (pressed && list == substates) AutoRun = false;
        if (!pressed && (IsControlledByServer || list.Acting == before)) return;
        if (pressed) BeginCommand();
        ApplyHoldRun();
        Apply(list);
        SendMoveToState(now);
    }

    private void HandleTurnKey(MovementKeys changed, MovementKeys key, MotionCommand turn, MotionCommand sidestep, double now)
    {
        if ((changed & key) == 0) return;
        bool asSidestep = (held & MovementKeys.HoldSidestep) != 0;
        HandleKey(changed, key, asSidestep ? sidesteps : turns, asSidestep ? sidestep : turn, now);
    }

    /// <summary>Turn keys that are held change what they mean.</summary>
    private void HandleHoldSidestep(MovementKeys changed, double now)
    {
        if ((changed & MovementKeys.HoldSidestep) == 0) return;
        bool on = (held & MovementKeys.HoldSidestep) != 0, any = false;
        any |= Exchange(changed, on, MovementKeys.TurnLeft, MotionCommand.TurnLeft, MotionCommand.SideStepLeft, MovementKeys.SidestepLeft);
        any |= Exchange(changed, on, MovementKeys.TurnRight, MotionCommand.TurnRight, MotionCommand.SideStepRight, MovementKeys.SidestepRight);
        if (!any || IsControlledByServer) return;
        Apply(sidesteps);
        Apply(turns);
        SendMoveToState(now);
    }

    private bool Exchange(MovementKeys changed, bool on, MovementKeys key, MotionCommand turn, MotionCommand sidestep, MovementKeys sidestepKey)
    {
        bool wasHeld = ((held ^ changed) & key) != 0;
        if (!wasHeld) return false;
        if (on)
        {
            turns.Release(turn);
            sidesteps.Press(sidestep);
        }
        else
        {
            if ((held & sidestepKey) == 0) sidesteps.Release(sidestep);
            turns.Press(turn);
        }

        return true;
    }

    private void HandleHoldRun(double now)
    {
        if (IsControlledByServer || !ApplyHoldRun() || StandsStill) return;
        SendMoveToState(now);
    }

    /// <summary>True when it changed whether forward walks or runs.</summary>
    private bool ApplyHoldRun()
    {
        bool run = AutoRun || RunAsDefault != ((held & MovementKeys.Walk) != 0);
        if (Interpreter.Raw.CurrentHoldKey == HoldKey.Run == run) return false;
        Interpreter.SetHoldRun(run, cancelMoveTo: false);
        return true;
    }

    private void BeginCommand()
    {
        if (IsControlledByServer) TakeControl();
    }

    /// <summary>The keys count again: what a server ordered ends, and what is held acts.</summary>
    /// <remarks>Retail: CommandInterpreter::TakeControlFromServer.</remarks>
    private void TakeControl()
    {
        IsControlledByServer = false;
        body.LastMoveWasAutonomous = true;
        Interpreter.PerformMovement(MovementKind.StopCompletely, MotionCommand.None, new MovementParameters());
        ApplyHoldRun();
        ApplySubstates();
        Apply(sidesteps);
        Apply(turns);
    }

    private void Apply(HeldCommands list)
    {
        if (list == substates) ApplySubstates();
        else if (list.Acting != MotionCommand.None) movement.DoMotion(list.Acting, new MovementParameters());
        else movement.StopMotion(list == sidesteps ? MotionCommand.SideStepRight : MotionCommand.TurnRight, new MovementParameters());
    }

    /// <summary>Hold key 0 with the flag to set it: the current hold key, and not one of the command, decides between walking and running.</summary>
    private void ApplySubstates()
    {
        MotionCommand acting = AutoRun ? MotionCommand.WalkForward : substates.Acting;
        movement.DoMotion(acting == MotionCommand.None ? MotionCommand.Ready : acting, new MovementParameters());
    }

    /// <remarks>Retail: ClientCombatSystem::CommenceJump @0x0056AF90.</remarks>
    private void CommenceJump(double now)
    {
        if (charge.IsPending) return;
        LastRefusal = Interpreter.ChargeJump();
        if (LastRefusal == MotionError.None) charge.Begin(now);
    }

    /// <remarks>Retail: ClientCombatSystem::DoJump @0x0056B110. The velocity is read after the jump.</remarks>
    private void DoJump(double now)
    {
        if (!charge.IsPending) return;
        float extent = Math.Max(JumpLevel(now), MovementFormulas.MinJumpExtent);
        FinishJump();
        LastRefusal = Interpreter.Jump(extent);
        if (LastRefusal == MotionError.None) sink.OnJump(new JumpEvent(now, extent, body.LocalVelocity, body.Position));
    }

    private void FinishJump()
    {
        charge.End();
        Interpreter.EndJumpCharge();
    }

    private void SendMoveToState(double now)
    {
        report.OnMoveToState(now);
        bool contact = body.HasContact && body.OnWalkable;
        sink.OnMoveToState(new MoveToStateEvent(now, Interpreter.Raw.Clone(), body.Position, contact, Interpreter.StandingLongJump));
    }

    private static void ThrowIfNotFinite(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
    }
}
