using Surefoot.DemoWorld.Placement;
using Surefoot.DemoWorld.Records;

namespace Surefoot.DemoWorld.Buildings;

/// <summary>
/// A dungeon without a way out: an entrance chamber, corridors in four pieces, a stair, a room with a pit, a hall of pillars.
/// </summary>
/// <remarks>It runs north (+y) and lies in a block of its own, far from the land.</remarks>
internal static class Dungeon
{
    public const uint BlockId = 0x01200000;
    public const int Entrance = 0, FirstCorridor = 1, PitRoom = 5, PillarHall = 6;

    /// <summary>Where its coordinates lie in the block.</summary>
    public static Spot Position { get; } = new(96, 40, 0, 0);

    /// <summary>The rooms.</summary>
    public static Interior Interior { get; } = Rooms();

    private static Interior Rooms()
    {
        var dungeon = new Interior(DemoIds.DungeonEnvironment);
        RoomPlan Room(double lowX, double lowY, double lowZ, double highX, double highY, double highZ)
            => new(new(lowX, lowY, lowZ, highX, highY, highZ), Surfaces.Flagstones, Surfaces.DarkStone, Surfaces.Stone);

        dungeon.Add(Room(-4, 0, 0, 4, 8, 4), seesOutside: false);
        dungeon.Add(Room(-1.5, 8, 0, 1.5, 20, 3), seesOutside: false);
        dungeon.Add(Room(-1.5, 20, 0, 1.5, 32, 3), seesOutside: false);
        dungeon.Add(Room(-1.5, 32, 0, 1.5, 44, 3), seesOutside: false);

        // A stair down by 2.4 m inside a corridor: twelve steps of 0.2 m.
        var stair = Room(-1.5, 44, -2.4, 1.5, 52, 3);
        for (int step = 0; step < 12; step++)
            stair.Solid(new(-1.5, 44 + (0.3 * step), -2.4, 1.5, 44 + (0.3 * (step + 1)), -0.2 * step), Surfaces.Stone);
        stair.Solid(new(-1.5, 48, 0.6, 1.5, 52, 3), Surfaces.DarkStone);
        dungeon.Add(stair, seesOutside: false);

        // Steps of 0.4 m lead out of the pit, which is 2 m deep.
        var pit = Room(-6, 52, -4.4, 6, 66, 2)
            .Solid(new(-6, 52, -4.4, 6, 66, -2.4), Surfaces.Flagstones)
            .Air(new(-3, 56, -4.4, 3, 62, -2.4));
        for (int step = 1; step <= 4; step++)
            pit.Solid(new(-3, 62 - (0.5 * (5 - step)), -4.4, 3, 62 - (0.5 * (4 - step)), -4.4 + (0.4 * step)), Surfaces.Stone);
        dungeon.Add(pit, seesOutside: false);

        var pillars = Room(-8, 66, -2.4, 8, 82, 3);
        for (int column = -1; column <= 1; column++)
        {
            for (int row = 0; row < 3; row++)
            {
                double x = 4.5 * column, y = 69.5 + (4.5 * row);
                pillars.Solid(new(x - 0.5, y - 0.5, -2.4, x + 0.5, y + 0.5, 3), Surfaces.Sandstone);
            }
        }

        dungeon.Add(pillars, seesOutside: false);

        double[] seams = [8, 20, 32, 44];
        for (int room = 0; room < seams.Length; room++)
            dungeon.Join(room, room + 1, new(-1.5, seams[room], 0, 1.5, seams[room], 3));
        dungeon.Join(4, PitRoom, new(-1.5, 52, -2.4, 1.5, 52, 0.6));
        dungeon.Join(PitRoom, PillarHall, new(-2, 66, -2.4, 2, 66, 0.6));
        return dungeon;
    }
}
