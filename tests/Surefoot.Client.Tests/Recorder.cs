namespace Surefoot.Client.Tests;

/// <summary>Keeps what the client would send.</summary>
internal sealed class Recorder : IMovementSink
{
    internal List<MoveToStateEvent> Moves { get; } = [];

    internal List<JumpEvent> Jumps { get; } = [];

    internal List<AutonomousPositionEvent> Positions { get; } = [];

    public void OnMoveToState(in MoveToStateEvent e) => Moves.Add(e);

    public void OnJump(in JumpEvent e) => Jumps.Add(e);

    public void OnAutonomousPosition(in AutonomousPositionEvent e) => Positions.Add(e);
}
