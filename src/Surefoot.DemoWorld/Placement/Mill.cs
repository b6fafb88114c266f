using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Placement;

/// <summary>The windmill east of the town, in the middle of a square of land: its sails stay within it.</summary>
internal static class Mill
{
    public static void AddTo(WorldPlan plan)
    {
        var foot = plan.Ground(23.5 * Landform.CellSide, 33.5 * Landform.CellSide);
        plan.AddObject(DemoIds.WindmillSetup, foot);
        plan.AddPlace("windmill", "The windmill", foot.X - 0.7, foot.Y - 10, 4,
            "Run through the passage between two sails, or stand in their way: a sail stops you, and holds you when it sweeps over you.");
    }
}
