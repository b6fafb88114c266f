using System.Numerics;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>What the panel names, on the demo world.</summary>
public sealed class TouchTests : IDisposable
{
    private const double Turn = 1.0 / 60;

    private readonly SimulatedWorld world = new(
        "Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, DemoSpawns.All);
    private double now = 100;

    public void Dispose() => world.Dispose();

    [Fact]
    [Behaviour("workbench.touches.ground-and-its-plane", "design.md, Who uses it")]
    public void On_open_ground_a_player_stands_on_the_ground_of_its_cell_and_touches_nothing()
    {
        IWorkbenchPlayer player = Enter("slope-30");
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        Pass(6);
        player.SetKeys(PlayerKeys.None, now);
        Pass(1);
        Touch only = Assert.Single(player.Touches);
        Assert.Equal((true, TouchKind.Ground, player.Pose.CellId), (only.IsFooting, only.Kind, only.Id));
        Assert.Equal(player.Pose.ContactPlane.Normal, only.Normal);
        Assert.Equal(MathF.Cos(30 * MathF.PI / 180), only.Normal.Z, 0.01f);
    }

    [Fact]
    [Behaviour("workbench.touches.room-floor-and-wall", "design.md, Who uses it")]
    public void In_a_house_it_stands_on_a_rooms_floor_and_touches_the_wall_it_runs_into()
    {
        IWorkbenchPlayer player = Enter("house-hall");
        Pass(1);
        Touch floor = Assert.Single(player.Touches);
        Assert.Equal((true, TouchKind.Room, player.Pose.CellId), (floor.IsFooting, floor.Kind, floor.Id));

        player.SetKeys(PlayerKeys.SidestepLeft, now);
        Pass(6);
        Touch wall = Assert.Single(player.Touches, touch => !touch.IsFooting);
        Assert.Equal((TouchKind.Room, player.Pose.CellId), (wall.Kind, wall.Id));
        Assert.Equal(0, wall.Normal.Z, 0.01f);
        Assert.Contains(player.Touches, touch => touch.IsFooting);
    }

    [Fact]
    [Behaviour("workbench.touches.held-along-a-wall", "spec/03, 4.6 adjust_offset: a sweep that is bent along a wall does not meet it")]
    public void Who_runs_along_a_wall_touches_it_in_every_quantum()
    {
        IWorkbenchPlayer player = Enter("house-hall");
        player.SetKeys(PlayerKeys.SidestepLeft, now);
        Pass(4);
        player.SetKeys(PlayerKeys.SidestepLeft | PlayerKeys.Forward | PlayerKeys.Walk, now);
        Pass(0.25);
        for (int i = 0; i < 40; i++)
        {
            Pass(Turn);
            Assert.Contains(player.Touches, touch => touch is { IsFooting: false, Kind: TouchKind.Room });
        }
    }

    [Fact]
    [Behaviour("workbench.touches.stairs-carry-all-the-way", "design.md, Who uses it")]
    public void On_a_stair_it_always_stands_on_the_room_even_with_the_foot_on_an_edge()
    {
        IWorkbenchPlayer player = Enter("house-stairs");
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        for (int i = 0; i < 80; i++)
        {
            Pass(Turn);
            if (player.Pose.Flags.HasFlag(PoseFlags.OnWalkable))
                Assert.Contains(player.Touches, touch => touch is { IsFooting: true, Kind: TouchKind.Room });
        }
    }

    [Fact]
    [Behaviour("workbench.touches.building-from-outside", "design.md, Who uses it")]
    public void Outside_it_touches_the_building()
    {
        IWorkbenchPlayer player = Enter("house-door");
        player.SetKeys(PlayerKeys.SidestepLeft, now);
        Pass(0.4);
        player.SetKeys(PlayerKeys.Forward, now);
        Pass(3);
        Touch wall = Assert.Single(player.Touches, touch => !touch.IsFooting);
        Assert.Equal(TouchKind.Building, wall.Kind);
        Assert.True(CellIds.IsOutdoor(player.Pose.CellId));
    }

    [Fact]
    [Behaviour("workbench.touches.names-creatures", "design.md, Who uses it")]
    public void A_guard_in_the_way_is_named()
    {
        IWorkbenchPlayer player = Enter("guards");
        DemoSpawn guard = DemoSpawns.All.Single(one => one.Name == "guard-west");
        player.SetKeys(PlayerKeys.SidestepLeft, now);
        for (int i = 0; i < 600 && Offset(player, guard).X > 0; i++) Pass(Turn);
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        bool named = false;
        for (int i = 0; i < 600 && !named; i++)
        {
            Pass(Turn);
            named = player.Touches.Any(touch => !touch.IsFooting && touch.Kind == TouchKind.Body && touch.Name == "guard-west");
        }

        Assert.True(named);
        Assert.True(new Vector2(Offset(player, guard).X, Offset(player, guard).Y).Length() < (2 * 0.48f) + 0.5f);
    }

    [Fact]
    [Behaviour("workbench.touches.object-under-the-feet", "design.md, Who uses it")]
    public void On_a_crate_it_stands_on_that_object()
    {
        IWorkbenchPlayer player = Enter("crates");
        WorkbenchPlace before = world.Places.Single(one => one.Name == "A pile of crates");
        player.Goto(before with { Position = before.Position + new Vector3(-0.3f, 5, 1.5f) }, now);
        Pass(1);
        Touch crate = Assert.Single(player.Touches, touch => touch.IsFooting);
        Assert.Equal(TouchKind.Object, crate.Kind);
        Assert.Equal(0x01u, crate.Id >> 24);
        Assert.Equal(1, crate.Normal.Z, 0.01f);
    }

    [Fact]
    [Behaviour("workbench.touches.tree-trunk-is-scenery", "design.md, Who uses it")]
    public void A_tree_that_holds_it_back_is_scenery()
    {
        IWorkbenchPlayer player = Enter("forest");
        IReadOnlyList<Plant> plants = world.ReadShapes(0xA8B7)!.Plants;
        Plant tree = plants.First(
            one =>
                !one.IsRound && one.Low is { X: > 20 and < 170, Y: > 20 and < 170 } &&
                    plants.Count(other => Vector3.Distance(one.Low, other.Low) < 6) == 1);
        player.Goto(new WorkbenchPlace("", 0xA8B70001, tree.Low + new Vector3(0.1f, -3, 1.5f), 0), now);
        Pass(1);
        player.SetKeys(PlayerKeys.Forward, now);
        bool met = false;
        for (int i = 0; i < 60 && !met; i++)
        {
            Pass(Turn);
            met = player.Touches.Any(touch => !touch.IsFooting && touch.Kind == TouchKind.Scenery && touch.Id >> 24 is 0x01 or 0x02);
        }

        Assert.True(met);
    }

    private IWorkbenchPlayer Enter(string place)
    {
        NamedPlace there = DemoPlaces.All.Single(one => one.Name == place);
        IWorkbenchPlayer player =
            world.Join(1, PlayerSettings.Default, world.Places.Single(one => one.Name == there.Title && one.CellId == there.CellId), now);
        Pass(0.5);
        return player;
    }

    private static Vector3 Offset(IWorkbenchPlayer player, DemoSpawn spawn) =>
        new Position(spawn.CellId, spawn.Origin).OffsetTo(new Position(player.Pose.CellId, player.Pose.Position));

    private void Pass(double seconds)
    {
        for (double end = now + seconds; now < end; now += Turn) world.Advance(now);
    }
}
