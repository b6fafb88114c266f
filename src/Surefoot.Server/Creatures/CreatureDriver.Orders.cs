using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <content>The orders that goals become: for the body and, as messages, for the clients' bodies.</content>
public sealed partial class CreatureDriver
{
    private readonly InterpretedMotionState standing = new();

    private ushort Style => (ushort)movement.Motions.Style;

    /// <summary>Goes about the goal: the body is ordered as clients will order theirs when they hear of it.</summary>
    private void Begin()
    {
        outrunFrom = Gap(Sought) + options.FollowSlack;
        Progress = CreatureProgress.Moving;
        Body.SetActive(true);
        MovementData order = OrderOf(Sought);
        goesByItself = order.Type != MovementType.InterpretedMotion;
        Obey(order);
        listener.OnMotion(this, messages.Motion(order));
        // Who takes hold again has not been anywhere.
        if (!(hasArrived && Goal == CreatureGoal.Stick)) watch.Begin(engine.Now);
    }

    private MovementData OrderOf(in Position sought) => Goal switch
    {
        CreatureGoal.FaceObject => MovementData.TurnToObject(
            Style, TargetId, Body.Position.HeadingTo(sought), (uint)MovementFlags.Default, 1, 0),
        CreatureGoal.FaceHeading => MovementData.TurnToHeading(Style, (uint)MovementFlags.Default, 1, heading),
        CreatureGoal.Place or CreatureGoal.Home =>
            MovementData.MoveToPosition(Style, sought.CellId, sought.Frame.Origin, Way(sought), options.RunRate),
        CreatureGoal.Stick when Gap(sought) <= options.Reach + options.FollowSlack =>
            MovementData.Motion(Style, new WireInterpretedMotion(style: Style), TargetId),
        _ => MovementData.MoveToObject(Style, TargetId, sought.CellId, sought.Frame.Origin, Way(sought), options.RunRate),
    };

    private MoveToParams Way(in Position sought)
    {
        MovementFlags flags = MovementFlags.Default;
        if (options.WalkWithin == 0 || charges || Goal == CreatureGoal.Flee) flags |= MovementFlags.CanCharge;
        if (Goal == CreatureGoal.Flee) flags = (flags & ~MovementFlags.MoveTowards) | MovementFlags.MoveAway;
        if (Goal == CreatureGoal.Stick) flags |= MovementFlags.Sticky;
        if (Goal == CreatureGoal.Home) flags |= MovementFlags.UseFinalHeading;
        float final = Goal == CreatureGoal.Home ? (float)sought.Frame.Heading : 0;
        float least = Goal == CreatureGoal.Flee ? options.FleeDistance : 0;
        return new MoveToParams((uint)flags, options.Reach, least, float.MaxValue, 1, options.WalkWithin, final);
    }

    private void Obey(in MovementData order)
    {
        MovementParameters way = new()
        {
            Flags = (MovementFlags)order.Parameters.Bits,
            DistanceToObject = order.Parameters.DistanceToObject,
            MinDistance = order.Parameters.MinDistance,
            FailDistance = order.Parameters.FailDistance,
            Speed = order.Parameters.Speed,
            WalkRunThreshold = order.Parameters.WalkRunThreshold,
            DesiredHeading = order.Parameters.DesiredHeading,
        };
        MotionCommand style = movement.Motions.Style;
        Position there = new(order.Cell, order.Origin);
        switch (order.Type)
        {
            case MovementType.MoveToObject:
                movement.ApplyMoveToObject(style, order.Target, there, way, order.RunRate, autonomous: false);
                break;
            case MovementType.MoveToPosition:
                movement.ApplyMoveToPosition(style, there, way, order.RunRate, autonomous: false);
                break;
            case MovementType.TurnToObject:
                movement.ApplyTurnToObject(style, order.Target, order.DesiredHeading, way, autonomous: false);
                break;
            case MovementType.TurnToHeading:
                movement.ApplyTurnToHeading(style, way, autonomous: false);
                break;
            default:
                standing.CurrentStyle = style;
                movement.ApplyUpdate(standing, autonomous: false, stickTo: order.Target);
                break;
        }
    }

    /// <summary>Whatever it does ends, for clients too.</summary>
    private void Stand()
    {
        MovementData order = MovementData.Motion(Style, new WireInterpretedMotion(style: Style));
        Obey(order);
        listener.OnMotion(this, messages.Motion(order));
        TellPosition(engine.Now);
    }

    /// <summary>The target has moved so far that the goal is no longer reached.</summary>
    private bool IsToGoOn()
    {
        double gap = Gap(Sought);
        return Goal switch
        {
            // Who sticks lets go after a second, and takes hold again.
            CreatureGoal.Stick => Body.StickyObjectId == 0,
            CreatureGoal.Flee => gap < options.FleeAgainWithin * options.FleeDistance,
            _ => gap > options.Reach + options.FollowSlack,
        };
    }

    /// <summary>
    /// What it walks after gets away from it. Walking or running is chosen once, when a move begins (specification 09b, 4.2), so that
    /// another order is needed: one to run whatever the distance.
    /// </summary>
    private bool IsOutrun() =>
        !charges && Goal is CreatureGoal.Object or CreatureGoal.Follow or CreatureGoal.Stick && Gap(Sought) > outrunFrom;

    /// <summary>Metres from surface to surface.</summary>
    private double Gap(in Position sought) =>
        Body.Position.DistanceTo(sought) - ((double)Body.Radius + (engine.Find(TargetId)?.Radius ?? 0));
}
