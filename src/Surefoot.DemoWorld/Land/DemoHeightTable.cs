using System.Collections.Immutable;

namespace Surefoot.DemoWorld.Land;

/// <summary>The 256 heights that a height byte of the demo land selects, in metres, ascending from 0 to 800.</summary>
/// <remarks>
/// Half-metre steps where one walks, growing steps up in the mountains, and the exact heights that the test slopes
/// need: with steps of 2 metres over 24-metre cells no slope could have the angle that its name promises.
/// </remarks>
internal static class DemoHeightTable
{
    private const int Entries = 256;
    private const double FineTop = 64.0;
    private const double Top = 800.0;

    /// <summary>The table as the region record carries it.</summary>
    public static ImmutableArray<float> Heights { get; } = Build();

    /// <summary>Index of the entry nearest to a height; the lower of two equally near.</summary>
    public static byte Nearest(double height)
    {
        int above = 0;
        while (above < Entries - 1 && Heights[above] < height)
            above++;
        if (above > 0 && height - Heights[above - 1] <= Heights[above] - height)
            above--;
        return (byte)above;
    }

    private static ImmutableArray<float> Build()
    {
        var heights = new SortedSet<float>();
        for (int step = 0; step < FineTop * 2; step++)
            heights.Add(step * 0.5f);
        foreach (var slope in SlopeYard.Slopes)
            heights.Add(slope.TopHeight);

        // The rest rises quadratically from the fine part to the top: n entries, the first half a metre above the fine part.
        int rest = Entries - heights.Count;
        double last = FineTop - 0.5;
        double growth = (Top - last - (0.5 * rest)) / ((double)rest * rest);
        for (int k = 1; k < rest; k++)
            heights.Add((float)(last + (0.5 * k) + (growth * k * k)));
        heights.Add((float)Top);
        return [.. heights];
    }
}
