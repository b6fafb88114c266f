using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Client;

/// <summary>
/// What the keys mean: which commands are held, whether the player or a server is in control, which motion follows, and that it is told.
/// The pointer has a file of its own (<c>CommandInterpreter.Mouse.cs</c>).
/// </summary>
/// <remarks>Retail: CommandInterpreter @0x006B3E40, at its normal level of autonomy; specification 09b, 9.</remarks>
internal sealed partial class CommandInterpreter(IMotionBody body, MovementManager movement, MovementSender sender, JumpKey jump)
{
    private readonly HeldCommands substates = new();
    private readonly HeldCommands turns = new();
    private readonly HeldCommands sidesteps = new();
    private bool runAsDefault = true;
    private bool holdRun;
    private bool holdSidestep;
    private bool posture;
    private uint actionStamp = 1;

    /// <summary>Keys act at all.</summary>
    public bool IsEnabled { get; private set; } = true;

    /// <summary>A server moves the body.</summary>
    public bool IsControlledByServer { get; private set; } = true;

    /// <summary>Runs ahead without a key.</summary>
    public bool AutoRun { get; private set; }

    /// <summary>Forward runs unless the walk key is held. A change acts at once, whatever the walk key does, and is not told.</summary>
    public bool RunAsDefault
    {
        get => runAsDefault;
        set
        {
            if (value == runAsDefault) return;
            runAsDefault = value;
            movement.Interpreter.SetHoldRun(value, cancelMoveTo: true);
        }
    }

    private bool IsDead => movement.Interpreter.Interpreted.ForwardCommand == MotionCommand.Dead;

    private bool StandsStill => body.HasContact && body.OnWalkable && movement.Interpreter.Interpreted is
    { ForwardCommand: MotionCommand.Ready, SidestepCommand: MotionCommand.None, TurnCommand: MotionCommand.None };

    /// <summary>True for a command that lasts as long as its key is held.</summary>
    public bool IsHeld(MotionCommand command) => ListOf(command) is not null;

    /// <summary>
    /// A key of a command went down or came up. Coming up it says so even when nothing changes, but not while a server is in control.
    /// </summary>
    /// <returns>Why the motion was refused; none when it was not.</returns>
    /// <remarks>Retail: CommandInterpreter::HandleKeyboardCommand @0x006B3690.</remarks>
    public MotionError HandleKey(MotionCommand command, bool down, double now)
    {
        if (!IsEnabled) return MotionError.None;
        if (IsControlledByServer && !down)
        {
            Release(ref command, ref down);
            return MotionError.None;
        }

        TakeControlFromServer(now);
        MotionError error = MotionError.None;
        if (down ? Press(command, now) : Release(ref command, ref down)) error = MovePlayer(new Move(AsHeld(command), down), now);
        sender.SendMoveToState(now);
        return error;
    }

    /// <summary>The walk key: forward walks where it would run, or the other way round. It acts at once and is not told.</summary>
    /// <remarks>Retail: CommandInterpreter::SetHoldRun @0x006B3370.</remarks>
    public void HandleWalkKey(bool down)
    {
        if (IsEnabled) SetHoldRun(down);
    }

    /// <summary>The key that makes sidesteps of turns.</summary>
    /// <remarks>Retail has the flag, and a command that sets it, but no key for that command.</remarks>
    public void HandleSidestepKey(bool down, double now)
    {
        if (!IsEnabled) return;
        MotionCommand before = AsHeld(turns.Head);
        holdSidestep = down;
        if (IsControlledByServer) return;
        if (before != MotionCommand.None) MovePlayer(new Move(before, Down: false), now);
        ApplyCurrentMovement(now);
        if (!StandsStill) sender.SendMoveToState(now);
    }

    /// <summary>The autorun key.</summary>
    public void HandleAutoRun(bool on, double now)
    {
        if (!IsEnabled || on == AutoRun) return;
        SetAutoRun(on, now);
        sender.SendMoveToState(now);
    }

    /// <summary>Ends everything, the keys' commands and autorun as well.</summary>
    /// <remarks>Retail: CommandInterpreter::StopCompletely @0x006B3B50.</remarks>
    public void StopCompletely(double now)
    {
        ClearCommands();
        EndAutoRun();
        movement.StopCompletely();
        sender.SendMoveToState(now);
    }

    /// <summary>The keyboard belongs to somebody else: every key counts as let go. Autorun goes on.</summary>
    /// <remarks>Retail: CommandInterpreter::LoseKeyboardFocus @0x006B31F0.</remarks>
    public void LoseKeyboardFocus(double now)
    {
        LetGo();
        if (IsControlledByServer) return;
        ApplyCurrentMovement(now);
        sender.SendMoveToState(now);
    }

    /// <summary>Keys and positions are not looked at until <see cref="Enable"/>.</summary>
    /// <remarks>Retail: CommandInterpreter::Disable @0x006B3250.</remarks>
    public void Disable(double now)
    {
        if (!IsEnabled) return;
        LoseKeyboardFocus(now);
        IsEnabled = false;
    }

    /// <summary>Keys act again.</summary>
    public void Enable()
    {
        IsEnabled = true;
        SetHoldRun(holdRun);
    }

    /// <summary>The body was teleported.</summary>
    /// <remarks>Retail: CommandInterpreter::PlayerTeleported @0x006B32B0.</remarks>
    public void HandleTeleport(double now)
    {
        SetAutoRun(on: false, now);
        sender.SendMoveToState(now);
    }

    /// <summary>
    /// A server's order was applied to the body: it goes first until it is done. The keys stay held; autorun and a charge end.
    /// </summary>
    /// <remarks>Retail: CommandInterpreter::LoseControlToServer @0x006B3170.</remarks>
    public void LoseControlToServer()
    {
        IsControlledByServer = true;
        EndAutoRun();
        jump.Finish();
    }

    /// <summary>
    /// Once a frame, after keys and messages: tells the position when it is due, and lets held keys act again when a server's order is
    /// done.
    /// </summary>
    /// <remarks>Retail: CommandInterpreter::UseTime @0x006B3BF0. Taking control back is not told.</remarks>
    public void UseTime(double now)
    {
        if (!IsEnabled) return;
        sender.SendPositionWhenDue(now);
        bool wanted = AutoRun || substates.Head != MotionCommand.None || turns.Head != MotionCommand.None ||
            sidesteps.Head != MotionCommand.None;
        if (IsControlledByServer && wanted && !movement.MotionsPending && !movement.IsMovingTo) TakeControlFromServer(now);
    }

    /// <summary>The keys count again: what a server ordered ends, and what is held acts. Not told, and not for the dead.</summary>
    /// <remarks>Retail: CommandInterpreter::TakeControlFromServer @0x006B32D0.</remarks>
    private void TakeControlFromServer(double now)
    {
        if (!IsControlledByServer || IsDead) return;
        IsControlledByServer = false;
        body.LastMoveWasAutonomous = true;
        movement.StopCompletely();
        body.StopInterpolating();
        SetHoldRun(holdRun);
        ApplyCurrentMovement(now);
    }

    private void SetHoldRun(bool held)
    {
        holdRun = held;
        movement.Interpreter.SetHoldRun(held != runAsDefault, cancelMoveTo: true);
    }

    /// <remarks>Retail: CommandInterpreter::SetAutoRun @0x006B4850, with what is held then applied.</remarks>
    private void SetAutoRun(bool on, double now)
    {
        if (on == AutoRun) return;
        AutoRun = on;
        posture = false;
        if (on) TakeControlFromServer(now);
        ApplyCurrentMovement(now);
    }

    /// <summary>Autorun is off; what the body does is up to the caller.</summary>
    private void EndAutoRun()
    {
        if (AutoRun) AutoRun = posture = false;
    }

    /// <summary>
    /// Enters a key that went down into its list. A new substate ends autorun; a posture keeps what comes up later from acting.
    /// </summary>
    /// <remarks>Retail: CommandInterpreter::AddCommand @0x006B39A0.</remarks>
    private bool Press(MotionCommand command, double now)
    {
        HeldCommands? list = ListOf(command);
        list?.Press(command);
        if (!command.IsSubstate()) return true;
        if (list is null || list == substates) SetAutoRun(on: false, now);
        posture = list is null && command != MotionCommand.Ready;
        return true;
    }

    /// <summary>
    /// Takes a key that came up out of its list. Nothing follows when it did not act. When another one is held in the same list, that one
    /// goes down instead.
    /// </summary>
    /// <returns>A motion follows.</returns>
    /// <remarks>Retail: CommandInterpreter::NukeCommand @0x006B3A20.</remarks>
    private bool Release(ref MotionCommand command, ref bool down)
    {
        HeldCommands? list = ListOf(command);
        if (list is null || !list.Release(command)) return false;
        if (posture || (AutoRun && list == substates)) return false;
        if (list.Head != MotionCommand.None) (command, down) = (list.Head, true);
        return true;
    }

    /// <summary>
    /// Puts what is held into effect, list by list. In this order: the stop of a sidestep among the turns comes before the sidestep's own
    /// turn.
    /// </summary>
    /// <remarks>Retail: CommandInterpreter::ApplyCurrentMovement @0x006B3430.</remarks>
    private void ApplyCurrentMovement(double now)
    {
        if (AutoRun) MovePlayer(new Move(MotionCommand.WalkForward, Down: true, ByMouse: true), now);
        else if (substates.Head != MotionCommand.None) MovePlayer(new Move(substates.Head, Down: true), now);
        else if (!posture) MovePlayer(new Move(MotionCommand.Ready, Down: true), now);

        if (turns.Head != MotionCommand.None)
        {
            MovePlayer(new Move(AsHeld(turns.Head), Down: true), now);
        }
        else
        {
            MovePlayer(new Move(MotionCommand.SideStepRight, Down: false), now);
            MovePlayer(new Move(MotionCommand.TurnRight, Down: false), now);
        }

        if (sidesteps.Head != MotionCommand.None) MovePlayer(new Move(sidesteps.Head, Down: true), now);
        else if (!holdSidestep || turns.Head == MotionCommand.None) MovePlayer(new Move(MotionCommand.SideStepRight, Down: false), now);
    }

    /// <summary>Begins or ends a motion of the body. The dead let everything go instead.</summary>
    /// <remarks>
    /// Retail: CommandInterpreter::MovePlayer @0x006B3F40. A key's motion has no hold key of its own and follows the current one; a
    /// button's and autorun's is a run whatever the walk key says.
    /// </remarks>
    private MotionError MovePlayer(Move move, double now)
    {
        if (IsDead)
        {
            LetGo();
            EndAutoRun();
            return MotionError.None;
        }

        if (UsesMouse) move = WithMouse(move, now);
        if (!move.Down) return Stop(move.Command, move.ByMouse);

        MovementParameters p = Parameters(move.ByMouse);
        p.Flags |= MovementFlags.Autonomous;
        p.Speed = move.Speed;
        p.ActionStamp = actionStamp;
        bool action = move.Command.IsAction();
        if (action) StopCompletely(now);
        MotionError error = movement.DoMotion(move.Command, p);
        if (action && error == MotionError.None) actionStamp++;
        return error;
    }

    private MotionError Stop(MotionCommand command, bool byMouse) => movement.StopMotion(command, Parameters(byMouse));

    private static MovementParameters Parameters(bool byMouse) => byMouse
        ? new MovementParameters { HoldKey = HoldKey.Run, Flags = MovementFlags.Default & ~MovementFlags.SetHoldKey }
        : new MovementParameters();

    private void LetGo()
    {
        ClearCommands();
        SetHoldRun(false);
        holdSidestep = false;
        jump.Finish();
    }

    private void ClearCommands()
    {
        substates.Clear();
        turns.Clear();
        sidesteps.Clear();
    }

    /// <remarks>Retail: CommandInterpreter::WhichList @0x006B3950.</remarks>
    private HeldCommands? ListOf(MotionCommand command) => command switch
    {
        MotionCommand.TurnRight or MotionCommand.TurnLeft => turns,
        MotionCommand.SideStepRight or MotionCommand.SideStepLeft => sidesteps,
        MotionCommand.WalkForward or MotionCommand.WalkBackwards or MotionCommand.RunForward => substates,
        _ => null,
    };

    /// <summary>What a held command means: a turn is a sidestep while the key for that is held.</summary>
    private MotionCommand AsHeld(MotionCommand command) => holdSidestep ? SidestepOf(command) : command;

    private static MotionCommand SidestepOf(MotionCommand command) => command switch
    {
        MotionCommand.TurnRight => MotionCommand.SideStepRight,
        MotionCommand.TurnLeft => MotionCommand.SideStepLeft,
        _ => command,
    };

    /// <summary>A motion to begin or to end.</summary>
    /// <param name="Command">The motion, as keys name it.</param>
    /// <param name="Down">It begins.</param>
    /// <param name="Speed">Speed factor.</param>
    /// <param name="ByMouse">A button of the pointer, the pointer itself, or autorun asks for it: it runs.</param>
    private readonly record struct Move(MotionCommand Command, bool Down, float Speed = 1f, bool ByMouse = false);
}
