using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <content>Turning by the pointer while its right button is held; all of it does nothing while the option is off.</content>
/// <remarks>Specification 09b, 9.7.</remarks>
internal sealed partial class CommandInterpreter
{
    private const double SendInterval = 0.5;

    /// <summary>
    /// What the right button asks for. No motion table has it: asking has its effect in <see cref="WithMouse"/> and fails harmlessly after
    /// that.
    /// </summary>
    private const MotionCommand LookChanges = (MotionCommand)0x0C0000C1;

    private bool leftButton;
    private double lastTurnSent = double.NegativeInfinity;

    /// <summary>The option "use mouse turning".</summary>
    public bool UsesMouse { get; private set; }

    /// <summary>The right button is held: the pointer turns the body, and keys that turn it step sideways.</summary>
    public bool IsLooking { get; private set; }

    /// <summary>Switches the option. Off ends a look.</summary>
    public void UseMouse(bool on, double now)
    {
        if (!on) HandleLook(on: false, now);
        UsesMouse = on;
    }

    /// <summary>The right button went down or came up.</summary>
    /// <remarks>Retail: CameraSet::ToggleMouseLook @0x00457490.</remarks>
    public void HandleLook(bool on, double now)
    {
        if (!UsesMouse || on == IsLooking || (on && !IsEnabled)) return;
        IsLooking = on;
        if (!IsEnabled) return;
        MovePlayer(new Move(LookChanges, on, ByMouse: true), now);
        if (!on) ApplyCurrentMovement(now);
        sender.SendMoveToState(now);
    }

    /// <summary>The left button went down or came up: with the right one held it runs ahead.</summary>
    /// <remarks>Retail: CommandInterpreter::HandleSelectLeft @0x006B3630.</remarks>
    public void HandleLeftButton(bool down, double now)
    {
        if (!IsEnabled || down == leftButton) return;
        leftButton = down;
        if (!UsesMouse || !IsLooking) return;
        MovePlayer(new Move(MotionCommand.WalkForward, down, ByMouse: true), now);
        sender.SendMoveToState(now);
    }

    /// <summary>The pointer turns the body.</summary>
    /// <param name="turn">How: below 0 right, above 0 left.</param>
    /// <param name="now">Seconds.</param>
    /// <remarks>Retail: CameraSet::Rotate @0x00458310, in third person.</remarks>
    public void TurnByMouse(float turn, double now)
    {
        float size = Math.Abs(turn);
        if (size < MouseTurning.DeadZone)
        {
            StopDrift();
            return;
        }

        float speed = Math.Min(2f * size, MouseTurning.MaxSpeed);
        MovePlayer(new Move(turn > 0 ? MotionCommand.TurnLeft : MotionCommand.TurnRight, Down: true, speed, ByMouse: true), now);
        SendTurn(now);
    }

    /// <summary>The pointer rests: the body stops turning.</summary>
    public void RestMouse(double now)
    {
        StopDrift();
        SendTurn(now);
    }

    /// <remarks>Retail: CommandInterpreter::StopDrift @0x006B4510.</remarks>
    private void StopDrift()
    {
        MovementParameters p = new() { HoldKey = HoldKey.None, Flags = MovementFlags.Default & ~MovementFlags.SetHoldKey };
        movement.StopMotion(MotionCommand.TurnRight, p);
        movement.StopMotion(MotionCommand.TurnLeft, p);
    }

    private void SendTurn(double now)
    {
        if (!(now - lastTurnSent > SendInterval)) return;
        lastTurnSent = now;
        sender.SendMoveToState(now);
    }

    /// <summary>What a motion becomes with the option on: keys that turn step sideways during a look, and turn again after it.</summary>
    private Move WithMouse(in Move move, double now)
    {
        if (move.ByMouse) return IsLooking ? AtLook(move, now) : AfterLook(move, now);
        if (!IsLooking) return move;
        TakeControlFromServer(now);
        if (move.Command is not (MotionCommand.TurnRight or MotionCommand.TurnLeft))
        {
            Stop(MotionCommand.TurnRight, move.ByMouse);
            Stop(MotionCommand.TurnLeft, move.ByMouse);
            return move;
        }

        MotionCommand sidestep = SidestepOf(move.Command);
        Stop(move.Down ? move.Command : sidestep, move.ByMouse);
        return move.Down ? new Move(sidestep, Down: true) : move;
    }

    private Move AtLook(in Move move, double now)
    {
        if (move.Command != LookChanges) return move;
        bool right = turns.Head == MotionCommand.TurnRight;
        if (!right && turns.Head != MotionCommand.TurnLeft) return leftButton ? move with { Command = MotionCommand.WalkForward } : move;

        // A sidestep held the other way wins; with the left turn held it is the right one that is stopped then.
        MotionCommand held = sidesteps.Head;
        bool toRight = right ? held != MotionCommand.SideStepLeft : held == MotionCommand.SideStepRight;
        TakeControlFromServer(now);
        Stop(right || toRight ? MotionCommand.TurnRight : MotionCommand.TurnLeft, move.ByMouse);
        return move with { Command = toRight ? MotionCommand.SideStepRight : MotionCommand.SideStepLeft };
    }

    private Move AfterLook(in Move move, double now)
    {
        MotionCommand turn = turns.Head;
        if (turn == MotionCommand.None) return move;
        TakeControlFromServer(now);
        Stop(SidestepOf(turn), move.ByMouse);
        return move with { Command = turn, Down = true };
    }
}
