using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Network;

/// <summary>How near to a runner it was drawn.</summary>
/// <param name="Frames">Frames in which it was drawn.</param>
/// <param name="AtRest">
/// How far it was from the place that the runner reported last, two seconds after the report arrived, once for each report that was
/// followed by none.
/// </param>
/// <param name="OffPath">Metres from the nearest point of the runner's path of the last second, one a frame, least first.</param>
/// <param name="Judged">Frames in which retail's placement test was asked about where it was drawn.</param>
/// <param name="InSolid">
/// Where that test found it inside something, touching a face or put there; see <see cref="SolidTest"/>.
/// </param>
/// <param name="Swept">How often it found it so where its own sweep led, touching no face.</param>
/// <param name="Blips">How often it was put somewhere instead of going there.</param>
/// <param name="PlacesReached">How often the runner got where its hands wanted it.</param>
/// <param name="Jumps">How often it jumped.</param>
/// <param name="Climbed">Metres that it went up without jumping.</param>
/// <param name="Messages">Messages about it.</param>
/// <param name="Resent">Packets that were sent again.</param>
/// <param name="Seconds">How long it ran.</param>
internal sealed record NetworkFigures(
    int Frames, IReadOnlyList<RestDistance> AtRest, double[] OffPath, int Judged, IReadOnlyList<string> InSolid, int Swept,
    long Blips, int PlacesReached, int Jumps, double Climbed, long Messages, long Resent, double Seconds)
{
    /// <summary>Retail's own tolerance, metres: a place so near counts as reached (specification 09, 3.2).</summary>
    internal const double RestLimit = 0.05;

    /// <summary>The distance from the path that all but a twentieth of frames keep, metres.</summary>
    internal const double PathLimit = 1;

    /// <summary>
    /// The share of rests that may be a step apart or blocked, where retail's own placement or sweep has a body. Three may in any run: ten
    /// minutes have some twenty rests.
    /// </summary>
    internal const double ExcusedShare = 0.02;

    private const int MostExcusedInShort = 3;

    internal double MeanOffPath => OffPath.Length > 0 ? OffPath.Average() : 0;

    internal double MaxOffPath => OffPath.Length > 0 ? OffPath[^1] : 0;

    /// <summary>The distance that 95 of 100 frames do not exceed.</summary>
    internal double P95OffPath => OffPath.Length > 0 ? OffPath[(int)Math.Ceiling(0.95 * OffPath.Length) - 1] : 0;

    /// <summary>The farthest at rest, those left out that are a step apart or blocked; metres.</summary>
    internal double WorstAtRest => AtRest.Where(one => !one.IsExcused).Select(one => one.Distance).DefaultIfEmpty().Max();

    /// <summary>How often it stood where retail's placement puts who is told to be there, and that is elsewhere.</summary>
    internal int StepsApart => AtRest.Count(one => one.IsAStepApart);

    /// <summary>How often it stood within 0.2 m, and retail's sweep leads no nearer.</summary>
    internal int Blocked => AtRest.Count(one => one.IsBlocked);

    /// <summary>How many may be a step apart or blocked: three, or 2 % of the rests if that is more.</summary>
    internal int MostExcused => Math.Max(MostExcusedInShort, (int)(ExcusedShare * AtRest.Count));

    internal double BlipsAnHour => Blips * 3600 / Seconds;

    /// <summary>Everything is as near as it is to be.</summary>
    internal bool IsGood =>
        WorstAtRest <= RestLimit && StepsApart + Blocked <= MostExcused && InSolid.Count == 0 && P95OffPath < PathLimit;
}

/// <summary>How far a body that stands is from where it was told to be.</summary>
/// <param name="Distance">Metres.</param>
/// <param name="FromPut">Metres from where retail's placement puts a body that is to be at the place told.</param>
/// <param name="WhenSwept">Metres from the place told to where the body's own sweep to it ends.</param>
internal readonly record struct RestDistance(double Distance, double FromPut, double WhenSwept)
{
    private const double QuietLimit = 0.2;

    /// <summary>A human's step, up or down to the next one, metres: nobody is a step apart who is farther away.</summary>
    private const double StepLimit = 0.6;

    /// <summary>
    /// It stands exactly where it would have been put, and that is not the place told: who climbed a stair stands on the edge of the next
    /// step already, who is put there on the one below, as a placement takes the floor within the step-down height (specification 03, 4.9).
    /// Following a place right above does not lift who stands: the way is bent along the floor (03, 4.6), and a place that cannot be got
    /// nearer to ends in a placement (09, 3.2).
    /// </summary>
    internal bool IsAStepApart =>
        Distance is > NetworkFigures.RestLimit and <= StepLimit && FromPut <= NetworkFigures.RestLimit;

    /// <summary>
    /// It cannot get nearer: who ran against a wall keeps the wall's normal for the next sweep, which is bent along it though there is a
    /// step's room left (03, 4.6), and nearer than 0.2 m a place that is not got nearer to counts as reached (09, 3.2, step 5, and 6.4 d).
    /// </summary>
    internal bool IsBlocked =>
        !IsAStepApart && Distance is > NetworkFigures.RestLimit and < QuietLimit && WhenSwept > NetworkFigures.RestLimit;

    /// <summary>Retail's own rules have it elsewhere.</summary>
    internal bool IsExcused => IsAStepApart || IsBlocked;
}

/// <summary>The way of a body in its last second.</summary>
internal sealed class RecentPath
{
    private const double Length = 1.0;

    private readonly Queue<(double Time, Position Place)> points = new();

    /// <summary>The body is somewhere.</summary>
    internal void Add(in Position place, double now)
    {
        points.Enqueue((now, place));
        while (points.Peek().Time < now - Length) points.Dequeue();
    }

    /// <summary>Metres from a place to the nearest point of the way, between its points too.</summary>
    internal double DistanceTo(in Position place)
    {
        double least = double.MaxValue;
        Vector3? before = null;
        foreach ((_, Position point) in points)
        {
            Vector3 offset = place.OffsetTo(point);
            least = Math.Min(least, before is { } from ? DistanceToLine(from, offset) : offset.Length());
            before = offset;
        }

        return least;
    }

    /// <summary>Distance of the origin from a straight line between two points.</summary>
    private static double DistanceToLine(Vector3 from, Vector3 to)
    {
        Vector3 line = to - from;
        float square = line.LengthSquared();
        return square == 0 ? from.Length() : (from + (line * Math.Clamp(-Vector3.Dot(from, line) / square, 0, 1))).Length();
    }
}
