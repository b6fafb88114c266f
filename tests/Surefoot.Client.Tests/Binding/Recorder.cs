using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>Keeps what the client sent.</summary>
internal sealed class Recorder : IMovementObserver
{
    internal List<SentMove> Moves { get; } = [];

    internal List<SentJump> Jumps { get; } = [];

    internal List<SentPosition> Positions { get; } = [];

    public void OnMoveToState(in MoveToState message, double now) => Moves.Add(new SentMove(now, message));

    public void OnJump(in Jump message, double now) => Jumps.Add(new SentJump(now, message));

    public void OnAutonomousPosition(in AutonomousPosition message, double now) => Positions.Add(new SentPosition(now, message));
}

/// <summary>A MoveToState and when it was sent.</summary>
internal readonly record struct SentMove(double Time, MoveToState Message)
{
    internal SentState State => new(Message.Motion);

    internal bool Contact => Message.Contact;

    internal bool StandingLongJump => Message.StandingLongJump;
}

/// <summary>What a MoveToState asks, in the words of the physics.</summary>
internal readonly record struct SentState(WireRawMotion Motion)
{
    internal HoldKey CurrentHoldKey => (HoldKey)Motion.CurrentHoldKey;

    internal MotionCommand ForwardCommand => (MotionCommand)Motion.ForwardCommand;

    internal HoldKey ForwardHoldKey => (HoldKey)Motion.ForwardHoldKey;

    internal float ForwardSpeed => Motion.ForwardSpeed;

    internal MotionCommand TurnCommand => (MotionCommand)Motion.TurnCommand;

    internal HoldKey TurnHoldKey => (HoldKey)Motion.TurnHoldKey;

    internal float TurnSpeed => Motion.TurnSpeed;
}

/// <summary>A Jump and when it was sent.</summary>
internal readonly record struct SentJump(double Time, Jump Message)
{
    internal float Extent => Message.Extent;

    internal Vector3 Velocity => Message.Velocity;
}

/// <summary>An AutonomousPosition and when it was sent.</summary>
internal readonly record struct SentPosition(double Time, AutonomousPosition Message)
{
    internal WirePosition Position => Message.Position;

    internal bool Contact => Message.Contact;
}
