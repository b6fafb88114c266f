using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Placement;

/// <summary>The places that the landscape alone makes: meadow, slopes, mountains, water, borders.</summary>
internal static class LandPlaces
{
    private const double Cell = Landform.CellSide;

    // What retail lets one stand on: upward normal at least this (48.38 degrees).
    private const float WalkableNormalZ = 0.66417414f;

    public static void AddTo(WorldPlan plan)
    {
        var (west, south, east, north) = Landform.Flat;
        plan.AddPlace("meadow", "The meadow", 30.5 * Cell, 33 * Cell, 0,
            "Walk, run, sidestep and turn on level ground; the slopes lie ahead, the lake behind.");
        plan.AddPlace("runway", "The runway", (west + 1) * Cell, (south + 2.5) * Cell, 90,
            "Run east in a straight line: 1.1 km of level ground across five block borders.");
        plan.AddPlace("road-crossing", "The crossing", Roads.CrossingColumn * Cell, Roads.CrossingRow * Cell, 180,
            "Follow the roads: south to the lake, north to the slopes, east to the mountain and the cliff.");
        plan.AddPlace("landblock-border", "A block border", (32 * Cell) - 6, (south + 3.5) * Cell, 90,
            "Step over the border in front of you: the cell id changes and nothing else does.");
        plan.AddPlace("block-corner", "Where four blocks meet", (32 * Cell) - 4, (32 * Cell) - 4, 45,
            "Run in circles over the corner of four blocks.");
        AddSlopes(plan, north);
        AddHills(plan);
        AddMountain(plan);
        AddCliff(plan);
        AddWater(plan);
        plan.AddPlace("beach", "The east beach", EastBeach(plan.Terrain) * Cell, 31.5 * Cell, 90,
            "Walk into the sea: shallow water carries you, the open sea stops you like a wall.");
        plan.AddPlace("meadow-east", "The meadow's east end", (east - 1) * Cell, (south + 2.5) * Cell, 270,
            "Run the runway back west.");
    }

    private static void AddSlopes(WorldPlan plan, int meadowNorth)
    {
        plan.AddPlace("slope-yard", "The slope yard", (SlopeYard.FirstColumn + 17.5) * Cell, meadowNorth * Cell, 0,
            "Twelve slopes from 15 to 60 degrees in a row: the steepest that carries you has 48.38.");
        foreach (var slope in SlopeYard.Slopes)
        {
            string degrees = FormattableString.Invariant($"{slope.Degrees}");
            plan.AddPlace(slope.Name, $"A slope of {degrees} degrees", (slope.Column + 1) * Cell, (SlopeYard.FootRow * Cell) - 8, 0,
                slope.Degrees < 48.38
                    ? $"Run up the slope of {degrees} degrees and down again without losing the ground."
                    : $"Run at the slope of {degrees} degrees: it is too steep to stand on; jump at it, too.");
        }
    }

    private static void AddHills(WorldPlan plan)
    {
        // The highest vertex of the southern hills that is no cliff.
        var terrain = plan.Terrain;
        var (column, row) = Best(25, 6, 39, 18, (c, r) => terrain.Height(c, r));
        plan.AddPlace("hills", "In the rolling hills", (column + 0.5) * Cell, (row + 0.5) * Cell, 300,
            "Run downhill and uphill at full speed: feet keep the ground in every stride.");
        plan.AddPlace("valley", "The river valley", 9.2 * Cell, 23.2 * Cell, 140,
            "Follow the river down to the lake between the hills.");
    }

    private static void AddMountain(WorldPlan plan)
    {
        var terrain = plan.Terrain;
        double summitX = (Landform.SummitColumn + 0.5) * Cell, summitY = (Landform.SummitRow + 0.5) * Cell;
        plan.AddPlace("mountain-top", "The summit", summitX, summitY, 225,
            "Look around, then jump off: on slopes beyond the limit you slide.");

        // From outside towards the summit along the south-west diagonal: the last walkable stretch before the first steep one.
        const double diagonal = 0.70710678;
        double distance = 320;
        while (distance > 30 &&
            terrain.GroundAt(summitX - (distance * diagonal), summitY - (distance * diagonal)).Normal.Z >= WalkableNormalZ)
            distance -= 1;
        distance += 6;
        plan.AddPlace(
            "foot-of-the-mountain", "The foot of the mountain", summitX - (distance * diagonal), summitY - (distance * diagonal), 45,
            "Climb: a few metres ahead the ground gets too steep to stand on.");
    }

    private static void AddCliff(WorldPlan plan)
    {
        double y = 0.5 * (Landform.CliffSouthRow + Landform.CliffNorthRow) * Cell;
        plan.AddPlace("cliff-edge", "The brink of the cliff", (Landform.CliffColumn * Cell) + 4, y, 270,
            "Run along the brink, which holds whoever walks, or jump from it: you keep your speed in the air and land 36 metres lower.");
        plan.AddPlace("cliff-foot", "Under the cliff", ((Landform.CliffColumn - 1) * Cell) - 6, y, 90,
            "Run at the cliff: it is too steep to climb, you slide along it.");
    }

    private static void AddWater(WorldPlan plan)
    {
        var terrain = plan.Terrain;
        double y = Landform.LakeY * Cell;
        double shore = Landform.LakeX * Cell;
        while (terrain.GroundAt(shore, y).WaterDepth > 0.4f)
            shore += 1;
        plan.AddPlace("lake-shore", "The lake shore", shore + 12, y, 270,
            "Wade in: the water lets you sink a little and slows nothing.");
        plan.AddPlace("lake-shallows", "In the shallows", shore - 8, y, 270,
            "Stand knee-deep: in a cell that is partly water feet sink 0.45 m, in the middle 0.9 m.");
        plan.AddPlace("lake-middle", "In the middle of the lake", Landform.LakeX * Cell, y, 90,
            "Walk on the lake's bed, 0.9 m under the water; jump.");

        var (x, row) = Watercourse.River.Along(4.0 / 12.0);
        plan.AddPlace("river", "The river", x * Cell, row * Cell, 90,
            "Cross the river from bank to bank.");
    }

    private static double EastBeach(DemoTerrain terrain)
    {
        int column = Landform.Side;
        while (TerrainKinds.IsWater(terrain.Kind(column, 31)) || TerrainKinds.IsWater(terrain.Kind(column, 32)))
            column--;
        return column - 0.5;
    }

    private static (int Column, int Row) Best(int west, int south, int east, int north, Func<int, int, float> score)
    {
        var best = (Column: west, Row: south);
        for (int column = west; column <= east; column++)
        {
            for (int row = south; row <= north; row++)
            {
                if (score(column, row) > score(best.Column, best.Row))
                    best = (column, row);
            }
        }

        return best;
    }
}
