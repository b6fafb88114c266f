using System.Collections.Immutable;

namespace Surefoot.DemoWorld.Land;

/// <summary>A row of straight slopes of exact steepness, side by side at the north edge of the meadow, each rising north.</summary>
/// <remarks>
/// One cell long (24 m on the map) and two cells wide; a third, twisted cell leads over to the next slope. In front lies
/// flat meadow, behind a terrace. The steepest slope that a body can stand on has 48.38 degrees (normal z 0.66417414).
/// </remarks>
internal static class SlopeYard
{
    /// <summary>Grid row of the feet of the slopes.</summary>
    public const int FootRow = 40;

    /// <summary>Grid columns from one slope to the next.</summary>
    public const int Pitch = 3;

    /// <summary>Grid column of the first slope's west edge.</summary>
    public const int FirstColumn = 10;

    /// <summary>Column of the last slope's east edge.</summary>
    public static int LastColumn => FirstColumn + (Pitch * (Slopes.Length - 1)) + 2;

    /// <summary>The slopes from west to east.</summary>
    public static ImmutableArray<YardSlope> Slopes { get; } =
        [.. new[] { 15.0, 30.0, 40.0, 45.0, 46.0, 47.0, 47.9, 48.3, 48.5, 50.0, 55.0, 60.0 }
            .Select((degrees, place) => new YardSlope(degrees, FirstColumn + (Pitch * place)))];

    /// <summary>Height of the yard at a vertex, and how far it decides there (0 not at all, 1 alone).</summary>
    public static (double Height, double Weight) At(int column, int row)
    {
        double side = Math.Max(Math.Max(FirstColumn - column, column - LastColumn), 0);
        double weight = 1.0 - ValueNoise.Step(0.0, 3.0, side);
        int place = Math.Clamp((column - FirstColumn) / Pitch, 0, Slopes.Length - 1);
        double height = row <= FootRow ? Landform.MeadowHeight : Slopes[place].TopHeight;
        weight *= row <= FootRow
            ? ValueNoise.Step(FootRow - 5.0, FootRow - 3.0, row)
            : 1.0 - ValueNoise.Step(FootRow + 2.0, FootRow + 8.0, row);
        return (height, weight);
    }
}

/// <summary>One slope of the yard.</summary>
/// <param name="Degrees">Steepness against the horizontal.</param>
/// <param name="Column">Grid column of its west edge; it is two cells wide.</param>
internal readonly record struct YardSlope(double Degrees, int Column)
{
    /// <summary>Height of its upper edge (m); one entry of the height table.</summary>
    public float TopHeight => (float)(Landform.MeadowHeight + (Landform.CellSide * Math.Tan(Degrees * Math.PI / 180.0)));

    /// <summary>Name for places: "slope-46", "slope-47-9".</summary>
    public string Name => FormattableString.Invariant($"slope-{Degrees}").Replace('.', '-');
}
