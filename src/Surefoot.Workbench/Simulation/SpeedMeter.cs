using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// Speed over ground as a person reads it. Ground movement is handed out in whole animation frames (specification 01b, section 2), so the
/// speed of one tick jumps between two or three values; over half a second it is the speed that the formula says.
/// </summary>
internal sealed class SpeedMeter
{
    private const double Window = 0.5;

    private readonly Queue<(double Time, double Way)> marks = [];
    private Position last;
    private double way;

    /// <summary>Forgets the way so far, after a teleport.</summary>
    public void Reset() => marks.Clear();

    /// <summary>The speed when a tick ends here, metres a second.</summary>
    /// <param name="time">End of the tick, seconds; not before the last one.</param>
    /// <param name="position">Where it ends.</param>
    public float At(double time, in Position position)
    {
        if (marks.Count > 0)
        {
            Vector3 leg = last.OffsetTo(position);
            way += Math.Sqrt((leg.X * (double)leg.X) + (leg.Y * (double)leg.Y));
        }

        last = position;
        marks.Enqueue((time, way));
        while (marks.Count > 2 && marks.Peek().Time < time - Window) marks.Dequeue();
        (double startTime, double startWay) = marks.Peek();
        return time > startTime ? (float)((way - startWay) / (time - startTime)) : 0f;
    }
}
