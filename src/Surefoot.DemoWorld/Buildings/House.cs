using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Buildings;

/// <summary>
/// A house of 8.6 by 12.6 m: a hall behind the door, a back room with stairs up through the ceiling and down through the
/// floor, an upper floor, a cellar, and a flat roof.
/// </summary>
/// <remarks>Coordinates: the floor of hall and back room is z = 0, the door is in the wall at y = -6 and opens to -y.</remarks>
internal static class House
{
    public const uint ShellId = 0x01000100;
    public const int Hall = 0, BackRoom = 1, UpperFloor = 2, Cellar = 3;

    /// <summary>Height of the floor above the ground outside (m).</summary>
    public const double FloorAboveGround = 0.1;

    /// <summary>Height of the roof above the floor (m).</summary>
    public const double RoofHeight = 6.5;

    private const double Rise = 0.2, Run = 0.28;
    private const int Steps = 15;

    /// <summary>The rooms.</summary>
    public static Interior Interior { get; } = Rooms();

    /// <summary>The outside: walls of 0.3 m with the doorway, roof and doorstep. Hollow inside.</summary>
    public static GfxObj Shell() => Meshes.Solid(
        ShellId,
        new BoxGrid()
            .Fill(new(-4.3, -6.3, -0.5, 4.3, 6.3, 6.2), Surfaces.Plaster)
            .Fill(new(-4.3, -6.3, 6.2, 4.3, 6.3, RoofHeight), Surfaces.Tiles)
            .Clear(new(-4, -6, -0.5, 4, 6, 6.2))
            .Clear(new(-0.6, -6.3, 0, 0.6, -6, 2.2))
            .Fill(new(-1, -7.1, -0.5, 1, -6.3, 0), Surfaces.Stone)
            .Faces());

    private static Interior Rooms()
    {
        var house = new Interior(DemoIds.HouseEnvironment);
        var hall = new RoomPlan(new(-4, -6, 0, 4, 0, 3), Surfaces.Boards, Surfaces.Plaster, Surfaces.Timber)
            .Solid(new(-4, -0.2, 0, 4, 0, 3), Surfaces.Plaster)
            .Air(new(-0.6, -0.2, 0, 0.6, 0, 2.2));
        var back = new RoomPlan(new(-4, 0, -0.2, 4, 6, 3.2), Surfaces.Boards, Surfaces.Plaster, Surfaces.Timber)
            .Solid(new(-4, 0, -0.2, 4, 6, 0), Surfaces.Boards)
            .Air(new(-0.4, 0.4, -0.2, 3, 1.6, 0))
            .Solid(new(-4, 0, 3, 4, 6, 3.2), Surfaces.Timber)
            .Air(new(-2.6, 4.6, 3, 2, 5.8, 3.2));
        var upper = new RoomPlan(new(-4, -6, 3.2, 4, 6, 6.2), Surfaces.Boards, Surfaces.Plaster, Surfaces.Timber);
        var cellar = new RoomPlan(new(-4, 0, -3.2, 4, 6, -0.2), Surfaces.Flagstones, Surfaces.Stone, Surfaces.Timber);
        for (int step = 1; step <= Steps; step++)
        {
            // The holes are longer than the stairs: a step up lifts the head by 0.6 m for a moment.
            // Up towards +x from -2.2; down towards -x from 3. The sixteenth step is the floor that one comes out on.
            back.Solid(new(-2.2 + (Run * (step - 1)), 4.6, 0, -2.2 + (Run * step), 5.8, Rise * step), Surfaces.Timber);
            cellar.Solid(new(3 - (Run * step), 0.4, -3.2, 3 - (Run * (step - 1)), 1.6, -Rise * step), Surfaces.Stone);
        }

        house.Add(hall, seesOutside: true);
        house.Add(back, seesOutside: true);
        house.Add(upper, seesOutside: true);
        house.Add(cellar, seesOutside: true);
        house.OpenOutside(Hall, new(-0.6, -6, 0, 0.6, -6, 2.2));
        house.Join(Hall, BackRoom, new(-0.6, 0, 0, 0.6, 0, 2.2));
        house.Join(BackRoom, UpperFloor, new(-2.6, 4.6, 3.2, 2, 5.8, 3.2));
        house.Join(BackRoom, Cellar, new(-0.4, 0.4, -0.2, 3 - Run, 1.6, -0.2));
        return house;
    }
}
