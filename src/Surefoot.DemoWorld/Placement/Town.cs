using Surefoot.DemoWorld.Buildings;
using Surefoot.DemoWorld.Land;
using Surefoot.DemoWorld.Things;

namespace Surefoot.DemoWorld.Placement;

/// <summary>The town in block A8B5: three houses, a shed with a flat roof, a footbridge over the road.</summary>
internal static class Town
{
    private const double Cell = Landform.CellSide;

    /// <summary>The house with the open door, whose rooms are places.</summary>
    public static Spot FirstHouse(WorldPlan plan) => plan.Ground(19.5 * Cell, 35.5 * Cell, 0).At(0, 0, House.FloorAboveGround);

    /// <summary>The house that has a door to shut.</summary>
    public static Spot DoorHouse(WorldPlan plan) => plan.Ground(22.5 * Cell, 35.5 * Cell, 30).At(0, 0, House.FloorAboveGround);

    public static void AddTo(WorldPlan plan)
    {
        var house = FirstHouse(plan);
        uint cells = plan.AddBuilding(House.ShellId, House.Interior, house);
        plan.AddBuilding(House.ShellId, House.Interior, DoorHouse(plan));
        plan.AddBuilding(House.ShellId, House.Interior, plan.Ground(17.5 * Cell, 37.5 * Cell, 90).At(0, 0, House.FloorAboveGround));

        plan.AddPlace("town", "The town", 20.5 * Cell, 33.4 * Cell, 340,
            "Run between the houses, into doorways and along walls.");
        plan.AddPlace("house-door", "At a house's door", house.X, house.Y - 10, 0,
            "Go in and out of the doorway at every angle: the room is never lost.");
        plan.AddPlaceIn(cells + House.Hall, "house-hall", "In the hall", house.At(0, -3, 0),
            "Walk through the doorways: back room ahead, the open air behind.");
        plan.AddPlaceIn(cells + House.BackRoom, "house-stairs", "At the stairs", house.At(-3.2, 5.2, 0, 90),
            "Climb the stairs along the north wall, through the hole in the ceiling.");
        plan.AddPlaceIn(cells + House.UpperFloor, "house-upstairs", "Upstairs", house.At(3.3, 5.2, 3.2, 270),
            "Walk around the hole in the floor, go down the stairs, or jump into the hole.");
        plan.AddPlaceIn(cells + House.Cellar, "house-cellar", "In the cellar", house.At(-2.6, 1, -3.2, 90),
            "Come up the cellar stairs without catching on the edge of the floor.");
        plan.AddPlaceOn("house-roof", "On a roof", house.At(0, -5, House.RoofHeight, 180),
            "Run along the edge, which holds whoever walks, and jump off it.");

        var shed = plan.Ground(16.5 * Cell, 34.5 * Cell, 0);
        plan.AddObject(ObstacleShapes.Shed, shed);
        plan.AddObject(ObstacleShapes.Crate, shed.At(-4, -2, 0));
        plan.AddPlace("rooftop", "A roof to jump to", shed.X - 8, shed.Y - 2, 90,
            "Jump onto the crate, from there onto the roof at 2.8 m, and fall off the far side.");

        var bridge = plan.Ground(28 * Cell, 35 * Cell, 0);
        plan.AddObject(ObstacleShapes.Footbridge, bridge);
        plan.AddPlace("footbridge", "The footbridge", bridge.X - 11, bridge.Y, 90,
            "Go over the road on the bridge and under it on the road.");
    }
}
