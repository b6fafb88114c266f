using Surefoot.DemoWorld.Land;
using Surefoot.DemoWorld.Things;

namespace Surefoot.DemoWorld.Placement;

/// <summary>
/// The butts, on the meadow between the obstacle park and the crowd: an archer who shoots at a target, and a spell trap whose wall shelters
/// a guard.
/// </summary>
internal static class Archery
{
    private const double Cell = Landform.CellSide;

    // Height at which an archer's arrow leaves the bow.
    private const double BowHeight = 1.4;

    public static void AddTo(WorldPlan plan)
    {
        double x = 44.5 * Cell, y = 33.5 * Cell;
        plan.AddSpawn("archer", DemoSpawnKind.Guard, DemoIds.HumanSetup, plan.Ground(x, y, 0));
        plan.AddObject(Arrow.Target, plan.Ground(x, y + 24.8));
        // 24 m to the target at 30 m/s: 0.8 s in which an arrow falls 3.1 m, which 7.57 degrees upwards make good.
        plan.AddShooter("bow", plan.Ground(x, y + 0.8, 0).At(0, 0, BowHeight), pitch: 7.57f, speed: 30, period: 2, falls: true);

        double trapX = x + 12;
        plan.AddObject(ObstacleShapes.Wall, plan.Ground(trapX, y + 20).At(-2.5, 0, 0, 90));
        plan.AddSpawn("guard-sheltered", DemoSpawnKind.Guard, DemoIds.HumanSetup, plan.Ground(trapX, y + 24, 180));
        plan.AddShooter("spell-trap", plan.Ground(trapX, y, 0).At(0, 0, BowHeight), pitch: 0, speed: 50, period: 1.5f, falls: false);

        plan.AddPlace("archery", "The butts", x + 6, y - 6, 0,
            "Here an archer and a spell trap shoot: surefoot demo arrows tells what each missile hits; the wall shelters the guard.");
    }
}
