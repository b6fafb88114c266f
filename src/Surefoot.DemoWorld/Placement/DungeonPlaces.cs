using Surefoot.DemoWorld.Buildings;

namespace Surefoot.DemoWorld.Placement;

/// <summary>The dungeon and its places.</summary>
internal static class DungeonPlaces
{
    public static void AddTo(WorldPlan plan)
    {
        plan.AddDungeon(Dungeon.BlockId, Dungeon.Interior, Dungeon.Position);
        void Place(int room, string name, string title, double x, double y, double z, double heading, string whatToTry)
            => plan.AddPlaceIn(Dungeon.BlockId | (uint)(0x100 + room), name, title, Dungeon.Position.At(x, y, z, heading), whatToTry);
        Place(Dungeon.Entrance, "dungeon", "The dungeon", 0, 3, 0, 0, "Go north: corridors, a stair, a pit and a hall of pillars.");
        Place(Dungeon.FirstCorridor, "dungeon-corridor", "A corridor of four rooms", 0, 9, 0, 0,
            "Run along the corridor: where its rooms join there is no bump.");
        Place(Dungeon.PitRoom, "dungeon-pit", "At the pit", 0, 54, -2.4, 0,
            "Jump into the pit of 2 m, whose edge holds whoever walks, and come out over its steps.");
        Place(Dungeon.PillarHall, "dungeon-pillars", "The hall of pillars", 0, 67.5, -2.4, 0, "Run and jump around the pillars.");
    }
}
