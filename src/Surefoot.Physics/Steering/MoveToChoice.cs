using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Steering;

/// <summary>How a body goes about a distance to its target.</summary>
/// <param name="Command">The motion; none when it is where it should be.</param>
/// <param name="Key">Walk or run.</param>
/// <param name="MovingAway">The motion leads away from the target.</param>
internal readonly record struct MoveToChoice(MotionCommand Command, HoldKey Key, bool MovingAway)
{
    /// <summary>What the parameters say about a distance, metres.</summary>
    /// <remarks>
    /// Retail: MovementParameters::get_command @0x0052AA00, towards_and_away @0x0052A9A0. A body that flees asks whether it is far, as one
    /// that approaches does.
    /// </remarks>
    internal static MoveToChoice Of(in MovementParameters p, float distance)
    {
        (MotionCommand command, bool away) = Direction(p, distance);
        bool far = (double)distance - p.DistanceToObject > p.WalkRunThreshold;
        bool run = p.Has(MovementFlags.CanCharge) || (p.Has(MovementFlags.CanRun) && (far || !p.Has(MovementFlags.CanWalk)));
        return new MoveToChoice(command, run ? HoldKey.Run : HoldKey.None, away);
    }

    /// <summary>What to add to the direction of the target to face the right way, degrees.</summary>
    /// <remarks>Retail: MovementParameters::get_desired_heading @0x0052AAD0.</remarks>
    internal static float FacingOffset(MotionCommand command, bool movingAway) => command switch
    {
        MotionCommand.WalkForward or MotionCommand.RunForward => movingAway ? 180f : 0f,
        MotionCommand.WalkBackwards => movingAway ? 0f : 180f,
        _ => 0f,
    };

    private static (MotionCommand Command, bool Away) Direction(in MovementParameters p, float distance)
    {
        bool away = p.Has(MovementFlags.MoveAway), towards = p.Has(MovementFlags.MoveTowards);
        if (away && !towards) return distance < p.MinDistance ? (MotionCommand.WalkForward, true) : default;
        if (distance > p.DistanceToObject) return (MotionCommand.WalkForward, false);
        return away && (double)distance - p.MinDistance < RetailMath.Epsilon ? (MotionCommand.WalkBackwards, true) : default;
    }
}
