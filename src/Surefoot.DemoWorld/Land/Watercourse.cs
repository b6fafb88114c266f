namespace Surefoot.DemoWorld.Land;

/// <summary>A line across the land with a height at every point: the river. Grid units (cells of 24 m), heights in metres.</summary>
/// <param name="points">Corners from source to mouth.</param>
internal sealed class Watercourse(params (double X, double Y, double Level)[] points)
{
    /// <summary>The river of the demo land: from the northern hills along the west, through the lake, to the south coast.</summary>
    public static Watercourse River { get; } = new(
        (13, 58, 40), (9, 53, 34), (5, 47, 28), (4, 40, 21), (3, 34, 17.5), (5, 27, 15.5), (8, 22, 14), (11, 18, 12.5), (14, 14, 12),
        (16.5, 9, 12), (18, 6, 9), (18.5, 3, 4), (20, -1, 0));

    /// <summary>Distance in cells to the nearest point of the line, and the line's height there.</summary>
    public (double Distance, double Level) Nearest(double x, double y)
    {
        double best = double.MaxValue, level = 0;
        for (int i = 0; i + 1 < points.Length; i++)
        {
            var (ax, ay, aLevel) = points[i];
            var (bx, by, bLevel) = points[i + 1];
            double dx = bx - ax, dy = by - ay;
            double t = Math.Clamp((((x - ax) * dx) + ((y - ay) * dy)) / ((dx * dx) + (dy * dy)), 0.0, 1.0);
            double ox = x - (ax + (t * dx)), oy = y - (ay + (t * dy));
            double distance = Math.Sqrt((ox * ox) + (oy * oy));
            if (distance < best)
                (best, level) = (distance, ValueNoise.Lerp(aLevel, bLevel, t));
        }

        return (best, level);
    }

    /// <summary>The point at a share (0 source, 1 mouth) of the corners' count.</summary>
    public (double X, double Y) Along(double share)
    {
        double place = share * (points.Length - 1);
        int i = Math.Min((int)place, points.Length - 2);
        double t = place - i;
        return (ValueNoise.Lerp(points[i].X, points[i + 1].X, t), ValueNoise.Lerp(points[i].Y, points[i + 1].Y, t));
    }
}
