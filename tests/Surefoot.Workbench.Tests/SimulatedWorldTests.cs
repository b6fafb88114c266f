using System.Numerics;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>The physics behind the page, on the demo world, in a time that the tests make up.</summary>
public sealed class SimulatedWorldTests : IDisposable
{
    private const double Turn = 1.0 / 240;

    private readonly SimulatedWorld world = new(
        "Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, DemoSpawns.All);
    private double now = 100;

    private WorkbenchPlace Runway => world.Places.Single(place => place.Name == "The runway");

    public void Dispose() => world.Dispose();

    [Theory]
    [Behaviour("workbench.world.speeds", "spec/01, 4.1 and 6")]
    [InlineData(300, 0, false, 10.6000004)]
    [InlineData(300, 22_500, false, 7.3000002)]
    [InlineData(800, 0, false, 18)]
    [InlineData(300, 0, true, 3.12)]
    public void A_players_pose_moves_with_the_formulas_speed(int run, int burden, bool walk, double speed)
    {
        IWorkbenchPlayer player = world.Join(1, new PlayerSettings(run, 250, burden), Runway, now);
        Pass(1);
        player.SetKeys(walk ? PlayerKeys.Forward | PlayerKeys.Walk : PlayerKeys.Forward, now);
        Pass(1);
        PlayerPose from = player.Pose;
        Pass(5);
        PlayerPose to = player.Pose;
        double way = new Position(from.CellId, from.Position).OffsetTo(new Position(to.CellId, to.Position)).Length();
        Assert.Equal(speed, way / (to.Time - from.Time), speed * 0.01);
        Assert.Equal(speed, to.Speed, speed * 0.05);
        Assert.True(to.Flags.HasFlag(PoseFlags.Contact | PoseFlags.OnWalkable));
    }

    [Fact]
    [Behaviour("workbench.world.left-out", "spec/07, 9.1")]
    public void Damaged_files_leave_out_places_and_rooms_and_say_so_once()
    {
        const uint village = 0xA8B50000;
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-damaged");
        try
        {
            DemoWorldBuilder.Write(folder.FullName);
            WorkbenchPlace damaged = KnownPlaces.Demo().First(place => place.CellId >> 16 != village >> 16);
            using (DatFileEditor editor = DatFileEditor.Open(Path.Combine(folder.FullName, DatSet.CellName)))
            {
                editor.Put(village | 0x100, [0xFF, 0xFF, 0xFF]);
                editor.Put((damaged.CellId & 0xFFFF0000) | 0xFFFF, [0xFF, 0xFF, 0xFF]);
                editor.Complete();
            }

            List<string> said = [];
            WorkbenchPlace beside = new("Beside the damage", village | 1, new Vector3(12, 12, float.NaN), 0);
            WorkbenchPlace inside = beside with { CellId = village | 0x100 };
            using SimulatedWorld played = new("Damaged", DatSet.Open(folder.FullName), [damaged, inside, beside], NullLogger.Instance,
                [])
            { Notice = said.Add };
            Assert.Equal((beside.Name, beside.CellId), (Assert.Single(played.Places).Name, played.Places[0].CellId));
            Assert.Equal(LeftOutNotice.Nothing, played.LeftOut);
            IWorkbenchPlayer player = played.Join(1, PlayerSettings.Default, played.Places[0], now);
            played.Leave(player);
            played.Join(2, PlayerSettings.Default, played.Places[0], now);
            Assert.Contains("Room 0xA8B50100", Assert.Single(said), StringComparison.Ordinal);
            Assert.Contains(played.LeftOut.Lines, line => line.Contains("A8B50100", StringComparison.Ordinal));
            Assert.NotNull(played.ReadShapes((ushort)(village >> 16)));
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Fact]
    [Behaviour("workbench.world.new-skill-waits-for-the-server",
        "design.md, Who uses it: until the answer arrives the player moves at the old rate")]
    public void A_new_run_skill_acts_when_the_server_has_answered()
    {
        IWorkbenchPlayer player = world.Join(1, new PlayerSettings(0, 250, 0), Runway, now);
        player.SetKeys(PlayerKeys.Forward, now);
        Pass(1);
        Assert.Equal(1f, player.Pose.RunRate);
        player.Configure(new PlayerSettings(300, 250, 0), now);
        Pass(0.05);
        Assert.Equal(1f, player.Pose.RunRate);
        Pass(0.1);
        Assert.Equal(2.65f, player.Pose.RunRate, 0.001f);
    }

    [Fact]
    [Behaviour("workbench.world.jump-and-land", "spec/01, 4.12")]
    public void A_held_jump_charges_and_a_release_jumps_and_lands()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        Pass(1);
        Drain(player);
        float ground = player.Pose.Position.Z;
        player.SetKeys(PlayerKeys.Jump, now);
        Pass(0.5);
        Assert.Equal(0.5, player.Pose.Charge, 0.05);
        Assert.True(player.Pose.Flags.HasFlag(PoseFlags.Charging));
        Pass(0.7);
        Assert.Equal(1f, player.Pose.Charge);
        player.SetKeys(PlayerKeys.None, now);
        Pass(0.4);
        Assert.False(player.Pose.Flags.HasFlag(PoseFlags.Contact));
        Assert.True(player.Pose.Position.Z > ground + 2);
        Pass(3);
        List<PlayerEvent> events = Drain(player);
        Assert.Equal([PlayerEventKind.Jumped, PlayerEventKind.Landed], events.Select(one => one.Kind).Distinct());
        Assert.Equal(1f, events[0].Value);
        Assert.Equal(ground, player.Pose.Position.Z, 0.01f);
    }

    [Fact]
    [Behaviour("workbench.world.pointer-turns-where-it-goes", "spec/09b, 9.7 and 15.6")]
    public void The_pointer_to_the_right_turns_right_while_its_right_button_is_held()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        Pass(1);
        player.UseMouseTurning(true, now);
        player.MovePointer(PointerButtons.Left, 0, now);
        Drag(player, PointerButtons.Left, 10);
        Assert.Equal(0f, player.Pose.TurnSpeed);
        float yaw = player.Pose.Yaw;
        Drag(player, PointerButtons.Right, 10);
        Assert.Equal(2f, player.Pose.TurnSpeed, 0.001f);
        Assert.True(player.Pose.Yaw < yaw - 0.1f);
        player.MovePointer(PointerButtons.None, 0, now);
        Pass(0.1);
        Assert.Equal(0f, player.Pose.TurnSpeed);

        player.MovePointer(PointerButtons.Left | PointerButtons.Right, 0, now);
        Pass(1);
        Assert.Equal(10.6000004, player.Pose.Speed, 0.5);
    }

    [Fact]
    [Behaviour("workbench.world.autorun-survives-lost-focus", "spec/09b, 9.6")]
    public void Autorun_goes_on_when_the_page_loses_the_keyboard_and_keys_do_not()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        Pass(1);
        player.ToggleAutoRun(now);
        player.SetKeys(PlayerKeys.TurnLeft, now);
        Pass(0.5);
        Assert.NotEqual(0f, player.Pose.TurnSpeed);
        player.LoseFocus(now);
        Pass(0.5);
        Assert.Equal(0f, player.Pose.TurnSpeed);
        Assert.Equal(10.6000004, player.Pose.Speed, 0.5);
        player.ToggleAutoRun(now);
        Pass(0.5);
        Assert.Equal(0, player.Pose.Speed, 0.01);
    }

    [Fact]
    [Behaviour("workbench.world.refused-jump-says-why", "spec/01, 4.12 and section 3: 0x49, too loaded to jump")]
    public void A_jump_that_is_refused_says_why()
    {
        IWorkbenchPlayer player = world.Join(1, new PlayerSettings(300, 250, 30_000), Runway, now);
        Pass(1);
        Drain(player);
        player.SetKeys(PlayerKeys.Jump, now);
        PlayerEvent refused = Assert.Single(Drain(player));
        Assert.Equal((PlayerEventKind.JumpRefused, 0x49u), (refused.Kind, refused.Code));
    }

    [Fact]
    [Behaviour("workbench.world.every-place-stands", "design.md, Who uses it: jump to a named place")]
    public void At_every_named_place_a_player_stands_or_slides_on_the_ground_of_that_place()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        foreach (WorkbenchPlace place in world.Places)
        {
            byte before = player.Pose.Teleports;
            player.Goto(place, now);
            Assert.Equal((byte)(before + 1), player.Pose.Teleports);
            Vector3 offset = new Position(place.CellId, place.Position).OffsetTo(new Position(player.Pose.CellId, player.Pose.Position));
            Assert.True(offset.Length() < 0.1f, $"{place.Name}: {offset} off");
            Pass(0.5);
            Assert.True(player.Pose.Flags.HasFlag(PoseFlags.Contact), $"{place.Name}: no ground");
        }
    }

    [Fact]
    [Behaviour("workbench.world.place-in-numbers", "design.md, Who uses it: jump to a named place")]
    public void A_player_can_be_put_at_a_cell_and_metres_or_on_the_ground_there()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        player.Goto(new WorkbenchPlace("", 0xA9B50032, new Vector3(150, 30, 20), 1), now);
        Assert.Equal(0xA9B50032u, player.Pose.CellId);
        Assert.True(Vector3.Distance(new Vector3(150, 30, 20), player.Pose.Position) < 0.01f);
        Assert.Equal(1 - Math.Tau, player.Pose.Yaw, 1e-5);
        player.Goto(new WorkbenchPlace("", 0xA9B50001, new Vector3(84, 96.01f, float.NaN), 0), now);
        Assert.Equal(0xA9B5001Du, player.Pose.CellId);
        Assert.Equal(20, player.Pose.Position.Z, 0.01);
        Assert.Equal(2, player.Pose.Teleports);
    }

    [Theory]
    [Behaviour("workbench.world.impossible-place-is-refused", "design.md, Errors: a bad argument leaves the state unchanged")]
    [InlineData(0x00010001u, 12, 12, 0, PlaceRefusal.NoSuchCell)]
    [InlineData(0xA9B5FFFFu, 12, 12, 0, PlaceRefusal.NoSuchCell)]
    [InlineData(0xA9B50000u, 12, 12, 0, PlaceRefusal.NoSuchCell)]
    [InlineData(0xA9B50100u, 12, 12, 0, PlaceRefusal.NoSuchCell)]
    [InlineData(0xFFFF0100u, 12, 12, 0, PlaceRefusal.NoSuchCell)]
    [InlineData(0xFEFE0040u, 500, 0, 0, PlaceRefusal.OutsideMap)]
    [InlineData(0xA9B50001u, 1e30f, 0, 0, PlaceRefusal.OutsideMap)]
    [InlineData(0x01200100u, -500, 43, 0, PlaceRefusal.OutsideRooms)]
    [InlineData(0x01200100u, 96, 43, float.NaN, PlaceRefusal.NoSuchCell)]
    [InlineData(0xA9B50032u, 156, 24, -50, PlaceRefusal.UnderGround)]
    [InlineData(0xA9B50032u, 156, 24, 1e6f, PlaceRefusal.TooHigh)]
    public void An_impossible_place_leaves_the_player_where_it_was_and_says_why(uint cell, float x, float y, float z, object refusal)
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Runway, now);
        Pass(0.2);
        Drain(player);
        PlayerPose before = player.Pose;
        player.Goto(new WorkbenchPlace("", cell, new Vector3(x, y, z), 0), now);
        PlayerEvent refused = Assert.Single(Drain(player));
        Assert.Equal((PlayerEventKind.PlaceRefused, (PlaceRefusal)refusal), (refused.Kind, (PlaceRefusal)refused.Code));
        Assert.Equal(before, player.Pose);
    }

    [Fact]
    [Behaviour("workbench.world.second-player-stands-beside-the-first", "design.md, Who uses it: two tabs")]
    public void Whoever_comes_to_a_place_where_somebody_stands_is_put_beside()
    {
        List<IWorkbenchPlayer> players = [];
        WorkbenchPlace corridor = world.Places.Single(place => place.Name == "A corridor of four rooms");
        for (uint id = 1; id <= 6; id++) players.Add(world.Join(id, PlayerSettings.Default, Runway, now));
        AssertApart(players);
        foreach (IWorkbenchPlayer player in players)
        {
            player.Goto(corridor, now);
            Assert.True(Vector3.Distance(corridor.Position, player.Pose.Position) < 4);
        }

        AssertApart(players);
        Pass(0.5);
        Assert.All(players, player => Assert.True(player.Pose.Flags.HasFlag(PoseFlags.OnWalkable)));
        PlayerPose last = players[^1].Pose;
        players[^1].Goto(new WorkbenchPlace("", last.CellId, last.Position, last.Yaw), now);
        Assert.True(Vector3.Distance(last.Position, players[^1].Pose.Position) < 0.01f);
    }

    [Fact]
    [Behaviour("workbench.world.leaving-leaves-nothing", "design.md, Who uses it: a closed tab leaves nothing behind")]
    public void A_player_that_leaves_can_come_back_under_the_same_id_in_the_same_place()
    {
        for (int i = 0; i < 3; i++)
        {
            IWorkbenchPlayer player = world.Join(7, PlayerSettings.Default, Runway, now);
            Pass(0.2);
            Assert.True(Vector3.Distance(Runway.Position, player.Pose.Position) < 0.1f);
            world.Leave(player);
            Pass(0.2);
        }
    }

    [Fact]
    [Behaviour("workbench.world.terrain-split", "spec/05, 4.3 and 6.4")]
    public void Terrain_is_cut_where_physics_cuts_it()
    {
        TerrainBlock terrain = world.ReadTerrain(0xA9B4)!;
        for (uint cell = 0; cell < 64; cell++)
        {
            uint x = (8 * 0xA9) + (cell >> 3), y = (8 * 0xB4) + (cell & 7);
            uint hash = unchecked((y * ((214614067 * x) + 1813693831)) - (1109124029 * x) - 1369149221);
            Assert.Equal(hash >> 31 == 1, terrain.SouthWestCut[cell]);
        }

        Assert.Null(world.ReadTerrain(0x0101));
    }

    [Fact]
    [Behaviour("workbench.server.missing-dat-folder", "design.md, Who uses it: missing or partial dat folder")]
    public async Task A_folder_without_dat_files_is_refused_by_name()
    {
        string empty = Directory.CreateTempSubdirectory().FullName;
        DatFolderException refused = await Assert.ThrowsAsync<DatFolderException>(
            () => WorkbenchServer.StartAsync(new WorkbenchOptions { Port = 0, DatFolder = empty }));
        Assert.Contains(DatSet.PortalName, refused.Message, StringComparison.Ordinal);
        Directory.Delete(empty);
    }

    [Fact]
    [Behaviour("workbench.server.any-dat-folder", "design.md, Who uses it: --dats DIR")]
    public async Task A_folder_of_dat_files_is_played_at_the_towns_that_it_has()
    {
        await using WorkbenchServer server =
            await WorkbenchServer.StartAsync(new WorkbenchOptions { Port = 0, DatFolder = DemoWorldCache.GetOrCreate() });
        using HttpClient http = new();
        string places = await http.GetStringAsync(new Uri(server.Address, "/places.json"));
        Assert.Contains("Holtburg", places, StringComparison.Ordinal);
        Assert.DoesNotContain("Yaraq", places, StringComparison.Ordinal);
    }

    /// <summary>The width of a body and more between each two.</summary>
    private static void AssertApart(List<IWorkbenchPlayer> players)
    {
        for (int i = 0; i < players.Count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                PlayerPose a = players[i].Pose, b = players[j].Pose;
                Assert.True(new Position(a.CellId, a.Position).OffsetTo(new Position(b.CellId, b.Position)).Length() > 0.96f,
                    $"players {i} and {j}");
            }
        }
    }

    private static List<PlayerEvent> Drain(IWorkbenchPlayer player)
    {
        List<PlayerEvent> events = [];
        while (player.TryTakeEvent(out PlayerEvent happened)) events.Add(happened);
        return events;
    }

    /// <summary>Half a second of a hand that moves a button's pointer to the right.</summary>
    private void Drag(IWorkbenchPlayer player, PointerButtons held, float right)
    {
        for (int i = 0; i < 30; i++)
        {
            player.MovePointer(held, right, now);
            Pass(1.0 / 60);
        }
    }

    private void Pass(double seconds)
    {
        for (double end = now + seconds; now < end; now += Turn) world.Advance(now);
    }
}
