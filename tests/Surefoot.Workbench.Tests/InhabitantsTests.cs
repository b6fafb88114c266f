using System.Numerics;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>Who lives in the demo world, in a time that the tests make up.</summary>
public sealed class InhabitantsTests : IDisposable
{
    private const double Turn = 1.0 / 60;

    private readonly SimulatedWorld world = NewWorld();
    private double now = 100;

    public void Dispose() => world.Dispose();

    [Fact]
    [Behaviour("workbench.inhabitants.guards-and-crowd-stand", "design.md, Who uses it")]
    public void Guards_and_the_crowd_of_a_hundred_stand_where_they_are_spawned()
    {
        IWorkbenchPlayer player = Enter(world, "A crowd of a hundred");
        Pass(world, ref now, 3);
        List<BodyPose> near = Look(world, player);
        Assert.Equal(100, near.Count(one => one.Kind == BodyKind.Crowd));
        foreach (BodyPose one in near.Where(one => one.Kind == BodyKind.Crowd))
        {
            Assert.True(From(Spawn(one.Name), one).Length() < 0.1f, $"{one.Name} strayed");
            Assert.Equal(BodyFlags.None, one.Flags);
        }

        player.Goto(Place(world, "Two guards"), now);
        Pass(world, ref now, 1);
        near = Look(world, player);
        Assert.Equal(["guard-east", "guard-west"], near.Where(one => one.Kind == BodyKind.Guard).Select(one => one.Name).Order());
    }

    [Fact]
    [Behaviour("workbench.inhabitants.wanderers-wander-near-home", "design.md, Who uses it")]
    public void Wanderers_walk_about_near_their_homes_and_do_the_same_again_in_another_world()
    {
        using SimulatedWorld other = NewWorld();
        IWorkbenchPlayer player = Enter(world, "Creatures at pasture"), twin = Enter(other, "Creatures at pasture");
        double otherNow = now;
        HashSet<string> moved = [];
        for (int second = 0; second < 40; second++)
        {
            Pass(world, ref now, 1);
            Pass(other, ref otherNow, 1);
            List<BodyPose> near = [.. Look(world, player).Where(one => one.Kind == BodyKind.Wanderer)];
            Assert.Equal(6, near.Count);
            Assert.Equal(near, Look(other, twin).Where(one => one.Kind == BodyKind.Wanderer));
            foreach (BodyPose one in near)
            {
                Vector3 strayed = From(Spawn(one.Name), one);
                // It walks straight to a place within the radius, from one within it; only what it runs into turns it aside.
                Assert.True(new Vector2(strayed.X, strayed.Y).Length() < 12 + 2, $"{one.Name} is {strayed} from home");
                if (strayed.Length() > 1) moved.Add(one.Name);
            }
        }

        Assert.Equal(6, moved.Count);
    }

    [Fact]
    [Behaviour("workbench.inhabitants.come-back-with-their-land", "design.md, Who uses it")]
    public void Whoever_went_away_with_the_land_comes_back_with_it()
    {
        IWorkbenchPlayer player = Enter(world, "Creatures at pasture");
        Pass(world, ref now, 10);
        List<BodyPose> before = Look(world, player);
        player.Goto(Place(world, "The dungeon"), now);
        Pass(world, ref now, 5);
        Assert.Empty(Look(world, player));
        player.Goto(Place(world, "Creatures at pasture"), now);
        Pass(world, ref now, Turn * 4);
        List<BodyPose> after = Look(world, player);
        Assert.Equal(before.Select(one => one.Name), after.Select(one => one.Name));
        foreach ((BodyPose then, BodyPose again) in before.Zip(after))
            Assert.True(Between(then, again).Length() < 0.5f, $"{then.Name} moved while nothing was loaded");
    }

    [Fact]
    [Behaviour("workbench.door.opens-and-closes", "spec/02, 4.12; design.md, Who uses it")]
    public void A_door_blocks_opens_lets_through_and_closes_behind()
    {
        IWorkbenchPlayer player = Enter(world, "A door");
        Pass(world, ref now, 1);
        BodyPose door = Door(player);
        Assert.True(From(Spawn("door"), door).Length() < 0.01f, "The door hangs in its frame");

        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        Pass(world, ref now, 4);
        Assert.True(CellIds.IsOutdoor(player.Pose.CellId), "The closed door holds the player out");
        Assert.True(player.Pose.Speed < 0.1f);

        // Head-on against a wall the way along it is nothing, and the wall slid along is not looked for again: one steps back first.
        player.SetKeys(PlayerKeys.Back, now);
        Pass(world, ref now, 0.3);
        player.Use(now);
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        Pass(world, ref now, Turn * 4);
        Assert.Equal(BodyFlags.Open, Door(player).Flags);
        Pass(world, ref now, 1.5);
        Assert.False(CellIds.IsOutdoor(player.Pose.CellId), "Through the open door the player comes in");
        player.SetKeys(PlayerKeys.None, now);
        Pass(world, ref now, 6);
        Assert.Equal(BodyFlags.None, Door(player).Flags);
    }

    [Fact]
    [Behaviour("workbench.door.waits-for-whoever-stands-in-it", "spec/02, set_ethereal")]
    public void A_door_does_not_become_solid_around_a_player()
    {
        IWorkbenchPlayer player = Enter(world, "A door");
        Pass(world, ref now, 1);
        player.Use(now);
        Assert.Equal(BodyFlags.None, Door(player).Flags);
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        for (int i = 0; i < 600 && Between(player.Pose, Door(player)).Length() > 0.2f; i++)
        {
            Pass(world, ref now, Turn);
            if (Door(player).Flags == BodyFlags.None && Between(player.Pose, Door(player)).Length() < Inhabitants.Reach) player.Use(now);
        }

        player.SetKeys(PlayerKeys.None, now);
        Pass(world, ref now, 8);
        Assert.Equal(BodyFlags.Open | BodyFlags.WaitsToClose, Door(player).Flags);
        player.SetKeys(PlayerKeys.Forward | PlayerKeys.Walk, now);
        Pass(world, ref now, 1.5);
        Assert.Equal(BodyFlags.None, Door(player).Flags);
    }

    private static SimulatedWorld NewWorld() =>
        new("Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, DemoSpawns.All);

    private static WorkbenchPlace Place(SimulatedWorld world, string name) => world.Places.Single(place => place.Name == name);

    private static List<BodyPose> Look(SimulatedWorld world, IWorkbenchPlayer player)
    {
        List<BodyPose> near = [];
        world.Look(player, near);
        return near;
    }

    private static DemoSpawn Spawn(string name) => DemoSpawns.All.Single(one => one.Name == name);

    private static Vector3 From(DemoSpawn spawn, in BodyPose pose) =>
        new Position(spawn.CellId, spawn.Origin).OffsetTo(new Position(pose.CellId, pose.Position));

    private static Vector3 Between(in BodyPose one, in BodyPose other) =>
        new Position(one.CellId, one.Position).OffsetTo(new Position(other.CellId, other.Position));

    private static Vector3 Between(in PlayerPose one, in BodyPose other) =>
        new Position(one.CellId, one.Position).OffsetTo(new Position(other.CellId, other.Position));

    private static void Pass(SimulatedWorld world, ref double now, double seconds)
    {
        for (double end = now + seconds; now < end; now += Turn) world.Advance(now);
    }

    private BodyPose Door(IWorkbenchPlayer player) => Look(world, player).Single(one => one.Kind == BodyKind.Door);

    private IWorkbenchPlayer Enter(SimulatedWorld where, string place) => where.Join(1, PlayerSettings.Default, Place(where, place), now);
}
