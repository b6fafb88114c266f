using System.Numerics;

namespace Surefoot.Tool.Walking;

/// <summary>The body after one quantum of a scripted walk.</summary>
/// <param name="Time">Seconds since the start.</param>
/// <param name="CellId">Cell.</param>
/// <param name="Local">Origin in the landblock, metres.</param>
/// <param name="Map">Origin on the map: metres east and north of the map's corner, and up.</param>
/// <param name="Speed">Achieved speed over the ground plane, m/s.</param>
/// <param name="Heading">Compass heading, degrees.</param>
/// <param name="OnWalkable">Stands on a plane that can be walked on.</param>
/// <param name="HasContact">Touches a plane.</param>
/// <param name="Charge">Jump charge, 0 to 1.</param>
internal sealed record WalkSample(
    double Time, uint CellId, Vector3 Local, Vector3 Map, double Speed, double Heading, bool OnWalkable, bool HasContact, double Charge);

/// <summary>Something that happened on the way.</summary>
/// <param name="Time">Seconds since the start.</param>
/// <param name="What">In words.</param>
internal sealed record WalkEvent(double Time, string What);

/// <summary>A scripted walk, done.</summary>
/// <param name="Place">Where it began.</param>
/// <param name="Script">What the hands did.</param>
/// <param name="RunSkill">Run skill.</param>
/// <param name="JumpSkill">Jump skill.</param>
/// <param name="Samples">One a quantum, the start first.</param>
/// <param name="Events">What happened.</param>
internal sealed record WalkResult(
    string Place, string Script, int RunSkill, int JumpSkill, IReadOnlyList<WalkSample> Samples, IReadOnlyList<WalkEvent> Events)
{
    /// <summary>Length of the way over ground, metres.</summary>
    internal double Distance
    {
        get
        {
            double sum = 0;
            for (int i = 1; i < Samples.Count; i++)
            {
                Vector3 d = Samples[i].Map - Samples[i - 1].Map;
                sum += Math.Sqrt(((double)d.X * d.X) + ((double)d.Y * d.Y));
            }

            return sum;
        }
    }

    /// <summary>Way over ground divided by time, m/s.</summary>
    internal double MeanSpeed => Samples[^1].Time > 0 ? Distance / Samples[^1].Time : 0;

    /// <summary>Highest speed, m/s.</summary>
    internal double TopSpeed => Samples.Max(s => s.Speed);
}
