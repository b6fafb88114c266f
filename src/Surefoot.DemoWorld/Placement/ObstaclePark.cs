using Surefoot.DemoWorld.Land;
using Surefoot.DemoWorld.Things;

namespace Surefoot.DemoWorld.Placement;

/// <summary>The obstacle park on the meadow east of the road: stairs, wedges, arches, gaps, a maze and awkward corners.</summary>
internal static class ObstaclePark
{
    private const double Cell = Landform.CellSide;
    private const double South = 33.5 * Cell, North = 35.5 * Cell, West = 34 * Cell;

    public static void AddTo(WorldPlan plan)
    {
        AddSteps(plan);
        AddWedges(plan);
        AddArchesAndGaps(plan);
        AddLongStair(plan);
        AddCorners(plan);
        AddForest(plan);
    }

    private static void AddSteps(WorldPlan plan)
    {
        for (int i = 0; i < ObstacleShapes.StepHeights.Length; i++)
        {
            double x = West + (8 * i), height = ObstacleShapes.StepHeights[i];
            plan.AddObject(ObstacleShapes.StepsId(i), plan.Ground(x, South));
            plan.AddPlace(
                FormattableString.Invariant($"steps-{100 * height:0}"), FormattableString.Invariant($"Steps of {height} m"),
                x, South - 5, 0,
                height < 0.6
                    ? FormattableString.Invariant($"Run up four steps of {height} m.")
                    : FormattableString.Invariant($"Steps of {height} m are too high for a stride, whose limit is 0.6: jump them."));
        }
    }

    private static void AddWedges(WorldPlan plan)
    {
        for (int i = 0; i < ObstacleShapes.WedgeAngles.Length; i++)
        {
            double x = West + 72 + (8 * i), angle = ObstacleShapes.WedgeAngles[i];
            plan.AddObject(ObstacleShapes.WedgeId(i), plan.Ground(x, South));
            plan.AddPlace(
                FormattableString.Invariant($"wedge-{angle}"), FormattableString.Invariant($"A wedge of {angle} degrees"), x, South - 5, 0,
                angle < 48.38
                    ? FormattableString.Invariant($"Run up the wedge of {angle} degrees and off its back.")
                    : FormattableString.Invariant($"The wedge of {angle} degrees is too steep: slide along it, jump onto it, glide down."));
        }
    }

    private static void AddArchesAndGaps(WorldPlan plan)
    {
        double arches = West + 4;
        for (int i = 0; i < ObstacleShapes.ArchHeights.Length; i++)
            plan.AddObject(ObstacleShapes.ArchId(i), plan.Ground(arches, North + (5 * i)));
        plan.AddPlace("arches", "Arches of falling height", arches, North - 5, 0,
            "Run north through the arches until one is too low for you.");

        double gaps = West + 16;
        for (int i = 0; i < ObstacleShapes.GapWidths.Length; i++)
            plan.AddObject(ObstacleShapes.GapId(i), plan.Ground(gaps, North + (5 * i)));
        plan.AddPlace("gaps", "Gaps of shrinking width", gaps, North - 5, 0,
            "Squeeze north through the gaps: 0.97 m is one centimetre wider than you, 0.95 m one narrower.");

        var maze = plan.Ground(West + 34, North + 10);
        plan.AddObject(ObstacleShapes.Maze, maze);
        plan.AddPlace("maze", "The fence maze", maze.X - 4, maze.Y - 10, 0, "Find the way through, or jump the fences of 1.2 m.");
    }

    private static void AddLongStair(WorldPlan plan)
    {
        // Two stairs that meet halfway up, and a platform: seams between three objects.
        var foot = plan.Ground(West + 56, North);
        plan.AddObject(ObstacleShapes.LongStairLower, foot);
        plan.AddObject(ObstacleShapes.LongStairUpper, foot.At(0, 3.6, 0));
        plan.AddObject(ObstacleShapes.LongStairPlatform, foot.At(0, 7.2, 0));
        plan.AddPlace("long-stair", "The long stair", foot.X, foot.Y - 5, 0,
            "Run up 6 m over the seam between two stairs to the platform, turn and run down.");
        plan.AddPlaceOn("platform", "On the platform", foot.At(0, 9.7, 6, 180),
            "Run down the long stair without losing the ground, or jump off the side.");
    }

    private static void AddCorners(WorldPlan plan)
    {
        var corners = plan.Ground(West + 74, North + 6);
        plan.AddObject(ObstacleShapes.Corners, corners);
        plan.AddPlace("corners", "Convex and concave corners", corners.X, corners.Y - 3, 30,
            "Run into the corner between two walls, and around the end of a wall.");

        var ceiling = plan.Ground(West + 90, North + 6);
        plan.AddObject(ObstacleShapes.LowCeiling, ceiling);
        plan.AddPlace("low-ceiling", "Under a low ceiling", ceiling.X, ceiling.Y, 0, "Jump: the head meets the ceiling at 2.2 m.");

        var blocks = plan.Ground(West + 104, North + 6);
        plan.AddObject(ObstacleShapes.Block, blocks);
        plan.AddObject(ObstacleShapes.Block, blocks.At(3.9, 0, 0));
        plan.AddObject(ObstacleShapes.Block, blocks.At(7.94, 0, 0));
        plan.AddPlaceOn("close-blocks", "On blocks that stand close", blocks.At(0, 0, 3, 90),
            "Jump and walk over gaps of 0.9 and 1.04 m: a body of 0.96 m falls through the second only.");

        var wall = plan.Ground(West + 122, North);
        plan.AddObject(ObstacleShapes.WedgeId(ObstacleShapes.WedgeAngles.Length - 1), wall);
        plan.AddObject(ObstacleShapes.Wall, wall.At(1.7, 0, 0));
        plan.AddPlace("wall-and-slope", "Between a wall and a steep slope", wall.X + 0.8, wall.Y - 4, 20,
            "Run and jump into the corner between the wall and the slope of 60 degrees.");

        var crates = plan.Ground(West + 122, North + 20);
        plan.AddObject(ObstacleShapes.Crate, crates);
        plan.AddObject(ObstacleShapes.Crate, crates.At(1.3, 0.2, 0, 20));
        plan.AddObject(ObstacleShapes.Crate, crates.At(0.6, 0.1, 1.2, 45));
        plan.AddPlace("crates", "A pile of crates", crates.X, crates.Y - 5, 0, "Jump onto the crates, one of which stands askew.");

        var rocks = plan.Ground(West + 140, North + 10);
        plan.AddObject(NatureShapes.Boulder, rocks);
        plan.AddObject(NatureShapes.Rock, rocks.At(3.2, 1, 0, 40));
        plan.AddObject(NatureShapes.Rock, rocks.At(-3, 1.5, 0, 110));
        plan.AddPlace("rocks", "The rocks", rocks.X, rocks.Y - 6, 0, "Slide around the rocks and jump onto them.");
    }

    private static void AddForest(WorldPlan plan)
        => plan.AddPlace("forest", "In the forest", Landform.ForestColumn * Cell, Landform.ForestRow * Cell, 45,
            "Run between the trees: you slide around their trunks.");
}
