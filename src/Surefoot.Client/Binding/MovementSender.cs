using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>Puts what is told to the server together, and knows when the position is due.</summary>
/// <remarks>Retail: the senders of CommandInterpreter; specification 08, section 5 and 09b, 9.8.</remarks>
internal sealed class MovementSender(
    IMotionBody body, MovementManager movement, PlayerObject player, IServerLink server, IMovementObserver? observer, double now)
{
    private PositionReport report = new(now);

    private bool StandsOnGround => body.HasContact && body.OnWalkable;

    /// <summary>What is asked of the body now, whether it changed or not.</summary>
    /// <remarks>Retail: CommandInterpreter::SendMovementEvent @0x006B4680.</remarks>
    public void SendMoveToState(double now)
    {
        report.OnMoveToState(now);
        MotionInterpreter motions = movement.Interpreter;
        MoveToState message = new(WireForms.Of(motions.Raw), WireForms.Of(body.Position), player.Sent, StandsOnGround,
            motions.StandingLongJump);
        server.Send(message, now);
        observer?.OnMoveToState(message, now);
    }

    /// <summary>The body has jumped: its velocity is that after the jump.</summary>
    public void SendJump(float extent, double now)
    {
        Jump message = new(extent, body.LocalVelocity, WireForms.Of(body.Position), player.Sent);
        server.Send(message, now);
        observer?.OnJump(message, now);
    }

    /// <summary>Where the body is, when that is due.</summary>
    /// <remarks>Retail: CommandInterpreter::SendPositionEvent @0x006B4770.</remarks>
    public void SendPositionWhenDue(double now)
    {
        if (report.IsDue(body, now)) SendPosition(now);
    }

    /// <summary>Where the body is, at once, as a correction asks for; nothing while it is in the air or nowhere.</summary>
    /// <remarks>Retail: CommandInterpreter::SendPositionEvent @0x006B4770; specification 08, 4.4, step 1.</remarks>
    public void SendCorrectedPosition(double now)
    {
        if (!PositionReport.CanBeTold(body)) return;
        report.OnPosition(body, now);
        SendPosition(now);
    }

    private void SendPosition(double now)
    {
        AutonomousPosition message = new(WireForms.Of(body.Position), player.Sent, Contact: true);
        server.Send(message, now);
        observer?.OnAutonomousPosition(message, now);
    }
}
