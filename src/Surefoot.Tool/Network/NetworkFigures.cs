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
/// <param name="InSolid">Where that test found it inside something.</param>
/// <param name="WithoutFaces">
/// Frames in which it could not have been put where it was, though it touched no face: sweeps lead there too.
/// </param>
/// <param name="Blips">How often it was put somewhere instead of going there.</param>
/// <param name="PlacesReached">How often the runner got where its hands wanted it.</param>
/// <param name="Jumps">How often it jumped.</param>
/// <param name="Climbed">Metres that it went up without jumping.</param>
/// <param name="Messages">Messages about it.</param>
/// <param name="Resent">Packets that were sent again.</param>
/// <param name="Seconds">How long it ran.</param>
internal sealed record NetworkFigures(
    int Frames, IReadOnlyList<RestDistance> AtRest, double[] OffPath, int Judged, IReadOnlyList<string> InSolid, int WithoutFaces,
    long Blips, int PlacesReached, int Jumps, double Climbed, long Messages, long Resent, double Seconds)
{
    /// <summary>Retail's own tolerance, metres: a place so near counts as reached (specification 09, 3.2).</summary>
    internal const double RestLimit = 0.05;

    /// <summary>The distance from the path that all but a twentieth of frames keep, metres.</summary>
    internal const double PathLimit = 1;

    /// <summary>
    /// The share of rests that may be a step apart, given up or under way, all together: where retail's own rules have a body. One may in
    /// any run: ten minutes have some twenty rests.
    /// </summary>
    internal const double ExcusedShare = 0.02;

    internal double MeanOffPath => OffPath.Length > 0 ? OffPath.Average() : 0;

    internal double MaxOffPath => OffPath.Length > 0 ? OffPath[^1] : 0;

    /// <summary>The distance that 95 of 100 frames do not exceed.</summary>
    internal double P95OffPath => OffPath.Length > 0 ? OffPath[(int)Math.Ceiling(0.95 * OffPath.Length) - 1] : 0;

    /// <summary>The farthest at rest, those left out that are a step apart, given up or under way; metres.</summary>
    internal double WorstAtRest => AtRest.Where(one => !one.IsExcused).Select(one => one.Distance).DefaultIfEmpty().Max();

    /// <summary>How often it stood where it was to be, but a step higher or lower.</summary>
    internal int StepsApart => AtRest.Count(one => one.IsAStepApart);

    /// <summary>How often it stood within 0.2 m, and something was in the way.</summary>
    internal int GivenUp => AtRest.Count(one => one.IsGivenUp);

    /// <summary>How often it was still following places that it had been told before.</summary>
    internal int UnderWay => AtRest.Count(one => one.IsUnderWay);

    /// <summary>How many may be a step apart, given up or under way: one, or 2 % of the rests if that is more.</summary>
    internal int MostExcused => Math.Max(1, (int)(ExcusedShare * AtRest.Count));

    internal double BlipsAnHour => Blips * 3600 / Seconds;

    /// <summary>Everything is as near as it is to be.</summary>
    internal bool IsGood =>
        WorstAtRest <= RestLimit && AtRest.Count(one => one.IsExcused) <= MostExcused && InSolid.Count == 0 && P95OffPath < PathLimit;
}

/// <summary>How far a body that stands is from where it was told to be.</summary>
/// <param name="OverGround">Metres over ground.</param>
/// <param name="Height">Metres up to where it was told to be.</param>
/// <param name="Follows">It has places yet to follow.</param>
internal readonly record struct RestDistance(double OverGround, double Height, bool Follows = false)
{
    /// <summary>What a human steps down without leaving the ground, metres.</summary>
    private const double MostStep = 0.6;

    private const double QuietLimit = 0.2;

    internal double Distance => Math.Sqrt((OverGround * OverGround) + (Height * Height));

    /// <summary>
    /// It stands where it was told to, on another step: who climbed there stands on the edge of the next step already, who is put there on
    /// the one below, as a placement takes the floor within the step-down height (specification 03, 4.9). Following a place right above
    /// does not lift who stands: the way is bent along the floor (03, 4.6).
    /// </summary>
    internal bool IsAStepApart =>
        OverGround <= NetworkFigures.RestLimit && Math.Abs(Height) is > NetworkFigures.RestLimit and <= MostStep;

    /// <summary>
    /// The way was blocked, by the edge of a step as a rule: nearer than 0.2 m a place that is not got nearer to counts as reached
    /// (specification 09, 3.2, step 5, and 6.4 d).
    /// </summary>
    internal bool IsGivenUp => !IsAStepApart && Distance is > NetworkFigures.RestLimit and < QuietLimit;

    /// <summary>
    /// It is on its way: places are followed in the order in which they were told, and none in the air. Who had not got to where it took
    /// off goes back there when it has landed, and only then to where it is to be (specification 09, 3.2 and 4.4).
    /// </summary>
    internal bool IsUnderWay => Follows && !IsAStepApart && Distance >= QuietLimit;

    /// <summary>Retail's own rules have it elsewhere.</summary>
    internal bool IsExcused => IsAStepApart || IsGivenUp || IsUnderWay;
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
