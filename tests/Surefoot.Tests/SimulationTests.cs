using System.Numerics;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tests;

public sealed class SimulationTests(DemoFolder demo) : IClassFixture<DemoFolder>
{
    private const double Frame = 1.0 / 60;
    private static readonly CharacterStats Runner = new(RunSkill: 300, JumpSkill: 250);
    private static readonly Place Meadow = Place.Parse("0xA9B50032,156,24.01");

    /// <summary>The runway runs east over five block borders; it is level at 20 m.</summary>
    private static readonly Place Runway = Place.Parse("0xA7B4000F,24.01,150,20,90");

    private static double Run(Player player, MovementKeys keys, double now, double seconds)
    {
        for (double end = now + seconds; now < end; now += Frame) player.Update(keys, now);
        return now;
    }

    [Fact]
    [Behaviour("door.three-lines-to-a-walking-body", "README, Embed it; spec/01, 6 (skill 300: 10.6 m/s)")]
    public void A_player_is_put_on_the_ground_and_runs_at_the_speed_of_its_skill()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Player player = world.SpawnPlayer(Meadow, Runner);
        Assert.Equal((0x50000001u, 20f), (player.Body.Id, MathF.Round(player.Position.Frame.Origin.Z)));
        double now = Run(player, MovementKeys.Forward, 0, 1);
        Position before = player.Position;
        Run(player, MovementKeys.Forward, now, 5);
        Assert.Equal(10.6 * 5, before.DistanceTo(player.Position), 0.6);
    }

    [Fact]
    [Behaviour("door.loads-around-players", "design.md, Who uses it")]
    public void What_is_around_a_runner_is_loaded_and_what_is_far_behind_is_forgotten()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Player player = world.SpawnPlayer(Runway, new CharacterStats(RunSkill: 800, JumpSkill: 0));
        uint first = CellIds.BlockOf(player.Position.CellId);
        double now = 0;
        for (int i = 0; i < 50 && !player.Body.IsLost; i++)
        {
            now = Run(player, MovementKeys.Forward, now, 1);
            int column = (int)(player.Position.CellId >> 24);
            for (int beside = -1; beside <= 1; beside++)
                Assert.NotNull(world.World.FindLandblock((uint)((column + beside) << 24) | 0x00B40001));
        }

        Assert.False(player.Body.IsLost);
        Assert.True((player.Position.CellId >> 24) - (first >> 24) >= 4);
        Assert.Null(world.World.FindLandblock(first | 1));
    }

    [Fact]
    [Behaviour("door.several-players", "design.md, Who uses it")]
    public void Several_players_hold_their_own_keys_and_go_on_together()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Player runner = world.SpawnPlayer(Meadow, Runner), stander = world.SpawnPlayer(Runway, Runner);
        Assert.Equal([0x50000001u, 0x50000002u], world.Players.Select(player => player.Body.Id));
        Position stood = stander.Position;
        runner.Keys = MovementKeys.Forward;
        for (double now = 0; now < 2; now += Frame) world.Tick(now);
        Assert.True(runner.Position.Frame.Origin.Y > 24 + 15);
        Assert.Equal(0, stood.DistanceTo(stander.Position), 0.01);

        world.Remove(stander);
        world.Remove(stander);
        Assert.Equal([runner], world.Players);
        Assert.Null(world.Engine.Find(0x50000002));
    }

    [Fact]
    [Behaviour("door.new-numbers-wait-for-the-server", "design.md, Who uses it; spec/08, 5.7 and 7.1")]
    public void New_numbers_act_when_the_servers_message_has_arrived()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Player player = world.SpawnPlayer(Runway, new CharacterStats(RunSkill: 0, JumpSkill: 0), latency: 0.5);
        double now = Run(player, MovementKeys.Forward, 0, 2);
        player.SetStats(new CharacterStats(RunSkill: 800, JumpSkill: 0), now);
        Position before = player.Position;
        now = Run(player, MovementKeys.Forward, now, 0.45);
        Assert.Equal(4 * 0.45, before.DistanceTo(player.Position), 0.3);
        now = Run(player, MovementKeys.Forward, now, 1);
        before = player.Position;
        Run(player, MovementKeys.Forward, now, 2);
        Assert.Equal(18 * 2, before.DistanceTo(player.Position), 1);
    }

    [Fact]
    [Behaviour("door.teleport-loads-and-places", "spec/02, 4.17; spec/08, 4.4")]
    public void A_teleport_loads_the_world_there_and_puts_the_player_on_the_ground()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Player player = world.SpawnPlayer(Meadow, Runner);
        double now = Run(player, MovementKeys.Forward, 0, 1);
        player.Teleport(Place.Parse("0xACB4003F,180,150"), now);
        Run(player, MovementKeys.None, now, 0.5);
        Assert.Equal(0xACB40000, player.Position.CellId & 0xFFFF0000);
        Assert.True(player.Body.OnWalkable);
        Assert.Null(world.World.FindLandblock(0xA7B50001));

        Position before = player.Position;
        Assert.Throws<PlaceException>(() => player.Teleport(Place.Parse("0x01230001,12,12,0"), now));
        Assert.Throws<ArgumentException>(() => player.Teleport(Meadow, double.NaN));
        Assert.Equal(before, player.Position);
    }

    [Theory]
    [Behaviour("door.bad-place-says-why", "design, decision 7")]
    [InlineData("0x01230001,12,12,0", "has no cell 0x01230001; that land does not exist")]
    [InlineData("0xA9B403FF,12,12,0", "has no cell 0xA9B403FF; that room does not exist")]
    [InlineData("0xFEFE0001,999,12,0", "outside the map")]
    public void A_place_that_is_not_there_is_refused_with_the_reason_and_nobody_is_put_anywhere(string place, string reason)
    {
        using Simulation world = Simulation.Open(demo.Path);
        PlaceException e = Assert.Throws<PlaceException>(() => world.SpawnPlayer(Place.Parse(place), Runner));
        Assert.Contains(reason, e.Message, StringComparison.Ordinal);
        Assert.Empty(world.Players);
        Assert.Empty(world.Engine.Bodies);
    }

    [Fact]
    [Behaviour("door.bad-numbers-change-nothing", "design, decision 7")]
    public void Bad_numbers_are_refused_and_change_nothing()
    {
        using Simulation world = Simulation.Open(demo.Path);
        Assert.Throws<ArgumentOutOfRangeException>(() => world.SpawnPlayer(Meadow, new CharacterStats(-1, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.SpawnPlayer(Meadow, Runner, latency: double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => world.SpawnPlayer(Meadow, Runner, id: 0));
        Assert.Throws<PlaceException>(() => world.SpawnPlayer(new Position(0xA9B50032, new Vector3(float.NaN, 0, 0)), Runner));
        Assert.Throws<PlaceException>(() => world.SpawnPlayer(new Position(0xA9B50100, new Vector3(float.PositiveInfinity, 0, 0)), Runner));
        Assert.Throws<PlaceException>(() => world.SpawnPlayer(default(Place), Runner));
        Assert.Empty(world.Engine.Bodies);

        Player player = world.SpawnPlayer(Meadow, Runner, id: 7);
        Assert.Throws<ArgumentException>(() => world.SpawnPlayer(Meadow, Runner, id: 7));
        Position before = player.Position;
        Assert.Throws<ArgumentException>(() => player.Update(MovementKeys.Forward, double.NaN));
        Assert.Throws<ArgumentException>(() => world.Tick(double.PositiveInfinity));
        Assert.Equal(before, player.Position);
    }

    [Fact]
    [Behaviour("door.bad-folder-says-what-to-do", "design, decision 7")]
    public void A_folder_that_lacks_something_is_refused_in_a_line_that_says_what_to_do()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-door-bad-");
        try
        {
            Assert.Contains("surefoot demo write", Refusal(Path.Combine(folder.FullName, "none")), StringComparison.Ordinal);
            Assert.Contains($"has no {DatSet.PortalName} and {DatSet.CellName}", Refusal(folder.FullName), StringComparison.Ordinal);

            // Two files in which there is nothing.
            new DatFileWriter(Path.Combine(folder.FullName, DatSet.PortalName), DatFileKind.Portal).Complete();
            new DatFileWriter(Path.Combine(folder.FullName, DatSet.CellName), DatFileKind.Cell).Complete();
            Assert.Contains("has no Region 0x13000000", Refusal(folder.FullName), StringComparison.Ordinal);
        }
        finally
        {
            folder.Delete(recursive: true);
        }

        static string Refusal(string path)
        {
            string message = Assert.Throws<DatFolderException>(() => Simulation.Open(path)).Message;
            Assert.DoesNotContain('\n', message);
            return message;
        }
    }
}
