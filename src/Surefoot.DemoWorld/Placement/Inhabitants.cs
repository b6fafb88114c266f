using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Placement;

/// <summary>Whom and what to spawn, and the places to meet them.</summary>
internal static class Inhabitants
{
    private const double Cell = Landform.CellSide;
    private const int CrowdSide = 10;

    public static void AddTo(WorldPlan plan)
    {
        double x = 20.5 * Cell, y = 34.2 * Cell;
        plan.AddSpawn("guard-west", DemoSpawnKind.Guard, DemoIds.HumanSetup, plan.Ground(x - 3, y, 180));
        plan.AddSpawn("guard-east", DemoSpawnKind.Guard, DemoIds.HumanSetup, plan.Ground(x + 3, y, 180));
        plan.AddPlace("guards", "Two guards", x, y - 8, 0, "Run into a guard: you stop, slide around, or stand on top after a jump.");

        double fieldX = 14 * Cell, fieldY = 34 * Cell;
        for (int i = 0; i < 6; i++)
        {
            bool large = i % 3 == 2;
            plan.AddSpawn($"creature-{i + 1}", DemoSpawnKind.Wanderer, large ? DemoIds.LargeCreatureSetup : DemoIds.SmallCreatureSetup,
                plan.Ground(fieldX + (6 * (i % 3)), fieldY + (9 * (i / 3)), 60 * i), wanderRadius: 12);
        }

        plan.AddPlace("creatures", "Creatures at pasture", fieldX + 6, fieldY - 14, 0, "Get in the way of creatures that wander.");

        double crowdX = 48 * Cell, crowdY = 33.2 * Cell;
        for (int i = 0; i < CrowdSide * CrowdSide; i++)
        {
            int column = i % CrowdSide, row = i / CrowdSide;
            plan.AddSpawn($"crowd-{i + 1}", DemoSpawnKind.Crowd, DemoIds.HumanSetup,
                plan.Ground(crowdX + (1.6 * column) + (0.4 * (row % 2)), crowdY + (1.5 * row), 37 * i % 360));
        }

        plan.AddPlace("crowd", "A crowd of a hundred", crowdX + 7, crowdY - 8, 0, "Run into the crowd and jump out of it.");

        // The door fills the doorway of the second house, whose wall is 0.3 m thick.
        var house = Town.DoorHouse(plan);
        plan.AddSpawn("door", DemoSpawnKind.Door, DemoIds.DoorSetup, house.At(0, -6.15, 0));
        var before = house.At(0, -11, 0);
        plan.AddPlace("door", "A door", before.X, before.Y, before.Heading, "Open the door, walk in, and let it close on you.");
    }
}
