using static Surefoot.DemoWorld.Land.ValueNoise;

namespace Surefoot.DemoWorld.Land;

/// <summary>The shape of the land before it is rounded to the height table: height and cover of each grid vertex.</summary>
/// <remarks>
/// Grid units are cells of 24 m counted from the south-west corner of the land (the sea around it not included), so the
/// land spans 0 to 64 on both axes. Features are laid over each other from coarse to fine; those at the end win.
/// </remarks>
internal sealed class Landform(uint seed)
{
    /// <summary>Side of a cell (m).</summary>
    public const double CellSide = 24.0;

    /// <summary>Cells a side of the whole land.</summary>
    public const int Side = 64;

    /// <summary>Height of the flat meadow (m).</summary>
    public const double MeadowHeight = 20.0;

    /// <summary>Height of the lake's water (m).</summary>
    public const double LakeHeight = 12.0;

    /// <summary>Middle of the lake.</summary>
    public const double LakeX = 15.0, LakeY = 13.0;

    /// <summary>South-west vertex of the flat cell on the highest summit.</summary>
    public const int SummitColumn = 53, SummitRow = 53;

    /// <summary>Rows between which the cliff runs straight north, and the column of its brink there.</summary>
    public const int CliffSouthRow = 9, CliffNorthRow = 15, CliffColumn = 44;

    /// <summary>A clearing in the northern woods.</summary>
    public const int ForestColumn = 23, ForestRow = 51;

    private const double SummitHeight = 400.0;
    private const double CliffRise = 36.0;
    private const double RiverHalfWidth = 0.72;

    private readonly ValueNoise noise = new(seed);

    /// <summary>Rectangle of level meadow, crossed by five block borders west to east and by one south to north.</summary>
    public static (int West, int South, int East, int North) Flat => (8, 28, 56, 36);

    /// <summary>Height (m, not rounded) and cover of a vertex; outside the land the deep sea.</summary>
    public (double Height, TerrainKind Kind) At(int column, int row)
    {
        if (EdgeDistance(column, row) <= 0)
            return (0, TerrainKind.WaterDeepSea);

        double height = Hills(column, row) + Mountains(column, row) + Cliff(column, row);
        height *= Step(0.2, 6.0, EdgeDistance(column, row) + (2.6 * noise.At(column / 5.0, row / 5.0, 40)));

        double lake = LakeDistance(column, row);
        height = Lerp(LakeHeight + 0.5, height, Step(0.3, 7.0, lake));
        var (river, level) = Watercourse.River.Nearest(column, row);
        height = river <= 1.05 ? level : Lerp(Math.Min(level + 0.5, height), height, Step(1.0, 4.5, river));
        if (lake <= 0)
            height = LakeHeight;

        var (yard, yardWeight) = SlopeYard.At(column, row);
        height = Lerp(height, yard, yardWeight);
        height = Lerp(height, MeadowHeight, FlatWeight(column, row));

        if (lake <= 0)
            return (LakeHeight, TerrainKind.WaterStandingFresh);
        bool inYard = yardWeight + FlatWeight(column, row) >= 1.0;
        if (river <= RiverHalfWidth && !inYard)
            return (height, TerrainKind.WaterRunning);
        if (height < 0.75)
            return (0, TerrainKind.WaterShallowSea);
        return (height, inYard ? YardCover(column, row) : Cover(column, row, height, lake, river));
    }

    /// <summary>Which of the scene types 0 bare, 1 wood, 2 rocks, 3 shrubs a vertex has.</summary>
    public int SceneryAt(int column, int row, TerrainKind kind)
    {
        var (_, yardWeight) = SlopeYard.At(column, row);
        if (yardWeight > 0 || FlatWeight(column, row) > 0.99 || LakeDistance(column, row) < 1.5)
            return 0;
        double density = noise.Fractal(column / 6.0, row / 6.0, 60);
        return kind switch
        {
            TerrainKind.ForestFloor => 1,
            TerrainKind.LushGrass => density > 0.15 ? 1 : 3,
            TerrainKind.Grassland or TerrainKind.PatchyGrassland => density > 0.45 ? 3 : 0,
            TerrainKind.SemiBarrenRock => 2,
            _ => 0,
        };
    }

    /// <summary>Distance (cells) from the lake's shore, negative inside; the shore winds a little.</summary>
    public double LakeDistance(double column, double row)
    {
        double dx = column - LakeX, dy = row - LakeY;
        return Math.Sqrt((dx * dx) + (dy * dy)) - 5.2 - (0.8 * noise.At(column / 3.0, row / 3.0, 20));
    }

    private static double EdgeDistance(int column, int row)
        => Math.Min(Math.Min(column, Side - column), Math.Min(row, Side - row));

    private static double FlatWeight(int column, int row)
    {
        var (west, south, east, north) = Flat;
        double dx = Math.Max(Math.Max(west - column, column - east), 0), dy = Math.Max(Math.Max(south - row, row - north), 0);
        return 1.0 - Step(0.0, 5.0, Math.Sqrt((dx * dx) + (dy * dy)));
    }

    // 1 in the middle of an ellipse, 0 outside it.
    private static double Bump(int column, int row, double x, double y, double radiusX, double radiusY)
    {
        double dx = (column - x) / radiusX, dy = (row - y) / radiusY;
        return 1.0 - Step(0.5, 1.0, Math.Sqrt((dx * dx) + (dy * dy)));
    }

    private double Hills(int column, int row)
    {
        double ground = MeadowHeight + (2.0 * noise.Fractal(column / 9.0, row / 9.0, 1));
        double mask = Math.Max(Bump(column, row, 25, 54, 20, 10), Bump(column, row, 33, 12, 10, 12));
        double hill = 13.0 + (15.0 * noise.At(column / 4.5, row / 4.5, 4)) + (5.0 * noise.At(column / 2.0, row / 2.0, 5));

        // A ring of hills around the lake makes its valley; the river breaks through it.
        double dx = column - LakeX, dy = row - LakeY;
        double ring = Math.Sqrt((dx * dx) + (dy * dy));
        double rim = Step(6.5, 10.0, ring) * (1.0 - Step(10.0, 14.0, ring));
        return ground + (mask * Math.Max(hill, 0.0)) + (rim * (15.0 + (5.0 * noise.At(column / 3.0, row / 3.0, 8))));
    }

    private double Mountains(int column, int row)
    {
        double dx = column - SummitColumn - 0.5, dy = row - SummitRow - 0.5;
        double nearness = Math.Max(1.0 - (Math.Sqrt((dx * dx) + (dy * dy)) / 12.5), 0.0);
        if (Math.Abs(dx) < 1.0 && Math.Abs(dy) < 1.0)
            return SummitHeight;
        double ridge = 1.0 - Math.Abs(noise.At(column / 4.0, row / 4.0, 30));
        return SummitHeight * 0.9 * nearness * Math.Sqrt(nearness) * (0.72 + (0.28 * ridge) + (0.1 * noise.At(column, row, 31)));
    }

    // A plateau that ends in the west with a drop of one cell's width and sinks into the meadow in the north.
    private double Cliff(int column, int row)
    {
        double bend = row < CliffSouthRow ? row - CliffSouthRow : Math.Max(row - CliffNorthRow, 0);
        double brink = CliffColumn + Math.Round(0.35 * bend + (2.0 * Math.Min(Math.Abs(bend), 1.0) * noise.At(row / 3.0, 0.5, 35)));
        return column < brink ? 0.0 : CliffRise * (1.0 - Step(18.0, 27.0, row));
    }

    private TerrainKind YardCover(int column, int row)
    {
        if (row > SlopeYard.FootRow + 1)
            return TerrainKind.SemiBarrenRock;
        if (row >= SlopeYard.FootRow)
            return TerrainKind.SedimentaryRock;
        return noise.At(column / 3.0, row / 3.0, 50) > 0.35 ? TerrainKind.PatchyGrassland : TerrainKind.Grassland;
    }

    private TerrainKind Cover(int column, int row, double height, double lake, double river)
    {
        double mottle = noise.Fractal(column / 5.0, row / 5.0, 52);
        if (height > 190.0 + (30.0 * mottle))
            return TerrainKind.Snow;
        if (height > 75.0 + (20.0 * mottle))
            return TerrainKind.BarrenRock;
        if (height > 52.0 + (12.0 * mottle) && Mountains(column, row) > 15.0)
            return TerrainKind.SemiBarrenRock;
        if (height < 4.0)
            return TerrainKind.SandYellow;
        if (lake < 1.3)
            return TerrainKind.SandGrey;
        if (river < 1.6)
            return TerrainKind.MudRichDirt;
        if (height > 26.0)
            return mottle > 0.1 ? TerrainKind.ForestFloor : TerrainKind.LushGrass;
        return mottle > 0.3 ? TerrainKind.PatchyGrassland : TerrainKind.Grassland;
    }
}
