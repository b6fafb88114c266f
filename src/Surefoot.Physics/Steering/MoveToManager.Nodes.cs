using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Steering;

/// <content>The queue of turns and moves, and how each is begun.</content>
internal sealed partial class MoveToManager
{
    private void AddTurn(float heading) => nodes.Enqueue(new MoveToNode(IsMove: false, heading));

    private void AddMove() => nodes.Enqueue(new MoveToNode(IsMove: true, 0));

    /// <summary>Begins what is next; after the last everything stops, and a sticky order sticks.</summary>
    /// <remarks>Retail: MoveToManager::BeginNextNode @0x00529CB0.</remarks>
    private void BeginNextNode()
    {
        if (nodes.Count > 0)
        {
            if (nodes[0].IsMove) BeginMove();
            else BeginTurn();
            return;
        }

        (bool sticky, uint id, float radius) = (mp.Has(MovementFlags.Sticky), topLevelId, soughtRadius);
        Finish();
        if (sticky) body.MakePositionManager().StickTo(id, radius);
    }

    /// <summary>Walks or runs; the choice holds until the move ends. It does not wait for pending motions.</summary>
    /// <remarks>Retail: MoveToManager::BeginMoveForward @0x00529A00.</remarks>
    private void BeginMove()
    {
        float distance = (float)GetCurrentDistance();
        MoveToChoice choice = MoveToChoice.Of(mp, distance);
        if (choice.Command == MotionCommand.None)
        {
            nodes.Dequeue();
            BeginNextNode();
            return;
        }

        MovementParameters p = Fresh();
        (p.Speed, p.HoldKey) = (mp.Speed, choice.Key);
        MotionError error = body.DoMotion(choice.Command, ref p);
        if (error != MotionError.None)
        {
            Cancel(error);
            return;
        }

        CurrentCommand = choice.Command;
        IsMovingAway = choice.MovingAway;
        mp.HoldKey = choice.Key;
        ResetProgress(distance);
    }

    /// <summary>Turns the short way; waits while motions are pending.</summary>
    /// <remarks>
    /// Retail: MoveToManager::BeginTurnToHeading @0x00529B90. The previous heading begins as a difference, in retail too.
    /// </remarks>
    private void BeginTurn()
    {
        if (body.MotionsPending) return;
        MotionCommand turn = Headings.TurnTo(nodes[0].Heading, OwnHeading, out float difference);
        if (turn == MotionCommand.None)
        {
            nodes.Dequeue();
            BeginNextNode();
            return;
        }

        MovementParameters p = Fresh();
        (p.Speed, p.HoldKey) = (mp.Speed, mp.HoldKey);
        MotionError error = body.DoMotion(turn, ref p);
        if (error != MotionError.None)
        {
            Cancel(error);
            return;
        }

        CurrentCommand = turn;
        PreviousHeading = difference;
    }

    /// <summary>Defaults that end no move-to: this one is what asks. The interpreted state follows it, the raw state does not.</summary>
    private static MovementParameters Fresh()
    {
        MovementParameters p = new();
        p.Flags &= ~MovementFlags.CancelMoveTo;
        return p;
    }

    private MovementParameters ParametersOfStops()
    {
        MovementParameters p = Fresh();
        p.HoldKey = mp.HoldKey;
        return p;
    }
}
