using System.Numerics;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests.Peer;

/// <summary>The client on a server, over real sockets and in real time: a player walks.</summary>
public abstract partial class ServerSuite(IGameServer server)
{
    /// <summary>Metres between what the server says and where the player is.</summary>
    private const float Same = 0.05f;

    /// <summary>Cell of the one door of the demo town; its house looks south-west.</summary>
    private const uint DoorCell = 0xA8B50034;

    private static readonly Vector3 Doorway = new(152.925f, 78.674f, 20), IntoHouse = new(0.5f, 0.8660254f, 0);
    private static readonly Quaternion FacingHouse = new(0, 0, -0.25881904f, 0.9659258f);

    [Theory]
    [Behaviour("client.server.walks", "08, 5 and 9; 09b, 9.8")]
    [InlineData("W 2")]
    [InlineData("Shift+W 2")]
    [InlineData("Q 1; E 0.5")]
    [InlineData("A 1; D 0.5; W 1")]
    [InlineData("S 1")]
    [InlineData("W 1; W+Space 0.5; W 1")]
    public void What_a_new_character_does_ends_where_the_server_says(string script)
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        Vector3 start = player.Position.Frame.Origin;
        party.Walk(player, script);
        party.Settle(player);
        Assert.True((player.Position.Frame.Origin - start).Length() > 0.5f, "it has not moved");
        AssertAgreed(player);
    }

    [Fact]
    [Behaviour("client.server.jumps", "08, 5.4 and 5.7; 01, 4.12")]
    public void A_jump_is_told_once_costs_stamina_and_lands_where_the_server_says()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        int stamina = player.Player.Weenie.Stats.Stamina;
        float ground = player.Position.Frame.Origin.Z, top = ground;
        party.Walk(player, "Space 1");
        party.Until(() => (top = Math.Max(top, player.Position.Frame.Origin.Z)) > float.MaxValue, 1);
        party.Settle(player);
        Assert.Single(player.Sent.OfType<Jump>());
        Assert.InRange(top - ground, 0.3f, 3);
        if (server.JumpsCostStamina) Assert.InRange(player.Player.Weenie.Stats.Stamina, 0, stamina - 1);
        AssertAgreed(player);
    }

    [Fact]
    [Behaviour("client.server.steps-and-house", "08, 5.7; 03")]
    public void Steps_are_climbed_and_the_house_is_entered_and_its_stairs_climbed()
    {
        using Party party = new(server);
        OnlinePlayer player = party.EnterAsAdministrator();
        party.Teleport(player, "steps-20");
        float foot = player.Position.Frame.Origin.Z;
        party.Walk(player, "Shift+W 2");
        party.Settle(player);
        Assert.InRange(player.Position.Frame.Origin.Z - foot, 0.15f, 0.9f);
        AssertAgreed(player);

        party.Teleport(player, "house-door");
        Assert.True(CellIds.IsOutdoor(player.Position.CellId));
        party.Walk(player, "Shift+W 2.5");
        party.Settle(player);
        Assert.Equal(0xA8B50100, player.Position.CellId);
        AssertAgreed(player);

        party.Teleport(player, "house-stairs");
        party.Walk(player, "Shift+W 2.5");
        party.Settle(player);
        Assert.InRange(player.Position.Frame.Origin.Z - 20, 1, 3.5f);
        AssertAgreed(player);
        party.LogOff(player);
    }

    [Fact]
    [Behaviour("client.server.seen-by-another", "09, 3.2 and 6; 08, 8.7")]
    public void Another_player_sees_the_runner_at_its_speed_and_where_it_ends()
    {
        using Party party = new(server);
        OnlinePlayer runner = party.Enter(), watcher = party.Enter();
        Assert.True(party.Until(() => watcher.Game!.Others.Find(runner.Id) is not null), "the runner is not seen");
        RemoteBody seen = watcher.Game!.Others.Find(runner.Id)!;

        runner.Keys = MovementKeys.Forward;
        party.Wait(1.5);
        (Position begin, Position seenBegin, double since) = (runner.Position, seen.Body.Position, party.Now);
        party.Wait(2);
        double seconds = party.Now - since;
        float ran = Apart(begin, runner.Position), seenRunning = Apart(seenBegin, seen.Body.Position);
        runner.Keys = MovementKeys.None;
        party.Settle(runner);

        Assert.InRange(ran / seconds, 4, 20);
        Assert.InRange(seenRunning / ran, 0.9f, 1.1f);
        Assert.InRange(Apart(seen.Body.Position, runner.Position), 0, 0.1f);
        Assert.Equal(runner.Position.CellId, seen.Body.Position.CellId);
    }

    [Fact]
    [Behaviour("client.server.teleport", "08, 4.4, step 5 and 5.7")]
    public void A_teleport_there_and_back_holds_reports_until_arrival_and_stops_the_runner()
    {
        using Party party = new(server);
        OnlinePlayer player = party.EnterAsAdministrator();
        party.Teleport(player, "meadow");
        Position home = player.Position;
        party.Teleport(player, "dungeon");
        Assert.Equal(0x01200100u, player.Position.CellId);
        Assert.Null(player.Game!.Engine.World.FindLandblock(home.CellId));
        party.Walk(player, "Shift+W 1");
        party.Settle(player);
        AssertAgreed(player);

        int sent = player.Sent.Count;
        party.Teleport(player, "meadow");
        Assert.InRange(Apart(home, player.Position), 0, Same);
        Assert.IsType<MoveToState>(player.Sent[sent]);
        AssertAgreed(player);
        party.LogOff(player);
    }

    [Fact]
    [Behaviour("client.server.door", "08, 5.7 (Door); 09, 5.5")]
    public void A_closed_door_stops_the_player_and_an_opened_one_lets_it_through()
    {
        using Party party = new(server);
        OnlinePlayer player = party.EnterAsAdministrator();
        RemoteBody door = GoToDoor(party, player, 2);
        if (door.Body.State.Has(PhysicsState.Ethereal))
            Assert.True(party.Until(() => !door.Body.State.Has(PhysicsState.Ethereal), 40), "the door stays open");
        party.Walk(player, "W 1.5");
        party.Settle(player);
        Assert.InRange(Inside(player), -1.5f, 0);
        AssertAgreed(player);

        // A step back: who leans squarely on a door is held by having leaned, also when it has opened.
        party.Walk(player, "S 0.3");
        player.Session.Send(new Use(door.Id));
        Assert.True(party.Until(() => door.Body.State.Has(PhysicsState.Ethereal)), "the door does not open");
        party.Wait(1.5);
        party.Walk(player, "W 1");
        party.Settle(player);
        Assert.InRange(Inside(player), 0.5f, 10);
        Assert.False(CellIds.IsOutdoor(player.Position.CellId));
        AssertAgreed(player);
        party.LogOff(player);
    }

    [Fact]
    [Behaviour("client.server.controlled-approach", "08, 5.7 (Use) and 5.6; 09b, 9.6")]
    public void The_server_walks_the_player_to_a_far_object_and_a_key_takes_control_back()
    {
        using Party party = new(server);
        OnlinePlayer player = party.EnterAsAdministrator();
        RemoteBody door = GoToDoor(party, player, 15);
        party.Walk(player, "W 0.2");
        party.Settle(player);
        float start = Inside(player);
        Assert.False(player.Player.Controller.IsControlledByServer);

        player.Session.Send(new Use(door.Id));
        Assert.True(party.Until(() => player.Player.Controller.IsControlledByServer), "control is not lost");
        Assert.True(party.Until(() => Inside(player) > start + 3), "the player does not go");
        Assert.True(player.Player.Movement.IsMovingTo);
        int sent = player.Sent.Count;
        party.Walk(player, "S 0.5");
        Assert.False(player.Player.Controller.IsControlledByServer);
        Assert.False(player.Player.Movement.IsMovingTo);
        Assert.Contains(player.Sent[sent..], message => message is MoveToState);
        party.Settle(player);
        AssertAgreed(player);

        // Now all the way: it arrives, and stands where the server says.
        player.Session.Send(new Use(door.Id));
        Assert.True(party.Until(() => player.Player.Movement.IsMovingTo));
        Assert.True(party.Until(() => !player.Player.Movement.IsMovingTo), "it never arrives");
        party.Settle(player);
        Assert.InRange(Inside(player), -5, 0);
        AssertAgreed(player);
        party.LogOff(player);
    }

    /// <summary>Metres of the way through the doorway; negative before it.</summary>
    private static float Inside(OnlinePlayer player) => Vector3.Dot(player.Position.Frame.Origin - Doorway, IntoHouse);

    private static RemoteBody GoToDoor(Party party, OnlinePlayer player, float before)
    {
        Position there = new(DoorCell, Doorway - (before * IntoHouse));
        Assert.True(there.AdjustToOutside());
        party.Teleport(player, there.CellId, there.Frame.Origin, FacingHouse);
        RemoteBody? door = null;
        Assert.True(
            party.Until(() => (door = player.Game!.Others.Objects.FirstOrDefault(
                item => item.Body.Position.CellId >> 16 == DoorCell >> 16 && (item.Weenie.Description & 0x1000) != 0)) is not null),
            "there is no door");
        return door!;
    }

    private static float Apart(in Position a, in Position b) =>
        (CellIds.BlockOffset(a.CellId, b.CellId) + b.Frame.Origin - a.Frame.Origin).Length();

    private static void AssertAgreed(OnlinePlayer player)
    {
        Assert.True(player.LastPlaceOf(player.Id) is not null, "the server has not said where the player is");
        Assert.True(player.Disagreement <= Same,
            $"the server says {player.LastPlaceOf(player.Id)!.Value.Position}, the player is at {player.Position}");
    }
}
