using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <content>What is done each quantum: turning, moving, arriving, giving up.</content>
internal sealed partial class MoveToManager
{
    private const double ProgressSeconds = 1.0;
    private const double LeastSpeed = 0.25;
    private const double SpeedWithoutNews = 0.1;
    private const double QuantumTolerance = 1.0;
    private const double HalfTurn = 180.0;

    /// <summary>The motion of the move or turn under way, as it was asked for; none between them.</summary>
    internal MotionCommand CurrentCommand { get; private set; }

    /// <summary>The turn made while moving.</summary>
    internal MotionCommand AuxCommand { get; private set; }

    /// <summary>The move leads away from the target.</summary>
    internal bool IsMovingAway { get; private set; }

    /// <summary>Quanta without progress; nobody acts on it, in retail neither.</summary>
    internal int StallCount { get; private set; }

    /// <summary>Distance and time of the last progress, metres and seconds.</summary>
    internal (float Distance, double Time) Previous { get; private set; }

    /// <summary>Distance and time of the beginning, metres and seconds.</summary>
    internal (float Distance, double Time) Original { get; private set; }

    /// <summary>Heading in the last quantum of a turn, degrees.</summary>
    internal float PreviousHeading { get; private set; }

    /// <summary>Hold key of the order; that of its move once it has begun.</summary>
    internal HoldKey HoldKey => mp.HoldKey;

    private float OwnHeading => (float)body.Position.Frame.Heading;

    /// <summary>A quantum of the order under way. Without contact nothing is looked at.</summary>
    /// <remarks>Retail: MoveToManager::UseTime @0x0052A780.</remarks>
    internal void UseTime()
    {
        if (!body.HasContact || nodes.Count == 0) return;
        if (topLevelId != 0 && IsMovingTo && !IsInitialised) return;
        if (nodes[0].IsMove) HandleMove();
        else HandleTurn();
    }

    /// <remarks>Retail: MoveToManager::HandleTurnToHeading @0x0052A0C0. A turn that is past ends exactly at its heading.</remarks>
    private void HandleTurn()
    {
        if (CurrentCommand is not (MotionCommand.TurnRight or MotionCommand.TurnLeft))
        {
            BeginTurn();
            return;
        }

        float own = OwnHeading, goal = nodes[0].Heading;
        if (Headings.IsPast(own, goal, CurrentCommand))
        {
            StallCount = 0;
            body.SetHeading(goal);
            nodes.Dequeue();
            MovementParameters p = ParametersOfStops();
            body.StopMotion(CurrentCommand, ref p);
            CurrentCommand = MotionCommand.None;
            BeginNextNode();
            return;
        }

        double turned = Headings.Difference(own, PreviousHeading, CurrentCommand);
        PreviousHeading = own;
        CountStall(turned > RetailMath.Epsilon && turned < HalfTurn);
    }

    /// <remarks>Retail: MoveToManager::HandleMoveToPosition @0x00529D80.</remarks>
    private void HandleMove()
    {
        // One set of parameters for the whole quantum: a left turn leaves its speed negative, and a run that ends in the same quantum is
        // then stopped under the name of the walk, which stops nothing. Retail's bodies run on as well.
        MovementParameters p = ParametersOfStops();
        p.Speed = mp.Speed;
        TurnOnTheWay(ref p);

        float distance = (float)GetCurrentDistance();
        bool progress = CheckProgress(distance);
        CountStall(progress);
        if (progress) ArriveOrGiveUp(distance, ref p);
        if (IsMovingTo && topLevelId != 0) LookFurtherAhead(distance);
    }

    private void TurnOnTheWay(ref MovementParameters p)
    {
        MotionCommand turn = MotionCommand.None;
        if (!body.MotionsPending)
        {
            Position here = body.Position;
            float wanted = Headings.Add(here.HeadingTo(currentTarget), MoveToChoice.FacingOffset(CurrentCommand, IsMovingAway));
            turn = Headings.TurnWhileMoving(wanted, here.Frame.Heading);
        }

        if (turn == MotionCommand.None)
        {
            StopAux(ref p);
        }
        else if (turn != AuxCommand)
        {
            body.DoMotion(turn, ref p);
            AuxCommand = turn;
        }
    }

    private void ArriveOrGiveUp(float distance, ref MovementParameters p)
    {
        if (IsMovingAway ? distance >= mp.MinDistance : distance <= mp.DistanceToObject)
        {
            nodes.Dequeue();
            body.StopMotion(CurrentCommand, ref p);
            CurrentCommand = MotionCommand.None;
            StopAux(ref p);
            BeginNextNode();
        }
        else if (start.DistanceTo(body.Position) > mp.FailDistance)
        {
            Cancel(MotionError.ChargedTooFar);
        }
    }

    private void StopAux(ref MovementParameters p)
    {
        if (AuxCommand == MotionCommand.None) return;
        body.StopMotion(AuxCommand, ref p);
        AuxCommand = MotionCommand.None;
    }

    /// <summary>The place of the tracked object is foretold as far ahead as the way still takes.</summary>
    private void LookFurtherAhead(float distance)
    {
        double speed = RetailMath.Length(body.AchievedVelocity);
        if (speed <= SpeedWithoutNews || body.TargetManager is not { } targets) return;
        double seconds = distance / speed;
        if (Math.Abs(seconds - targets.Quantum) > QuantumTolerance) targets.SetQuantum(seconds);
    }

    private void CountStall(bool progress)
    {
        if (progress) StallCount = 0;
        else if (!body.IsInterpolating && !body.MotionsPending) StallCount++;
    }

    /// <summary>A quarter of a metre a second, since the last progress and since the beginning; looked at after a second.</summary>
    /// <remarks>
    /// Retail: MoveToManager::CheckProgressMade @0x005290F0. Too little progress stores nothing: the rate asked for is then one over a
    /// longer time.
    /// </remarks>
    private bool CheckProgress(float distance)
    {
        double now = body.Now, elapsed = now - Previous.Time;
        if (elapsed <= ProgressSeconds) return true;
        if (Gain(Previous.Distance, distance) / elapsed < LeastSpeed) return false;
        Previous = (distance, now);
        return Gain(Original.Distance, distance) / (now - Original.Time) >= LeastSpeed;
    }

    private double Gain(float before, float now) => IsMovingAway ? (double)now - before : (double)before - now;

    /// <remarks>Retail: MoveToManager::GetCurrentDistance @0x005291B0.</remarks>
    private double GetCurrentDistance() => mp.Has(MovementFlags.UseSpheres)
        ? body.Position.CylinderDistance(body.Radius, body.Height, currentTarget, soughtRadius, soughtHeight)
        : body.Position.DistanceTo(currentTarget);

    private void ResetProgress(float distance) => Previous = Original = (distance, body.Now);

    private void AddProgressTo(ref StateHash hash)
    {
        hash.Add((uint)CurrentCommand);
        hash.Add((uint)AuxCommand);
        hash.Add(IsMovingAway ? 1UL : 0UL);
        hash.Add(IsInitialised ? 1UL : 0UL);
        hash.Add(Previous.Distance);
        hash.Add(Previous.Time);
        hash.Add(Original.Distance);
        hash.Add(Original.Time);
        hash.Add(PreviousHeading);
    }
}
