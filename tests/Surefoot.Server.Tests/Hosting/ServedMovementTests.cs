using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Hosting;

public sealed class ServedMovementTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const uint InPortalSpace = 0x604410, Visible = 0x600408, Ethereal = 0x4;
    private const ushort On = 0x0B, Off = 0x0C;

    [Fact]
    [Behaviour("server.claims.forced-back", "spec/08, 5.7 (z correction); 4.4")]
    public void Who_claims_what_cannot_be_is_put_back_and_nobody_sees_it_there()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        WirePosition place = walker.Place;
        host.Run(1);
        walker.ClaimPlace(TestClient.Beside(place, 30, 0));
        Assert.True(host.RunUntil(() => walker.Stamps.ForcePosition == 1, 2));
        UpdatePosition forced = walker.Positions.Last(told => told.Guid == walker.Id);
        Assert.True(Vector3.Distance(place.Origin, forced.Pack.Position.Origin) < 0.05f);
        Assert.Equal((0, 1), (forced.Pack.Teleport, forced.Pack.ForcePosition));
        Assert.All(
            watcher.Positions.Where(told => told.Guid == walker.Id),
            told => Assert.True(Vector3.Distance(place.Origin, told.Pack.Position.Origin) < 0.05f));
        Assert.Equal(1, host.Server.Figures.AllRefusedClaims);

        // What it claimed before it heard of that is not held against it, and afterwards all is well.
        walker.ClaimPlace(forced.Pack.Position);
        host.Run(1);
        Assert.Equal(1, walker.Stamps.ForcePosition);
    }

    [Fact]
    [Behaviour("server.claims.play-on-after-force", "spec/08, 4.4 and 5.6")]
    public void Who_was_put_back_in_full_run_runs_on_from_there()
    {
        SimulatedHost host = new(ground);
        TestClient walker = host.Enter("Walker");
        WirePosition place = walker.Place;
        WireRawMotion runs = new(currentHoldKey: 2, forwardCommand: 0x45000005);
        walker.Session.Send(new MoveToState(runs, place, walker.Stamps, true, false));
        host.Run(0.5);
        walker.ClaimPlace(TestClient.Beside(place, 0, 60));
        Assert.True(host.RunUntil(() => walker.Stamps.ForcePosition == 1, 2));
        WirePosition at = walker.Place;
        for (int i = 0; i < 3; i++)
        {
            // The keys are still held: it goes on at its speed, 4 m/s times its rate, northwards.
            host.Run(0.5);
            at = TestClient.Beside(at, 0, 1);
            walker.ClaimPlace(at);
        }

        host.Run(0.5);
        Assert.Equal(1, walker.Stamps.ForcePosition);
    }

    [Fact]
    [Behaviour("server.claims.believed", "spec/08, 5.7: live servers believe claims")]
    public void A_server_that_believes_takes_what_is_claimed()
    {
        SimulatedHost host = new(ground, options => options with { Authority = null });
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        WirePosition far = TestClient.Beside(walker.Place, 0, 30);
        walker.ClaimPlace(far);
        Assert.True(host.RunUntil(() => watcher.Positions.Any(told => told.Pack.Position.Origin == far.Origin), 2));
        Assert.Equal(0, walker.Stamps.ForcePosition);
    }

    [Fact]
    [Behaviour("server.teleport", "spec/08, 5.7 (Teleport)")]
    public void A_teleport_hides_the_player_until_its_client_has_loaded_the_place()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        walker.States.Clear();
        Position to = DemoGround.At(DemoPlaces.All[0].Name, right: 6);
        Vector3 at = to.Frame.Origin;
        walker.Session.Send(new Talk(FormattableString.Invariant($"@teleloc 0x{to.CellId:X8} {at.X} {at.Y} {at.Z}")));
        Assert.True(host.RunUntil(() => walker.Teleports.Count == 1, 2));
        host.Run(0.2);
        Assert.Equal(1, walker.Teleports[0].Teleport);
        Assert.Equal(InPortalSpace, walker.States.Single(state => state.Guid == walker.Id).State);
        UpdatePosition[] told = [.. watcher.Positions.Where(position => position.Guid == walker.Id && position.Pack.Teleport == 1)];
        Assert.Equal(2, told.Length);
        Assert.True(Vector3.Distance(at, told[1].Pack.Position.Origin) < 0.1f);

        // Positions are not taken before.
        WirePosition there = walker.Place;
        walker.ClaimPlace(TestClient.Beside(there, 0, 0.5f));
        host.Run(0.5);
        Assert.Equal(there, walker.Place);
        walker.Session.Send(new LoginComplete());
        Assert.True(host.RunUntil(() => walker.States.Any(state => state.State == Visible), 2));
        Assert.Empty(watcher.Teleports);
    }

    [Fact]
    [Behaviour("server.teleport.far", "spec/08, 8.7")]
    public void Who_goes_far_away_is_forgotten_after_a_while_and_seen_again_when_it_comes_back()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        uint id = walker.Id;
        NamedPlace far = DemoPlaces.All.First(place => Math.Abs((int)(place.CellId >> 24) - (int)(walker.Place.Cell >> 24)) > 1);
        walker.Session.Send(new Talk(FormattableString.Invariant(
            $"@teleloc 0x{far.CellId:X8} {far.Origin.X} {far.Origin.Y} {far.Origin.Z}")));
        host.Run(20);
        walker.Session.Send(new LoginComplete());
        Assert.DoesNotContain(watcher.Deleted, gone => gone.Guid == id);
        host.Run(12);
        Assert.Contains(watcher.Deleted, gone => gone.Guid == id);
        Assert.DoesNotContain(watcher.Id, walker.Objects.Keys);
        walker.Session.Send(new Talk("@start"));
        host.Run(1);
        walker.Session.Send(new LoginComplete());
        Assert.True(host.RunUntil(() => watcher.Objects.ContainsKey(id) && walker.Objects.ContainsKey(watcher.Id), 2));
    }

    [Fact]
    [Behaviour("server.rooms", "spec/08, 8.7: in a closed indoor cell, of that cell and its visible-cell list")]
    public void In_a_closed_room_those_are_known_who_are_in_a_room_that_is_seen_from_there()
    {
        Position room = DemoGround.At("dungeon"), hall = DemoGround.At("dungeon-pillars");
        SimulatedHost host = new(ground, options => options with
        {
            Start = room,
            Spawns = [new WorldSpawn("far", WorldSpawnKind.Creature, DemoGround.HumanSetup, hall)],
        });
        TestClient one = host.Enter("One"), two = host.Enter("Two");
        Assert.Contains(two.Id, one.Objects.Keys);
        Assert.Contains(one.Id, two.Objects.Keys);
        Assert.Contains(one.Objects.Values, item => item.Object.Weenie.Name == "far");
    }

    [Fact]
    [Behaviour("server.door.in-reach", "spec/08, 5.7 (Use, Door)")]
    public void A_door_in_reach_opens_and_closes_by_itself()
    {
        SimulatedHost host = new(ground, options => options with { Start = DemoGround.At("door", ahead: 4) });
        TestClient walker = host.Enter("Walker"), watcher = host.Enter("Watcher");
        CreateObject door = walker.Objects.Values.Single(item => (item.Object.Weenie.Description & 0x1000) != 0);
        uint id = door.Object.Guid;
        Assert.Equal(Off, door.Object.Physics.Movement!.Value.State.ForwardCommand);
        walker.Session.Send(new Use(id));
        Assert.True(host.RunUntil(() => walker.UsesDone.Count == 1, 2));
        host.Run(0.1);
        Assert.Equal(0u, walker.UsesDone[0].Error);
        Assert.Equal(MovementType.TurnToObject, walker.Motions.Last(motion => motion.Guid == walker.Id).Movement.Type);
        Assert.Equal(On, watcher.Motions.Single(motion => motion.Guid == id).Movement.State.ForwardCommand);
        SetState open = watcher.States.Single(state => state.Guid == id);
        Assert.Equal(door.Object.Physics.State | Ethereal, open.State);
        Assert.True(host.RunUntil(() => watcher.States.Count(state => state.Guid == id) == 2, 32));
        Assert.Equal(door.Object.Physics.State, watcher.States.Last(state => state.Guid == id).State);
        Assert.Equal(Off, watcher.Motions.Last(motion => motion.Guid == id).Movement.State.ForwardCommand);
    }

    [Fact]
    [Behaviour("server.door.out-of-reach", "spec/08, 5.7 (Use)")]
    public void A_door_out_of_reach_opens_when_the_server_has_moved_the_player_there()
    {
        SimulatedHost host = new(ground, options => options with { Start = DemoGround.At("door") });
        TestClient walker = host.Enter("Walker");
        CreateObject door = walker.Objects.Values.Single(item => (item.Object.Weenie.Description & 0x1000) != 0);
        host.Run(1);
        walker.Session.Send(new Use(door.Object.Guid));
        Assert.True(host.RunUntil(() => walker.Motions.Any(motion => motion.Guid == walker.Id && !motion.Autonomous), 2));
        UpdateMotion order = walker.Motions.Last(motion => motion.Guid == walker.Id);
        Assert.Equal(
            (MovementType.MoveToObject, door.Object.Guid, (ushort)1, false),
            (order.Movement.Type, order.Movement.Target, order.ServerControlledMove, order.Autonomous));
        Assert.Empty(walker.UsesDone);

        // Its client obeys, and says where it is.
        WirePosition place = walker.Place;
        Vector3 way = door.Object.Physics.Position!.Value.Origin - place.Origin;
        for (int i = 1; i <= 4 && walker.UsesDone.Count == 0; i++)
        {
            host.Run(0.5);
            Vector3 step = Vector3.Normalize(way with { Z = 0 }) * i * 0.9f;
            walker.ClaimPlace(TestClient.Beside(place, step.X, step.Y));
        }

        Assert.True(host.RunUntil(() => walker.UsesDone.Count == 1, 2));
        Assert.Equal((0u, 0L), (walker.UsesDone[0].Error, host.Server.Figures.AllRefusedClaims));
    }

    [Fact]
    [Behaviour("server.use.control-taken-back", "spec/08, 5.7 (Use)")]
    public void Who_takes_the_control_back_uses_nothing()
    {
        SimulatedHost host = new(ground, options => options with { Start = DemoGround.At("door") });
        TestClient walker = host.Enter("Walker");
        CreateObject door = walker.Objects.Values.Single(item => (item.Object.Weenie.Description & 0x1000) != 0);
        host.Run(1);
        walker.Session.Send(new Use(door.Object.Guid));
        host.Run(0.5);
        walker.Session.Send(new MoveToState(new WireRawMotion(currentHoldKey: 2), walker.Place, walker.Stamps, true, false));
        Assert.True(host.RunUntil(() => walker.UsesDone.Count == 1, 2));
        Assert.NotEqual(0u, walker.UsesDone[0].Error);
        host.Run(2);
        Assert.DoesNotContain(walker.States, state => state.Guid == door.Object.Guid);
    }

    [Fact]
    [Behaviour("server.creatures.hunt", "spec/08, 8.7 (creatures); 09b, 6")]
    public void A_hunter_chases_who_comes_near_and_tells_where_it_is_five_times_a_second()
    {
        Position lair = DemoGround.At(DemoPlaces.All[0].Name, ahead: 12);
        uint hound = DemoSpawns.All.First(spawn => spawn.Kind == DemoSpawnKind.Wanderer).SetupId;
        SimulatedHost host = new(ground, options => options with
        {
            Spawns = [new WorldSpawn("hunter", WorldSpawnKind.Hunter, hound, lair)],
        });
        TestClient walker = host.Enter("Walker");
        CreateObject hunter = walker.Objects.Values.Single(item => item.Object.Weenie.Name == "hunter");
        uint id = hunter.Object.Guid;
        Assert.True(host.RunUntil(() => walker.Motions.Any(motion => motion.Guid == id), 2));
        UpdateMotion chase = walker.Motions.First(motion => motion.Guid == id);
        Assert.Equal((MovementType.MoveToObject, walker.Id, false), (chase.Movement.Type, chase.Movement.Target, chase.Autonomous));
        int before = walker.Positions.Count(told => told.Guid == id);
        host.Run(1);
        Assert.InRange(walker.Positions.Count(told => told.Guid == id) - before, 4, 6);
        host.Run(10);
        Vector3 last = walker.Positions.Last(told => told.Guid == id).Pack.Position.Origin;
        Assert.True(Vector3.Distance(last, walker.Place.Origin) < 3, $"{last} {walker.Place}");
    }
}
