using System.Collections.Immutable;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>Shapes to climb, squeeze through and bump into. Each stands on z = 0 and is met from -y, unless it says otherwise.</summary>
internal static class ObstacleShapes
{
    public const uint LongStairLower = 0x01000140, LongStairUpper = 0x01000141, LongStairPlatform = 0x01000142, Maze = 0x01000143,
        LowCeiling = 0x01000144, Corners = 0x01000145, Block = 0x01000146, Crate = 0x01000147, Wall = 0x01000148, Footbridge = 0x01000149,
        Shed = 0x0100014A;

    private const uint FirstSteps = 0x01000110, FirstWedge = 0x01000120, FirstArch = 0x01000130, FirstGap = 0x01000138;

    /// <summary>Heights of the steps of the short stairs (m); a human's step up height is 0.6.</summary>
    public static ImmutableArray<double> StepHeights { get; } = [0.2, 0.3, 0.4, 0.5, 0.55, 0.6, 0.7, 0.8, 0.9];

    /// <summary>Angles of the wedges (degrees).</summary>
    public static ImmutableArray<double> WedgeAngles { get; } = [30, 45, 47, 48, 49, 50, 60];

    /// <summary>Clear heights of the arches (m); the top of a human's upper sphere is at 1.83.</summary>
    public static ImmutableArray<double> ArchHeights { get; } = [2.4, 2.1, 1.95, 1.85, 1.8, 1.6];

    /// <summary>Widths of the gaps (m); a human's spheres are 0.96 wide.</summary>
    public static ImmutableArray<double> GapWidths { get; } = [1.4, 1.2, 1.05, 0.97, 0.95, 0.8];

    public static uint StepsId(int index) => FirstSteps + (uint)index;

    public static uint WedgeId(int index) => FirstWedge + (uint)index;

    public static uint ArchId(int index) => FirstArch + (uint)index;

    public static uint GapId(int index) => FirstGap + (uint)index;

    /// <summary>All of them.</summary>
    public static IEnumerable<DatRecord> All() =>
    [
        .. StepHeights.Select((height, index) => Meshes.Solid(StepsId(index), Stair(4, height, 0.6, 3, 0, 2))),
        .. WedgeAngles.Select((angle, index) => Meshes.Solid(WedgeId(index), Wedge(angle))),
        .. ArchHeights.Select((height, index) => Meshes.Solid(ArchId(index), Arch(height))),
        .. GapWidths.Select((width, index) => Meshes.Solid(GapId(index), Gap(width))),
        Meshes.Solid(LongStairLower, Stair(12, 0.25, 0.3, 2.4, 0, 0)),
        Meshes.Solid(LongStairUpper, Stair(12, 0.25, 0.3, 2.4, 3, 0)),
        Meshes.Solid(LongStairPlatform, new BoxGrid().Fill(new(-2.5, 0, 0, 2.5, 5, 6), Surfaces.Sandstone).Faces()),
        Meshes.Solid(Maze, MazeFences()),
        Meshes.Solid(LowCeiling, Roof(3, 2.2)),
        Meshes.Solid(Corners, new BoxGrid()
            .Fill(new(-5, 3, 0, 5, 3.5, 2.5), Surfaces.Stone)
            .Fill(new(4.5, -3, 0, 5, 3.5, 2.5), Surfaces.Stone)
            .Fill(new(-5.5, 3, 0, -5, 7, 2.5), Surfaces.Stone).Faces()),
        Meshes.Solid(Block, new BoxGrid().Fill(new(-1.5, -1.5, 0, 1.5, 1.5, 3), Surfaces.Sandstone).Faces()),
        Meshes.Solid(Crate, new BoxGrid().Fill(new(-0.6, -0.6, 0, 0.6, 0.6, 1.2), Surfaces.Timber).Faces()),
        Meshes.Solid(Wall, new BoxGrid().Fill(new(-0.2, -1, 0, 0.2, 6, 4), Surfaces.Stone).Faces()),
        Meshes.Solid(Footbridge, Bridge()),
        Meshes.Solid(Shed, new BoxGrid()
            .Fill(new(-3, -3, -0.3, 3, 3, 2.6), Surfaces.Timber)
            .Fill(new(-3.2, -3.2, 2.6, 3.2, 3.2, 2.8), Surfaces.Tiles).Faces()),
    ];

    /// <summary>A straight stair with a solid base and an optional landing behind the last step.</summary>
    private static ImmutableArray<Face> Stair(int steps, double rise, double run, double width, double baseHeight, double landing)
    {
        var grid = new BoxGrid();
        for (int step = 0; step < steps; step++)
        {
            double end = (run * (step + 1)) + (step == steps - 1 ? landing : 0);
            grid.Fill(new(-width / 2, run * step, 0, width / 2, end, baseHeight + (rise * (step + 1))),
                rise >= 0.6 ? Surfaces.WarningRed : Surfaces.Sandstone);
        }

        return grid.Faces();
    }

    // Four metres long, three wide: an inclined face, a back wall, two triangular sides and a bottom.
    private static ImmutableArray<Face> Wedge(double degrees)
    {
        double height = 4 * Math.Tan(degrees * Math.PI / 180);
        uint surface = degrees < 48.38 ? Surfaces.Sandstone : Surfaces.WarningRed;
        Point3 frontLeft = new(-1.5, 0, 0), frontRight = new(1.5, 0, 0), backLeft = new(-1.5, 4, 0), backRight = new(1.5, 4, 0);
        Point3 topLeft = new(-1.5, 4, height), topRight = new(1.5, 4, height);
        return
        [
            new([frontLeft, frontRight, topRight, topLeft], surface),
            new([backLeft, topLeft, topRight, backRight], surface),
            new([frontLeft, topLeft, backLeft], surface),
            new([frontRight, backRight, topRight], surface),
            new([frontLeft, backLeft, backRight, frontRight], surface),
        ];
    }

    private static ImmutableArray<Face> Arch(double clear) => new BoxGrid()
        .Fill(new(-1.6, -0.3, 0, 1.6, 0.3, clear + 0.4), Surfaces.Stone)
        .Clear(new(-1, -0.3, 0, 1, 0.3, clear))
        .Faces();

    private static ImmutableArray<Face> Gap(double width) => new BoxGrid()
        .Fill(new((-width / 2) - 1, 0, 0, -width / 2, 2, 2.2), Surfaces.Stone)
        .Fill(new(width / 2, 0, 0, (width / 2) + 1, 2, 2.2), Surfaces.Stone)
        .Faces();

    private static ImmutableArray<Face> Roof(double half, double clear)
    {
        var grid = new BoxGrid().Fill(new(-half, -half, clear, half, half, clear + 0.3), Surfaces.Timber);
        foreach (var (x, y) in new[] { (-1, -1), (-1, 1), (1, -1), (1, 1) })
            grid.Fill(new((x * (half - 0.2)) - 0.2, (y * (half - 0.2)) - 0.2, 0, (x * (half - 0.2)) + 0.2, (y * (half - 0.2)) + 0.2, clear),
                Surfaces.Timber);
        return grid.Faces();
    }

    // Runs along x: a stair up, eight metres of deck, a stair down.
    private static ImmutableArray<Face> Bridge()
    {
        var grid = new BoxGrid().Fill(new(-4, -1, 2.7, 4, 1, 3), Surfaces.Timber);
        for (int step = 0; step < 12; step++)
        {
            double far = 4 + (0.3 * (12 - step)), near = 4 + (0.3 * (11 - step)), top = 0.25 * (step + 1);
            grid.Fill(new(-far, -1, 0, -near, 1, top), Surfaces.Stone).Fill(new(near, -1, 0, far, 1, top), Surfaces.Stone);
        }

        return grid.Faces();
    }

    // Fences of 1.2 m on a grid of two metres; the way in is in the south, the way out in the north.
    private static ImmutableArray<Face> MazeFences()
    {
        string[] plan =
        [
            "+-+-+-+-+-+ +-+",
            "|   |     |   |",
            "+ + + +-+ +-+ +",
            "| |   | |   | |",
            "+ +-+-+ +-+ + +",
            "|   |     | | |",
            "+-+ + +-+ + + +",
            "|   | |   |   |",
            "+ +-+ + +-+-+ +",
            "|     |   |   |",
            "+ +-+-+-+ + +-+",
            "|   |     |   |",
            "+-+ +-+ +-+-+ +",
            "|       |     |",
            "+-+ +-+-+-+-+-+",
        ];
        var grid = new BoxGrid();
        for (int row = 0; row < plan.Length; row++)
        {
            for (int column = 0; column < plan[row].Length; column++)
            {
                double x = column - 7, y = 7 - row;
                if (plan[row][column] == '-')
                    grid.Fill(new(x - 1.1, y - 0.1, 0, x + 1.1, y + 0.1, 1.2), Surfaces.Timber);
                else if (plan[row][column] == '|')
                    grid.Fill(new(x - 0.1, y - 1.1, 0, x + 0.1, y + 1.1, 1.2), Surfaces.Timber);
            }
        }

        return grid.Faces();
    }
}
