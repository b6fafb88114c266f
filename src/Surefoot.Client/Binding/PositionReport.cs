using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Client;

/// <summary>Decides when the server is told where the body is.</summary>
/// <remarks>Retail: CommandInterpreter::ShouldSendPositionEvent @0x006B45E0; specification 08, 5.6 and 09b, 9.8.</remarks>
internal struct PositionReport
{
    private const double Interval = 1.0;

    private double lastTime;
    private Position lastPosition;
    private Plane lastPlane;

    /// <summary>Nothing was told yet.</summary>
    public PositionReport(double now)
    {
        lastTime = now;
        lastPosition = Position.Nowhere;
        lastPlane = default;
    }

    /// <summary>Something else that holds the position was sent.</summary>
    public void OnMoveToState(double now) => lastTime = now;

    /// <summary>The position is sent.</summary>
    public void OnPosition(IMotionBody body, double now) =>
        (lastTime, lastPosition, lastPlane) = (now, body.Position, body.ContactPlane);

    /// <summary>It stands on ground, at a place that is one.</summary>
    public static bool CanBeTold(IMotionBody body) =>
        body.HasContact && body.OnWalkable && body.Position.CellId != 0 && body.Position.Frame.IsValid;

    /// <summary>True when the position is to be sent now; it then counts as sent.</summary>
    public bool IsDue(IMotionBody body, double now)
    {
        if (!CanBeTold(body)) return false;
        Position position = body.Position;
        bool changed = position.CellId != lastPosition.CellId ||
                       (now > lastTime + Interval
                           ? !Frame.NearlyEqual(position.Frame, lastPosition.Frame)
                           : PlaneDiffers(body.ContactPlane));
        if (changed) OnPosition(body, now);
        return changed;
    }

    private readonly bool PlaneDiffers(in Plane plane) =>
        !RetailMath.NearlyEqual(plane.Normal, lastPlane.Normal) || Math.Abs((double)plane.D - lastPlane.D) >= RetailMath.Epsilon;
}
