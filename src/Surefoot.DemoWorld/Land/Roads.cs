namespace Surefoot.DemoWorld.Land;

/// <summary>Which vertices of the land carry a road. Roads are drawn and keep scenery away; they never collide.</summary>
internal static class Roads
{
    /// <summary>Where the two main roads meet, in grid units.</summary>
    public const int CrossingColumn = 28, CrossingRow = 31;

    // Each step between corners is straight or diagonal, so neighbouring road vertices always touch.
    private static readonly (int X, int Y)[][] Lines =
    [
        [(8, 29), (10, 31), (CrossingColumn, CrossingRow), (46, CrossingRow), (50, 35), (50, 40)],
        [(CrossingColumn, 39), (CrossingColumn, CrossingRow), (CrossingColumn, 27), (25, 24), (25, 17), (22, 14)],
        [(46, CrossingRow), (49, 28), (49, 20), (47, 18), (47, 12)],
    ];

    /// <summary>Every road vertex, some of them more than once.</summary>
    public static IEnumerable<(int Column, int Row)> Vertices()
    {
        foreach (var line in Lines)
        {
            var (x, y) = line[0];
            yield return (x, y);
            foreach (var (toX, toY) in line.AsSpan(1).ToArray())
            {
                while (x != toX || y != toY)
                {
                    x += Math.Sign(toX - x);
                    y += Math.Sign(toY - y);
                    yield return (x, y);
                }
            }
        }
    }
}
