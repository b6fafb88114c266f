using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>Puts what is told to the server together, and knows when the position is due.</summary>
/// <remarks>Retail: the senders of CommandInterpreter; specification 09b, 9.8.</remarks>
internal sealed class MovementSender(IMotionBody body, MovementManager movement, IMovementSink sink, double now)
{
    private PositionReport report = new(now);

    /// <summary>What is asked of the body now, whether it changed or not.</summary>
    /// <remarks>Retail: CommandInterpreter::SendMovementEvent @0x006B4680.</remarks>
    public void SendMoveToState(double now)
    {
        report.OnMoveToState(now);
        MotionInterpreter motions = movement.Interpreter;
        bool contact = body.HasContact && body.OnWalkable;
        sink.OnMoveToState(new MoveToStateEvent(now, motions.Raw.Clone(), body.Position, contact, motions.StandingLongJump));
    }

    /// <summary>The body has jumped: its velocity is that after the jump.</summary>
    public void SendJump(float extent, double now) => sink.OnJump(new JumpEvent(now, extent, body.LocalVelocity, body.Position));

    /// <summary>Where the body is, when that is due.</summary>
    /// <remarks>Retail: CommandInterpreter::SendPositionEvent @0x006B4770.</remarks>
    public void SendPositionWhenDue(double now)
    {
        if (report.IsDue(body, now)) sink.OnAutonomousPosition(new AutonomousPositionEvent(now, body.Position, Contact: true));
    }
}
